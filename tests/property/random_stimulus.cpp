// Random actions of a PLC, a scenario and a trainer, biased to interesting cases.
#include <algorithm>
#include <bit>
#include <limits>

#include "property/dice.hpp"
#include "property/malfunction_names.hpp"
#include "property/random_malfunctions.hpp"
#include "property/random_material.hpp"
#include "property/random_plant.hpp"
#include "property/random_values.hpp"

namespace symplant::property {
namespace {

using Kind = Action::Kind;
using tables::kMillisecond;

class StimulusWriter {
 public:
  StimulusWriter(Dice& dice, Dice& other, const model::PlantModel& plant)
      : dice_(dice), other_(other), plant_(plant), on_(plant.symbols.size()) {
    const bool ripples = plant.units.size() > 200;
    chance_ = !plant.malfunctions.empty() ? 30 : other_.percent(ripples ? 5 : 30) ? 20 : 0;
    for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
      (plant.symbols[i].direction == tables::Direction::operation ? operations_ : events_).push_back(i);
    }
  }

  std::vector<Action> write() {
    reset();
    if (has_reversing_tracks(plant_)) return freeze_tracks();
    if (has_restless_malfunctions(plant_)) return freeze_malfunctions();
    if (dice_.percent(80)) add(Kind::advance, {}, 0, 0);
    const std::size_t large = plant_.units.size() > 100 ? 6 : plant_.units.size() > 20 ? 3 : 1;
    for (std::size_t i = (40 + dice_.below(110)) / large; i > 0; --i) {
      for (std::size_t k = dice_.below(4); k > 0; --k) act();
      if (!plant_.material.empty()) parts();
      malfunctions();
      values();
      keep();
      advance();
    }
    return std::move(actions_);
  }

 private:
  void add(Kind kind, std::string what, std::uint64_t value, tables::Time time) {
    actions_.push_back({kind, std::move(what), value, time});
  }
  std::string name(std::uint32_t symbol) const { return std::string(plant_.symbols[symbol].name()); }

  void reset() {
    static const std::vector<tables::Time> kCycles = {0, 0, 0, 10 * kMillisecond, 15 * kMillisecond, 1};
    const std::uint64_t seed = dice_.below(4);
    add(Kind::reset, {}, seed, dice_.pick(kCycles));
    std::fill(on_.begin(), on_.end(), false);
    forced_.clear();
  }

