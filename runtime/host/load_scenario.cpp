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

scenario::OpenedFile open_file(const std::string& path) {
  std::error_code unknown;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, unknown)) {
    return {std::nullopt, file ? "it is a directory" : std::strerror(errno)};
  }
  return {std::string(std::istreambuf_iterator<char>(file), {}), ""};
}

void report_faults(const std::string& path, std::string_view text, const std::vector<json::Placed>& faults,
                   std::ostream& err) {
  for (const json::Placed& fault : std::span(faults).first(std::min(faults.size(), kShownFaults))) {
    err << index_text(path, text, fault.span) << ": error: " << shown(fault.message) << "\n";
    if (fault.related) {
      err << index_text(path, text, fault.related->span) << ": note: " << shown(fault.related->message) << "\n";
    }
  }
  if (faults.size() > kShownFaults) {
    err << fmt::format("{}: error: {} more errors are not shown\n", path, faults.size() - kShownFaults);
  }
}

}  // namespace

std::optional<scenario::Scenario> load_scenario(const std::string& path, const trace::PlantNames& names,
                                                const std::vector<bool>& carried, std::ostream& err) {
  const scenario::OpenedFile file = open_file(path);
  if (!file.text) {
    err << fmt::format("error: cannot read the scenario `{}`: {}\n", path, file.error);
    return std::nullopt;
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const auto in_folder = [&](const std::string& included) { return (folder / included).generic_string(); };
  scenario::ReadScenario read = scenario::read_scenario(
      *file.text, names, carried, [&](const std::string& included) { return open_file(in_folder(included)); });
  for (const scenario::FileFaults& found : read.faults) {
    const bool own = found.path.empty();
    report_faults(own ? path : in_folder(found.path), own ? *file.text : found.text, found.faults, err);
  }
  if (read.scenario) {
    std::vector<std::string>& files = read.scenario->files;
    std::transform(files.begin() + 1, files.end(), files.begin() + 1, in_folder);
    std::string& restore = read.scenario->restore;
    if (!restore.empty()) restore = in_folder(restore);
  }
  return std::move(read.scenario);
}

std::string scenario_summary(const std::string& path, const scenario::Scenario& scenario) {
  const auto expecting = std::count_if(scenario.steps.begin(), scenario.steps.end(),
                                       [](const scenario::Step& step) { return step.expect.has_value(); });
  std::string text = fmt::format("scenario {}: {}, {} with expectations", shown(path),
                                 plural(scenario.steps.size(), "step"), expecting);
  if (!scenario.repeats.empty()) text += fmt::format(", {}", plural(scenario.repeats.size(), "repeat"));
  if (scenario.files.size() > 1) text += fmt::format(", {} included", plural(scenario.files.size() - 1, "file"));
  return text + "\n";
}

}  // namespace symplant::host
