// What a description adds to units, from the plant model to the engine's tables.
#include <array>

#include "lower/lower.hpp"
#include "symplant/tables/names.hpp"
#include "unit/lower/altered_model.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using lower::EngineTables;
using model::kNone;

/// Devices of one type: states A1 and B2, each with operation and event.
model::PlantModel devices(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    const std::string path = "L_P_D" + std::to_string(i);
    for (const char* task : {"_O_A1", "_O_B2", "_I_A1", "_I_B2"}) names.push_back(path + task);
  }
  return model_of(names);
}

const tables::Transition& transition(const EngineTables& tables, std::uint32_t unit, std::size_t t) {
  return tables.types[tables.units[unit].type].transitions[t];
}

TEST_CASE("A transition keeps its operation, or that it is automatic, or that it is a spring return") {
  model::PlantModel plant = devices(1);
  model::Unit& unit = plant.units[0];
  unit.actuation = tables::Actuation::spring;
  unit.rest = 1;
  unit.transitions = {{0, 1, 1, {}, Duration::fixed(7), model::Origin::given},
                      {1, 0, kNone, Duration::fixed(8), {}, model::Origin::given},
                      {0, 1, kNone, {}, Duration::fixed(9), model::Origin::given, true}};
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.types[0].actuation == tables::Actuation::spring);
  CHECK(tables.types[0].rest == 1);
  CHECK(transition(tables, 0, 0).on == 1);
  CHECK(transition(tables, 0, 1).on == tables::kNoOperation);
  CHECK(transition(tables, 0, 2).on == tables::kSpringReturn);
  CHECK_FALSE(transition(tables, 0, 0).once);
  CHECK(transition(tables, 0, 0).when == tables::kNoCondition);
}

TEST_CASE("Units that differ in once, when, outputs, or the name of their class share no type") {
  model::PlantModel plant = devices(8);
  plant.units[1].transitions[0].once = true;
  plant.units[2].transitions[0].when = 0;
  plant.units[2].conditions = {settled(0, 0)};
  plant.units[3].transitions[0].when = 0;
  plant.units[3].conditions = {settled(1, 1)};
  plant.units[4].outputs = {{{{1, true}}, {}}, {}};
  plant.units[5].outputs = {{{}, {{1, true}}}, {}};
  std::array<description::DeviceDescription, 3> described;
  described[0].type = "Mine";
  described[1].type = "Yours";
  described[2].initial = "A1";
  plant.units[6].described = &described[0];
  plant.units[7].described = &described[1];
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.types.size() == 7);
  CHECK(tables.units[2].type == tables.units[3].type);  // the condition itself may differ within a type
  CHECK(transition(tables, 1, 0).once);
  CHECK(transition(tables, 2, 0).when == 0);

  model::PlantModel same = devices(3);
  same.units[0].described = &described[0];
  same.units[1].described = &described[0];
  CHECK(lower::lower(same).types.size() == 2);
  same.units[0].described = same.units[1].described = &described[2];
  CHECK(lower::lower(same).types.size() == 1);
}

TEST_CASE("l_enter and l_leave switch the state's own event, then the outputs, the later of two wins") {
  model::PlantModel plant = model_of({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "L_P_D_I_BUSY3"});
  model::Unit& unit = plant.units[0];
  unit.states.pop_back();  // BUSY3 is only an event
  unit.outputs = {{{{2, true}, {1, false}}, {{2, false}}}, {{{1, false}, {2, true}, {2, false}}, {{1, true}}}};
  const EngineTables tables = lower::lower(plant);
  CHECK(masks(tables.types[0].enter) == Masks{{0b101, 0b010}, {0, 0b110}});
  CHECK(masks(tables.types[0].leave) == Masks{{0, 0b101}, {0b010, 0}});
}

TEST_CASE("An output switches every event of its unit on the same address") {
  Analysed analysed = analyse_rows({{"L_P_D_O_A1", "Y1"},
                                    {"L_P_D_I_A1", "X1"},
                                    {"L_P_D_O_B2", "Y2"},
                                    {"L_P_D_I_B2", "X2"},
                                    {"L_P_D_I_C3", "X3"},
                                    {"L_P_D_I_D4", "X3"}});
  REQUIRE(analysed.derived);
  model::PlantModel plant = std::move(analysed.derived->plant);
  plant.units[0].states.resize(2);
  plant.units[0].transitions.clear();
  plant.units[0].outputs = {{{{3, true}}, {{2, false}}}, {}};
  const EngineTables tables = lower::lower(plant);
  CHECK(masks(tables.types[0].enter) == Masks{{0b1101, 0}, {0b0010, 0}});
  CHECK(masks(tables.types[0].leave) == Masks{{0, 0b1101}, {0, 0b0010}});
}

