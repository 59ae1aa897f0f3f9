// Pairs operations and events of one unit by name, by inference and by the description.
#include "score/paired_by_task.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "name/task_reader.hpp"
#include "name/vocabulary.hpp"
#include "text/ascii.hpp"
#include "text/folding.hpp"

namespace symplant::score {
namespace {

using model::kNone;
using model::State;
using model::Transition;
using model::Unit;

/// A symbol whose task is a word of a motion.
struct MotionTask {
  std::uint32_t symbol;
  const name::ReadTask* motion;
};

const name::TaskRules kRules;  ///< the vocabulary that ships

class TaskPairs {
 public:
  explicit TaskPairs(const model::PlantModel& plant) : plant_(plant), paired_(plant.symbols.size()) {}

  std::vector<bool> run() {
    for (const Unit& unit : plant_.units) {
      if (!unit.events.empty()) pair(unit);
    }
    return std::move(paired_);
  }

 private:
  void mark(const std::vector<std::uint32_t>& side, std::uint32_t index) {
    if (index != kNone) paired_[side[index]] = true;
  }

  void pair(const Unit& unit) {
    if (unit.has_behaviour()) {
      for (std::uint32_t i = 0; i < unit.operations.size(); ++i) mark(unit.operations, i);
      for (std::uint32_t i = 0; i < unit.events.size(); ++i) mark(unit.events, i);
      return;
    }
    const bool by_task = unit.described == nullptr || !unit.described->only;
    if (by_task && !unit.operations.empty() && !pair_by_name(unit)) {
      pair_by_spring(unit);
      pair_by_sequence(unit);
      pair_by_motion(unit);
    }
    if (unit.described != nullptr) pair_by_description(unit);
  }

  /// Returns whether all symbols of the unit are paired.
  bool pair_by_name(const Unit& unit) {
    std::size_t pairs = 0;
    for (const State& state : unit.states) {
      if (state.operation == kNone || state.event == kNone) continue;
      mark(unit.operations, state.operation);
      mark(unit.events, state.event);
      ++pairs;
    }
    return pairs == unit.operations.size() && pairs == unit.events.size();
  }

  /// A spring returns to the rest position from the state that its operation leads to.
  void pair_by_spring(const Unit& unit) {
    if (unit.actuation != tables::Actuation::spring || unit.rest == kNone) return;
    const std::uint32_t event = unit.states[unit.rest].event;
    mark(unit.events, event);
    if (event != kNone && unit.states.size() == 2) mark(unit.operations, unit.states[1 - unit.rest].operation);
  }

  /// What follows by itself after the state that an operation leads to.
  void pair_by_sequence(const Unit& unit) {
    std::vector<std::uint32_t> next;
    for (const Transition& t : unit.transitions) {
      if (t.origin != model::Origin::inferred || t.on != kNone) continue;
      next.resize(unit.states.size(), kNone);
      next[t.from] = t.to;
    }
    if (next.empty()) return;
    for (const State& state : unit.states) {
      if (state.operation == kNone) continue;
      auto s = next[static_cast<std::size_t>(&state - unit.states.data())];
      for (; s != kNone && unit.states[s].operation == kNone; s = next[s]) {
        if (unit.states[s].event == kNone) continue;
        mark(unit.operations, state.operation);
        mark(unit.events, unit.states[s].event);
      }
    }
  }

  std::vector<MotionTask> motions_of(const std::vector<std::uint32_t>& symbols) {
    std::vector<MotionTask> motions;
    for (const std::uint32_t symbol : symbols) {
      const name::ReadTask& motion = motion_of(plant_.symbols[symbol].reading.task());
      if (motion.pair != name::kNoPair) motions.push_back({symbol, &motion});
    }
    return motions;
  }

