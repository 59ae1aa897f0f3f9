// Looks up states, parts, symbols and values by name.
#include "symplant/condition/lookup.hpp"

#include <charconv>
#include <system_error>
#include <utility>

#include "symplant/condition/compare.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::condition {
namespace {

constexpr std::size_t kMostNames = 3;  ///< of DEVICE.FACET.STATE

Fault no_facet_of_location(Path path) {
  const std::string& name = path.front().text;
  return {whole(path), ticked(name) + " is a track or place of parts; write " + ticked(name + ".part")};
}

std::string numbered(const std::string& name, std::uint32_t output) {
  return ticked(name + "[" + std::to_string(output) + "]");
}

}  // namespace

bool is_word(std::string_view name, std::string_view word) {
  if (name.size() != word.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if ((name[i] | 0x20) != word[i]) return false;
  }
  return true;
}

std::string ticked(std::string_view name) { return "`" + std::string(name) + "`"; }

std::string missing(const std::string& what, const std::string& nearest) {
  return what + " not found" + (nearest.empty() ? "" : "; did you mean " + ticked(nearest) + "?");
}

std::string dotted(Path path) {
  std::string text;
  for (const Name& name : path) text.append(text.empty() ? "" : ".").append(name.text);
  return text;
}

Location whole(Path path) {
  const Name& last = path.back();
  return {path.front().index.offset, last.index.offset + last.index.length - path.front().index.offset};
}

/// missing(), which also proposes a value if that is nearer than `nearest`, the last name of another proposal.
std::string Lookup::missing_value(const std::string& what, Path path, const std::string& nearest) const {
  const std::string wanted = dotted(path);
  const std::string value = names_.nearest_value(wanted);
  if (value.empty()) return missing(what, nearest);
  std::string other = nearest;
  if (!nearest.empty() && path.size() > 1) other = dotted(path.first(path.size() - 1)) + "." + nearest;
  tables::NearestName nearer(wanted);
  if (!nearest.empty()) nearer.offer(other);
  nearer.offer(value);
  return missing(what, nearer.name() == value ? value : nearest);
}

std::variant<Atom, Fault> Lookup::parts(Path path, std::uint32_t location) const {
  if (path.size() != 2) return no_facet_of_location(path);
  const Name& name = path.front();
  const Name& last = path.back();
  Atom atom;
  atom.kind = Atom::Kind::parts;
  atom.of = location;
  atom.comparison = tables::Comparison::greater_equal;
  atom.number = tables::NumberKind::unsigned_integer;
  atom.operand = 1;
  if (is_word(last.text, "part")) return atom;
  if (is_word(last.text, "parts")) {
    return Fault{last.index, ticked(name.text + ".parts") + " is a number; compare it, as in " +
                                 ticked(name.text + ".parts > 0") + ", or write " + ticked(name.text + ".part")};
  }
  const auto kind = names_.part_kind(last.text);
  if (!kind && is_word(last.text, "weight")) {
    return Fault{last.index, ticked(name.text + ".weight") + " is a number; compare it, as in " +
                                 ticked(name.text + ".weight > 0")};
  }
  if (!kind) {
    const std::string nearest = names_.nearest_part_kind(last.text);
    return Fault{last.index, missing_value("kind of part " + ticked(last.text), path, nearest)};
  }
  atom.part = *kind;
  return atom;
}

std::variant<Atom, Fault> Lookup::state(Path path) const {
  const Name& device = path.front();
  const Name& last = path.back();
  if (const auto location = names_.location(device.text)) return parts(path, *location);
  if (path.size() > kMostNames) return Fault{whole(path), missing_value(ticked(dotted(path)), path, {})};
  const std::string_view facet = path.size() == 3 ? std::string_view(path[1].text) : "";
  const std::vector<std::uint32_t> units = units_of(device.text, facet);
  if (units.empty()) return no_unit(path, facet);
  Atom atom;
  std::vector<std::uint32_t> having;
  for (const std::uint32_t unit : units) {
    if (const auto found = names_.state(unit, last.text)) {
      if (having.empty()) atom.state = *found;
      having.push_back(unit);
    }
  }
  if (having.empty() && is_word(last.text, "moving")) {
    atom.kind = Atom::Kind::moving;
    having = units;
  }
  // The facet with the device's name comes first: it has no longer name.
  if (having.size() > 1 && names_.unit(device.text, facet) != having.front()) return several(path, having);
  if (having.empty()) return no_state(path, units);
  atom.of = having.front();
  return atom;
}

std::optional<std::variant<std::uint32_t, Fault>> Lookup::output(Path path, const std::optional<Name>& index) const {
  using Result = std::variant<std::uint32_t, Fault>;
  const std::string name = dotted(path);
  const auto value = names_.value(name);
  if (!value) return std::nullopt;
  if (value->outputs <= 1) {
    if (!index) return Result(value->output);
    return Result(
        Fault{index->index, ticked(name) + " has one output; write it without " + ticked("[" + index->text + "]")});
  }
  const Location at = index ? index->index : whole(path);
  std::uint32_t number = 0;
  if (index) {
    const char* end = index->text.data() + index->text.size();
    const auto [stop, error] = std::from_chars(index->text.data(), end, number);
    if (error != std::errc{} || stop != end) number = 0;
  }
  if (number >= 1 && number <= value->outputs) return Result(value->output + number - 1);
  return Result(Fault{at, ticked(name) + " has " + std::to_string(value->outputs) + " outputs; write one of " +
                              numbered(name, 1) + " to " + numbered(name, value->outputs)});
}

