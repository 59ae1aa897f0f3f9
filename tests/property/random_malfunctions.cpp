// Random malfunctions of every kind, biased to several on one unit or symbol.
#include "property/random_malfunctions.hpp"

#include <algorithm>
#include <bit>

#include "property/malfunction_names.hpp"
#include "property/random_material.hpp"
#include "property/random_plant.hpp"

namespace symplant::property {
namespace {

using description::Duration;
using description::GivenEffect;
using description::GivenMalfunction;
using tables::kMillisecond;
using tables::MalfunctionKind;

class MalfunctionWriter {
 public:
  MalfunctionWriter(Dice& dice, const model::PlantModel& model)
      : dice_(dice), model_(model), atoms_(atoms_of_plant(model)) {
    for (std::uint32_t i = 0; i < model.symbols.size(); ++i) {
      if (model.symbols[i].type == tables::DataType::boolean) bits_.push_back(i);
    }
    // A few of them, so that malfunctions meet.
    for (int i = 0; i < 3 && !bits_.empty(); ++i) favorites_.push_back(dice.pick(bits_));
  }

  std::vector<GivenMalfunction> write() {
    const std::size_t count = 1 + dice_.below(dice_.percent(70) ? 4 : 9);
    for (std::size_t i = 0; i < count; ++i) add("m" + std::to_string(all_.size() + 1));
    if (!bits_.empty() && dice_.percent(25)) add_ripple();
    for (GivenMalfunction& given : all_) {
      if (dice_.percent(35)) becomes(given);
    }
    for (GivenMalfunction& given : all_) extend(given);
    return std::move(all_);
  }

 private:
  /// After all else is drawn: what acts on tracks, holds events, has several effects, or lasts as long as a condition.
  void extend(GivenMalfunction& given) {
    add_tracks(given.one);
    hold(given.one);
    if (dice_.percent(25)) split(given);
    if (atoms_.empty() || given.name == "r1" || !dice_.percent(20)) return;
    given.when = condition();
    given.during = true;
    given.chance.reset();
    given.lasts.reset();
    given.becomes.reset();
  }

  void add_tracks(GivenEffect& given) {
    if (given.of.empty() || !given.state.empty() || model_.material.tracks.empty() || !dice_.percent(60)) return;
    if (dice_.percent(40)) given.of.clear();
    given.of.push_back(model_.material.tracks[dice_.below(model_.material.tracks.size())].name);
  }

  /// Some of the events that it forces have what they show when it starts.
  void hold(GivenEffect& given) {
    for (auto& [name, value] : given.force) {
      const auto is_it = [&forced = name](const model::Symbol& symbol) { return symbol.name() == forced; };
      const auto symbol = std::find_if(model_.symbols.begin(), model_.symbols.end(), is_it);
      if (symbol == model_.symbols.end() || symbol->direction == tables::Direction::operation) continue;
      if (dice_.percent(35)) value = {std::nullopt, "hold", "`\"hold\"`", true};
    }
  }

  /// The effect becomes one of several; those that name no devices use those of the malfunction.
  void split(GivenMalfunction& given) {
    given.effects.push_back(given.one);
    given.one = {};
    for (std::size_t i = 1 + dice_.below(2); i > 0; --i) {
      GivenEffect more;
      if (!set_kind(more)) continue;
      add_tracks(more);
      hold(more);
      given.effects.push_back(std::move(more));
    }
    dice_.shuffle(given.effects);
    if (given.effects.front().of.empty() || !given.effects.front().state.empty() || !dice_.percent(50)) return;
    std::swap(given.one.of, given.effects.front().of);
    std::swap(given.one.of_is_list, given.effects.front().of_is_list);
  }

  void add(const std::string& name) {
    GivenMalfunction given;
    given.name = name;
    if (!set_kind(given.one)) return;
    if (!atoms_.empty() && dice_.percent(35)) given.when = condition();
    if (dice_.percent(30)) given.chance = duration();
    if (dice_.percent(45)) given.lasts = duration();
    all_.push_back(std::move(given));
  }

