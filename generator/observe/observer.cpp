// What the devices of a plant do, as their operations and events show it.
#include "observe/observer.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "observe/causes.hpp"
#include "observe/dependents.hpp"
#include "observe/positions.hpp"
#include "observe/truth.hpp"

namespace symplant::observe {
namespace {

using model::Unit;
using Shown = Positions::Shown;

/// Of one unit within one time: more would be a fault of this code, not of the plant.
constexpr int kMostSteps = 64;

}  // namespace

class Observer::Impl {
 public:
  Impl(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution)
      : plant_(plant),
        grace_(2 * resolution),
        values_(plant.symbols.size(), 0),
        known_(plant.symbols.size(), false),
        dependents_(dependents_of(plant)),
        disabled_by_(plant.units.size()) {
    units_.reserve(plant.units.size());
    for (const Unit& unit : plant.units) units_.push_back({Positions(plant, unit, recorded)});
    for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
      for (std::uint32_t s = 0; s < plant.units[u].disables.size(); ++s) {
        for (const std::uint32_t other : plant.units[u].disables[s]) disabled_by_[other].emplace_back(u, s);
      }
    }
    view_.value = [this](std::uint32_t symbol) {
      return known_[symbol] ? std::optional(values_[symbol]) : std::nullopt;
    };
    view_.settled = [this](std::uint32_t unit, std::uint32_t state) -> std::optional<bool> {
      const Followed& followed = units_[unit];
      if (followed.state == kNone || followed.contradicts) return std::nullopt;
      return !followed.moving && followed.state == state;
    };
    view_.moving = [this](std::uint32_t unit) -> std::optional<bool> {
      const Followed& followed = units_[unit];
      // While it is in a state without an event nothing shows whether it moves.
      if (followed.state == kNone || followed.contradicts) return std::nullopt;
      if (!followed.moving && !followed.positions.is_lit(followed.state)) return std::nullopt;
      return followed.moving;
    };
  }

  void set(std::uint32_t symbol, double value) {
    if (known_[symbol] && values_[symbol] == value) return;
    known_[symbol] = true;
    values_[symbol] = value;
    if (plant_.symbols[symbol].unit != kNone) queue(plant_.symbols[symbol].unit);
    for (const std::uint32_t unit : dependents_.of_symbol[symbol]) queue(unit);
  }

  std::span<const Step> close(Time time) {
    steps_.clear();
    now_ = time;
    ++visit_;
    if (!begun_) {
      begin();
      return steps_;
    }
    // A change that has no cause yet may have one in what another unit does at the same time: it waits for that.
    std::vector<std::uint32_t> waiting;
    while (!queue_.empty() || !waiting.empty()) {
      const bool last_resort = queue_.empty();
      std::vector<std::uint32_t>& from = last_resort ? waiting : queue_;
      const std::uint32_t unit = from.back();
      from.pop_back();
      units_[unit].queued = false;
      if (!follow(unit, last_resort)) waiting.push_back(unit);
    }
    return steps_;
  }

  void forget() {
    begun_ = false;
    for (Followed& followed : units_) followed = {std::move(followed.positions)};
    queue_.clear();
  }

  View view(std::uint32_t unit) const {
    const Followed& followed = units_[unit];
    return {followed.state, followed.moving, followed.contradicts, followed.stopped_since != kUnknown, followed.since,
            followed.next};
  }

  double value(std::uint32_t symbol) const { return values_[symbol]; }

 private:
  struct Followed {
    Positions positions;
    Causes causes{};
    std::uint32_t state = kNone;
    bool moving = false;
    bool contradicts = false;
    bool queued = false;
    Time set_back = kUnknown;  ///< the cause that ended while it may have begun to move: the next move is not from rest
    int steps = 0;             ///< at the present time
    std::uint64_t visit = 0;   ///< the number of that time
    Time since = kUnknown;
    Time contradicts_since = kUnknown;
    Time stopped_since = kUnknown;  ///< kUnknown: it is not stopped
    Move next{};                    ///< what is caused, or going on
  };

