// Collects the changes of a recording in the order in which a file has them.
#include "recording/collector.hpp"

#include <algorithm>

namespace symplant::recording {

std::uint32_t Collector::series_of(Series::Kind kind, std::string_view name, std::string_view part) {
  Series wanted{std::string(name), kind, std::string(part), {}, {}};
  const auto [found, added] = recording_.index.emplace(wanted.key(), recording_.series.size());
  if (added) {
    wanted.is_operation = is_operation_name(wanted.name) || written_.contains(wanted.name);
    recording_.series.push_back(std::move(wanted));
  }
  return static_cast<std::uint32_t>(found->second);
}

std::uint32_t Collector::symbol(Series::Kind kind, std::string_view name) {
  key_ = name;
  const auto found = recording_.index.find(key_);
  return found == recording_.index.end() ? series_of(kind, name) : static_cast<std::uint32_t>(found->second);
}

void Collector::clear() {
  recording_.series.clear();
  recording_.index.clear();
  recording_.order.clear();
  recording_.has_parts = false;
  begin_ = 0;
}

void Collector::end_time() {
  std::vector<std::uint32_t>& order = recording_.order;
  const auto begin = order.begin() + static_cast<std::ptrdiff_t>(begin_);
  const auto is_operation = [&](std::uint32_t s) { return recording_.series[s].is_operation; };
  if (!std::is_partitioned(begin, order.end(), is_operation)) std::stable_partition(begin, order.end(), is_operation);
  begin_ = order.size();
}

}  // namespace symplant::recording
