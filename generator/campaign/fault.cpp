// The single faults of a plant.
#include "campaign/fault.hpp"

#include <map>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "text/ascii.hpp"

namespace symplant::campaign {
namespace {

using model::kNone;
using model::PlantModel;
using tables::MalfunctionKind;

constexpr tables::Time kEvery = tables::kSecond;
constexpr tables::Time kShows = 80 * tables::kMillisecond;
constexpr std::uint32_t kSlower = 3000;  // thousandths

constexpr std::string_view kLoose = " loose";
constexpr std::string_view kHeld = " held";
constexpr std::string_view kStuck = " stuck";
constexpr std::string_view kSlow = " slow";
constexpr std::string_view kLost = " lost";
constexpr std::string_view kCondition = " (condition)";

std::string named(std::string_view item, std::string_view what) { return std::string(item).append(what); }
/// Not the name of what a device of that name has.
std::string track_named(std::string_view item, std::string_view what) { return "track " + named(item, what); }

bool is_bit(const model::Symbol& symbol) { return symbol.type == tables::DataType::boolean; }

/// Whether a fault of the symbol is one of the plant: it is an input, and the first one on its address.
bool is_input(const PlantModel& plant, const model::Symbol& symbol) {
  if (symbol.direction != tables::Direction::event) return false;
  return symbol.leader == kNone || plant.symbols[symbol.leader].direction != tables::Direction::event;
}

/// The name of a controller, `PLC` for one without a name.
std::string controller_item(const PlantModel& plant, std::uint32_t controller) {
  if (!plant.controllers[controller].empty()) return plant.controllers[controller];
  const bool taken = std::any_of(plant.controllers.begin(), plant.controllers.end(),
                                 [](const std::string& name) { return text::to_upper(name) == "PLC"; });
  return taken ? "unnamed PLC" : "PLC";
}

/// Adds malfunctions to a plant.
class Adder {
 public:
  explicit Adder(PlantModel& plant) : plant_(plant) {
    for (const model::Malfunction& one : plant.malfunctions) taken_.insert(text::to_upper(one.name));
  }

  /// Returns the names that the plant has already.
  std::vector<std::string> run() {
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (is_input(plant_, plant_.symbols[i])) add_of_input(i);
    }
    for (std::uint32_t track = 0; track < plant_.material.tracks.size(); ++track) {
      const std::string& name = plant_.material.tracks[track].name;
      model::Effect stuck;
      stuck.kind = MalfunctionKind::stuck;
      stuck.tracks = {track};
      add(track_named(name, kStuck), std::move(stuck));
      model::Effect slow;
      slow.kind = MalfunctionKind::slower;
      slow.tracks = {track};
      slow.factor = kSlower;
      add(track_named(name, kSlow), std::move(slow));
    }
    for (std::uint32_t i = 0; i < plant_.controllers.size(); ++i) {
      model::Effect lost;
      lost.kind = MalfunctionKind::lose;
      lost.subject = i;
      add(named(controller_item(plant_, i), kLost), std::move(lost));
    }
    return std::move(already_);
  }

 private:
  void add_of_input(std::uint32_t index) {
    const model::Symbol& symbol = plant_.symbols[index];
    model::Effect effect;
    if (is_bit(symbol)) {
      effect.kind = MalfunctionKind::flicker;
      effect.subject = index;
      effect.every = description::Duration::fixed(kEvery);
      effect.shows = kShows;
    } else {
      effect.kind = MalfunctionKind::force;
      effect.forces.emplace_back().symbol = index;
      effect.forces.back().holds = true;
    }
    add(named(symbol.name(), is_bit(symbol) ? kLoose : kHeld), std::move(effect));
  }

  void add(std::string name, model::Effect effect) {
    if (!taken_.insert(text::to_upper(name)).second) return already_.push_back(std::move(name));
    model::Malfunction& malfunction = plant_.malfunctions.emplace_back();
    malfunction.name = std::move(name);
    malfunction.effects.push_back(std::move(effect));
  }

  PlantModel& plant_;
  std::unordered_set<std::string> taken_;  ///< names in upper case
  std::vector<std::string> already_;
};

/// `X0012, part at the stop`
std::string more_of(const model::Symbol& symbol) {
  std::string more(symbol.written_address());
  const std::string_view comment = symbol.row->comment;
  if (!comment.empty()) more.append(more.empty() ? "" : ", ").append(comment);
  return more;
}

class Lister {
 public:
  explicit Lister(const PlantModel& plant) : plant_(plant) {}

  std::vector<Fault> run() {
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (is_input(plant_, plant_.symbols[i])) list_input(i);
    }
    for (std::uint32_t unit = 0; unit < plant_.units.size(); ++unit) {
      if (!plant_.units[unit].moves()) continue;  // a person or parts move it
      const std::string path(plant_.units[unit].path);
      faults_.push_back({Fault::Mode::stuck, path, "", named(path, kStuck), {}, {unit}});
      faults_.push_back({Fault::Mode::slow, path, "", named(path, kSlow), {}, {unit}});
    }
    for (const auto& track : plant_.material.tracks) {
      faults_.push_back({Fault::Mode::stuck, track.name, "", track_named(track.name, kStuck), {}, {}});
      faults_.push_back({Fault::Mode::slow, track.name, "", track_named(track.name, kSlow), {}, {}});
    }
    for (std::uint32_t i = 0; i < plant_.controllers.size(); ++i) {
      const std::string item = controller_item(plant_, i);
      faults_.push_back({Fault::Mode::lost, item, "", named(item, kLost), {}, {}, {i}});
    }
    return std::move(faults_);
  }

