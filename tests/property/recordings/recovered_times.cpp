// Which true times learning has found.
#include "property/recordings/recovered_times.hpp"

#include <algorithm>
#include <optional>

namespace symplant::property {
namespace {

using description::Duration;
using learn::LearnedTime;
using learn::LearnedTransition;
using tables::kNone;
using tables::Time;

struct Range {
  Time least = 0;
  Time most = 0;
  int random = 0;  ///< of how many random times it is the sum

  friend bool operator==(const Range&, const Range&) = default;
};

Range range_of(const Duration& duration) {
  const bool random = duration.kind == Duration::Kind::uniform;
  return {duration.a, random ? duration.b : duration.a, random ? 1 : 0};
}

Range operator+(const Range& a, const Range& b) { return {a.least + b.least, a.most + b.most, a.random + b.random}; }

struct TrueTimes {
  Range after;
  Range takes;

  friend bool operator==(const TrueTimes&, const TrueTimes&) = default;
};

/// The true times of a transition or of a spring's return; nothing if several that count as one differ.
std::optional<TrueTimes> true_times(const model::Unit& unit, const LearnedTransition& learned) {
  if (learned.transition == kNone) {
    const auto found = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& t) {
      return t.from == learned.from && t.to == learned.to && (t.on != kNone || t.spring_return);
    });
    const Duration travel = Duration::fixed(unit.travel);
    return TrueTimes{{}, range_of(found == unit.transitions.end() ? travel : found->takes)};
  }
  const model::Transition& of = unit.transitions[learned.transition];
  const TrueTimes times{range_of(of.after), range_of(of.takes)};
  for (const model::Transition& one : unit.transitions) {
    const bool alike = one.from == of.from && one.to == of.to && one.on == of.on && !one.spring_return;
    if (alike && !(times == TrueTimes{range_of(one.after), range_of(one.takes)})) return std::nullopt;
  }
  return times;
}

std::string range_text(const Range& range) {
  const auto ms = [](Time time) { return std::to_string(time / tables::kMillisecond); };
  return range.least == range.most ? ms(range.least) : ms(range.least) + ".." + ms(range.most);
}

class Judge {
 public:
  Judge(const model::PlantModel& real, const learn::Learned& learned, std::size_t least,
        std::vector<std::string>& misses)
      : real_(real), learned_(learned), least_(least), misses_(misses) {}

  RecoveredTimes run() {
    for (const learn::LearnedGroup& group : learned_.groups) {
      if (group.units.size() != 1) continue;  // several devices: they have different true times
      for (const LearnedTransition& transition : group.times.transitions) judge(group.times.unit, transition);
    }
    return counts_;
  }

 private:
  void judge(std::uint32_t unit, const LearnedTransition& learned) {
    if (!learned.after && !learned.takes) return;
    const std::size_t moves = (learned.takes ? learned.takes : learned.after)->statistics.count;
    if (moves < least_) {
      ++counts_.few;
      return;
    }
    const std::optional<TrueTimes> times = true_times(real_.units[unit], learned);
    if (!times) return;
    name_ = std::string(real_.units[unit].path) + " " + real_.units[unit].states[learned.from].name + "->" +
            real_.units[unit].states[learned.to].name + " #" +
            (learned.transition == kNone ? "return" : std::to_string(learned.transition)) + " of " +
            std::to_string(moves) + " moves: ";
    if (learned.after && learned.takes) {
      judge(range_of(learned.after->proposed), times->after, learned.after->resolution);
      judge(range_of(learned.takes->proposed), times->takes, learned.takes->resolution);
      return;
    }
    // One time has both: the other one stays what the description says.
    const LearnedTime& time = learned.after ? *learned.after : *learned.takes;
    Range other;
    if (learned.transition != kNone) {
      const model::Transition& of = learned_.plant->units[unit].transitions[learned.transition];
      other = range_of(learned.after ? of.takes : of.after);
      if (learned.after ? learned.resets_takes : learned.resets_after) other = {};
    }
    const bool shows_only_leaving = learned.after && !is_lit(unit, learned.to);
    judge(shows_only_leaving ? range_of(time.proposed) : range_of(time.proposed) + other,
          shows_only_leaving ? times->after : times->after + times->takes, time.resolution);
  }

  bool is_lit(std::uint32_t unit, std::uint32_t state) const { return real_.units[unit].states[state].event != kNone; }

  void judge(const Range& proposed, const Range& truth, Time resolution) {
    if (truth.random > 1) return;  // no range of a sum is promised
    Recovered& counts = truth.random == 0 ? counts_.constant : counts_.random;
    ++counts.times;
    const bool within = proposed.least >= truth.least - resolution && proposed.most <= truth.most + resolution;
    const bool same_kind = (proposed.random == 0) == (truth.random == 0);
    if (same_kind) ++counts.of_kind;
    if (!within) ++counts.outside;
    const bool right = within && same_kind;
    if (right) ++counts.right;
    const bool wide = (proposed.most - proposed.least) * 10 >= (truth.most - truth.least) * 8;
    if (right && wide) ++counts.wide;
    if (!right || !wide) misses_.push_back(name_ + range_text(proposed) + " instead of " + range_text(truth));
  }

  const model::PlantModel& real_;
  const learn::Learned& learned_;
  const std::size_t least_;
  std::vector<std::string>& misses_;
  RecoveredTimes counts_;
  std::string name_;
};

}  // namespace

Recovered& Recovered::operator+=(const Recovered& other) {
  times += other.times;
  right += other.right;
  wide += other.wide;
  of_kind += other.of_kind;
  outside += other.outside;
  return *this;
}

RecoveredTimes& RecoveredTimes::operator+=(const RecoveredTimes& other) {
  constant += other.constant;
  random += other.random;
  few += other.few;
  return *this;
}

RecoveredTimes recovered_times(const model::PlantModel& real, const learn::Learned& learned, std::size_t least,
                               std::vector<std::string>& misses) {
  return Judge(real, learned, least, misses).run();
}

}  // namespace symplant::property