std::variant<Quantity, Fault> Lookup::quantity(const Operand& operand) const {
  if (const auto found = output(operand.names, operand.output)) {
    if (const auto* fault = std::get_if<Fault>(&*found)) return *fault;
    return Quantity{Quantity::Kind::output, std::get<std::uint32_t>(*found)};
  }
  if (operand.output) return no_outputs(*operand.output);
  if (operand.names.size() > 1) return compared_path(operand.names);
  const Name& name = operand.names.front();
  const auto found = symbol(name);
  if (!found) return no_symbol(name);
  if (found->type == tables::DataType::boolean) {
    return Fault{name.index, ticked(name.text) + " is of type BOOL and compared with a number; remove the comparison"};
  }
  return Quantity{Quantity::Kind::symbol, found->index, found->type};
}

/// Two or more names that are not a value, in a comparison.
std::variant<Quantity, Fault> Lookup::compared_path(Path path) const {
  const Name& name = path.front();
  const Name& last = path.back();
  const bool is_pair = path.size() == 2;
  if (const auto found = names_.location(name.text)) {
    if (!is_pair) return no_facet_of_location(path);
    if (is_word(last.text, "parts")) return Quantity{Quantity::Kind::parts, *found};
    if (is_word(last.text, "weight")) return Quantity{Quantity::Kind::weight, *found};
    return Fault{whole(path), "only the number of parts is compared, as in " + ticked(name.text + ".parts > 0")};
  }
  const bool of_parts = is_pair && (is_word(last.text, "parts") || is_word(last.text, "weight"));
  if (of_parts && units_of(name.text, {}).empty()) {
    const std::string nearest = names_.nearest_device(name.text, {});
    return Fault{name.index, missing("track or place " + ticked(name.text), nearest)};
  }
  const std::string value = names_.nearest_value(dotted(path));
  const bool is_state = path.size() <= kMostNames && (value.empty() || std::holds_alternative<Atom>(state(path)));
  if (!is_state) {
    return Fault{whole(path), missing("value " + ticked(dotted(path)), value)};
  }
  return Fault{whole(path), "a state is compared with a number; only numeric symbols can be compared"};
}

/// The unit that a name means, and all facets of a device.
std::vector<std::uint32_t> Lookup::units_of(std::string_view device, std::string_view facet) const {
  std::vector<std::uint32_t> units;
  if (const auto unit = names_.unit(device, facet)) units.push_back(*unit);
  if (facet.empty()) {
    const std::vector<std::uint32_t> facets = names_.facets(device);
    units.insert(units.end(), facets.begin(), facets.end());
  }
  return units;
}

Fault Lookup::several(Path path, const std::vector<std::uint32_t>& having) const {
  const Name& device = path.front();
  const Name& last = path.back();
  constexpr std::size_t kMostNamed = 3;
  std::string paths;
  for (std::size_t i = 0; i < having.size() && i < kMostNamed; ++i) {
    paths += (i == 0 ? "" : ", ") + ticked(names_.path(having[i]) + "." + last.text);
  }
  if (having.size() > kMostNamed) paths += " and others";
  return {whole(path), ticked(device.text + "." + last.text) + " is in several facets of the device; write " + paths};
}

Fault Lookup::no_state(Path path, const std::vector<std::uint32_t>& units) const {
  const Name& device = path.front();
  const Name& last = path.back();
  for (const std::uint32_t unit : units) {
    std::string why = names_.why_no_state(unit, last.text);
    if (!why.empty()) return {last.index, std::move(why)};
  }
  std::string nearest;
  for (std::size_t i = 0; nearest.empty() && i < units.size(); ++i) nearest = names_.nearest_state(units[i], last.text);
  return {last.index, missing_value("state " + ticked(last.text) + " of " + ticked(device.text), path, nearest)};
}

Fault Lookup::no_outputs(const Name& index) {
  return {index.index, "only a value of kind `linear` has several outputs; remove " + ticked("[" + index.text + "]")};
}

Fault Lookup::no_symbol(const Name& name) const {
  if (names_.location(name.text)) {
    return {name.index, ticked(name.text) + " is a track or place of parts; write " + ticked(name.text + ".part")};
  }
  if (!units_of(name.text, {}).empty()) {
    return {name.index,
            ticked(name.text) + " is a device; name one of its states, as in " + ticked(name.text + ".STATE")};
  }
  return {name.index, missing_value("symbol " + ticked(name.text), {&name, 1}, names_.nearest_symbol(name.text))};
}

Fault Lookup::no_unit(Path path, std::string_view facet) const {
  const Name& device = path.front();
  const std::string nearest = names_.nearest_device(device.text, facet);
  if (!facet.empty() && !units_of(device.text, {}).empty()) {
    return {path[1].index, missing("facet " + ticked(facet) + " of " + ticked(device.text), nearest)};
  }
  if (facet.empty() && names_.symbol(device.text)) {
    return {device.index, ticked(device.text) + " is a symbol and has no states; use its name only"};
  }
  const std::string wanted = dotted(path);
  const std::string value = names_.nearest_value(wanted);
  const std::string other = nearest + wanted.substr(device.text.size());
  tables::NearestName nearer(wanted);
  if (!value.empty()) nearer.offer(value);
  if (!nearest.empty()) nearer.offer(other);
  if (!value.empty() && nearer.name() == value) return {whole(path), missing("value " + ticked(wanted), value)};
  return {device.index, missing("device " + ticked(device.text), nearest)};
}

}  // namespace symplant::condition
