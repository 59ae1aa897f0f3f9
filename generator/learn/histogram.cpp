// Intervals and counts of a histogram.
#include "learn/histogram.hpp"

#include <algorithm>
#include <array>

#include "learn/proposal.hpp"

namespace symplant::learn {
namespace {

constexpr Time kMostIntervals = 60;
constexpr Time kModelReach = 3;

struct Axis {
  Time least;
  Time most;

  void include(Time time) {
    least = std::min(least, time);
    most = std::max(most, time);
  }
};

/// 1, 2 or 5 times a power of ten: the least that divides a length into few intervals.
Time nice_step(Time length, Time least) {
  for (Time ten = 1;; ten *= 10) {
    for (const Time factor : {1, 2, 5}) {
      if (factor * ten >= least && length / (factor * ten) < kMostIntervals) return factor * ten;
    }
  }
}

Axis axis_of(const LearnedTime& time, const description::Duration& model) {
  const Statistics& of = time.statistics;
  Axis range{of.min, of.max};
  const bool random = time.proposed.kind == description::Duration::Kind::uniform;
  range.include(time.proposed.a);
  if (random) range.include(time.proposed.b);
  const bool is_shown = model.kind != description::Duration::Kind::seconds && model.a <= kModelReach * range.most &&
                        kModelReach * model.a >= range.least;
  if (is_shown) {
    range.include(model.a);
    if (model.kind == description::Duration::Kind::uniform) range.include(std::min(model.b, kModelReach * range.most));
  }
  const Time margin = std::max({(range.most - range.least) / 10, range.most / 20, 2 * time.resolution, Time{1}});
  return {std::max<Time>(0, range.least - margin), range.most + margin};
}

}  // namespace

Histogram histogram_of(const LearnedTime& time, const description::Duration& model) {
  const Axis range = axis_of(time, model);
  Histogram histogram;
  histogram.step = nice_step(range.most - range.least, std::max(time.resolution / 2, digit_of(time.resolution)));
  histogram.from = range.least / histogram.step * histogram.step - histogram.step / 2;
  const auto count = static_cast<std::size_t>((range.most - histogram.from) / histogram.step + 1);
  histogram.counts.resize(count);
  histogram.outliers.resize(count);
  std::vector<bool> is_outlier(time.samples.size());
  for (const std::size_t i : time.clusters.outliers) is_outlier[i] = true;
  for (std::size_t i = 0; i < time.samples.size(); ++i) {
    const Time above = std::max<Time>(0, time.samples[i].duration - histogram.from);
    const std::size_t at = std::min(static_cast<std::size_t>(above / histogram.step), count - 1);
    ++(is_outlier[i] ? histogram.outliers : histogram.counts)[at];
  }
  return histogram;
}

}  // namespace symplant::learn
