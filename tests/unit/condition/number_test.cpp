// Numbers, exactly.
#include "condition_support.hpp"

namespace symplant::test {
namespace {

std::string read(std::string_view text) {
  const auto number = condition::Number::read(text);
  if (!number) return "none";
  return (number->negative ? "-" : "") + number->digits + "e" + std::to_string(number->exponent);
}

std::string floor(std::string_view text) {
  const condition::WholeNumber whole = condition::Number::read(text)->floor();
  return (whole.negative ? "-" : "") + (whole.huge ? "huge" : std::to_string(whole.magnitude));
}

TEST_CASE("A number keeps all its digits") {
  CHECK(read("12") == "12e0");
  CHECK(read("+0012.3400") == "1234e-2");
  CHECK(read("-0.000") == "e0");
  CHECK(read("1200") == "12e2");
  CHECK(read("1.5E3") == "15e2");
  CHECK(read("123456789012345678901234567890.5") == "1234567890123456789012345678905e-1");
  CHECK(read("16#ff") == "255e0");
  CHECK(read("-8#17") == "-15e0");
  CHECK(read("2#1010_1010") == "17e1");
}

TEST_CASE("An invalid number is rejected") {
  for (const char* text : {"",     "-",     "1.",  ".5",    "1e",    "1e+",   "0x1F",
                           "1__0", "_1",    "1_",  "16#",   "16#_1", "16#1_", "16#10000000000000000",
                           "16#G", "16#-1", "--1", "1.5.2", "inf",   "nan",   "1 2",
                           "1e5.5"}) {
    INFO(text);
    CHECK(read(text) == "none");
  }
}

TEST_CASE("The floor of a number is exact up to 64 bits, and huge above") {
  CHECK(floor("3.5") == "3");
  CHECK(floor("-3.5") == "-4");
  CHECK(floor("-0.5") == "-1");
  CHECK(floor("0.999999999999999999999999") == "0");
  CHECK(floor("18446744073709551615") == "18446744073709551615");
  CHECK(floor("18446744073709551615.9") == "18446744073709551615");
  CHECK(floor("18446744073709551616") == "huge");
  CHECK(floor("-18446744073709551615.5") == "-huge");
  CHECK(floor("1e3") == "1000");
  CHECK(floor("1e-99999999999999999999") == "0");
  CHECK(floor("-1e99999999999999999999") == "-huge");
  CHECK(floor("0e99999999999999999999") == "0");
}

TEST_CASE("A number gives the nearest double, if there is one") {
  CHECK(condition::Number::read("0.1")->real() == 0.1);
  CHECK(condition::Number::read("-2.5e3")->real() == -2500.0);
  CHECK(condition::Number::read("0")->real() == 0.0);
  CHECK_FALSE(condition::Number::read("1e400")->real());
  CHECK_FALSE(condition::Number::read("1e-400")->real());
}

}  // namespace
}  // namespace symplant::test
