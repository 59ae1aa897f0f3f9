// Explanations of random plants agree with what the engine does: nothing that could act stays as it is.
#include <algorithm>

#include "lower/lower.hpp"
#include "property/random_plant.hpp"
#include "why_support.hpp"

namespace symplant::test {
namespace {

constexpr std::uint64_t kPlants = 150;
constexpr int kMostInstants = 200;

/// What the explanations of all plants mentioned.
struct Mentioned {
  std::size_t settled = 0;
  std::size_t midway = 0;
  std::size_t needs = 0;
  std::size_t halted_parts = 0;
  std::size_t circles = 0;
  std::size_t requirements = 0;
};

class Explained {
 public:
  Explained(const tables::PlantTables& tables, Mentioned& mentioned)
      : tables_(tables),
        mentioned_(mentioned),
        names_(tables),
        history_(names_),
        recorder_(tables, 1 << 16),
        explainer_(names_),
        plant_(tables) {
    recorder_.attach(plant_);
    for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) symbols_.emplace(names_.symbol(i), i);
    for (std::uint32_t i = 0; i < tables.units.size(); ++i) units_.emplace(names_.unit(i), i);
    to(0);
  }

  /// False if the plant has too many instants.
  bool act(const property::Action& action) {
    using Kind = property::Action::Kind;
    const auto symbol = symbols_.find(action.what);
    const auto unit = units_.find(action.what);
    if (action.kind == Kind::set && symbol != symbols_.end()) write(symbol->second, action.value);
    if (action.kind == Kind::set_input && symbol != symbols_.end()) plant_.set_input(symbol->second, action.value);
    if (action.kind == Kind::force && symbol != symbols_.end()) force(symbol->second, true, action.value);
    if (action.kind == Kind::release && symbol != symbols_.end()) force(symbol->second, false, 0);
    if (action.kind == Kind::set_state && unit != units_.end()) {
      plant_.set_state(unit->second, static_cast<std::uint8_t>(action.value));
    }
    if (action.kind == Kind::advance || action.kind == Kind::run) return advance(plant_.now() + action.time);
    if (action.kind == Kind::advance_to_due && plant_.next_due() < tables::kNever / 2)
      return advance(plant_.next_due());
    return true;
  }

 private:
  void write(std::uint32_t symbol, std::uint64_t value) {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    if (row.direction() == tables::Direction::event) return;
    if (row.type() == tables::DataType::boolean) {
      plant_.set_operation(row.index, value != 0);
    } else {
      plant_.set_operation_value(row.index, value);
    }
  }
  void force(std::uint32_t symbol, bool forced, std::uint64_t value) {
    forced ? plant_.force(symbol, value) : plant_.release(symbol);
    history_.force(symbol, forced, plant_.now());
  }
  bool advance(tables::Time target) {
    for (int i = 0; plant_.next_due() < target; ++i) {
      if (i == kMostInstants) return false;
      to(plant_.next_due());
    }
    to(target);
    check();
    return true;
  }
  void to(tables::Time time) {
    plant_.advance_to(time, &recorder_);
    recorder_.drain([this](const trace::Record& record) { history_.apply(record); });
  }

  void check() {
    using Kind = why::Reference::Kind;
    for (std::uint32_t u = 0; u < std::min<std::size_t>(tables_.units.size(), 40); ++u) check_unit(u);
    for (std::uint32_t s = 0; s < std::min<std::size_t>(tables_.symbols.size(), 40); ++s) lines({Kind::symbol, s});
    for (std::uint32_t r = 0; r < tables_.requirements.size(); ++r) {
      if (!lines({Kind::requirement, r}).empty()) ++mentioned_.requirements;
    }
    for (std::uint32_t l = 0; l < tables_.material.locations(); ++l) {
      for (const std::string& line : lines({Kind::location, l})) check_part(line);
    }
    for (std::uint32_t t = 0; t < tables_.material.transfers.size(); ++t) {
      const std::string line = lines({Kind::transfer, t}).front();
      INFO(line);
      CHECK(contains(line, ": "));
    }
    for (std::uint32_t w = 0; w < tables_.material.work.size(); ++w) lines({Kind::work, w});
    for (std::uint32_t s = 0; s < tables_.material.sources.size(); ++s) lines({Kind::source, s});
  }
  void check_unit(std::uint32_t unit) {
    const auto text = lines({why::Reference::Kind::unit, unit});
    const plant::UnitView view = plant_.unit(unit);
    INFO(text.front());
    if (view.frozen || view.disabled) return;
    ++(view.stopped_midway ? mentioned_.midway : mentioned_.settled);
    if (!view.moving || view.stopped_midway) CHECK(contains(text.front(), ": "));
  }
  void check_part(const std::string& line) {
    const std::size_t end = line.find(", does not move");
    if (end == line.npos) return;
    ++mentioned_.halted_parts;
    INFO(line);
    CHECK((contains(line, "does not move: ") || contains(line, "see above") || contains(line, "a circle")));
  }
  std::vector<std::string> lines(const why::Reference& thing) {
    std::vector<std::string> all;
    for (const why::StateView* view : views()) {
      all = why::lines_of(explainer_.why(thing, *view));
      for (const std::string& line : all) {
        INFO(line);
        CHECK(line.find_first_not_of(' ') <= 4 * 5);
        CHECK(!contains(line, "about to have"));
        if (contains(line, "needs")) ++mentioned_.needs;
        if (contains(line, "a circle")) ++mentioned_.circles;
      }
    }
    return all;
  }
  /// The records alone, then with the plant.
  std::vector<const why::StateView*> views() {
    alone_.emplace(history_, plant_.now(), nullptr);
    exact_.emplace(history_, plant_.now(), &plant_);
    return {&*alone_, &*exact_};
  }

  const tables::PlantTables& tables_;
  Mentioned& mentioned_;
  trace::PlantNames names_;
  trace::History history_;
  trace::Recorder recorder_;
  why::Explainer explainer_;
  plant::OwnedPlant plant_;
  std::optional<why::RecordedView> alone_;
  std::optional<why::RecordedView> exact_;
  std::map<std::string, std::uint32_t, std::less<>> symbols_;
  std::map<std::string, std::uint32_t, std::less<>> units_;
};

TEST_CASE("Everything in random plants has a reason, and nothing is about to act") {
  Mentioned mentioned;
  for (std::uint64_t seed = 1; seed <= kPlants; ++seed) {
    const property::DrawnPlant drawn =
        property::random_plant(seed, {.behaviours = false, .most_units = 60, .values = false});
    const lower::EngineTables lowered = lower::lower(drawn.model);
    const tables::PlantTables tables = lowered.tables();
    INFO("plant " << seed);
    Explained explained(tables, mentioned);
    for (const property::Action& action : property::random_stimulus(seed, drawn.model)) {
      if (!explained.act(action)) break;
    }
  }
  CHECK(mentioned.settled > 1000);
  CHECK(mentioned.midway > 20);
  CHECK(mentioned.needs > 1000);
  CHECK(mentioned.halted_parts > 20);
  CHECK(mentioned.circles > 0);
  CHECK(mentioned.requirements > 100);
}

}  // namespace
}  // namespace symplant::test
