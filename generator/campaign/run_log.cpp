// What a run did, as far as a campaign compares it.
#include "campaign/run_log.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "symplant/trace/value_text.hpp"

namespace symplant::campaign {

using tables::Time;

void RunLog::take(const trace::Record& record) {
  using Kind = trace::Record::Kind;
  switch (record.kind) {
    case Kind::change:
      return symbols.push_back({record.time, record.value, record.of});
    case Kind::value:
      return outputs.push_back({record.time, record.value, record.of});
    case Kind::unit:
      return units.push_back({record.time, record.value & ((std::uint64_t{1} << trace::kUnitBits) - 1), record.of});
    case Kind::malfunction:
      return malfunctions.push_back({record.time, record.more ? 1U : 0U, record.of});
    case Kind::finding:
      if (record.finding == tables::FindingKind::requirement_violated && !violation) {
        violation = Violation{record.time, record.of};
      }
      return;
    default:
      return;
  }
}

double number_of(const tables::SymbolRow& symbol, std::uint64_t value) {
  if (trace::is_real(symbol.type())) return std::bit_cast<double>(value);
  return trace::is_signed(symbol.type()) ? static_cast<double>(static_cast<std::int64_t>(value))
                                         : static_cast<double>(value);
}

recording::Recording recorded(const RunLog& log, const trace::PlantNames& names, const std::vector<bool>& chosen,
                              const char* name) {
  recording::Recording recorded;
  recorded.name = name;
  recorded.end = log.end;
  std::vector<std::uint32_t> series_of(chosen.size(), tables::kNone);
  std::size_t first_of_time = 0;  // in recorded.order: operations come first at one time
  const auto sort_time = [&] {
    std::stable_partition(recorded.order.begin() + static_cast<std::ptrdiff_t>(first_of_time), recorded.order.end(),
                          [&](std::uint32_t series) { return recorded.series[series].is_operation; });
    first_of_time = recorded.order.size();
  };
  Time last = -1;
  for (const Change& change : log.symbols) {
    if (!chosen[change.of]) continue;
    if (change.time != last) sort_time();
    last = change.time;
    const tables::SymbolRow& row = names.tables().symbols[change.of];
    std::uint32_t& series = series_of[change.of];
    if (series == tables::kNone) {
      series = static_cast<std::uint32_t>(recorded.series.size());
      const auto kind =
          row.type() == tables::DataType::boolean ? recording::Series::Kind::boolean : recording::Series::Kind::number;
      recorded.series.push_back({std::string(names.symbol(change.of)), kind, {}, {}, names.is_operation(change.of)});
      recorded.index.emplace(recorded.series.back().key(), series);
    }
    recorded.series[series].changes.push_back({change.time, number_of(row, change.value)});
    recorded.order.push_back(series);
  }
  sort_time();
  return recorded;
}

}  // namespace symplant::campaign
