// What the devices look like in the panel's plan.
#include "model/plan_shapes.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "text/ascii.hpp"
#include "text/name_words.hpp"

namespace symplant::model {
namespace {

using tables::Shape;

struct ShapeWords {
  Shape shape;
  std::string_view words;  ///< separated by blanks
};

/// English and German words of devices, and their usual abbreviations.
constexpr ShapeWords kDeviceWords[] = {
    {Shape::device, "BRAKE BREMSE POWER SUPPLY"},
    {Shape::button, "PB BTN BUTTON PUSHBUTTON ESTOP TASTER TASTE NOTHALT"},
    {Shape::clamp, "CLAMP CLAMPS CLP CLMP VICE CHUCK SPANNER KLEMME SPANNFUTTER LOCK LATCH"},
    {Shape::conveyor, "CONV CONVEYOR CV BELT ROLLER CHAIN BAND FOERDERER FOERDERBAND ROLLENBAHN INFEED OUTFEED"},
    {Shape::cylinder,
     "CYL CYLINDER CYLINDERS PUSHER PUSH STOPPER STP STOP EJECT EJECTOR KICKER SLIDE PIN PLUNGER DIVERTER PUNCH ZYL "
     "ZYLINDER SCHIEBER AUSWERFER ANSCHLAG"},
    {Shape::door, "DOOR DOORS GATE SHUTTER HATCH COVER HOOD TUER TOR KLAPPE"},
    {Shape::gripper, "GRIP GRIPPER GRP GRAB SUCTION VACUUM SPREADER GREIFER SAUGER"},
    {Shape::lamp, "LAMP LAMPS LIGHT LED BEACON TOWER HORN SIREN BUZZER LEUCHTE HUPE SIGNAL"},
    {Shape::lift, "LIFT LIFTER ELEVATOR HOIST HUB HUBWERK HEBER HEBEBUEHNE"},
    {Shape::machine,
     "MC MACH MACHINE MILL MILLING LATHE PRESS OVEN FURNACE WELDER WELD GLUE PRINTER LABELER LABELLER FILLER CAPPER "
     "MASCHINE "
     "PRESSE OFEN FRAESE"},
    {Shape::motor,
     "MOTOR MOT MTR SPINDLE FAN DRIVE MIXER AGITATOR BLOWER BOOM SLEW LUFF ANTRIEB SPINDEL LUEFTER RUEHRER"},
    {Shape::pump, "PUMP PMP PUMPE COMPRESSOR KOMPRESSOR"},
    {Shape::robot, "RBT ROB ROBOT ROBOTER MANIPULATOR ARM"},
    {Shape::selector, "SEL SELECTOR SW SWITCH KEYSWITCH MODE SCHALTER WAHLSCHALTER"},
    {Shape::sensor,
     "PE PX PHOTOEYE PHOTOCELL EYE SENSOR PROX LS LT FT TT PT RFID SCANNER BARCODE CAMERA CURTAIN INSPECT INITIATOR "
     "LICHTSCHRANKE"},
    {Shape::tank, "TANK VESSEL SILO HOPPER BIN REACTOR BEHAELTER KESSEL"},
    {Shape::turntable, "TURNTABLE TABLE ROTARY INDEXER CAROUSEL TURN DREHTISCH DREHTELLER"},
    {Shape::valve, "VALVE VALVES VLV SV XV VENTIL"},
    {Shape::vehicle,
     "AGV AGVS SHUTTLE CART TROLLEY CARRIAGE CARRIER VEHICLE CRANE TRAVERSER WAGEN KATZE PORTAL GANTRY"},
};

/// Words of states, of devices whose name has no known word.
constexpr ShapeWords kStateWords[] = {
    {Shape::cylinder, "ADV ADVANCE ADVANCED RET RETURN RETRACT RETRACTED EXT EXTEND EXTENDED FWDPOS HOME"},
    {Shape::clamp, "CLAMP CLAMPED UNCLAMP UNCLAMPED LOCKED UNLOCKED"},
    {Shape::gripper, "GRIP GRIPPED PICK RELEASE"},
    {Shape::lift, "UP DOWN RAISE RAISED LOWER LOWERED"},
    {Shape::motor, "RUN RUNNING FWD REV FORWARD REVERSE CW CCW"},
    {Shape::valve, "OPEN OPENED CLOSE CLOSED SHUT"},
    {Shape::lamp, "RED GREEN YELLOW BLUE FLASH"},
};

using WordTable = std::unordered_map<std::string_view, Shape>;

template <std::size_t Size>
WordTable table_of(const ShapeWords (&rows)[Size]) {
  WordTable table;
  for (const ShapeWords& row : rows) {
    text::any_word(row.words, [&](std::string_view word) {
      table.emplace(word, row.shape);
      return false;
    });
  }
  return table;
}

/// The shape of a word, or of the longest known word with which a compound such as `BUTTONSTART` begins or ends.
std::optional<Shape> shape_of_word(std::string_view word, const WordTable& table) {
  constexpr std::size_t kShortest = 4;  // shorter ones are in too many other words
  if (const auto found = table.find(word); found != table.end()) return found->second;
  for (std::size_t size = word.size(); size > kShortest; --size) {
    for (const std::string_view part : {word.substr(word.size() - size + 1), word.substr(0, size - 1)}) {
      if (const auto found = table.find(part); found != table.end()) return found->second;
    }
  }
  return std::nullopt;
}

/// The shape of the last known word of a name: in `CLAMP_SENSOR` the last word says what the device is.
std::optional<Shape> shape_in(std::string_view name, const WordTable& table) {
  std::optional<Shape> shape;
  text::any_word(name, [&](std::string_view word) {
    if (const auto found = shape_of_word(text::to_upper(word), table)) shape = found;
    return false;
  });
  return shape;
}

Shape guess(const Unit& unit) {
  static const WordTable kDevices = table_of(kDeviceWords);
  static const WordTable kStates = table_of(kStateWords);
  if (unit.facet != nullptr) {
    if (const auto shape = shape_in(unit.path.substr(unit.device_path().size()), kDevices)) return *shape;
  }
  if (const auto shape = shape_in(unit.device, kDevices)) return *shape;
  if (unit.operations.empty()) return unit.events.empty() ? Shape::device : Shape::sensor;
  for (const State& state : unit.states) {
    if (const auto shape = shape_in(state.name, kStates)) return *shape;
  }
  if (unit.events.empty() && unit.states.size() <= 2) return Shape::lamp;
  return unit.actuation == tables::Actuation::spring && unit.states.size() == 2 ? Shape::cylinder : Shape::device;
}

}  // namespace

std::vector<Shape> plan_shapes(const PlantModel& plant) {
  text::ByName<Shape> given;
  for (const description::GivenView& view : plant.description->view) {
    if (view.shape) given[view.device] = *view.shape;
  }
  std::vector<Shape> shapes;
  shapes.reserve(plant.units.size());
  for (const Unit& unit : plant.units) {
    const auto found = given.find(unit.device_path());
    shapes.push_back(found != given.end() ? found->second : guess(unit));
  }
  return shapes;
}

}  // namespace symplant::model
