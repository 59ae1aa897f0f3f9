// Looks up the names of conditions and formulas in a plant, and words what is wrong with them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/expression.hpp"
#include "symplant/condition/names.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::condition {

/// Whether a name is `word` in any ASCII case; `word` is in lower case.
bool is_word(std::string_view name, std::string_view word);

std::string ticked(std::string_view name);

/// "... not found", with the nearest known name.
std::string missing(const std::string& what, const std::string& nearest);

/// Identifiers joined by dots: at least one.
using Path = std::span<const Name>;

/// The text without quotes.
std::string dotted(Path path);
/// From the first name to the last one.
Location whole(Path path);

/// `names` must outlive this object. A function is O(1) look-ups, or a search for the nearest name if it fails.
class Lookup {
 public:
  explicit Lookup(const Names& names) : names_(names) {}

  /// `DEVICE.STATE`, `DEVICE.FACET.STATE`, `DEVICE.moving`, `LOCATION.part`, `LOCATION.KIND`: for parts a comparison
  /// with at least 1.
  std::variant<Atom, Fault> state(Path path) const;
  /// An output of a value, of which `index` is the text in `[ ]`, if there is one. Nothing if no value has the name.
  std::optional<std::variant<std::uint32_t, Fault>> output(Path path, const std::optional<Name>& index) const;
  /// A name that can be compared: a value, a numeric symbol, `LOCATION.parts`, `LOCATION.weight`.
  std::variant<Quantity, Fault> quantity(const Operand& operand) const;
  /// Nothing if the name is not that of a symbol.
  std::optional<Names::Symbol> symbol(const Name& name) const { return names_.symbol(name.text); }
  std::optional<std::uint32_t> location(const Name& name) const { return names_.location(name.text); }

  /// What is wrong with the name of a symbol that symbol() did not find.
  Fault no_symbol(const Name& name) const;
  /// `[ ]` behind a name that is not that of a value.
  static Fault no_outputs(const Name& index);

 private:
  std::variant<Atom, Fault> parts(Path path, std::uint32_t location) const;
  std::variant<Quantity, Fault> compared_path(Path path) const;
  std::vector<std::uint32_t> units_of(std::string_view device, std::string_view facet) const;
  Fault several(Path path, const std::vector<std::uint32_t>& having) const;
  Fault no_state(Path path, const std::vector<std::uint32_t>& units) const;
  Fault no_unit(Path path, std::string_view facet) const;
  std::string missing_value(const std::string& what, Path path, const std::string& nearest) const;

  const Names& names_;
};

}  // namespace symplant::condition