TEST_CASE("An event that is no state keeps its Initial, unless entering the initial state switches it") {
  const auto starting = [](bool output) {
    model::PlantModel plant = model_of({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "L_P_D_I_BUSY3*"});
    model::Unit& unit = plant.units[0];
    unit.states.pop_back();
    unit.initial = 0;
    unit.outputs = {{{}, {{2, false}}}, {{{2, true}}, {}}};
    if (output) unit.outputs[0].enter = {{2, false}};
    return lower::lower(plant).initial_values;
  };
  REQUIRE(starting(false).size() == 1);
  CHECK(starting(false)[0].symbol == 4);
  CHECK(starting(false)[0].value == 1);
  CHECK(starting(true).empty());
}

TEST_CASE("A random time is a negative number, and equal ones share it") {
  model::PlantModel plant = devices(3);
  const Duration uniform{Duration::Kind::uniform, 10, 20};
  const Duration normal{Duration::Kind::normal, 10, 20};
  plant.units[0].transitions[0].takes = uniform;
  plant.units[0].transitions[1].takes = normal;
  plant.units[1].transitions[1].after = uniform;
  plant.units[2].transitions[0].takes = Duration{Duration::Kind::uniform, 10, 21};
  const EngineTables tables = lower::lower(plant);
  REQUIRE(tables.random_times.size() == 3);
  CHECK(tables.random_times[0].kind == tables::RandomTime::Kind::uniform);
  CHECK(tables.random_times[0].a == 10);
  CHECK(tables.random_times[0].b == 20);
  CHECK(tables.random_times[1].kind == tables::RandomTime::Kind::normal);
  CHECK(tables.random_times[2].b == 21);
  const auto times = [&](std::uint32_t unit, std::uint16_t dt) {
    CHECK((dt & tables::kOfDevice) != 0);
    return tables.times[tables.units[unit].times + (dt ^ tables::kOfDevice)];
  };
  const auto& transitions = tables.types[0].transitions;
  CHECK(times(0, transitions[0].dt).takes == -1);
  CHECK(times(0, transitions[1].dt).takes == -2);
  CHECK(times(1, transitions[1].dt).after == -1);
  CHECK(times(2, transitions[0].dt).takes == -3);
}

TEST_CASE("A time in which all devices agree is the type's, others are rows of the devices, which share equal ones") {
  model::PlantModel plant = devices(3);
  plant.units[1].transitions[0].takes = Duration::fixed(5);
  const EngineTables tables = lower::lower(plant);
  REQUIRE(tables.types.size() == 1);
  const lower::Type& type = tables.types[0];
  REQUIRE(type.times.size() == 1);
  CHECK(type.times[0].takes == tables::kSecond);
  CHECK(type.transitions[0].dt == tables::kOfDevice);
  CHECK(type.transitions[1].dt == 0);
  CHECK(tables.times.size() == 2);
  CHECK(tables.units[0].times == tables.units[2].times);
  CHECK(tables.times[tables.units[0].times].takes == tables::kSecond);
  CHECK(tables.times[tables.units[1].times].takes == 5);
}

TEST_CASE("Times that are equal in one device and differ in another are two rows of the devices") {
  model::PlantModel plant = devices(2);
  for (model::Transition& t : plant.units[1].transitions) t.takes = Duration::fixed(5);
  CHECK(lower::lower(plant).times.size() == 2);
  plant.units[1].transitions[1].takes = Duration::fixed(6);
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.times.size() == 4);
  CHECK(tables.types[0].transitions[0].dt == tables::kOfDevice);
  CHECK(tables.types[0].transitions[1].dt == (tables::kOfDevice | 1));
}

TEST_CASE("The time of a move without a transition counts only where there can be one") {
  model::PlantModel plant = devices(2);
  plant.units[1].travel = 5;
  CHECK(lower::lower(plant).times.empty());
  for (model::Unit& unit : plant.units) {
    unit.actuation = tables::Actuation::spring;
    unit.rest = 0;
  }
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.types[0].travel == tables::kOfDevice);
  CHECK(tables.times[tables.units[1].times].takes == 5);
}

TEST_CASE("A transition is timed if it waits or draws in some unit of its type, a travel alone is not") {
  model::PlantModel plant = devices(3);
  plant.units[2].transitions[1].after = Duration::fixed(3);
  const EngineTables waits = lower::lower(plant);
  CHECK(waits.types.size() == 1);
  CHECK_FALSE(transition(waits, 0, 0).timed);
  CHECK(transition(waits, 0, 1).timed);
  CHECK(waits.units[0].general == 1);
  plant.units[2].transitions[1].after = {};
  CHECK_FALSE(transition(lower::lower(plant), 0, 1).timed);
  CHECK(lower::lower(plant).units[2].general == 0);
  plant.units[2].transitions[1].takes = {Duration::Kind::uniform, 0, 0};
  CHECK(transition(lower::lower(plant), 0, 1).timed);
}

