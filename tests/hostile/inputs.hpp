// Hostile inputs, by name.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace symplant::hostile {

struct Input {
  enum class Kind { list, plant, scenario };
  Kind kind;
  const char* what;             ///< for the page, as a table cell
  std::string (*text)();        ///< the bytes of `symbols.csv`, `plant.json` or `scenario.json`
  bool large = false;           ///< takes seconds; skipped under sanitizers
  const char* index = nullptr;  ///< the file that the rejection names; null: the input itself
};

std::span<const Input> list_inputs();
std::span<const Input> name_inputs();   ///< lists, too
std::span<const Input> plant_inputs();  ///< each with good_list()
std::span<const Input> scenario_inputs();

/// All inputs, in this order.
std::vector<Input> inputs();

/// A small valid list.
std::string good_list();

/// The header of a list, and one row.
inline constexpr const char* kHeader = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n";
std::string row(const std::string& name, std::size_t number, const std::string& type = "BOOL",
                const std::string& initial = "FALSE");

std::string repeated(const std::string& text, std::size_t times);

/// Valid names that have broken compilers, terminals or readers; each once.
std::vector<std::string> hostile_names();
/// The same as a level of a name by the naming rule: letters and digits only.
std::vector<std::string> hostile_levels();

}  // namespace symplant::hostile
