// Makes entries of ValueTables::compiled from functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "symplant/tables/value.hpp"

#ifdef __FAST_MATH__
#error "formulas are IEEE 754 arithmetic in the order of their text: compile the plant without -ffast-math"
#endif

namespace symplant::tables {
namespace detail {

template <auto Function, class... Input, std::size_t... I>
double call_formula(double (*)(Input...) noexcept, [[maybe_unused]] const double* numbers,
                    [[maybe_unused]] const std::uint32_t* slots, std::index_sequence<I...>) noexcept {
  return Function(numbers[slots[I]]...);
}

template <class... Input>
constexpr auto input_numbers(double (*)(Input...) noexcept) {
  return std::index_sequence_for<Input...>();
}

}  // namespace detail

/// The entry of a formula: `Function` is called with its inputs, `Model` is what the description says.
template <auto Function, auto Model>
constexpr CompiledFormula compiled_formula() noexcept {
  static_assert(std::is_same_v<decltype(Function), decltype(Model)>,
                "a formula of yours takes and gives the same as that of ModelFormulas, and is noexcept");
  const auto call = [](const double* numbers, const std::uint32_t* slots) noexcept -> double {
    return detail::call_formula<Function>(Function, numbers, slots, detail::input_numbers(Function));
  };
  return {call, Function != Model};
}

/// Whether any of the formulas is the user's.
template <std::size_t N>
constexpr bool replaces_any(const CompiledFormula (&formulas)[N]) noexcept {
  for (const CompiledFormula& formula : formulas) {
    if (formula.replaced) return true;
  }
  return false;
}

}  // namespace symplant::tables
