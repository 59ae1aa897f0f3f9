// What a trace or a recording holds.
#include "recording/recording.hpp"

#include <algorithm>

namespace symplant::recording {

const Series* Recording::find(const Series& same) const {
  const auto found = index.find(same.key());
  return found == index.end() ? nullptr : &series[found->second];
}

bool is_operation_name(std::string_view name) { return name.find("_O_") != name.npos; }

void order_operations(Recording& recording) {
  std::vector<std::uint32_t>& order = recording.order;
  std::vector<std::size_t> next(recording.series.size(), 0);
  const auto is_operation = [&](std::uint32_t s) { return recording.series[s].is_operation; };
  auto begin = order.begin();  // of the changes of one time
  tables::Time time = 0;
  for (auto at = begin; at != order.end(); ++at) {
    const tables::Time now = recording.series[*at].changes[next[*at]++].time;
    if (now != time) {
      std::stable_partition(begin, at, is_operation);
      begin = at;
    }
    time = now;
  }
  std::stable_partition(begin, order.end(), is_operation);
}

}  // namespace symplant::recording