  void queue(std::uint32_t unit) {
    if (units_[unit].queued || !begun_) return;
    units_[unit].queued = true;
    queue_.push_back(unit);
  }

  void queue_dependents(std::uint32_t unit) {
    for (const std::uint32_t other : dependents_.of_unit[unit]) queue(other);
  }

  /// Bits of symbols as levels, by index in `symbols`.
  Levels levels(const std::vector<std::uint32_t>& symbols) const {
    Levels levels;
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      if (!known_[symbols[i]]) continue;
      const std::uint64_t bit = std::uint64_t{1} << i;
      levels.known |= bit;
      if ((values_[symbols[i]] != 0) != plant_.symbols[symbols[i]].inverted) levels.on |= bit;
    }
    return levels;
  }

  void begin() {
    begun_ = true;
    for (std::uint32_t u = 0; u < units_.size(); ++u) {
      Followed& followed = units_[u];
      followed.queued = false;
      if (!followed.positions.shows_anything()) continue;
      const auto shown = followed.positions.at(levels(plant_.units[u].events).on, kNone);
      followed.state = shown.shown == Shown::state  ? shown.state
                       : shown.shown == Shown::dark ? followed.positions.dark_state()
                                                    : kNone;
      followed.causes.enter(plant_.units[u], followed.state, kUnknown);
    }
    queue_.clear();
    for (std::uint32_t u = 0; u < units_.size(); ++u) update_causes(u);
  }

  /// Reports what is caused now, and what no longer is.
  void update_causes(std::uint32_t u) {
    Followed& followed = units_[u];
    const Unit& unit = plant_.units[u];
    followed.causes.update(unit, levels(unit.operations), view_, now_);
    if (followed.moving || followed.state == kNone) return;
    const Cause cause = followed.causes.pending();
    const Cause before{followed.next.to, followed.next.transition, followed.next.cause};
    if (cause == before) return;
    if (before.to != kNone) {
      add(Step::Kind::canceled, followed.next);
      // It may have begun to move, which no event shows.
      if (before.since != now_ && !followed.positions.is_lit(followed.state)) followed.set_back = before.since;
    }
    followed.next = {};
    if (cause.to == kNone) return;
    followed.next = move_of(u, cause);
    add(Step::Kind::caused, followed.next);
  }

  Move move_of(std::uint32_t u, const Cause& cause) const {
    Move move;
    move.unit = u;
    move.from = units_[u].state;
    move.to = cause.to;
    move.transition = cause.transition;
    move.spring_return = cause.is_spring_return();
    move.since = units_[u].since;
    move.cause = cause.since;
    return move;
  }

  void add(Step::Kind kind, const Move& move) { steps_.push_back({kind, move}); }

  bool is_disabled(std::uint32_t u) const {
    return std::any_of(disabled_by_[u].begin(), disabled_by_[u].end(), [&](const auto& by) {
      const Followed& other = units_[by.first];
      return !other.moving && other.state == by.second;
    });
  }

  /// Whether the model lets the unit not go on with its move now.
  bool is_stopped(std::uint32_t u) const {
    const Move& move = units_[u].next;
    if (is_disabled(u)) return true;
    const Unit& unit = plant_.units[u];
    if (move.transition == kNone) return false;
    const model::Transition& transition = unit.transitions[move.transition];
    if (transition.during != kNone && holds(unit.conditions[transition.during], view_) == false) return true;
    return unit.actuation == tables::Actuation::held && transition.on != kNone &&
           !units_[u].causes.commands(unit, move.from, move.to);
  }

  /// Notes stops and turns of a move that goes on, also of one whose leaving no event shows.
  void follow_move(std::uint32_t u) {
    Followed& followed = units_[u];
    const Unit& unit = plant_.units[u];
    const bool goes_on =
        followed.next.to != kNone && (followed.moving || !followed.positions.is_lit(followed.state) || is_disabled(u));
    const bool stopped = goes_on && is_stopped(u);
    if (followed.stopped_since != kUnknown && !stopped) {
      followed.next.stopped += now_ - std::max(followed.stopped_since, followed.next.cause);
      followed.stopped_since = kUnknown;
    } else if (followed.stopped_since == kUnknown && stopped) {
      followed.stopped_since = now_;
    }
    if (!followed.moving || followed.next.to == kNone || unit.actuation == tables::Actuation::latched) return;
    const bool back = followed.causes.commands(unit, followed.next.to, followed.next.from);
    const bool springs = unit.actuation == tables::Actuation::spring && followed.next.from == unit.rest &&
                         !followed.causes.commands(unit, followed.next.from, followed.next.to);
    const bool again = followed.next.spring_return && followed.causes.commands(unit, followed.next.to, followed.state);
    if (back || springs || again) followed.next.turned = true;
  }

  /// Brings one unit up to date; false if it changed its state without a cause and may wait for one.
  bool follow(std::uint32_t u, bool last_resort) {
    Followed& followed = units_[u];
    if (std::exchange(followed.visit, visit_) != visit_) followed.steps = 0;
    if (!followed.positions.shows_anything() || ++followed.steps > kMostSteps) return true;
    update_causes(u);
    const Unit& unit = plant_.units[u];
    const std::uint64_t events = levels(unit.events).on;
    const auto shown = followed.positions.at(events, followed.moving ? followed.next.to : followed.state);
    if (shown.shown == Shown::dark) clear_contradiction(u);
    if (shown.shown == Shown::contradiction) {
      contradict(u);
    } else if (followed.contradicts && shown.shown == Shown::state) {
      end_contradiction(u, shown.state);
    } else if (shown.shown == Shown::state && (followed.moving || shown.state != followed.state)) {
      if (!followed.moving && !last_resort && !cause_of(u, shown.state).is_certain()) return false;
      arrive(u, shown.state, now_);
    } else if (shown.shown == Shown::dark && !followed.moving && followed.state != kNone &&
               followed.positions.is_lit(followed.state) && !followed.positions.fits(followed.state, events)) {
      if (!last_resort && !cause_of(u, kNone).is_certain()) return false;
      leave(u);
    }
    follow_move(u);
    return true;
  }

  Cause cause_of(std::uint32_t u, std::uint32_t to) const {
    if (units_[u].state == kNone) return {};
    return units_[u].causes.of(plant_.units[u], to, now_, grace_);
  }

  void leave(std::uint32_t u) {
    Followed& followed = units_[u];
    const Cause cause = cause_of(u, kNone);
    begin_move(u, cause);
    followed.next.left = now_;
    const bool hidden = cause.to != kNone ? !followed.positions.is_lit(cause.to) : dark_is_next(u);
    if (hidden) {
      if (cause.to == kNone) followed.next.to = followed.positions.dark_state();
      add(Step::Kind::left, followed.next);
      settle(u, followed.next.to, now_);
      return;
    }
    add(Step::Kind::left, followed.next);
    followed.moving = true;
    followed.since = now_;
    queue_dependents(u);
  }

  /// Whether the unit can only have gone to a state without an event.
  bool dark_is_next(std::uint32_t u) const { return units_[u].positions.dark_state() != kNone; }

  /// Makes `next` the move that starts now by this cause.
  void begin_move(std::uint32_t u, const Cause& cause) {
    Followed& followed = units_[u];
    const Cause before{followed.next.to, followed.next.transition, followed.next.cause};
    if (!(cause == before) || cause.to == kNone) {
      followed.next = move_of(u, cause);
      followed.stopped_since = kUnknown;
    }
    const Time set_back = std::exchange(followed.set_back, kUnknown);
    followed.next.turned = set_back != kUnknown && set_back != cause.since;
    followed.causes.leave(plant_.units[u], cause);
  }

  void arrive(std::uint32_t u, std::uint32_t state, Time time) {
    Followed& followed = units_[u];
    if (!followed.moving) {
      const Cause cause = cause_of(u, state);
      const bool shows_leaving = followed.state != kNone && followed.positions.is_lit(followed.state);
      begin_move(u, cause);
      if (shows_leaving) followed.next.left = time;
    } else if (followed.next.to != state) {
      take_other_end(u, state);
    }
    if (followed.stopped_since != kUnknown) {
      followed.next.stopped += now_ - std::max(followed.stopped_since, followed.next.cause);
    }
    followed.stopped_since = kUnknown;
    followed.next.to = state;
    followed.next.arrived = time;
    add(Step::Kind::arrived, followed.next);
    settle(u, state, now_);
  }

  /// A move ended elsewhere than it was caused to.
  void take_other_end(std::uint32_t u, std::uint32_t state) {
    Move& move = units_[u].next;
    const bool came_back = state == move.from;
    const Cause cause = came_back ? Cause{} : cause_of(u, state);
    move.turned = move.turned || came_back || move.to != kNone;
    move.to = state;
    move.transition = cause.transition;
    move.spring_return = cause.is_spring_return();
    if (!came_back) move.cause = cause.since;
  }

  void settle(std::uint32_t u, std::uint32_t state, Time time) {
    Followed& followed = units_[u];
    followed.state = state;
    followed.moving = false;
    followed.contradicts = false;
    followed.since = time;
    followed.next = {};
    followed.causes.enter(plant_.units[u], state, time);
    queue(u);
    queue_dependents(u);
  }

  void contradict(std::uint32_t u) {
    Followed& followed = units_[u];
    if (followed.contradicts) return;
    followed.contradicts = true;
    followed.contradicts_since = now_;
    Move move = followed.next;
    move.unit = u;
    move.from = followed.state;
    add(Step::Kind::contradiction, move);
    queue_dependents(u);
  }

  void clear_contradiction(std::uint32_t u) {
    if (!std::exchange(units_[u].contradicts, false)) return;
    Move settled;
    settled.unit = u;
    settled.from = units_[u].state;
    add(Step::Kind::settled, settled);
    queue_dependents(u);
  }

  void end_contradiction(std::uint32_t u, std::uint32_t state) {
    Followed& followed = units_[u];
    followed.contradicts = false;
    Move settled;
    settled.unit = u;
    settled.from = followed.state;
    settled.to = state;
    add(Step::Kind::settled, settled);
    if (state == followed.state && !followed.moving) {
      queue_dependents(u);
      return;
    }
    if (!followed.moving) {
      begin_move(u, cause_of(u, state));
      followed.moving = true;  // the end that it left showed too long: no time of leaving
    }
    arrive(u, state, followed.contradicts_since);
  }

  const model::PlantModel& plant_;
  const Time grace_;
  std::vector<double> values_;
  std::vector<bool> known_;
  Dependents dependents_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> disabled_by_;  ///< by unit: unit, state
  std::vector<Followed> units_;
  Known view_;
  std::vector<std::uint32_t> queue_;
  std::vector<Step> steps_;
  Time now_ = 0;
  std::uint64_t visit_ = 0;
  bool begun_ = false;
};

Observer::Observer(const model::PlantModel& plant, const std::vector<bool>& recorded, Time resolution)
    : impl_(std::make_unique<Impl>(plant, recorded, resolution)) {}
Observer::~Observer() = default;

void Observer::set(std::uint32_t symbol, double value) { impl_->set(symbol, value); }
std::span<const Step> Observer::close(Time time) { return impl_->close(time); }
void Observer::forget() { impl_->forget(); }
View Observer::view(std::uint32_t unit) const { return impl_->view(unit); }
double Observer::value(std::uint32_t symbol) const { return impl_->value(symbol); }

}  // namespace symplant::observe
