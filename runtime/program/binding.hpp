// Which symbols the variables of a program are bound to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/program.h"
#include "symplant/trace/plant_names.hpp"

namespace symplant::program {

/// The symbols of a program's variables.
struct Binding {
  std::vector<std::uint32_t> symbols;  ///< by variable: its row in PlantTables::symbols; tables::kNone: it is ignored
  std::vector<std::string> errors;     ///< for the user; empty: the program can run
  std::uint32_t unwritten = 0;         ///< operations of the controller that the program does not write
};

/// Binds each variable to a symbol of the controller: by its name, otherwise by its address: a bit by its number
/// (`%IX3.2`, `%IX26` and `X001A` are the same), another address by its text or its number. `ignore`: patterns of names
/// and addresses that need no symbol. O((symbols + variables) log symbols), and O(symbols) for each error.
Binding bind(const symplant_program& program, const trace::PlantNames& names, std::uint32_t controller,
             const std::vector<std::string>& ignore);

/// By symbol: whether it, or another one on its address, is an operation that the program writes. O(symbols).
std::vector<bool> written_symbols(const symplant_program& program, const Binding& binding,
                                  const tables::PlantTables& tables);

/// "`iDoor` at `%IX3.2`": a variable, for messages.
std::string variable_words(const symplant_variable& variable);

}  // namespace symplant::program
