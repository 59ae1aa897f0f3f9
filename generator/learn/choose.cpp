// Chooses between operations that an event follows equally well.
#include "learn/choose.hpp"

#include <algorithm>
#include <utility>

namespace symplant::learn {
namespace {

/// The longest scan of a PLC that answers an event.
constexpr Time kAnswer = tables::kSecond / 20;

/// What an observation is worth that only the right operation shows: about 150 to 1.
constexpr double kEvidence = 5;

class Chooser {
 public:
  Chooser(const std::vector<EventCauses>& events, std::vector<bool> used, const Timeline& timeline)
      : events_(events), used_(std::move(used)), timeline_(timeline), choices_(events.size()) {}

  std::vector<Choice> run() {
    std::vector<std::vector<Cause>> open(events_.size());
    for (std::size_t e = 0; e < events_.size(); ++e) {
      open[e] = likely(events_[e]);
      if (open[e].size() == 1) settle(e, open[e].front());
    }
    for (std::size_t e = 0; e < events_.size(); ++e) {
      if (open[e].size() > 1) settle_open(e, std::move(open[e]));
    }
    return std::move(choices_);
  }

 private:
  /// The causes that are not clearly less probable than another one by all that is observed.
  std::vector<Cause> likely(const EventCauses& event) const {
    std::vector<Cause> causes;
    std::copy_if(event.on.begin(), event.on.end(), std::back_inserter(causes),
                 [](const Cause& cause) { return !cause.same_reading; });
    if (causes.empty()) return causes;
    double least = causes.front().cost;
    std::erase_if(causes, [&](const Cause& cause) { return cause.cost > least + 2 * kEvidence + kClearly; });
    drop_opposite(causes);
    for (Cause& cause : causes) {
      if (ends_with(event, cause.edge)) cause.cost -= kEvidence;
      if (is_reset_by(event, cause.edge)) cause.cost -= kEvidence;
      least = std::min(least, cause.cost);
    }
    std::erase_if(causes, [&](const Cause& cause) { return cause.cost > least + kClearly; });
    return causes;
  }

  /// Leaves the operation that is on of two that are opposite.
  void drop_opposite(std::vector<Cause>& causes) const {
    const std::vector<Cause> all = causes;
    std::erase_if(causes, [&](const Cause& cause) {
      return !cause.edge.on && std::any_of(all.begin(), all.end(), [&](const Cause& other) {
        return other.edge.on && are_opposite(cause.edge.symbol, other.edge.symbol);
      });
    });
  }

  /// Whether one operation is off while the other one is on, as those of a valve with two coils may be. Then the event
  /// is that of the one which is on.
  bool are_opposite(std::uint32_t a, std::uint32_t b) const {
    return change_at_once(timeline_.tracks[a].rises, timeline_.tracks[b].falls) &&
           change_at_once(timeline_.tracks[a].falls, timeline_.tracks[b].rises);
  }

  /// Whether 95 % of changes are in one reading with others. One may not be: at the beginning both are off.
  bool change_at_once(const std::vector<Time>& changes, const std::vector<Time>& others) const {
    const auto is_at_once = [&](Time time) {
      const auto other = std::lower_bound(others.begin(), others.end(), time - timeline_.resolution);
      return other != others.end() && *other <= time + timeline_.resolution;
    };
    const auto count = static_cast<std::size_t>(std::count_if(changes.begin(), changes.end(), is_at_once));
    return !changes.empty() && count + std::max<std::size_t>(1, changes.size() / 20) >= changes.size();
  }

  /// Whether the other change of the operation may cause the event's changes to off. Leaving an end often takes less
  /// than a reading.
  bool ends_with(const EventCauses& event, const EdgeOf& edge) const {
    const auto of_other = std::find_if(event.off.begin(), event.off.end(), [&](const Cause& cause) {
      return cause.edge.symbol == edge.symbol && cause.edge.on != edge.on;
    });
    return of_other != event.off.end() && is_constant(*of_other, timeline_) && is_only_cause(*of_other) &&
           of_other->excess_over(event.off.front()) <= kClearly;
  }

  /// Whether the PLC ends the operation as soon as it sees the event.
  bool is_reset_by(const EventCauses& event, const EdgeOf& edge) const {
    const Follows answer =
        follow(Edges(timeline_.tracks[event.event], true), Edges(timeline_.tracks[edge.symbol], !edge.on), timeline_);
    return answer.changes >= kLeastChanges && answer.hits >= hits_needed(answer.changes) &&
           answer.most <= kAnswer + 2 * timeline_.resolution;
  }

  bool are_together(const Cause& a, const Cause& b) const {
    const Time between = a.follows.median - b.follows.median;
    return (between < 0 ? -between : between) <= timeline_.resolution;
  }

  bool qualifies(const Cause& cause) const { return is_followed(cause, timeline_) && is_only_cause(cause); }

  void settle(std::size_t e, const Cause& cause) {
    if (!qualifies(cause)) return;
    choices_[e].causes.push_back(cause);
    if (cause.edge.on) used_[cause.edge.symbol] = true;
  }

  /// An operation that drives another event is less probable, and so is one that changes earlier.
  void settle_open(std::size_t e, std::vector<Cause> causes) {
    const auto is_used = [&](const Cause& cause) { return cause.edge.on && used_[cause.edge.symbol]; };
    if (!std::all_of(causes.begin(), causes.end(), is_used)) std::erase_if(causes, is_used);
    const Cause cause = nearest(causes);
    std::erase_if(causes, [&](const Cause& other) { return !are_together(cause, other); });
    if (causes.size() == 1) {
      settle(e, cause);
    } else if (qualifies(cause)) {
      choices_[e].causes = std::move(causes);
    }
  }

  static const Cause& nearest(const std::vector<Cause>& causes) {
    return *std::min_element(causes.begin(), causes.end(),
                             [](const Cause& a, const Cause& b) { return a.follows.median < b.follows.median; });
  }

  const std::vector<EventCauses>& events_;
  std::vector<bool> used_;  ///< by symbol: an event follows its changes to on
  const Timeline& timeline_;
  std::vector<Choice> choices_;
};

}  // namespace

std::vector<Choice> choose(const std::vector<EventCauses>& events, const std::vector<bool>& used,
                           const Timeline& timeline) {
  return Chooser(events, used, timeline).run();
}

}  // namespace symplant::learn