 private:
  void list_input(std::uint32_t index) {
    const model::Symbol& symbol = plant_.symbols[index];
    const auto add = [&](Fault::Mode mode, std::string_view what) {
      faults_.push_back({mode, std::string(symbol.name()), more_of(symbol), named(symbol.name(), what), {index}, {}});
    };
    if (!is_bit(symbol)) return add(Fault::Mode::held, kHeld);
    add(Fault::Mode::stuck_on, " stuck on");
    add(Fault::Mode::stuck_off, " stuck off");
    add(Fault::Mode::loose, kLoose);
  }

  const PlantModel& plant_;
  std::vector<Fault> faults_;
};

/// The names of what a malfunction acts on, separated by commas; its devices and inputs in `fault`.
void describe(const PlantModel& plant, const model::Malfunction& malfunction, Fault& fault) {
  const auto add = [&](std::string_view name) {
    if (!fault.item.empty()) fault.item += ", ";
    fault.item += name;
  };
  const auto add_symbol = [&](std::uint32_t symbol) {
    add(plant.symbols[symbol].name());
    if (plant.symbols[symbol].direction == tables::Direction::event) fault.symbols.push_back(symbol);
  };
  for (const model::Effect& effect : malfunction.effects) {
    for (const tables::MalfunctionUnit& unit : effect.units) {
      add(plant.units[unit.unit].path);
      fault.units.push_back(unit.unit);
    }
    for (const std::uint32_t track : effect.tracks) add(plant.material.tracks[track].name);
    for (const tables::MalfunctionForce& force : effect.forces) add_symbol(force.symbol);
    for (const tables::MalfunctionSet& set : effect.sets) add(plant.values[set.value].name);
    if (effect.kind == MalfunctionKind::flicker) add_symbol(effect.subject);
    if (effect.kind == MalfunctionKind::lose) {
      add(controller_item(plant, effect.subject));
      fault.controllers.push_back(effect.subject);
    }
    if (effect.kind == MalfunctionKind::distort) add_symbol(plant.signals[effect.subject].row.symbol);
  }
}

}  // namespace

std::string mode_words(const Fault& fault) {
  switch (fault.mode) {
    case Fault::Mode::stuck_on:
      return "stuck on";
    case Fault::Mode::stuck_off:
      return "stuck off";
    case Fault::Mode::loose:
      return "loose contact";
    case Fault::Mode::held:
      return "keeps its number";
    case Fault::Mode::stuck:
      return "does not move";
    case Fault::Mode::slow:
      return "moves slowly";
    case Fault::Mode::lost:
      return "lost";
    case Fault::Mode::described:
      break;
  }
  return fault.malfunction;
}

std::vector<std::uint32_t> stations_of(const PlantModel& plant) {
  std::vector<std::uint32_t> stations;
  std::map<std::pair<std::string_view, std::string_view>, std::uint32_t> numbers;
  for (const model::Symbol& symbol : plant.symbols) {
    const std::pair station{symbol.reading.line(), symbol.reading.process()};
    const auto next = static_cast<std::uint32_t>(numbers.size());
    stations.push_back(symbol.reading.is_named() ? numbers.try_emplace(station, next).first->second : kNone);
  }
  return stations;
}

std::vector<std::string> add_malfunctions(PlantModel& plant, std::size_t own) {
  const std::size_t all = plant.malfunctions.size();
  for (std::size_t i = own; i < all; ++i) {
    model::Malfunction condition;
    condition.name = plant.malfunctions[i].name + std::string(kCondition);
    condition.condition = std::exchange(plant.malfunctions[i].condition, std::nullopt);
    condition.during = std::exchange(plant.malfunctions[i].during, false);
    plant.malfunctions[i].chance.reset();
    if (condition.condition) plant.malfunctions.push_back(std::move(condition));
  }
  return Adder(plant).run();
}

std::vector<Fault> described_faults(const PlantModel& plant, std::size_t from, std::size_t to) {
  std::vector<Fault> faults;
  for (std::size_t i = from; i < to; ++i) {
    Fault& fault = faults.emplace_back();
    fault.mode = Fault::Mode::described;
    fault.malfunction = plant.malfunctions[i].name;
    describe(plant, plant.malfunctions[i], fault);
    const std::string condition = fault.malfunction + std::string(kCondition);
    const auto found = std::find_if(plant.malfunctions.begin(), plant.malfunctions.end(),
                                    [&](const model::Malfunction& one) { return one.name == condition; });
    if (found != plant.malfunctions.end())
      fault.begins = static_cast<std::uint32_t>(found - plant.malfunctions.begin());
  }
  return faults;
}

std::vector<Fault> faults_of(const PlantModel& plant, std::size_t described) {
  std::vector<Fault> faults = Lister(plant).run();
  std::vector<Fault> more = described_faults(plant, 0, described);
  faults.insert(faults.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return faults;
}

}  // namespace symplant::campaign
