// A comparison as JUnit XML, for build servers.
#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "symplant/trace/junit_xml.hpp"

namespace symplant::compare {
namespace {

constexpr std::size_t kMostSentences = 20;  ///< of a test case

std::string failure_of(const std::vector<const Difference*>& differences) {
  std::string text;
  for (std::size_t i = 0; i < std::min(differences.size(), kMostSentences); ++i) {
    text += (i == 0 ? "" : "\n") + sentence(*differences[i]);
  }
  if (differences.size() > kMostSentences) {
    text += "\n... and " + counted(differences.size() - kMostSentences, "difference") + " more";
  }
  return text;
}

}  // namespace

void write_junit(const Comparison& comparison, base::TextSink& sink) {
  std::unordered_map<std::string, const std::vector<const Difference*>*> failed;
  const auto groups = by_series(comparison);
  for (const auto& [series, differences] : groups) {
    failed.emplace(series == nullptr ? std::string() : series->key(), &differences);
  }
  std::vector<trace::TestCase> cases;
  const auto add = [&](std::string name, const std::string& key) {
    const auto found = failed.find(key);
    const bool well = found == failed.end();
    cases.push_back({std::move(name),
                     well ? comparison.expected->end : found->second->front()->time,
                     well ? std::string() : failure_of(*found->second),
                     {}});
  };
  for (const Series* const series : comparison.compared) add(name_of(*series), series->key());
  add("end of the traces", "");
  sink.put(trace::junit_xml(comparison.actual->name, cases, comparison.expected->end));
}

}  // namespace symplant::compare
