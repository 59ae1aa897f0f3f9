// Durations in their written form.
#include "symplant/tables/duration.hpp"

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using tables::parse_duration;

TEST_CASE("Durations are read exactly") {
  CHECK(parse_duration("500ms") == 500'000'000);
  CHECK(parse_duration("1.5 s") == 1'500'000'000);
  CHECK(parse_duration("  2h ") == 7'200'000'000'000);
  CHECK(parse_duration("1min") == 60'000'000'000);
  CHECK(parse_duration("7us") == 7'000);
  CHECK(parse_duration("3ns") == 3);
  CHECK(parse_duration("0s") == 0);
  CHECK(parse_duration("0.1s") == 100'000'000);
  CHECK(parse_duration("0.000000001s") == 1);
  CHECK(parse_duration("1.10us") == 1'100);
  CHECK(parse_duration("0.25h") == 900'000'000'000);
  CHECK(parse_duration("0.05 min") == 3'000'000'000);
  CHECK(parse_duration("9223372036854775806ns") == tables::kNever - 1);
}

TEST_CASE("An invalid duration is rejected") {
  for (const char* text : {"",
                           "s",
                           "5",
                           "5 m",
                           "-1s",
                           "+1s",
                           "1,5s",
                           "1.s",
                           ".5s",
                           "1e3s",
                           "1 s s",
                           "0.5ns",
                           "0.0001us",
                           "0.0000000001s",
                           "9223372036854775807ns",
                           "9223372036854775808ns",
                           "9223372037s",
                           "99999999999999999999h",
                           "1.5",
                           "0.12345678901234567890h",
                           "0x10s",
                           "ms"}) {
    INFO(text);
    CHECK_FALSE(parse_duration(text).has_value());
  }
}

TEST_CASE("A duration in seconds is exact, and is read back") {
  using tables::duration_text;
  CHECK(duration_text(0) == "0s");
  CHECK(duration_text(21'000'000'000) == "21s");
  CHECK(duration_text(21'310'000'000) == "21.31s");
  CHECK(duration_text(1) == "0.000000001s");
  CHECK(duration_text(100'000'000'000) == "100s");
  for (const tables::Time time :
       {std::int64_t{999'999'999}, std::int64_t{1'000'000'001}, std::int64_t{9'223'372'036'000'000'000}}) {
    CHECK(parse_duration(duration_text(time)) == time);
  }
}

}  // namespace
}  // namespace symplant::test
