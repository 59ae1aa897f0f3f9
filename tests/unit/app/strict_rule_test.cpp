// The rule that applies without --naming is the profile `strict`, read as any naming rule is: the models are equal.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app_support.hpp"
#include "naming/load.hpp"
#include "naming/naming_text.hpp"

namespace symplant::test {
namespace {

namespace fs = std::filesystem;

/// The model of a list or plant.json as JSON; empty if it has none.
std::string model_of(const std::string& plant, const std::vector<std::string>& naming = {}) {
  base::DiskFileSystem files;
  std::vector<std::string> arguments = {"model", "--format", "json", plant};
  arguments.insert(arguments.end(), naming.begin(), naming.end());
  return run_tool(arguments, files).out;
}

/// The files of a folder that have a model, other than descriptions that give a naming rule. A model whose rule reads
/// nothing would compare nothing: `devices` counts those that have devices.
std::size_t compare_models(const fs::path& folder, const std::string& written) {
  std::size_t devices = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string path = entry.path().string();
    if (path.ends_with(".json") &&
        (entry.path().filename() != "plant.json" || read_bytes(path).find("\"naming\"") != std::string::npos)) {
      continue;
    }
    const std::string model = model_of(path);
    if (model.empty()) continue;
    INFO(path);
    CHECK(model_of(path, {"--naming", "@strict"}) == model);
    CHECK(model_of(path, {"--naming", written}) == model);
    if (model.find("\"path\"") != std::string::npos) ++devices;
  }
  return devices;
}

/// A naming.json with the profile as the tool writes rules, so that no text of the profile itself is compared.
class WrittenRule {
 public:
  WrittenRule() : path_((fs::temp_directory_path() / ("strict-" + std::to_string(::getpid()) + ".json")).string()) {
    std::ofstream(path_) << naming::naming_text(naming::strict_naming()->naming(), {});
  }
  ~WrittenRule() { fs::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST_CASE("The examples have the same models without --naming, with the profile strict, and with its text") {
  const WrittenRule rule;
  CHECK(compare_models(SYMPLANT_SOURCE_DIR "/examples", rule.path()) >= 20);
}

TEST_CASE("Real lists have the same models without --naming, with the profile strict, and with its text") {
  const char* const corpus = std::getenv("SYMPLANT_CORPUS");
  if (corpus == nullptr) return;
  const WrittenRule rule;
  compare_models(corpus, rule.path());
}

TEST_CASE("Names that break the levels of a rule are findings, also under a custom rule") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text(bits({"P_AGV_O_RUN", "P_AGV_I_RUN", "P_AGV_I_", "P_AGV_X_RUN", "P_A.B_I_RUN"}));
  files.files["own.json"] = R"({"symplant-naming": 1, "units": "device",
    "rules": [{"source": "name", "exact": true, "pattern": "{process}_{device}_{direction}_{task}",
               "fields": {"direction": {"I": "event", "O": "operation"}}}]})";
  const ToolRun run = run_tool({"model", "list.csv", "--naming", "own.json"}, files);
  CHECK(run.code == 0);
  CHECK_THAT(run.out, Catch::Matchers::ContainsSubstring("P_AGV: "));
  CHECK_THAT(run.out, Catch::Matchers::ContainsSubstring("its name does not follow the naming rule"));
}

}  // namespace
}  // namespace symplant::test
