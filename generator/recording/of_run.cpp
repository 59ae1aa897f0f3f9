// The records of a run as a recording.
#include "recording/of_run.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "symplant/trace/value_text.hpp"

namespace symplant::recording {

double number_of(const tables::SymbolRow& symbol, std::uint64_t value) {
  if (trace::is_real(symbol.type())) return std::bit_cast<double>(value);
  return trace::is_signed(symbol.type()) ? static_cast<double>(static_cast<std::int64_t>(value))
                                         : static_cast<double>(value);
}

Recording of_run(std::span<const RunChange> changes, tables::Time end, const trace::PlantNames& names,
                 const std::vector<bool>& chosen, std::string name) {
  Recording recorded;
  recorded.name = std::move(name);
  recorded.end = end;
  std::vector<std::uint32_t> series_of(chosen.size(), tables::kNone);
  std::size_t first_of_time = 0;  // in recorded.order: operations come first at one time
  const auto sort_time = [&] {
    std::stable_partition(recorded.order.begin() + static_cast<std::ptrdiff_t>(first_of_time), recorded.order.end(),
                          [&](std::uint32_t series) { return recorded.series[series].is_operation; });
    first_of_time = recorded.order.size();
  };
  tables::Time last = -1;
  for (const RunChange& change : changes) {
    if (!chosen[change.of]) continue;
    if (change.time != last) sort_time();
    last = change.time;
    const tables::SymbolRow& row = names.tables().symbols[change.of];
    std::uint32_t& series = series_of[change.of];
    if (series == tables::kNone) {
      series = static_cast<std::uint32_t>(recorded.series.size());
      const auto kind = row.type() == tables::DataType::boolean ? Series::Kind::boolean : Series::Kind::number;
      recorded.series.push_back({std::string(names.symbol(change.of)), kind, {}, {}, names.is_operation(change.of)});
      recorded.index.emplace(recorded.series.back().key(), series);
    }
    recorded.series[series].changes.push_back({change.time, number_of(row, change.value)});
    recorded.order.push_back(series);
  }
  sort_time();
  return recorded;
}

}  // namespace symplant::recording
