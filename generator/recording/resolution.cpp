// How exact the times of a recording are, by its rows.
#include "recording/resolution.hpp"

#include <algorithm>
#include <cstddef>

namespace symplant::recording {

using tables::Time;

Steps steps_of(const std::vector<Time>& times) {
  std::vector<Time> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] != times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  }
  if (steps.empty()) return {};
  std::sort(steps.begin(), steps.end());
  const auto count = [&](Time from, Time to) {
    return static_cast<std::size_t>(std::upper_bound(steps.begin(), steps.end(), to) -
                                    std::lower_bound(steps.begin(), steps.end(), from));
  };
  const Time median = steps[(steps.size() - 1) / 2];
  const std::size_t near_median = count(median - median / 10, median + median / 10);
  if (near_median * 2 >= steps.size()) return {median, near_median * 100 >= steps.size() * 95};
  for (const Time step : steps) {
    if (count(step, step + step / 10) * 20 >= steps.size()) return {step, false};
  }
  return {steps.front(), false};
}

std::vector<Gap> gaps_in(const std::vector<Time>& times, Time resolution) {
  std::vector<Gap> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const Time step = times[i] - times[i - 1];
    if (step / 3 > resolution) gaps.push_back({times[i - 1], step});
  }
  return gaps;
}

}  // namespace symplant::recording
