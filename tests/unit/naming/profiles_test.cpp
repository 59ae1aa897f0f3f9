// Ready profiles: each loads, and reads and pairs a list in its style as the stored text says.
#include "naming/profiles.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/file_system.hpp"
#include "name/symbol_reader.hpp"
#include "naming/load.hpp"
#include "naming/naming_file.hpp"
#include "naming/naming_text.hpp"
#include "pairing/pairing.hpp"
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

std::optional<name::Direction> side_of(std::string_view address) {
  if (address.starts_with("%I") || address.starts_with("X")) return name::Direction::event;
  if (address.starts_with("%Q") || address.starts_with("Y")) return name::Direction::operation;
  return std::nullopt;
}

/// A list in the style of a profile, read by it and paired.
class ReadList {
 public:
  ReadList(std::shared_ptr<const name::CompiledNaming> naming, const std::string& path)
      : table_(table_of(path)), reader_(naming) {
    for (const read::ListRow& row : table_.rows) {
      const auto side = side_of(row.iec_address.empty() ? row.vendor_address : row.iec_address);
      REQUIRE(side);
      readings_.push_back(reader_.read({row.name, row.comment, table_.extra_of(row).parent_comment, side}));
      inputs_.push_back({nullptr, row.name, *side, row.type == "BOOL"});
    }
    for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i].reading = &readings_[i];
    pairing_ = pairing::pair(*naming, inputs_, pairing::Extent::linked);
    states_.resize(inputs_.size());
    for (const pairing::Facet& facet : pairing_.facets) {
      for (const pairing::Member& member : facet.members) {
        states_[member.input] = std::string(facet.unit_path()) + " " + member.task;
      }
    }
  }

  /// A line a symbol: "S415_SOL_CLAMP2_ADV | motion after the device | operation S415_CLAMP2 ADV".
  std::string text() const {
    std::string text;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const read::ListRow& row = table_.rows[i];
      text += std::string(row.name) + (row.comment.empty() ? "" : " (" + std::string(row.comment) + ")") + " | " +
              rule_of(readings_[i]) + " | " + account_of(i) + "\n";
    }
    return text;
  }

 private:
  std::string rule_of(const name::Reading& reading) const {
    if (reading.account == name::Account::ignored || reading.account == name::Account::no_rule) return "-";
    return reader_.naming().naming().rules[reading.rule].name;
  }

  std::string account_of(std::size_t input) const {
    const name::Account account = pairing_.accounts[input];
    if (name::is_unpaired(account)) return "unpaired";
    if (account != name::Account::modelled) {
      std::string text(name::account_key(account));
      std::replace(text.begin(), text.end(), '_', ' ');
      return text;
    }
    return (inputs_[input].side == name::Direction::operation ? "operation " : "event ") + states_[input];
  }

  read::SymbolTable table_;
  name::SymbolReader reader_;
  std::vector<name::Reading> readings_;
  std::vector<pairing::Input> inputs_;
  pairing::Pairing pairing_;
  std::vector<std::string> states_;
};

TEST_CASE("Every profile loads, has its file's name and a description") {
  const MemoryFileSystem no_files;
  for (const naming::Profile& profile : naming::profiles()) {
    INFO(profile.name);
    CHECK(load("@" + std::string(profile.name), no_files)->rule->naming().name == profile.name);
    CHECK(profile.summary().size() > 20);
    CHECK(naming::find_profile(profile.name) == &profile);
  }
}

TEST_CASE("A profile that is written as text reads as the same rule") {
  const MemoryFileSystem no_files;
  for (const naming::Profile& profile : naming::profiles()) {
    INFO(profile.name);
    const std::string text = naming::naming_text(load("@" + std::string(profile.name), no_files)->rule->naming());
    const naming::NamingReading reading = naming::read_naming(text);
    CHECK(reading.syntax.empty());
    CHECK(reading.faults.empty());
    REQUIRE(reading.naming);
    CHECK(naming::naming_text(*reading.naming) == text);
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

TEST_CASE("The example of the manual is paired as the manual says") {
  const std::string folder = std::string(SYMPLANT_SOURCE_DIR) + "/examples/naming/";
  MemoryFileSystem files;
  files.files["naming.json"] = read_bytes(folder + "naming.json");
  const ReadList list(load("naming.json", files)->rule, folder + "side-line.csv");
  check_golden(kFolder + "example.txt", list.text());
}

TEST_CASE("Every profile reads and pairs a list in its style as stored") {
  const MemoryFileSystem no_files;
  for (const naming::Profile& profile : naming::profiles()) {
    const std::string path = kFolder + std::string(profile.name);
    INFO(path);
    const auto loaded = load("@" + std::string(profile.name), no_files);
    check_golden(path + ".txt", ReadList(loaded->rule, path + ".csv").text());
  }
}

}  // namespace
}  // namespace symplant::test
