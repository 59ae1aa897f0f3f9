// Writes a recording as JSON lines.
#include "recording/write_json_lines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "symplant/trace/value_text.hpp"

namespace symplant::recording {
namespace {

std::string number_text(double value) {
  constexpr double kExact = 9007199254740992;  // 2^53
  if (std::isnan(value)) return "\"nan\"";
  if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
  if (std::floor(value) == value && std::abs(value) <= kExact) return std::to_string(static_cast<std::int64_t>(value));
  return fmt::format("{}", value);
}

}  // namespace

void write_json_lines(const Recording& recording, base::TextSink& sink) {
  base::PartCollector parts(sink);
  parts.add(fmt::format("{{\"symplant-trace\":1{},\"every\":{},\"end\":{}}}\n",
                        recording.of_plant ? "" : ",\"recorded\":true", recording.resolution, recording.end));
  std::vector<std::string> names;  // as JSON
  names.reserve(recording.series.size());
  for (const Series& series : recording.series) names.push_back(trace::json_string(series.name));
  std::vector<std::size_t> next(recording.series.size(), 0);
  auto gap = recording.gaps.begin();
  const auto add_gaps = [&](tables::Time until) {
    for (; gap != recording.gaps.end() && gap->begin <= until; ++gap) {
      parts.add(fmt::format("{{\"t\":{},\"gap\":{}}}\n", gap->begin, gap->length));
    }
  };
  for (const std::uint32_t s : recording.order) {
    const Series& series = recording.series[s];
    const Series::Change& change = series.changes[next[s]++];
    if (series.kind == Series::Kind::parts) continue;
    add_gaps(change.time - 1);
    const bool is_boolean = series.kind == Series::Kind::boolean;
    parts.add(fmt::format("{{\"t\":{},\"symbol\":{},\"value\":{}}}\n", change.time, names[s],
                          !is_boolean         ? number_text(change.value)
                          : change.value != 0 ? "true"
                                              : "false"));
  }
  add_gaps(recording.end);
  parts.add(fmt::format("{{\"t\":{}}}\n", recording.end));
  parts.finish();
}

void settle_kinds(Recording& recording, const std::function<std::optional<Series::Kind>(const std::string&)>& kind_of) {
  for (Series& series : recording.series) {
    if (series.may_be_number && kind_of(series.name) == Series::Kind::number) series.kind = Series::Kind::number;
  }
}

}  // namespace symplant::recording
