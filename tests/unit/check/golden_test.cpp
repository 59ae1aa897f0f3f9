// Every rule fires on a golden list with the stored output.
#include "support/golden.hpp"

#include <filesystem>
#include <set>

#include "check/catalogue.hpp"
#include "diag/json.hpp"
#include "diag/text.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"

namespace symplant::test {
namespace {

const std::string kFolder = std::string(SYMPLANT_SOURCE_DIR) + "/tests/golden/check/";

std::set<std::string> cases() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  }
  return names;
}

Analysed analyse_case(const std::string& name) {
  const std::string second = kFolder + name + "/second.csv";
  const std::string list = kFolder + name + "/symbols.csv";
  if (std::filesystem::exists(second)) {
    return analyse_lists({{"symbols.csv", read_bytes(list)}, {"second.csv", read_bytes(second)}});
  }
  MemoryFileSystem files;
  if (std::filesystem::exists(list)) files.files["symbols.csv"] = read_bytes(list);
  app::CompileOptions options{"symbols.csv", {}, {}, "2026-07-01"};
  for (const std::string description : {"plant.json", "learned.json"}) {
    const std::string path = kFolder + name + "/" + description;
    if (std::filesystem::exists(path)) files.files[description] = read_bytes(path);
  }
  if (files.exists("plant.json")) options.plant = "plant.json";
  if (name == "unknown-input-format") options.read.input_format = "tape";
  std::ostringstream err;
  app::Progress progress(err, false);
  Analysed result;
  if (auto compiled = app::compile(options, files, progress, result.diagnostics)) {
    result.derived = model::Derived{std::move(compiled->plant), std::move(compiled->evidence)};
  }
  return result;
}

TEST_CASE("Every rule has a golden, and every golden has a rule") {
  std::set<std::string> rules{"clean"};
  for (const diag::RuleInfo* rule : check::catalogue()) rules.insert(std::string(rule->slug));
  rules.erase("plant-too-large");  // no list of a test is that large: limits_test has it
  rules.erase("array-too-large");  // its golden would have thousands of symbols: arrays_test has it
  rules.erase("baseline-stale");   // these two are about an option: the tests of the command have them
  rules.erase("baseline-not-valid");
  CHECK(cases() == rules);
}

TEST_CASE("Every golden fires its rule with the stored output") {
  for (const std::string& name : cases()) {
    INFO("case " << name);
    const Analysed analysed = analyse_case(name);
    if (name != "clean") CHECK(analysed.count(name) >= 1);
    check_golden(kFolder + name + "/expected.txt", diag::render_text(analysed.diagnostics.all(), {.all = true}));
    check_golden(kFolder + name + "/expected.json", diag::render_json(analysed.diagnostics.all()) + "\n");
  }
}

TEST_CASE("Messages follow the style rules") {
  for (const std::string& name : cases()) {
    const Analysed analysed = analyse_case(name);
    for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
      INFO(finding.message);
      CHECK_FALSE(finding.message.empty());
      CHECK(finding.message.back() != '.');
      CHECK(finding.message.find('\n') == std::string::npos);
      // A capital at the beginning is user text, in back-ticks.
      CHECK((finding.message.front() < 'A' || finding.message.front() > 'Z'));
    }
  }
}

TEST_CASE("A clean list fires no rule") { CHECK(analyse_case("clean").fired() == ""); }

}  // namespace
}  // namespace symplant::test
