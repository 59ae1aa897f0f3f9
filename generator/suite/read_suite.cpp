// Reads the suite.json of a folder, and finds its cases.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "suite/suite.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"

namespace symplant::suite {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<std::pair<Speed, std::string_view>, 3> kSpeeds{
    {{Speed::normal, "normal"}, {Speed::fast, "fast"}, {Speed::slow, "slow"}}};
constexpr std::string_view kSuiteFile = "suite.json";

/// The bytes of a file, or why it cannot be read.
std::optional<std::string> bytes_of(const std::string& path, std::string& error) {
  std::error_code unknown;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path, unknown)) {
    error = fmt::format("cannot read `{}`: {}", path, file ? "it is a directory" : std::strerror(errno));
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

class SuiteReader {
 public:
  explicit SuiteReader(std::string folder) : path_((fs::path(folder) / kSuiteFile).generic_string()) {
    suite_.folder = std::move(folder);
  }

  ReadSuite run() {
    std::string error;
    const auto bytes = bytes_of(path_, error);
    if (!bytes) return {std::nullopt, {error + "; a suite is a folder with this file"}, {}};
    text_ = *bytes;
    const json::Document document = json::parse(text_);
    for (const json::Placed& fault : document.faults) place(fault);
    if (!errors_.empty()) return {std::nullopt, std::move(errors_), {}};
    static const json::Schema schema(suite_schema());
    faults_ = schema.check(*document.root);
    if (faults_.empty()) take(*document.root);
    for (const json::Placed& fault : json::locate(text_, faults_)) place(fault);
    if (errors_.empty()) find_cases();
    if (!errors_.empty()) return {std::nullopt, std::move(errors_), {}};
    return {std::move(suite_), {}, std::move(warnings_)};
  }

 private:
  void place(const json::Placed& fault) {
    const json::LineColumn at = json::line_and_column(text_, fault.span.begin);
    errors_.push_back(fmt::format("{}:{}:{}: {}", path_, at.line, at.column, fault.message));
  }

  std::string in_folder(const std::string& file) const { return (fs::path(suite_.folder) / file).generic_string(); }

  void take(const Json& root) {
    suite_.plant = in_folder(root["plant"].get<std::string>());
    if (root.contains("programs")) {
      for (const Json& program : root["programs"]) {
        const std::string controller = program.value("controller", "");
        suite_.programs.push_back((controller.empty() ? "" : controller + "=") +
                                  in_folder(program["file"].get<std::string>()));
      }
    }
    if (root.contains("window")) suite_.how.window = duration(root, "window");
    if (root.contains("limit")) suite_.limit = duration(root, "limit");
    if (root.contains("align")) {
      const std::string align = root["align"].get<std::string>();
      suite_.how.align = compare::align_of(align);
      if (suite_.how.align == compare::Align::symbol) suite_.how.align_symbol = align;
    }
    if (root.contains("tolerance")) {
      const auto tolerance = compare::parse_tolerance(root["tolerance"].get<std::string>());
      if (!tolerance) fault("tolerance", "is not a share: write a number and %, such as `2.5%`", root);
      suite_.how.tolerance = tolerance.value_or(0);
    }
    if (root.contains("only")) suite_.how.only = root["only"].get<std::vector<std::string>>();
    if (root.contains("before")) suite_.before = in_folder(root["before"].get<std::string>());
  }

  void fault(const char* key, const std::string& what, const Json& root) {
    faults_.push_back({json::child("", key), fmt::format("`{}` {}", root[key].get<std::string>(), what)});
  }

  tables::Time duration(const Json& root, const char* key) {
    const auto time = tables::parse_duration(root[key].get<std::string>());
    if (!time) fault(key, "is not a duration: write a number and ns, us, ms, s, min or h, such as `30ms`", root);
    return time.value_or(0);
  }

  void find_cases() {
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(suite_.folder, failed)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".json" || path.filename() == kSuiteFile || !entry.is_regular_file()) continue;
      if (!suite_.before.empty() && fs::equivalent(path, suite_.before, failed)) continue;
      if (is_case(path.generic_string())) suite_.cases.push_back(path.stem().generic_string());
    }
    std::sort(suite_.cases.begin(), suite_.cases.end());
    check_names();
    find_references_without_case();
    if (suite_.cases.empty()) {
      errors_.push_back(fmt::format("`{}` has no case: a case is a scenario, a file NAME.json with `symplant-scenario`",
                                    suite_.folder));
    }
  }

  /// The reference traces of a case `a.fast` and of `a` on the fast plant would be one file.
  void check_names() {
    for (const std::string& name : suite_.cases) {
      for (const Speed speed : {Speed::fast, Speed::slow}) {
        const std::string end = "." + std::string(speed_name(speed));
        if (!name.ends_with(end)) continue;
        errors_.push_back(fmt::format(
            "{}: the name of a case must not end with `{}`, as that names a reference trace; rename the file",
            suite_.scenario(name), end));
      }
    }
  }

  void find_references_without_case() {
    std::set<std::string> known;
    for (const std::string& name : suite_.cases) {
      for (const Speed speed : {Speed::normal, Speed::fast, Speed::slow}) known.insert(suite_.reference(name, speed));
    }
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(suite_.folder, failed)) {
      const std::string path = entry.path().generic_string();
      if (!path.ends_with(".reference.jsonl") || known.contains(path)) continue;
      warnings_.push_back(fmt::format("`{}` is the reference trace of no case; rename or remove it", path));
    }
    std::sort(warnings_.begin(), warnings_.end());
  }

  /// A file that cannot be read is a case, which then fails.
  bool is_case(const std::string& path) {
    std::string error;
    const auto bytes = bytes_of(path, error);
    if (!bytes) return true;
    const json::Document document = json::parse(*bytes);
    if (document.root == nullptr) return true;
    const bool scenario = document.root->is_object() && document.root->contains("symplant-scenario");
    if (!scenario && document.root->is_object() && document.root->contains("steps")) {
      warnings_.push_back(
          fmt::format("`{}` has `steps`, but no `symplant-scenario`, and is not run; add the key", path));
    }
    return scenario;
  }

  std::string path_;
  std::string text_;
  Suite suite_;
  std::vector<json::Fault> faults_;
  std::vector<std::string> errors_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::string_view speed_name(Speed speed) {
  return std::find_if(kSpeeds.begin(), kSpeeds.end(), [&](const auto& one) { return one.first == speed; })->second;
}

std::optional<Speed> speed_of(std::string_view name) {
  const auto* const found =
      std::find_if(kSpeeds.begin(), kSpeeds.end(), [&](const auto& one) { return one.second == name; });
  return found == kSpeeds.end() ? std::nullopt : std::optional(found->first);
}

std::string Suite::scenario(const std::string& name) const {
  return (fs::path(folder) / (name + ".json")).generic_string();
}

std::string Suite::reference(const std::string& name, Speed speed) const {
  const std::string variant = speed == Speed::normal ? "" : "." + std::string(speed_name(speed));
  return (fs::path(folder) / (name + variant + ".reference.jsonl")).generic_string();
}

ReadSuite read_suite(const std::string& folder) { return SuiteReader(folder).run(); }

}  // namespace symplant::suite
