// Which symbols the variables of a program are bound to, and what is wrong with those that are not.
#include "symplant/program/binding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "program_support.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

using program::Binding;

Binding bound(const BenchTables& tables, std::vector<symplant_variable> variables,
              const std::vector<std::string>& ignore = {}) {
  const MadeProgram made(std::move(variables));
  return program::bind(made.program, trace::PlantNames(tables.rows), 0, ignore);
}

std::string errors_of(const BenchTables& tables, std::vector<symplant_variable> variables,
                      const std::vector<std::string>& ignore = {}) {
  return fmt::format("{}", fmt::join(bound(tables, std::move(variables), ignore).errors, "\n"));
}

TEST_CASE("Variables bind by name in any case, or by address as bytes with bits and as numbers") {
  const BenchTables tables(kCell);
  const Binding by_name = bound(tables, {writes("l_p_agv_o_p2"), reads("L_P_AGV_I_P1")});
  CHECK(by_name.errors.empty());
  CHECK(by_name.symbols == std::vector{tables.symbol("AGV_O_P2"), tables.symbol("AGV_I_P1")});
  CHECK(by_name.unwritten == 1);  // AGV_O_P1
  // The addresses of the list are %QX0, %QX1, %IX2 and %IX3.
  const Binding by_address = bound(tables, {writes_at("%QX0.1"), writes_at("%QX0"), reads_at("%ix2")});
  INFO(fmt::format("{}", fmt::join(by_address.errors, "\n")));
  CHECK(by_address.symbols ==
        std::vector{tables.symbol("AGV_O_P2"), tables.symbol("AGV_O_P1"), tables.symbol("AGV_I_P1")});
  CHECK(by_address.unwritten == 0);
}

TEST_CASE("A variable without a symbol, of another direction or width, or written twice is an error") {
  const BenchTables tables(kCell);
  CHECK(contains(errors_of(tables, {reads("L_P_AGV_I_P3")}), "symbol `L_P_AGV_I_P3` not found; did you mean"));
  CHECK(contains(errors_of(tables, {writes_at("%QX7")}), "no operation has the address `%QX7`; the nearest is"));
  CHECK(contains(errors_of(tables, {writes("L_P_AGV_I_P1")}), "is an event: a program reads events"));
  CHECK(contains(errors_of(tables, {reads("L_P_AGV_O_P1")}), "is an operation: a program writes operations"));
  CHECK(contains(errors_of(tables, {reads("L_P_AGV_I_P1", 16)}),
                 "has 16 bits, and `L_P_AGV_I_P1` is BOOL, which has 1 bit"));
  CHECK(contains(errors_of(tables, {writes("L_P_AGV_O_P1"), writes_at("%QX0")}), "both write"));
  CHECK_FALSE(errors_of(tables, {symplant_variable{nullptr, nullptr, 0, 1}}).empty());
  CHECK(errors_of(tables, {reads("L_P_AGV_I_P1"), reads("L_P_AGV_I_P1")}).empty());  // two readers are well
}

TEST_CASE("What a pattern ignores needs no symbol, and is still bound if there is one") {
  const BenchTables tables(kCell);
  const Binding binding =
      bound(tables, {reads("SPARE1"), reads_at("%IX99"), reads("L_P_AGV_I_P1")}, {"SPARE?", "%IX9*", "L_*"});
  CHECK(binding.errors.empty());
  CHECK(binding.symbols == std::vector{tables::kNone, tables::kNone, tables.symbol("AGV_I_P1")});
}

}  // namespace
}  // namespace symplant::test