  bool set_kind(GivenEffect& given) {
    const std::size_t kind = dice_.below(100);
    if (kind < 52) {
      given.kinds = {kind < 28 ? MalfunctionKind::slower : MalfunctionKind::stuck};
      if (model_.units.empty()) return false;
      if (kind < 28) given.factor = dice_.pick(kFactors);
      set_devices(given);
    } else if (kind < 74) {
      given.kinds = {MalfunctionKind::force};
      set_forces(given);
      return !given.force.empty();
    } else if (kind < 94) {
      given.kinds = {MalfunctionKind::flicker};
      if (bits_.empty()) return false;
      given.flicker = {std::string(model_.symbols[bit()].name()), duration(), duration().a};
    } else {
      given.kinds = {MalfunctionKind::lose};
      given.lose = model_.controllers.size() == 1 ? "" : model_.controllers.back();
    }
    return true;
  }

  void set_devices(GivenEffect& given) {
    const model::Unit& unit = model_.units[dice_.below(std::min<std::size_t>(model_.units.size(), 6))];
    given.of = {std::string(unit.device_path())};
    if (dice_.percent(30)) given.of.emplace_back(model_.units[dice_.below(model_.units.size())].device_path());
    if (dice_.percent(15)) given.of = {"*"};
    if (dice_.percent(10)) given.of.front().back() = '?';
    given.of_is_list = true;
    if (given.kinds.front() == MalfunctionKind::slower || unit.states.empty() || dice_.percent(60)) return;
    given.of.resize(1);
    given.state = unit.states[dice_.below(unit.states.size())].name;
  }

  std::uint32_t bit() { return dice_.percent(60) ? dice_.pick(favorites_) : dice_.pick(bits_); }

  std::uint32_t leader(std::uint32_t symbol) const {
    return model_.symbols[symbol].leader == model::kNone ? symbol : model_.symbols[symbol].leader;
  }

  void set_forces(GivenEffect& given) {
    std::vector<std::uint32_t> taken;
    if (model_.symbols.empty()) return;
    for (std::size_t i = 1 + dice_.below(3); i > 0; --i) {
      const bool any = bits_.empty() || dice_.percent(50);
      const std::uint32_t symbol = any ? static_cast<std::uint32_t>(dice_.below(model_.symbols.size())) : bit();
      if (std::find(taken.begin(), taken.end(), leader(symbol)) != taken.end()) continue;
      taken.push_back(leader(symbol));
      given.force.emplace_back(model_.symbols[symbol].name(), value(model_.symbols[symbol].type));
    }
  }

  description::GivenForcedValue value(tables::DataType type) {
    static const std::vector<std::string> kReals = {"0", "2.5", "-1", "300", "nan", "inf", "-0.0"};
    description::GivenForcedValue given;
    if (type == tables::DataType::boolean) {
      given.bit = dice_.percent(50);
      given.number = given.shown = *given.bit ? "true" : "false";
      return given;
    }
    const bool real = type == tables::DataType::real || type == tables::DataType::lreal;
    given.number = given.shown = real ? dice_.pick(kReals) : std::to_string(dice_.below(8));
    return given;
  }

  std::string condition() {
    std::string atom = dice_.percent(30) ? "not " : "";
    atom += dice_.pick(atoms_);
    if (dice_.percent(70)) return atom;
    atom += dice_.percent(50) ? " and " : " or ";
    return atom += dice_.pick(atoms_);
  }

  Duration duration() {
    static const std::vector<tables::Time> kGrid = {10 * kMillisecond, 20 * kMillisecond, 20 * kMillisecond,
                                                    50 * kMillisecond, 5'000'003};
    if (dice_.percent(2)) return Duration::fixed(1);
    Duration made = Duration::fixed(dice_.pick(kGrid));
    if (!dice_.percent(40)) return made;
    made.kind = dice_.percent(50) ? Duration::Kind::uniform : Duration::Kind::normal;
    made.b = made.kind == Duration::Kind::uniform ? made.a + dice_.pick(kGrid) : dice_.pick(kGrid);
    return made;
  }

