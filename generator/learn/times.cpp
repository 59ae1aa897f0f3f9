// From moves to `after`, `takes` and `overrun`.
#include "learn/times.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "learn/clusters.hpp"
#include "learn/proposal.hpp"

namespace symplant::learn {
namespace {

constexpr Time kSmallResolutions = 2;
constexpr std::size_t kLeastRests = 4;

using Span = Time (*)(const TimedMove&);

constexpr Span kBeforeLeaving = [](const TimedMove& move) { return move.left - move.cause; };
constexpr Span kMoving = [](const TimedMove& move) { return move.arrived - move.left; };
constexpr Span kWhole = [](const TimedMove& move) { return move.arrived - move.cause - move.stopped; };

LearnedTime sorted_time(std::vector<Sample> samples, const std::vector<Source>& sources) {
  LearnedTime time;
  time.samples = std::move(samples);
  std::sort(time.samples.begin(), time.samples.end(), [](const Sample& a, const Sample& b) {
    if (a.duration != b.duration) return a.duration < b.duration;
    return a.input != b.input ? a.input < b.input : a.at < b.at;
  });
  for (const Sample& sample : time.samples) {
    time.resolution = std::max(time.resolution, sources[sample.input].resolution);
  }
  time.clusters = clusters_of(time.samples, time.resolution);
  time.statistics = statistics_of(kept_durations(time.samples, time.clusters), time.resolution);
  return time;
}

/// What a time of the model is on average; 0 for one that a formula gives.
Time mean_of_model(const description::Duration& duration) {
  switch (duration.kind) {
    case description::Duration::Kind::uniform:
      return duration.a + (duration.b - duration.a) / 2;
    case description::Duration::Kind::seconds:
      return 0;
    default:
      return duration.a;
  }
}

LearnedTime time_of(std::vector<Sample> samples, const std::vector<Source>& sources) {
  LearnedTime time = sorted_time(std::move(samples), sources);
  time.proposed = proposal_of(kept_durations(time.samples, time.clusters), time.resolution);
  return time;
}

Time resolution_of(const std::vector<Source>& sources) {
  Time coarsest = 0;
  for (const Source& source : sources) coarsest = std::max(coarsest, source.resolution);
  return coarsest;
}

/// The moves that began at rest. No event shows when a device comes to a state without one; a cause that begins before
/// that turns it back, or makes it go on later, so that its move is shorter or longer than others. How long that takes
/// shows in the half of the moves with the longest rests: what rested no longer than one that differs from all of these
/// is left out.
std::vector<TimedMove> rested(const std::vector<TimedMove>& moves, Time resolution) {
  const auto is_unsure = [](const TimedMove& move) { return move.rest != observe::kUnknown && move.shows_arrival(); };
  std::vector<Time> rests;
  for (const TimedMove& move : moves) {
    if (is_unsure(move)) rests.push_back(move.rest);
  }
  if (rests.size() < kLeastRests) return moves;
  const auto middle = rests.begin() + static_cast<std::ptrdiff_t>(rests.size() / 2);
  std::nth_element(rests.begin(), middle, rests.end());
  Time least = tables::kNever;
  Time most = 0;
  for (const TimedMove& move : moves) {
    if (!is_unsure(move) || move.rest < *middle) continue;
    least = std::min(least, kWhole(move));
    most = std::max(most, kWhole(move));
  }
  Time too_short = -1;
  const Time tolerance = kSmallResolutions * resolution;
  for (const TimedMove& move : moves) {
    if (!is_unsure(move) || move.rest >= *middle) continue;
    if (kWhole(move) < least - tolerance || kWhole(move) > most + tolerance) too_short = std::max(too_short, move.rest);
  }
  std::vector<TimedMove> kept;
  std::copy_if(moves.begin(), moves.end(), std::back_inserter(kept),
               [&](const TimedMove& move) { return !is_unsure(move) || move.rest > too_short; });
  return kept;
}

class Learner {
 public:
  Learner(const model::Unit& unit, const TransitionMoves& moves, const std::vector<Source>& sources)
      : moves_(moves), sources_(sources), usable_(rested(moves.moves, resolution_of(sources))) {
    if (moves.transition != kNone) transition_ = &unit.transitions[moves.transition];
    for (const TimedMove& move : usable_) {
      const bool shows_leaving = move.shows_leaving() && move.stopped == 0;  // as samples_of() takes them
      leaves_ = leaves_ || shows_leaving;
      arrives_ = arrives_ || move.shows_arrival();
      both_ = both_ || (shows_leaving && move.shows_arrival());
      unstopped_ = unstopped_ || (move.shows_arrival() && move.stopped == 0);
    }
  }

