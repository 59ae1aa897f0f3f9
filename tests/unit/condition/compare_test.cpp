// A folded comparison gives the same result as the written one for every value.
#include "symplant/condition/compare.hpp"

#include <bit>

#include "condition_support.hpp"

namespace symplant::test {
namespace {

using tables::Comparison;
using tables::DataType;

constexpr Comparison kAll[] = {Comparison::less, Comparison::less_equal, Comparison::equal, Comparison::greater_equal,
                               Comparison::greater};

template <class T>
bool compares(T a, Comparison comparison, T b) {
  switch (comparison) {
    case Comparison::less:
      return a < b;
    case Comparison::less_equal:
      return a <= b;
    case Comparison::equal:
      return a == b;
    case Comparison::greater_equal:
      return a >= b;
    case Comparison::greater:
      return a > b;
  }
  return false;
}

std::string folded(DataType type, Comparison comparison, std::string_view number) {
  const auto result = condition::fold(type, comparison, *condition::Number::read(number));
  if (!result) return "none";
  if (const bool* constant = std::get_if<bool>(&*result)) return *constant ? "always" : "never";
  const auto& found = std::get<condition::FoldedComparison>(*result);
  return comparison_text(found.comparison) + std::to_string(static_cast<std::int64_t>(found.operand));
}

TEST_CASE("A fraction is compared with as the next integer") {
  CHECK(folded(DataType::int_, Comparison::less, "3.5") == "<=3");
  CHECK(folded(DataType::int_, Comparison::less_equal, "3.5") == "<=3");
  CHECK(folded(DataType::int_, Comparison::greater, "3.5") == ">3");
  CHECK(folded(DataType::int_, Comparison::greater_equal, "-3.5") == ">-4");
  CHECK(folded(DataType::int_, Comparison::equal, "3.5") == "never");
  CHECK(folded(DataType::int_, Comparison::equal, "30e-1") == "=3");
}

TEST_CASE("A comparison that no value or every value meets is a constant") {
  CHECK(folded(DataType::int_, Comparison::less, "32768") == "always");
  CHECK(folded(DataType::int_, Comparison::less_equal, "32767") == "always");
  CHECK(folded(DataType::int_, Comparison::less, "32767") == "<32767");
  CHECK(folded(DataType::int_, Comparison::greater, "32767") == "never");
  CHECK(folded(DataType::int_, Comparison::greater_equal, "-32768") == "always");
  CHECK(folded(DataType::word, Comparison::greater, "-0.5") == "always");
  CHECK(folded(DataType::word, Comparison::less, "0") == "never");
  CHECK(folded(DataType::word, Comparison::equal, "-1") == "never");
  CHECK(folded(DataType::ulint, Comparison::equal, "18446744073709551616") == "never");
  CHECK(folded(DataType::ulint, Comparison::greater, "9223372036854775808") == ">-9223372036854775808");
  CHECK(folded(DataType::lint, Comparison::less, "1e30") == "always");
  CHECK(folded(DataType::lint, Comparison::greater, "-1e30") == "always");
}

TEST_CASE("A folded comparison equals the exact one for every value of 8 bits") {
  for (const DataType type : {DataType::sint, DataType::usint, DataType::byte}) {
    const int least = type == DataType::sint ? -128 : 0;
    for (int quarters = -600; quarters <= 1200; ++quarters) {
      const std::string text = std::to_string(quarters * 25) + "e-2";
      for (const Comparison comparison : kAll) {
        const auto result = condition::fold(type, comparison, *condition::Number::read(text));
        const bool* constant = std::get_if<bool>(&*result);
        for (int value = least; value <= least + 255; ++value) {
          const bool exact = compares(value * 4, comparison, quarters);
          const bool found =
              constant != nullptr
                  ? *constant
                  : compares(static_cast<std::int64_t>(value),
                             std::get<condition::FoldedComparison>(*result).comparison,
                             static_cast<std::int64_t>(std::get<condition::FoldedComparison>(*result).operand));
          if (found != exact) FAIL(value << " " << comparison_text(comparison) << " " << text);
        }
      }
    }
  }
}

TEST_CASE("Reals are compared as doubles, and a number that a double cannot hold is invalid") {
  const auto result = condition::fold(DataType::real, Comparison::less, *condition::Number::read("0.1"));
  const auto& found = std::get<condition::FoldedComparison>(*result);
  CHECK(found.number == tables::NumberKind::real);
  CHECK(found.operand == std::bit_cast<std::uint64_t>(0.1));
  CHECK(folded(DataType::lreal, Comparison::less, "1e999") == "none");
}

}  // namespace
}  // namespace symplant::test
