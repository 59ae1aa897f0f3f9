// Every naming rule of the manual loads.
#include <sstream>
#include <string>
#include <vector>

#include "naming/load.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {
namespace {

/// The JSON blocks of docs/naming.md; parts of a rule are completed.
std::vector<std::string> rules_of_manual() {
  std::istringstream page(read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/docs/naming.md"));
  std::vector<std::string> rules;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) {
      inside = line == "```jsonc";
      if (inside) rules.emplace_back();
    } else if (inside) {
      rules.back() += line + "\n";
    }
  }
  for (std::string& rule : rules) {
    if (rule.starts_with('"')) {
      const bool has_rules = rule.find("\"rules\":") != std::string::npos;
      rule = "{\"symplant-naming\": 1, " + std::string(has_rules ? "" : "\"rules\": [{\"pattern\": \"{device}\"}], ") +
             rule + "}";
    }
  }
  return rules;
}

TEST_CASE("Every naming rule of the manual loads") {
  const std::vector<std::string> rules = rules_of_manual();
  CHECK(rules.size() >= 11);
  for (const std::string& rule : rules) {
    INFO(rule);
    MemoryFileSystem files;
    files.files["naming.json"] = rule;
    naming::NamingReference reference;
    reference.file = "naming.json";
    diag::Diagnostics diagnostics;
    const auto loaded = naming::load_naming(reference, files, diagnostics);
    for (const diag::Diagnostic& finding : diagnostics.all()) UNSCOPED_INFO(finding.message);
    CHECK(loaded != nullptr);
  }
}

TEST_CASE("The manual begins with the naming rule of the example") {
  const std::string example = read_bytes(std::string(SYMPLANT_SOURCE_DIR) + "/examples/naming/naming.json");
  CHECK(rules_of_manual().front() == "// naming.json\n" + example);
}

}  // namespace
}  // namespace symplant::test