  /// Few different tasks recur in many devices.
  const name::ReadTask& motion_of(std::string_view task) {
    const auto [found, added] = tasks_.try_emplace(task);
    if (!added) return found->second;
    if (!vocabulary_) vocabulary_.emplace(kRules, std::vector<name::DirectionWord>{});
    const std::string folded = text::folded(task);
    found->second = name::read_task({task}, {folded}, name::Direction::operation, kRules, *vocabulary_);
    return found->second;
  }

  /// An operation leaves the other end of its motion: O_ADV and I_RET. Several tasks of one end need equal numbers.
  void pair_by_motion(const Unit& unit) {
    const std::vector<MotionTask> operations = motions_of(unit.operations);
    if (operations.empty()) return;
    const std::vector<MotionTask> events = motions_of(unit.events);
    const auto is_end = [](const name::ReadTask& a, const name::ReadTask& b, bool same) {
      return a.pair == b.pair && (a.rest == b.rest) == same;
    };
    const auto count = [&](const std::vector<MotionTask>& tasks, const name::ReadTask& motion, bool same) {
      return std::count_if(tasks.begin(), tasks.end(),
                           [&](const MotionTask& task) { return is_end(*task.motion, motion, same); });
    };
    for (const MotionTask& operation : operations) {
      const bool only = count(operations, *operation.motion, true) == 1 && count(events, *operation.motion, false) == 1;
      for (const MotionTask& event : events) {
        if (!is_end(*event.motion, *operation.motion, false)) continue;
        if (!only && event.motion->index != operation.motion->index) continue;
        paired_[operation.symbol] = true;
        paired_[event.symbol] = true;
      }
    }
  }

  void pair_by_description(const Unit& unit) {
    for (const Transition& t : unit.transitions) {
      if (t.origin == model::Origin::given && !t.spring_return) pair_by_transition(unit, t);
    }
    for (std::uint32_t s = 0; s < unit.outputs.size(); ++s) {
      if (!unit.reaches(s)) continue;
      const bool enters = mark_outputs(unit, unit.outputs[s].enter);
      const bool leaves = mark_outputs(unit, unit.outputs[s].leave);
      if (enters || leaves) mark(unit.operations, unit.states[s].operation);
    }
  }

  void pair_by_transition(const Unit& unit, const Transition& t) {
    bool moves = mark_state(unit, t.to);
    if (!unit.outputs.empty()) moves |= mark_outputs(unit, unit.outputs[t.to].enter);
    if (unit.described->transitions[t.given].from != "*") {
      moves |= mark_state(unit, t.from);
      if (!unit.outputs.empty()) moves |= mark_outputs(unit, unit.outputs[t.from].leave);
    }
    if (!moves) return;
    mark(unit.operations, t.on);
    if (t.when != kNone) mark_operations(unit.conditions[t.when]);
  }

  /// Returns whether an event reports the state.
  bool mark_state(const Unit& unit, std::uint32_t state) {
    mark(unit.events, unit.states[state].event);
    return unit.states[state].event != kNone;
  }

  bool mark_outputs(const Unit& unit, const std::vector<std::pair<std::uint32_t, bool>>& outputs) {
    for (const auto& output : outputs) mark(unit.events, output.first);
    return !outputs.empty();
  }

  /// Of a condition that moves an event.
  void mark_operations(const condition::Tree& tree) {
    if (tree.kind == condition::Tree::Kind::atom && tree.atom.kind == condition::Atom::Kind::bit &&
        plant_.symbols[tree.atom.of].direction == tables::Direction::operation) {
      paired_[tree.atom.of] = true;
    }
    for (const condition::Tree& child : tree.children) mark_operations(child);
  }

  const model::PlantModel& plant_;
  std::vector<bool> paired_;
  std::optional<name::Vocabulary> vocabulary_;
  text::ByName<name::ReadTask> tasks_;
};

}  // namespace

std::vector<bool> paired_by_task(const model::PlantModel& plant) { return TaskPairs(plant).run(); }

}  // namespace symplant::score
