// Checks that no output file of a run is also an input or another output.
#include "symplant/host/files_apart.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace symplant::host {
namespace {

namespace fs = std::filesystem;

struct Output {
  std::string_view option;
  std::string path;
};

/// A pipe or a device: several outputs may share it, and it is never replaced.
bool is_device(const std::string& path) {
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  return is_standard_output(path) || (fs::exists(status) && !fs::is_regular_file(status));
}

std::vector<Output> outputs_of(const RunOptions& options) {
  std::vector<Output> outputs{{"--trace", options.trace}, {"--vcd", options.vcd},     {"--findings", options.findings},
                              {"--junit", options.junit}, {"--stats", options.stats}, {"--save", options.save}};
  outputs.erase(
      std::remove_if(outputs.begin(), outputs.end(), [](const Output& output) { return output.path.empty(); }),
      outputs.end());
  if (options.trace_limit == trace::kNoLimit) return outputs;
  for (const std::string* path : {&options.trace, &options.vcd}) {
    if (!path->empty() && !is_device(*path)) outputs.push_back({"--trace-limit", *path + ".1"});
  }
  return outputs;
}

/// Whether two paths are one file, also through links, and also if the file does not exist yet.
bool same_file(const std::string& a, const std::string& b) {
  if (is_standard_output(a) || is_standard_output(b)) return is_standard_output(a) && is_standard_output(b);
  if (is_device(a)) return false;
  std::error_code unknown;
  if (fs::equivalent(a, b, unknown) && !unknown) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), unknown);
  const fs::path second = fs::weakly_canonical(fs::absolute(b), unknown);
  return first == second;
}

}  // namespace

bool is_standard_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

bool uses_standard_output(const RunOptions& options) {
  const std::vector<Output> outputs = outputs_of(options);
  return std::any_of(outputs.begin(), outputs.end(), [](const Output& o) { return is_standard_output(o.path); });
}

bool files_are_apart(const RunOptions& options, std::span<const std::string_view> inputs, std::ostream& err) {
  std::vector<std::string> read(inputs.begin(), inputs.end());
  if (!options.scenario.empty()) read.push_back(options.scenario);
  if (!options.replay.empty()) read.push_back(options.replay);
  if (!options.resume.empty()) read.push_back(options.resume);
  const std::vector<Output> outputs = outputs_of(options);
  bool apart = true;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (std::any_of(read.begin(), read.end(), [&](const std::string& r) { return same_file(output.path, r); })) {
      err << "error: `" << output.path << "` is an input: writing there would destroy it; name another file\n";
      apart = false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!same_file(output.path, outputs[j].path)) continue;
      err << "error: " << outputs[j].option << " and " << output.option << " would both write `" << output.path
          << "`: name another file for one of them\n";
      apart = false;
    }
  }
  return apart;
}

}  // namespace symplant::host
