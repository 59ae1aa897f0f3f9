// Where numbers of two traces differ.
#include "compare/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace symplant::compare {
namespace {

double span_of(const Series& series) {
  double least = 0;
  double most = 0;
  for (const Series::Change& change : series.changes) {
    if (!std::isfinite(change.value)) continue;
    least = std::min(least, change.value);
    most = std::max(most, change.value);
  }
  return most - least;
}

double distance(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double apart = std::abs(a - b);
  return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

/// Follows both values, and the difference between them while there is one.
class Sweep {
 public:
  Sweep(const Series& of, const Limits& limits, std::vector<Difference>& differences)
      : of_(of), limits_(limits), most_(limits.tolerance * span_of(of)), differences_(differences) {}

  void go_to(tables::Time time, double expected, double actual) {
    const double apart = distance(expected, actual);
    if (apart <= most_) {
      end(time, limits_.window);
    } else if (!open_ || apart > apart_) {
      if (!open_) found_ = {Difference::Kind::deviates, &of_, time};
      open_ = true;
      apart_ = apart;
      found_.expected = expected;
      found_.actual = actual;
    }
  }

  /// What still differs at the end counts, if there was no time for more.
  void finish() { end(limits_.until, limits_.window == 0 ? -1 : limits_.window); }

 private:
  void end(tables::Time time, tables::Time longer_than) {
    if (!open_) return;
    open_ = false;
    found_.by = time - found_.time;
    if (found_.by > longer_than) differences_.push_back(found_);
  }

  const Series& of_;
  const Limits& limits_;
  double most_;
  std::vector<Difference>& differences_;
  Difference found_{};
  double apart_ = 0;
  bool open_ = false;
};

}  // namespace

void add_deviations(const Series& expected, const Series* actual, const Offsets& offsets, const Limits& limits,
                    std::vector<Difference>& differences) {
  constexpr tables::Time kLatest = std::numeric_limits<tables::Time>::max();
  const std::span<const Series::Change> ours = expected.changes;
  const std::span<const Series::Change> theirs =
      actual != nullptr ? actual->changes : std::span<const Series::Change>();
  Offsets::Translation translated(offsets);
  Sweep sweep(expected, limits, differences);
  double value = 0;
  double other = 0;
  std::size_t e = 0;
  std::size_t a = 0;
  tables::Time next = theirs.empty() ? kLatest : translated(theirs[0].time);
  for (;;) {
    const tables::Time time = std::min(e < ours.size() ? ours[e].time : kLatest, next);
    if (time == kLatest || time > limits.until) break;
    for (; e < ours.size() && ours[e].time <= time; ++e) value = ours[e].value;
    while (next <= time) {
      other = theirs[a++].value;
      next = a < theirs.size() ? translated(theirs[a].time) : kLatest;
    }
    sweep.go_to(time, value, other);
  }
  sweep.finish();
}

}  // namespace symplant::compare
