// The variables of a plant's FMU, made of its tables: equal in the description that is written and in the library that
// runs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::fmi {

/// The base types of FMI 2.0. An enumeration is got and set as an integer.
enum class BaseType : std::uint8_t { real, integer, boolean, enumeration };

struct Variable {
  enum class Kind : std::uint8_t {
    seed,             ///< of all random times; a fixed parameter
    operation,        ///< an input
    other_operation,  ///< on the address of another operation, whose value it has; local
    undriven_event,   ///< sets an event that no device, sensor or condition drives; an input
    event,            ///< an output
    state,            ///< of a unit, from 1: the state in which it is settled, or from which it moves; local
    moving,           ///< of a unit; local
    parts,            ///< the number of parts at a location; local
    output,           ///< of a value; local
    parameter,        ///< a value that is a parameter and has no `changes`; tunable
    malfunction,      ///< as tables::MalfunctionNumbers numbers them: true starts it, false ends it; tunable
    active,           ///< whether a written malfunction is active; local
    short_pulses,     ///< pulses of BOOL events that were shorter than a step, so far; local
    violations,       ///< violations of requirements, so far; local
  };

  Kind kind = Kind::event;
  BaseType type = BaseType::boolean;
  std::uint32_t of = 0;         ///< a symbol, unit, location, output, value or malfunction
  std::uint32_t reference = 0;  ///< FMI's value reference
  std::string name;
};

/// Whether an importer may set it: an input or a parameter.
constexpr bool is_settable(Variable::Kind kind) noexcept {
  using enum Variable::Kind;
  return kind == seed || kind == operation || kind == undriven_event || kind == parameter || kind == malfunction;
}

/// Immutable, so any thread may use it.
class Variables {
 public:
  /// Parameters and inputs come first, then outputs, then local variables; in each group in the order of the tables.
  /// O(tables).
  explicit Variables(const tables::PlantTables& tables);

  std::span<const Variable> all() const noexcept { return variables_; }
  /// The index of a variable; nothing if there is no such reference. O(log variables).
  std::optional<std::uint32_t> find(std::uint32_t reference) const noexcept;
  /// A name that two variables have; empty: each has its own.
  std::string_view repeated_name() const noexcept { return repeated_; }

 private:
  struct Entry {
    std::uint32_t reference;
    std::uint32_t variable;
  };

  void add(Variable::Kind kind, BaseType type, std::uint32_t of, std::string name);
  void add_symbols(const tables::PlantTables& tables);
  void add_malfunctions(const tables::PlantTables& tables);
  void add_local(const tables::PlantTables& tables);
  void number();

  std::vector<Variable> variables_;
  std::vector<Entry> by_reference_;  ///< ascending
  std::string repeated_;
};

/// How FMI has a symbol: an integer if all its numbers fit into 32 bits with a sign, else a real.
BaseType base_type(tables::DataType type) noexcept;

/// Identifies a plant and its variables: braces and hexadecimal digits. O(tables).
std::string guid_of(const tables::PlantTables& tables, const Variables& variables);

}  // namespace symplant::fmi
