// Ready profiles: each loads, and reads a list in its style as the stored text says.
#include "naming/profiles.hpp"

#include <array>
#include <filesystem>
#include <string>

#include "base/file_system.hpp"
#include "name/symbol_reader.hpp"
#include "naming/load.hpp"
#include "read/readers.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {
namespace {

const std::string kFolder = std::string(SYMPLANT_SOURCE_DIR) + "/tests/golden/naming/";

std::shared_ptr<const naming::LoadedNaming> load(const std::string& file, const base::FileSystem& files) {
  naming::NamingReference reference;
  reference.file = file;
  diag::Diagnostics diagnostics;
  auto loaded = naming::load_naming(reference, files, diagnostics);
  for (const diag::Diagnostic& finding : diagnostics.all()) UNSCOPED_INFO(finding.message);
  CHECK(diagnostics.all().empty());
  REQUIRE(loaded != nullptr);
  return loaded;
}

read::SymbolTable table_of(const std::string& path) {
  MemoryFileSystem files;
  files.files["list.csv"] = read_bytes(path);
  diag::Diagnostics diagnostics;
  auto table = read::read_symbol_list("list.csv", {}, files, diagnostics);
  REQUIRE(table);
  return std::move(*table);
}

std::optional<name::Side> side_of(std::string_view address) {
  if (address.starts_with("%I") || address.starts_with("X")) return name::Side::event;
  if (address.starts_with("%Q") || address.starts_with("Y")) return name::Side::operation;
  return std::nullopt;
}

std::string_view side_text(const std::optional<name::Side>& side) {
  if (!side) return "no side";
  constexpr std::array<std::string_view, 3> kTexts{"operation", "event", "internal"};
  return kTexts[static_cast<std::size_t>(*side)];
}

std::string_view role_text(name::Role role) {
  constexpr std::array<std::string_view, 5> kTexts{"", ", operator", ", data", ", constant", ", none"};
  return kTexts[static_cast<std::size_t>(role)];
}

/// "S415_CLAMP2: event of ADV, by motion after the device".
std::string line_of(const name::RuleReading& reading, const name::Naming& naming) {
  if (reading.outcome == name::Outcome::ignored) return "ignored";
  if (reading.outcome == name::Outcome::no_rule) return "no rule";
  return std::string(reading.path) + ": " + std::string(side_text(reading.side)) + " of " +
         std::string(reading.task.canonical) + std::string(role_text(reading.role)) + ", by " +
         naming.rules[reading.rule].name;
}

TEST_CASE("Every profile loads, has its file's name and a description") {
  const MemoryFileSystem no_files;
  for (const naming::Profile& profile : naming::profiles()) {
    INFO(profile.name);
    CHECK(load("@" + std::string(profile.name), no_files)->rule->naming().name == profile.name);
    CHECK(profile.summary().size() > 20);
    CHECK(naming::find_profile(profile.name) == &profile);
  }
}

TEST_CASE("Every file in the folder of the profiles is one") {
  std::size_t count = 0;
  const std::string folder = std::string(SYMPLANT_SOURCE_DIR) + "/generator/naming/profiles";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    INFO(entry.path().string());
    CHECK(naming::find_profile(entry.path().stem().string()) != nullptr);
    ++count;
  }
  CHECK(count == naming::profiles().size());
}

TEST_CASE("Every profile reads a list in its style as stored") {
  const MemoryFileSystem no_files;
  for (const naming::Profile& profile : naming::profiles()) {
    const std::string path = kFolder + std::string(profile.name);
    INFO(path);
    const auto loaded = load("@" + std::string(profile.name), no_files);
    const read::SymbolTable table = table_of(path + ".csv");
    name::SymbolReader reader(loaded->rule);
    std::string text;
    for (const read::ListRow& row : table.rows) {
      const name::RuleReading reading =
          reader.read({row.name, row.comment, table.extra_of(row).parent_comment,
                       side_of(row.iec_address.empty() ? row.vendor_address : row.iec_address)});
      text += std::string(row.comment.empty() ? row.name : row.comment) + " -> " +
              line_of(reading, loaded->rule->naming()) + "\n";
    }
    check_golden(path + ".txt", text);
  }
}

}  // namespace
}  // namespace symplant::test
