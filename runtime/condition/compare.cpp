// Folds comparisons: integers by exact arithmetic, reals as doubles.
#include "symplant/condition/compare.hpp"

#include <bit>
#include <string_view>

#include "symplant/condition/type_info.hpp"

namespace symplant::condition {
namespace {

using tables::Comparison;
using tables::DataType;

/// Negative, 0 or positive, as `a` is less than, equal to or greater than `b`; a `huge` number exceeds all others.
int order(const WholeNumber& a, const WholeNumber& b) {
  const auto rank = [](const WholeNumber& n) { return n.huge ? (n.negative ? -2 : 2) : n.negative ? -1 : 1; };
  if (rank(a) != rank(b)) return rank(a) < rank(b) ? -1 : 1;
  if (a.huge || a.magnitude == b.magnitude) return 0;
  return (a.magnitude < b.magnitude) != a.negative ? -1 : 1;
}

struct Range {
  WholeNumber least;
  WholeNumber most;
};

Range range_of(const TypeInfo& type) {
  const std::uint64_t all = ~std::uint64_t{0} >> (64 - type.bits);
  if (type.kind == tables::NumberKind::unsigned_integer) return {{}, {false, false, all}};
  return {{true, false, all / 2 + 1}, {false, false, all / 2}};
}

std::variant<FoldedComparison, bool> fold_integer(const TypeInfo& type, Comparison comparison, const Number& number) {
  const WholeNumber floor = number.floor();
  if (!number.is_whole()) {  // between two integers: `<` becomes `<=` of its floor, `>=` becomes `>`
    if (comparison == Comparison::equal) return false;
    if (comparison == Comparison::less) comparison = Comparison::less_equal;
    if (comparison == Comparison::greater_equal) comparison = Comparison::greater;
  }
  const Range range = range_of(type);
  const int to_least = order(floor, range.least);
  const int to_most = order(floor, range.most);
  const bool downwards = comparison == Comparison::less || comparison == Comparison::less_equal;
  if (to_least < 0) return !downwards && comparison != Comparison::equal;
  if (to_most > 0) return downwards;
  if (to_least == 0 && comparison == Comparison::less) return false;
  if (to_least == 0 && comparison == Comparison::greater_equal) return true;
  if (to_most == 0 && comparison == Comparison::greater) return false;
  if (to_most == 0 && comparison == Comparison::less_equal) return true;
  const std::uint64_t operand = floor.negative ? ~floor.magnitude + 1 : floor.magnitude;
  return FoldedComparison{comparison, type.kind, operand};
}

}  // namespace

std::optional<std::variant<FoldedComparison, bool>> fold(DataType type, Comparison comparison, const Number& number) {
  const TypeInfo& info = info_of(type);
  if (info.kind != tables::NumberKind::real) return fold_integer(info, comparison, number);
  const std::optional<double> value = number.real();
  if (!value) return std::nullopt;
  return FoldedComparison{comparison, info.kind, std::bit_cast<std::uint64_t>(*value)};
}

std::string_view type_name(DataType type) { return info_of(type).name; }

}  // namespace symplant::condition