  /// A bit that makes the condition of the malfunction itself false, and true again: without a limit for ever.
  void add_ripple() {
    const std::string symbol(model_.symbols[bit()].name());
    const bool on = dice_.percent(50);
    GivenMalfunction given;
    given.name = "r1";
    given.one.kinds = {MalfunctionKind::force};
    const char* const text = on ? "true" : "false";
    given.one.force.emplace_back(symbol, description::GivenForcedValue{on, text, text, false});
    given.when = (on ? "not '" : "'") + symbol + "'";
    if (dice_.percent(70)) {
      given.becomes = {duration().a, (on ? "'" : "not '") + symbol + "'", "r1"};
    }
    all_.push_back(std::move(given));
  }

  void becomes(GivenMalfunction& given) {
    if (given.becomes) return;
    given.becomes.emplace();
    given.becomes->after = duration().a;
    if (!atoms_.empty() && dice_.percent(60)) given.becomes->unless = condition();
    given.becomes->start = dice_.pick(all_).name;
  }

  static inline const std::vector<std::uint32_t> kFactors = {1000, 2000, 3000, 3000, 500, 1500, 333, 1, 2, 1'000'000};

  Dice& dice_;
  const model::PlantModel& model_;
  std::vector<std::string> atoms_;
  std::vector<std::uint32_t> bits_;
  std::vector<std::uint32_t> favorites_;
  std::vector<GivenMalfunction> all_;
};

/// One or two malfunctions that start and end again and again. Some do so not quite often enough to be a loop.
void add_restless(Dice& dice, std::vector<GivenMalfunction>& all) {
  static const std::vector<tables::Time> kShort = {1, 1, 3, 40, 90, 99, 100, 101, 400};
  const auto time = [&] { return Duration::fixed(dice.pick(kShort)); };
  const std::string number = std::to_string(all.size() + 1);
  GivenMalfunction one;
  one.name = "restless" + number;
  one.one.kinds = {MalfunctionKind::force};
  one.one.force.emplace_back(dice.percent(50) ? "EYE" : "L0_P_D0_I_B",
                             description::GivenForcedValue{true, "true", "true", false});
  GivenMalfunction other = one;
  other.name = "other" + number;
  const std::size_t kind = dice.below(3);
  if (kind == 0) {  // by chance
    one.chance = time();
    one.lasts = time();
  } else if (kind == 1) {  // its own condition
    one.when = "not " + one.one.force.front().first;
    one.becomes = {time().a, "", other.name};
    other.lasts = time();
  } else {  // each becomes the other one
    one.chance = Duration::fixed(kMillisecond);
    one.becomes = {time().a, "", other.name};
    other.becomes = {time().a, "", one.name};
  }
  all.push_back(one);
  if (kind != 0) all.push_back(other);
}

}  // namespace

void add_restless_malfunctions(Dice& dice, PlantText& text) {
  text.rows.push_back({"L0_P_D0_O_B", "%QX0", "BOOL", ""});
  text.rows.push_back({"L0_P_D0_I_A", "%IX0", "BOOL", ""});
  text.rows.push_back({"L0_P_D0_I_B", "%IX1", "BOOL", ""});
  text.rows.push_back({"EYE", "%IX2", "BOOL", ""});
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) add_restless(dice, text.description.malfunctions);
}

bool has_restless_malfunctions(const model::PlantModel& model) {
  return !model.malfunctions.empty() && model.malfunctions.front().name == "restless1";
}

void add_random_malfunctions(Dice& dice, PlantText& text, const model::PlantModel& model) {
  text.description.malfunctions = MalfunctionWriter(dice, model).write();
}

std::string random_malfunction(Dice& dice, const model::PlantModel& model) {
  const std::size_t written = model.malfunctions.size();
  if (written != 0 && dice.percent(70)) return model.malfunctions[dice.below(written)].name;
  if (!model.units.empty() && dice.percent(60)) {
    // Mostly of the first units, so that malfunctions meet.
    const std::size_t most = dice.percent(70) ? std::min<std::size_t>(model.units.size(), 4) : model.units.size();
    const std::string kind = dice.percent(50) ? "stuck:" : "slow:";
    return kind + std::string(model.units[dice.below(most)].path);
  }
  if (model.symbols.empty()) return "none";
  const std::string symbol(model.symbols[dice.below(model.symbols.size())].name());
  return (dice.percent(50) ? "on:" : "off:") + symbol;
}

}  // namespace symplant::property
