// A comparison for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "diag/visible_text.hpp"
#include "symplant/trace/words.hpp"

namespace symplant::compare {
namespace {

constexpr std::size_t kMostLines = 20;
constexpr std::size_t kMostNames = 20;

std::string names_of(const std::vector<const Series*>& series) {
  std::string text;
  for (std::size_t i = 0; i < std::min(series.size(), kMostNames); ++i) {
    text += (i == 0 ? "" : ", ") + fmt::format("`{}`", name_of(*series[i]));
  }
  return text + (series.size() > kMostNames ? ", ..." : "");
}

}  // namespace

void write_text(const Comparison& comparison, base::TextSink& sink) {
  const auto put = [&](const std::string& line) { sink.put(diag::visible(line) + "\n"); };
  put(fmt::format("{} (expected, to {}) | {} (actual, to {}); window {}", comparison.expected->name,
                  trace::seconds(comparison.expected->end), comparison.actual->name,
                  trace::seconds(comparison.actual->end), trace::seconds(comparison.window)));
  if (!comparison.not_recorded.empty()) {
    put(fmt::format("not recorded in one of them, not compared: {}", names_of(comparison.not_recorded)));
  }
  const std::size_t shown = std::min(comparison.differences.size(), kMostLines);
  for (std::size_t i = 0; i < shown; ++i) put(sentence(comparison.differences[i]));
  if (shown < comparison.differences.size()) {
    put(fmt::format("... and {} more; of each element:", comparison.differences.size() - shown));
    for (const auto& [series, differences] : by_series(comparison)) {
      if (series == nullptr) continue;
      put(fmt::format("{:6}  `{}`, first {}", differences.size(), name_of(*series), sentence(*differences.front())));
    }
  }
  put(summary(comparison));
}

}  // namespace symplant::compare
