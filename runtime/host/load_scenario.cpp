// Reads the scenario of a run from its file.
#include "symplant/host/load_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "symplant/host/words.hpp"
#include "symplant/scenario/read_scenario.hpp"

namespace symplant::host {
namespace {

constexpr std::size_t kShownFaults = 100;  // each location costs a pass over the text

std::string index_text(const std::string& path, std::string_view text, json::Span span) {
  const json::LineColumn at = json::line_and_column(text, span.begin);
  return fmt::format("{}:{}:{}", path, at.line, at.column);
}

std::optional<std::string> read_file(const std::string& path, std::ostream& err) {
  std::error_code unknown;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, unknown)) {
    err << fmt::format("error: cannot read the scenario `{}`: {}\n", path,
                       file ? "it is a directory" : std::strerror(errno));
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::optional<scenario::Scenario> load_scenario(const std::string& path, const trace::PlantNames& names,
                                                const std::vector<bool>& carried, std::ostream& err) {
  const auto text = read_file(path, err);
  if (!text) return std::nullopt;
  scenario::ReadScenario read = scenario::read_scenario(*text, names, carried);
  for (const json::Placed& fault : std::span(read.faults).first(std::min(read.faults.size(), kShownFaults))) {
    err << index_text(path, *text, fault.span) << ": error: " << shown(fault.message) << "\n";
    if (fault.related) {
      err << index_text(path, *text, fault.related->span) << ": note: " << shown(fault.related->message) << "\n";
    }
  }
  if (read.faults.size() > kShownFaults) {
    err << fmt::format("{}: error: {} more errors are not shown\n", path, read.faults.size() - kShownFaults);
  }
  return std::move(read.scenario);
}

std::string scenario_summary(const std::string& path, const scenario::Scenario& scenario) {
  const auto expecting = std::count_if(scenario.steps.begin(), scenario.steps.end(),
                                       [](const scenario::Step& step) { return step.expect.has_value(); });
  return fmt::format("scenario {}: {}, {} with expectations\n", shown(path), plural(scenario.steps.size(), "step"),
                     expecting);
}

}  // namespace symplant::host
