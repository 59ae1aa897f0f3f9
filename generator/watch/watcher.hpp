// Compares what units do with what their model expects.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/observer.hpp"
#include "watch/anomaly.hpp"
#include "watch/drift.hpp"
#include "watch/limits.hpp"
#include "watch/possible.hpp"
#include "watch/timers.hpp"

namespace symplant::watch {

/// What was watched.
struct Counts {
  std::size_t judged = 0;            ///< moves whose times could be judged
  std::vector<std::size_t> of_unit;  ///< moves of any kind, by unit
};

/// A unit that did something else than expected is reported once; after that it is where its events say. Calls are in
/// the order of time: time(), then for that time command() and step(). Not thread-safe.
class Watcher {
 public:
  using Report = std::function<void(const Anomaly&)>;

  /// `recorded`: by symbol. Everything given must outlive the watcher. `report` gets each anomaly when it is noticed.
  Watcher(const model::PlantModel& plant, const std::vector<bool>& recorded, const observe::Observer& observer,
          const Margin& margin, const std::vector<Statistic>& learned, Report report);

  /// Everything before `now` has happened: reports what is missing by then. O(log units) for each that is due.
  void time(Time now);
  /// An operation of a unit changed. O(1), or O(transitions) while the state of its unit is not known.
  void command(Time now, std::uint32_t symbol, bool on);
  /// O(log units), and O(transitions^2) for what may be an anomaly.
  void step(Time now, const observe::Step& step);
  /// Nothing was read for `length`, up to `now`. Forgets what was expected. O(units).
  void gap(Time now, Time length);
  /// The last time is over: what is missing by `end` is reported.
  void finish(Time end) { time(end + 1); }

  const Counts& counts() const { return counts_; }

 private:
  using Kind = Anomaly::Kind;
  using Part = Anomaly::Part;

  struct Watched {
    observe::Move expected{};     ///< the move that a timer waits for
    observe::Move canceled{};     ///< the last one whose cause ended before it left
    observe::Move loose{};        ///< a move without a cause: a timer waits for one
    Time loose_since = kUnknown;  ///< kUnknown: without a loose move
    Time contradicts = kUnknown;  ///< since when
    Time commanded = kUnknown;    ///< when an operation changed last
    Time turned = kUnknown;       ///< when it was commanded elsewhere first while it moved
    Time stepped = kUnknown;      ///< when anything happened last
    Time turned_net = 0;          ///< how long it was let move by then
    Time turned_idle = 0;         ///< for how long it was stopped then
    observe::Move failed{};       ///< a move whose command ended: a timer waits for what may be read of it
    Time failed_net = kUnknown;   ///< how long it was let move; kUnknown: no move failed
    bool reported = false;        ///< the present move has an anomaly
    std::size_t open = 0;         ///< the first anomaly while the unit is not where it should be; 0: it is

    bool is_loose() const { return loose_since != kUnknown; }
  };

  void caused(const observe::Move& move);
  void canceled(Time now, const observe::Move& move);
  void left(Time now, const observe::Move& move);
  void arrived(Time now, const observe::Move& move);
  void contradicts(Time now, const observe::Move& move);

  void wait_for(const observe::Move& move);
  void await_cause(Time now, const observe::Move& move);
  void forget_loose(std::uint32_t unit);
  void came_without_cause(Time now, const observe::Move& move);
  void judge(Part part, Time now, const observe::Move& move);
  void judge_return(Time now, const observe::Move& move);
  void turns(Time now, const observe::View& view);
  void await_failed(Time now, const observe::Move& move, Time net);
  void end_failed(Time now, const observe::Move& move);
  void did_not_arrive(Time now, const observe::Move& move, Part part, Time net, bool counts);
  void look_for_drift(Time now, const observe::Move& move);

  void fire(const Timer& timer);
  void fire_missing(const Timer& timer);
  void fire_unexpected(std::uint32_t unit);
  void fire_contradiction(const Timer& timer);
  void fire_dark(const Timer& timer);
  void fire_failed(Time now, std::uint32_t unit);

  Anomaly about(Kind kind, Part part, Time now, const observe::Move& move) const;
  void report(Anomaly anomaly, bool stays);
  std::size_t first_of(std::uint32_t unit) const;
  bool is_on(std::uint32_t symbol) const;
  static Time late_by(const observe::Move& move, const Limits& limits);
  bool is_shown(const observe::Move& move) const;

  const model::PlantModel& plant_;
  const std::vector<bool>& recorded_;
  const observe::Observer& observer_;
  const Margin margin_;
  const Report report_;
  const Possible possible_;
  std::vector<Watched> units_;
  Timers timers_;
  Drift drift_;
  Counts counts_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> failed_;  ///< in a row, by unit and state
  std::size_t numbers_ = 0;
};

}  // namespace symplant::watch
