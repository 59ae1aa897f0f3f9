// The trace as a file: its header, its values, and a disk that fails.
#include "symplant/trace/trace_file.hpp"

#include <bit>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::test {
namespace {

using tables::DataType;
using trace::json_value;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST_CASE("Written values read back the same") {
  CHECK(json_value(DataType::boolean, 1) == "true");
  CHECK(json_value(DataType::boolean, 0) == "false");
  CHECK(json_value(DataType::int_, static_cast<std::uint64_t>(-3)) == "-3");
  CHECK(json_value(DataType::uint, 65535) == "65535");
  CHECK(json_value(DataType::lint, std::uint64_t{1} << 53) == "9007199254740992");
  CHECK(json_value(DataType::lint, (std::uint64_t{1} << 53) + 1) == "\"9007199254740993\"");
  CHECK(json_value(DataType::lint, std::uint64_t{1} << 63) == "\"-9223372036854775808\"");
  CHECK(json_value(DataType::ulint, ~std::uint64_t{0}) == "\"18446744073709551615\"");
  CHECK(json_value(DataType::real, bits(0.1F)) == "0.1");
  CHECK(json_value(DataType::lreal, bits(0.1)) == "0.1");
  CHECK(json_value(DataType::lreal, bits(std::numeric_limits<double>::infinity())) == "\"inf\"");
  CHECK(json_value(DataType::lreal, bits(std::numeric_limits<double>::quiet_NaN())) == "\"nan\"");
  for (const double value : {1e300, -2.5, 1.0 / 3.0, 5e-324, 100.0}) {
    CHECK(nlohmann::json::parse(json_value(DataType::lreal, bits(value))).get<double>() == value);
  }
}

TEST_CASE("What reaches the system while a file is written ends with a whole line") {
  const auto path = (std::filesystem::temp_directory_path() / "symplant_output_test").string();
  {
    trace::OutputFile file("trace", path);
    const std::string line(999, 'x');
    std::size_t before = 0;
    for (int i = 0; i < 1'000; ++i) {
      file.put(line.substr(0, 700));  // a line in two parts, as the writers put it
      file.put(line.substr(700));
      file.put("\n");
      const std::string written = read_bytes(path);
      if (written.size() == before) continue;
      before = written.size();
      REQUIRE(written.back() == '\n');
    }
    CHECK(before > 900'000);
  }
  CHECK(read_bytes(path).size() == 1'000'000);
  std::filesystem::remove(path);
}

TEST_CASE("The file is a header and one line per change, for any names") {
  const auto folder = std::filesystem::temp_directory_path() / "symplant_trace_test";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "trace.jsonl").string();
  const std::vector<tables::SymbolRow> symbols{
      {0, tables::kNone, 0, 2,
       tables::symbol_kind(DataType::boolean, tables::Direction::event, tables::AddressForm::none, false)}};
  const std::string names{"a \"q\"\\\n\xC3\xA4\0\0", 12};
  tables::PlantTables tables = bare_tables("p\"1", 64, 64, 0, symbols);
  tables.symbol_names = names;
  {
    trace::TraceFile file({"trace", path}, tables, 0xABC, 7);
    file.write({1'500'000'000, 1, 0});
    file.flush();
    CHECK(file.error().empty());
  }
  const std::string text = read_bytes(path);
  const std::size_t end = text.find('\n');
  const auto header = nlohmann::json::parse(text.substr(0, end));
  CHECK(header["symplant-trace"] == 1);
  CHECK(header["plant"] == "p\"1");
  CHECK(header["model_hash"] == "0000000000000abc");
  CHECK(header["seed"] == 7);
  const auto line = nlohmann::json::parse(text.substr(end + 1));
  CHECK(line["t"] == 1'500'000'000);
  CHECK(line["symbol"] == "a \"q\"\\\n\xC3\xA4");
  CHECK(line["value"] == true);
  std::filesystem::remove_all(folder);
}

TEST_CASE("A full disk ends the file and is reported once") {
  if (!std::filesystem::exists("/dev/full")) return;
  const tables::PlantTables tables = bare_tables("p", 64, 64);
  trace::TraceFile file({"trace", "/dev/full"}, tables, 0, 0);
  file.flush();
  CHECK(file.error().find("/dev/full") != std::string::npos);
}

TEST_CASE("A file that cannot be opened reports the reason") {
  const tables::PlantTables tables = bare_tables("p", 64, 64);
  const trace::TraceFile file({"trace", "/no/such/folder/trace.jsonl"}, tables, 0, 0);
  CHECK(file.error().find("/no/such/folder/trace.jsonl") != std::string::npos);
}

}  // namespace
}  // namespace symplant::test
