// Values in scenarios: every type, its bounds, and invalid values.
#include "symplant/scenario/value.hpp"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/strings.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::test {
namespace {

using tables::DataType;

/// The value as a trace writes it, or the message.
std::string read(DataType type, const char* text) {
  const auto value = scenario::read_value(type, nlohmann::json::parse(text));
  if (const auto* message = std::get_if<std::string>(&value)) return *message;
  return trace::json_value(type, std::get<std::uint64_t>(value));
}

TEST_CASE("A BOOL is true or false and nothing else") {
  CHECK(read(DataType::boolean, "true") == "true");
  CHECK(read(DataType::boolean, "false") == "false");
  CHECK(contains(read(DataType::boolean, "1"), "expected true or false for a BOOL, but found `1`"));
  CHECK(contains(read(DataType::boolean, "\"true\""), "for a BOOL"));
}

TEST_CASE("Integers must be in the range of their type") {
  struct Range {
    DataType type;
    const char* least;
    const char* most;
    const char* below;
    const char* above;
  };
  const std::vector<Range> ranges = {
      {DataType::sint, "-128", "127", "-129", "128"},
      {DataType::int_, "-32768", "32767", "-32769", "32768"},
      {DataType::dint, "-2147483648", "2147483647", "-2147483649", "2147483648"},
      {DataType::usint, "0", "255", "-1", "256"},
      {DataType::uint, "0", "65535", "-1", "65536"},
      {DataType::udint, "0", "4294967295", "-1", "4294967296"},
      {DataType::byte, "0", "255", "-1", "256"},
      {DataType::word, "0", "65535", "-1", "65536"},
      {DataType::dword, "0", "4294967295", "-1", "4294967296"},
      {DataType::lint, "\"-9223372036854775808\"", "\"9223372036854775807\"", "\"-9223372036854775809\"",
       "\"9223372036854775808\""},
      {DataType::ulint, "0", "\"18446744073709551615\"", "-1", "\"18446744073709551616\""},
      {DataType::lword, "0", "\"18446744073709551615\"", "-1", "18446744073709551616"},
  };
  for (const Range& range : ranges) {
    INFO(range.most);
    CHECK(read(range.type, range.least) == range.least);
    CHECK(read(range.type, range.most) == range.most);
    CHECK(contains(read(range.type, range.below), "is out of range for "));
    CHECK(contains(read(range.type, range.above), "is out of range for "));
  }
  CHECK(contains(read(DataType::int_, "40000"), "out of range for INT, -32768 to 32767"));
}

TEST_CASE("An integer is whole, and may be a text in any base") {
  CHECK(read(DataType::int_, "5.0") == "5");
  CHECK(read(DataType::word, "\"16#FFFF\"") == "65535");
  CHECK(read(DataType::byte, "\"2#1010_1010\"") == "170");
  CHECK(contains(read(DataType::int_, "5.5"), "is not a whole number"));
  CHECK(contains(read(DataType::int_, "\"five\""), "is not a number"));
  CHECK(contains(read(DataType::int_, "true"), "expected a number for INT"));
}

TEST_CASE("REAL and LREAL take the nearest value, and what a trace writes") {
  CHECK(read(DataType::real, "0.1") == "0.1");
  CHECK(std::get<std::uint64_t>(scenario::read_value(DataType::real, 0.1)) ==
        std::bit_cast<std::uint64_t>(double{0.1F}));
  CHECK(read(DataType::lreal, "1e300") == "1e+300");
  CHECK(read(DataType::lreal, "3") == "3");
  CHECK(read(DataType::lreal, "\"nan\"") == "\"nan\"");
  CHECK(read(DataType::real, "\"-inf\"") == "\"-inf\"");
  CHECK(read(DataType::real, "-0.0") == "-0");
  CHECK(read(DataType::lreal, "\"-0\"") == "-0");
  CHECK(contains(read(DataType::real, "1e300"), "is out of range for REAL"));
  CHECK(contains(read(DataType::lreal, "\"1e999\""), "is out of range for LREAL"));
  CHECK(contains(read(DataType::lreal, "\"many\""), "is not a number"));
  CHECK(contains(read(DataType::lreal, "false"), "expected a number"));
}

}  // namespace
}  // namespace symplant::test