  /// Each track has an instant every nanosecond until it freezes.
  std::vector<Action> freeze_tracks() {
    actions_.back().time = 0;
    add(Kind::advance, {}, 0, 0);
    for (int i = 0; i < 5; ++i) {
      add(Kind::run, {}, 12'000, 20 * kMillisecond);
      if (dice_.percent(50) && !plant_.symbols.empty()) add(Kind::further, name(0), 0, 333);
    }
    return std::move(actions_);
  }

  /// Most of them change every few nanoseconds until they are frozen.
  std::vector<Action> freeze_malfunctions() {
    static const std::vector<std::uint64_t> kInstants = {700, 3'000, 12'000};
    actions_.back().time = 0;
    for (int i = 0; i < 8; ++i) {
      add(Kind::run, {}, dice_.pick(kInstants), 20 * kMillisecond);
      malfunctions();
      keep();
    }
    return std::move(actions_);
  }

  std::string location() {
    const model::Material& material = plant_.material;
    const std::size_t index = dice_.below(material.locations());
    std::string name = material.location_name(static_cast<std::uint32_t>(index));
    if (!material.is_track(static_cast<std::uint32_t>(index)) || dice_.percent(30)) return name;
    const std::int64_t length = material.tracks[index].length;
    const std::int64_t position = dice_.percent(50)
                                      ? length * static_cast<std::int64_t>(dice_.below(9)) / 8
                                      : static_cast<std::int64_t>(dice_.below(static_cast<std::size_t>(length) + 1));
    return name + "@" + std::to_string(position);
  }

  /// By hand, and instants that change nothing.
  void parts() {
    if (dice_.percent(22)) {
      std::string to = location();
      add(Kind::put, std::move(to), dice_.below(plant_.material.kinds.size()), 0);
    }
    if (dice_.percent(9)) add(Kind::take, location(), 0, 0);
    if (dice_.percent(25)) further(dice_);
  }

  void further(Dice& dice) {
    if (plant_.symbols.empty()) return;
    const auto symbol = static_cast<std::uint32_t>(dice.below(plant_.symbols.size()));
    static const std::vector<tables::Time> kTimes = {1, 7, 3 * kMillisecond, 3'333'333, 9'999'999, 0};
    const tables::Time time = dice.pick(kTimes);
    add(Kind::further, name(symbol), dice.below(2), time);
  }

  /// Drawn by other dice: the rest is the same without malfunctions.
  void malfunctions() {
    if (chance_ == 0) return;
    const bool many = plant_.units.size() > 10;
    if (many && other_.one_in(30)) {  // more ordinary ones than there may be
      for (int i = 0; i < 70; ++i) add(Kind::start, ordinary(), other_.below(2), 0);
    }
    while (other_.percent(chance_)) {
      const Kind kind = started_.empty() || other_.percent(60) ? Kind::start : Kind::stop;
      const std::string what =
          kind == Kind::stop && other_.percent(85) ? other_.pick(started_) : random_malfunction(other_, plant_);
      if (kind == Kind::start) started_.push_back(what);
      add(kind, what, other_.below(2), 0);
    }
  }

  /// Numbers for parameters and for outputs; further instants show that they do not matter.
  void values() {
    if (plant_.values.empty()) return;
    if (other_.percent(6)) {  // to a step that is still to come
      add(Kind::advance_to_due, {}, 0, 0);
      add(Kind::advance_before, {}, 0, 10 * kMillisecond);
    }
    while (other_.percent(22)) {
      const double number = other_.percent(5) ? std::numeric_limits<double>::infinity() : random_value_number(other_);
      add(Kind::set_value, random_settable_value(other_, *plant_.description), std::bit_cast<std::uint64_t>(number), 0);
    }
    if (other_.percent(12)) further(other_);
  }

  std::string ordinary() {
    const auto written = static_cast<std::uint32_t>(plant_.malfunctions.size());
    const std::size_t count = 2 * (plant_.units.size() + plant_.symbols.size());
    return malfunction_text(plant_, written + static_cast<std::uint32_t>(other_.below(count)));
  }

  void act() {
    const std::size_t kind = dice_.below(100);
    if (kind < 34) {
      operation();
    } else if (kind < 58) {
      command();
    } else if (kind < 66) {
      several_operations();
    } else if (kind < 76) {
      if (!events_.empty()) set(Kind::set_input, dice_.pick(events_));
    } else if (kind < 85) {
      force();
    } else if (kind < 93) {
      if (!forced_.empty()) add(Kind::release, dice_.pick(forced_), 0, 0);
    } else if (kind < 98) {
      state();
    } else {
      add(Kind::set_quality, {}, dice_.below(2), 0);
    }
  }

  void set(Kind kind, std::uint32_t symbol) {
    add(kind, name(symbol), random_content(dice_, plant_.symbols[symbol].type), 0);
  }

  void operation() {
    if (operations_.empty()) return;
    const std::uint32_t symbol = dice_.pick(operations_);
    if (plant_.symbols[symbol].type != tables::DataType::boolean) return set(Kind::set, symbol);
    write(symbol, dice_.percent(90) ? !on_[symbol] : on_[symbol]);
  }

  void write(std::uint32_t symbol, bool on) {
    on_[symbol] = on;
    add(Kind::set, name(symbol), on ? 1 : 0, 0);
  }

  /// One operation of a unit on, its other operations off, as when a PLC changes the command.
  void command() {
    if (plant_.units.empty()) return;
    const auto& operations = plant_.units[dice_.below(plant_.units.size())].operations;
    if (operations.empty()) return;
    const std::uint32_t wanted = dice_.pick(operations);
    for (const std::uint32_t symbol : operations) {
      if (on_[symbol] && symbol != wanted) write(symbol, false);
    }
    if (!on_[wanted] || dice_.percent(10)) write(wanted, true);
  }

  /// All operations of one unit at once: both coils on, all off.
  void several_operations() {
    if (plant_.units.empty()) return;
    const model::Unit& unit = plant_.units[dice_.below(plant_.units.size())];
    const unsigned chance = dice_.percent(50) ? 100 : 50;
    const bool on = dice_.percent(65);
    for (const std::uint32_t symbol : unit.operations) {
      if (!dice_.percent(chance)) continue;
      write(symbol, on);
    }
  }

  void force() {
    const auto& side = !events_.empty() && (operations_.empty() || dice_.percent(50)) ? events_ : operations_;
    if (side.empty()) return;
    const std::uint32_t symbol = dice_.pick(side);
    set(Kind::force, symbol);
    forced_.push_back(name(symbol));
  }

  void state() {
    if (plant_.units.empty()) return;
    const model::Unit& unit = plant_.units[dice_.below(plant_.units.size())];
    if (unit.states.empty()) return;
    add(Kind::set_state, std::string(unit.path), dice_.below(unit.states.size()), 0);
  }

  void keep() {
    if (dice_.percent(5)) add(Kind::save, {}, 0, 0);
    if (dice_.percent(4)) {
      const std::uint64_t which = dice_.below(8);
      add(Kind::restore, {}, which, static_cast<tables::Time>(dice_.below(2)));
    }
    if (dice_.one_in(80)) reset();
  }

  void advance() {
    static const std::vector<tables::Time> kTimes = {10 * kMillisecond,
                                                     10 * kMillisecond,
                                                     20 * kMillisecond,
                                                     5 * kMillisecond,
                                                     1,
                                                     50 * kMillisecond,
                                                     tables::kSecond,
                                                     33'333'333,
                                                     0};
    const std::size_t kind = dice_.below(100);
    if (kind < 40) return add(Kind::advance_to_due, {}, 0, 0);
    add(kind < 50 ? Kind::advance_before : Kind::advance, {}, 0, dice_.pick(kTimes));
  }

  Dice& dice_;
  Dice& other_;
  const model::PlantModel& plant_;
  unsigned chance_ = 0;               ///< of a malfunction that starts or stops, percent
  std::vector<std::string> started_;  ///< malfunctions
  std::vector<std::uint32_t> operations_;
  std::vector<std::uint32_t> events_;
  std::vector<bool> on_;  ///< of operations, as they were last written
  std::vector<std::string> forced_;
  std::vector<Action> actions_;
};

}  // namespace

std::uint64_t random_content(Dice& dice, tables::DataType type) {
  if (type == tables::DataType::boolean) return dice.below(2);
  const auto number = static_cast<std::int64_t>(dice.below(8));
  if (type == tables::DataType::real || type == tables::DataType::lreal) {
    static const std::vector<double> kReals = {0.0,
                                               1.0,
                                               2.0,
                                               2.5,
                                               -1.0,
                                               300.0,
                                               -0.0,
                                               5.0,
                                               std::numeric_limits<double>::infinity(),
                                               std::numeric_limits<double>::quiet_NaN()};
    return std::bit_cast<std::uint64_t>(dice.pick(kReals));
  }
  const bool is_signed = type >= tables::DataType::sint && type <= tables::DataType::lint;
  if (is_signed && dice.percent(20)) return static_cast<std::uint64_t>(-number);
  if (dice.percent(5)) return is_signed ? 127 : 255;
  return static_cast<std::uint64_t>(number);
}

std::vector<Action> random_stimulus(std::uint64_t seed, const model::PlantModel& plant) {
  Dice dice(seed * 2 + 0x5EED'0000'0000);
  Dice other(seed * 2 + 0x5EED'0000'0001);
  return StimulusWriter(dice, other, plant).write();
}

}  // namespace symplant::property