TEST_CASE("Disables are sorted by disabling unit, state and disabled unit, both units take the general path") {
  model::PlantModel plant = devices(5);
  plant.units[3].disables = {{0, 1}, {}};
  plant.units[1].disables = {{2}, {0, 3}};
  const EngineTables tables = lower::lower(plant);
  std::vector<std::array<std::uint32_t, 3>> rows;
  for (const tables::DisableRow& row : tables.disables) rows.push_back({row.by, row.state, row.unit});
  CHECK(rows == std::vector<std::array<std::uint32_t, 3>>{{1, 0, 2}, {1, 1, 0}, {1, 1, 3}, {3, 0, 0}, {3, 0, 1}});
  for (std::uint32_t u = 0; u < 4; ++u) CHECK(tables.units[u].general == 1);
  CHECK(tables.units[4].general == 0);
}

TEST_CASE("A unit with a behavior shares its type only with equal units, classes of one name are one") {
  model::PlantModel plant = devices(5);
  std::array<description::DeviceDescription, 2> described;
  described[0].behaviour = "MyStopper";
  described[1].behaviour = "MyLift";
  for (const std::uint32_t u : {1U, 3U}) plant.units[u].described = &described[0];
  plant.units[2].described = &described[1];
  plant.units[1].conditions = {settled(0, 0), settled(0, 1), moving(0)};
  plant.units[1].transitions[0].when = 0;
  plant.units[1].first_input = 1;
  plant.units[1].values = {4, 9};
  plant.units[3].values = {11};
  const EngineTables tables = lower::lower(plant);
  CHECK(tables.types.size() == 4);
  CHECK(tables.units[0].type == tables.units[4].type);
  REQUIRE(tables.behaviour_units.size() == 3);
  const tables::BehaviourUnit& first = tables.behaviour_units[0];
  CHECK(first.unit == 1);
  CHECK(first.name == 0);
  CHECK(first.first_input == 1);
  CHECK(first.input_count == 2);
  CHECK(first.first_value == 0);
  CHECK(first.value_count == 2);
  CHECK(tables.behaviour_units[1].unit == 2);
  CHECK(tables.behaviour_units[1].name == 1);
  CHECK(tables.behaviour_units[1].input_count == 0);
  CHECK(tables.behaviour_units[1].value_count == 0);
  CHECK(tables.behaviour_units[2].unit == 3);
  CHECK(tables.behaviour_units[2].name == 0);
  CHECK(tables.behaviour_units[2].first_value == 2);
  CHECK(tables.behaviour_values == std::vector<std::uint32_t>{4, 9, 11});
  CHECK(tables::split_names(tables.behaviour_names) == std::vector<std::string_view>{"MyStopper", "MyLift"});
  CHECK(tables.units[2].general == 1);
  CHECK(transition(tables, 2, 0).timed);
  CHECK(tables.units[4].general == 0);
}

TEST_CASE("Units with operations in one word are less than 255 apart") {
  // One operation, then 253 devices that only report, then two with one operation each: the first of them fits.
  for (const int between : {252, 253, 254, 300}) {
    std::vector<std::string> names{"L_P_FIRST_O_A1"};
    for (int i = 0; i < between; ++i) names.push_back("L_P_S" + std::to_string(i) + "_I_ON");
    names.insert(names.end(), {"L_P_SECOND_O_A1", "L_P_THIRD_O_A1"});
    const EngineTables tables = lower::lower(model_of(names));
    const auto second = static_cast<std::uint32_t>(between + 1);
    INFO(between);
    CHECK(tables.units[second].operation_bit == (second < tables::kMaxUnitsInWord ? 1 : 64));
    CHECK(tables.units[second + 1].operation_bit == (second + 1 < tables::kMaxUnitsInWord ? 2U
                                                     : second < tables::kMaxUnitsInWord   ? 64U
                                                                                          : 65U));
    for (std::size_t a = 0; a < tables.units.size(); ++a) {
      if (tables.types[tables.units[a].type].operations == 0) continue;
      const std::size_t b = a == 0 ? second : second + 1;
      if (tables.units[a].operation_bit / 64 == tables.units[b].operation_bit / 64) {
        CHECK(b - a < tables::kMaxUnitsInWord);
      }
    }
  }
}

}  // namespace
}  // namespace symplant::test