  LearnedTransition learn(const GivenBefore& given) const {
    LearnedTransition learned{moves_.from, moves_.to, moves_.transition, {}, {}};
    if (transition_ == nullptr) {
      learned.takes = arrives_ ? whole(0) : std::optional<LearnedTime>();  // the return of a spring has no `after`
    } else if (both_) {
      divide(learned);
      learned.resets_after = !learned.after && (given.after || !transition_->after.is_zero());
      learned.resets_takes = !learned.takes && (given.takes || !transition_->takes.is_zero());
    } else if (arrives_) {
      (is_automatic() ? learned.after : learned.takes) =
          whole(mean_of_model(is_automatic() ? transition_->takes : transition_->after));
    } else if (leaves_) {
      learn_leaving(learned, given);
    }
    return learned;
  }

 private:
  bool is_automatic() const { return transition_->on == kNone; }

  /// Both ends of moves are seen.
  void divide(LearnedTransition& learned) const {
    LearnedTime after = measured(kBeforeLeaving, true, true);
    LearnedTime takes = measured(kMoving, true, true);
    const bool short_after = is_small(after);
    const bool short_takes = is_small(takes);
    if (is_automatic() && short_takes) {
      learned.after = whole(0);
    } else if (short_after) {
      learned.takes = whole(0);
    } else {
      learned.after = std::move(after);
      learned.takes = std::move(takes);
    }
  }

  /// Only when moves begin is seen.
  void learn_leaving(LearnedTransition& learned, const GivenBefore& given) const {
    LearnedTime after = measured(kBeforeLeaving, true, false);
    if (after.samples.empty()) return;  // all were stopped
    if (is_automatic() || !is_small(after)) {
      learned.after = std::move(after);
    } else {
      learned.resets_after = given.after || !transition_->after.is_zero();
    }
  }

  /// Whether the resolution does not show that it is more than 0.
  static bool is_small(const LearnedTime& time) {
    return time.statistics.median <= kSmallResolutions * time.resolution;
  }

  /// From cause to arrival, without the part that the other time of the model has.
  LearnedTime whole(Time other) const {
    std::vector<Sample> samples = samples_of(kWhole, false, true);
    for (Sample& sample : samples) sample.duration = std::max<Time>(0, sample.duration - other);
    return time_of(std::move(samples), sources_);
  }

  LearnedTime measured(Span span, bool leaving, bool arrival) const {
    return time_of(samples_of(span, leaving, arrival), sources_);
  }

  std::vector<Sample> samples_of(Span span, bool leaving, bool arrival) const {
    std::vector<Sample> samples;
    samples.reserve(usable_.size());
    for (const TimedMove& move : usable_) {
      if ((leaving && !move.shows_leaving()) || (arrival && !move.shows_arrival())) continue;
      if (leaving && move.stopped > 0) continue;     // before it left, or later: nothing shows which
      if (unstopped_ && move.stopped > 0) continue;  // the times of a stop are less exact
      samples.push_back({std::max<Time>(0, span(move)), move.cause, move.input, moves_.unit});
    }
    return samples;
  }

  const TransitionMoves& moves_;
  const std::vector<Source>& sources_;
  const std::vector<TimedMove> usable_;
  bool unstopped_ = false;
  const model::Transition* transition_ = nullptr;  ///< null: the return of a spring
  bool leaves_ = false;
  bool arrives_ = false;
  bool both_ = false;
};

}  // namespace

LearnedTime overrun_time_of(std::vector<Sample> samples, const std::vector<Source>& sources) {
  LearnedTime time = sorted_time(std::move(samples), sources);
  time.proposed = overrun_of(kept_durations(time.samples, time.clusters), time.resolution);
  return time;
}

LearnedTransition learn_transition(const model::Unit& unit, const TransitionMoves& moves,
                                   const std::vector<Source>& sources, const GivenBefore& given) {
  return Learner(unit, moves, sources).learn(given);
}

}  // namespace symplant::learn
