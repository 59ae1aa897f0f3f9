// Looks up the names of conditions, and folds comparisons.
#include "symplant/condition/resolve.hpp"

#include <utility>

#include "symplant/condition/compare.hpp"

namespace symplant::condition {
namespace {

using Resolved = std::variant<Tree, Fault>;

Tree tree_of(const Atom& atom) {
  Tree tree;
  tree.kind = Tree::Kind::atom;
  tree.atom = atom;
  return tree;
}

/// The constant to which a comparison with a symbol, or with a number of parts, was folded.
Tree constant(bool value, Atom::Kind kind, std::uint32_t of) {
  Tree tree;
  tree.value = value;
  tree.atom.kind = kind;
  tree.atom.of = of;
  return tree;
}

/// Whether a name is `word`, which is in lower case.
bool is_word(std::string_view name, std::string_view word) {
  if (name.size() != word.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if ((name[i] | 0x20) != word[i]) return false;
  }
  return true;
}

std::string ticked(std::string_view name) { return "`" + std::string(name) + "`"; }

/// "... not found", with the nearest known name.
std::string missing(const std::string& what, const std::string& nearest) {
  return what + " not found" + (nearest.empty() ? "" : "; did you mean " + ticked(nearest) + "?");
}

class Resolver {
 public:
  explicit Resolver(const Names& names) : names_(names) {}

  Resolved resolve(const Expression& expression) const {
    switch (expression.kind) {
      case Expression::Kind::name:
        return expression.names.size() == 1 ? bit(expression.names.front()) : state(expression);
      case Expression::Kind::comparison:
        return comparison(expression);
      case Expression::Kind::negation:
      case Expression::Kind::all:
      case Expression::Kind::any:
        break;
    }
    Tree tree;
    tree.kind = expression.kind == Expression::Kind::negation ? Tree::Kind::negation
                : expression.kind == Expression::Kind::all    ? Tree::Kind::all
                                                              : Tree::Kind::any;
    tree.children.reserve(expression.children.size());
    for (const Expression& child : expression.children) {
      Resolved part = resolve(child);
      if (part.index() == 1) return part;
      tree.children.push_back(std::move(std::get<Tree>(part)));
    }
    return tree;
  }

 private:
  Resolved bit(const Name& name) const {
    const auto symbol = names_.symbol(name.text);
    if (!symbol) return no_symbol(name);
    if (symbol->type != tables::DataType::boolean) {
      return Fault{name.index, ticked(name.text) + " is of type " + std::string(type_name(symbol->type)) +
                                   " and has no comparison; compare it, as in " + ticked(name.text + " > 0")};
    }
    Atom atom;
    atom.kind = Atom::Kind::bit;
    atom.of = symbol->index;
    return tree_of(atom);
  }

  Resolved comparison(const Expression& expression) const {
    const Name& name = expression.names.front();
    if (expression.names.size() != 1) {
      const Name& last = expression.names.back();
      const auto location = names_.location(name.text);
      if (location && expression.names.size() != 2) return no_facet_of_location(expression);
      if (location && is_word(last.text, "parts")) return compared_parts(expression, *location);
      if (location) {
        return Fault{whole(expression),
                     "only the number of parts is compared, as in " + ticked(name.text + ".parts > 0")};
      }
      if (expression.names.size() == 2 && is_word(last.text, "parts") && units_of(name.text, {}).empty()) {
        return Fault{name.index, missing("track or place " + ticked(name.text), names_.nearest_device(name.text, {}))};
      }
      return Fault{whole(expression), "a state is compared with a number; only numeric symbols can be compared"};
    }
    const auto symbol = names_.symbol(name.text);
    if (!symbol) return no_symbol(name);
    if (symbol->type == tables::DataType::boolean) {
      return Fault{name.index,
                   ticked(name.text) + " is of type BOOL and compared with a number; remove the comparison"};
    }
    const auto folded = fold(symbol->type, expression.comparison, expression.number);
    if (!folded) {
      return Fault{expression.number_index, "the number is out of range for " + std::string(type_name(symbol->type))};
    }
    return folded_tree(*folded, Atom::Kind::number, symbol->index);
  }

  static Tree folded_tree(const std::variant<FoldedComparison, bool>& folded, Atom::Kind kind, std::uint32_t of) {
    if (const bool* always = std::get_if<bool>(&folded)) return constant(*always, kind, of);
    const auto& found = std::get<FoldedComparison>(folded);
    Atom atom;
    atom.kind = kind;
    atom.of = of;
    atom.comparison = found.comparison;
    atom.number = found.number;
    atom.operand = found.operand;
    return tree_of(atom);
  }

  static Resolved compared_parts(const Expression& expression, std::uint32_t location) {
    const auto folded = fold(tables::DataType::ulint, expression.comparison, expression.number);
    if (!folded) return Fault{expression.number_index, "the number is out of range"};
    return folded_tree(*folded, Atom::Kind::parts, location);
  }

  /// LOCATION.part or LOCATION.KIND
  Resolved parts(const Expression& expression, std::uint32_t location) const {
    if (expression.names.size() != 2) return no_facet_of_location(expression);
    const Name& name = expression.names.front();
    const Name& last = expression.names.back();
    Atom atom;
    atom.kind = Atom::Kind::parts;
    atom.of = location;
    atom.comparison = tables::Comparison::greater_equal;
    atom.number = tables::NumberKind::unsigned_integer;
    atom.operand = 1;
    if (is_word(last.text, "part")) return tree_of(atom);
    if (is_word(last.text, "parts")) {
      return Fault{last.index, ticked(name.text + ".parts") + " is a number; compare it, as in " +
                                   ticked(name.text + ".parts > 0") + ", or write " + ticked(name.text + ".part")};
    }
    const auto kind = names_.part_kind(last.text);
    if (!kind) {
      return Fault{last.index, missing("kind of part " + ticked(last.text), names_.nearest_part_kind(last.text))};
    }
    atom.part = *kind;
    return tree_of(atom);
  }

  Resolved state(const Expression& expression) const {
    const Name& device = expression.names.front();
    const Name& last = expression.names.back();
    if (const auto location = names_.location(device.text)) return parts(expression, *location);
    const std::string_view facet = expression.names.size() == 3 ? std::string_view(expression.names[1].text) : "";
    const std::vector<std::uint32_t> units = units_of(device.text, facet);
    if (units.empty()) return no_unit(expression, facet);
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
    if (having.size() > 1 && names_.unit(device.text, facet) != having.front()) return several(expression, having);
    if (!having.empty()) {
      atom.of = having.front();
      return tree_of(atom);
    }
    std::string why;
    for (const std::uint32_t unit : units) {
      if (why.empty()) why = names_.why_no_state(unit, last.text);
    }
    for (std::size_t i = 0; why.empty() && i < units.size(); ++i) {
      const std::string nearest = names_.nearest_state(units[i], last.text);
      if (nearest.empty() && i + 1 < units.size()) continue;
      why = missing("state " + ticked(last.text) + " of " + ticked(device.text), nearest);
    }
    return Fault{last.index, std::move(why)};
  }

  /// The unit that a name means, and all facets of a device.
  std::vector<std::uint32_t> units_of(std::string_view device, std::string_view facet) const {
    std::vector<std::uint32_t> units;
    if (const auto unit = names_.unit(device, facet)) units.push_back(*unit);
    if (facet.empty()) {
      const std::vector<std::uint32_t> facets = names_.facets(device);
      units.insert(units.end(), facets.begin(), facets.end());
    }
    return units;
  }

  Fault several(const Expression& expression, const std::vector<std::uint32_t>& having) const {
    const Name& device = expression.names.front();
    const Name& last = expression.names.back();
    constexpr std::size_t kMostNamed = 3;
    std::string paths;
    for (std::size_t i = 0; i < having.size() && i < kMostNamed; ++i) {
      paths += (i == 0 ? "" : ", ") + ticked(names_.path(having[i]) + "." + last.text);
    }
    if (having.size() > kMostNamed) paths += " and others";
    return {whole(expression),
            ticked(device.text + "." + last.text) + " is in several facets of the device; write " + paths};
  }

  /// From the first name to the last one.
  static Location whole(const Expression& expression) {
    const Name& first = expression.names.front();
    const Name& last = expression.names.back();
    return {first.index.offset, last.index.offset + last.index.length - first.index.offset};
  }

  static Fault no_facet_of_location(const Expression& expression) {
    const std::string& name = expression.names.front().text;
    return {whole(expression), ticked(name) + " is a track or place of parts; write " + ticked(name + ".part")};
  }

  Fault no_symbol(const Name& name) const {
    if (names_.location(name.text)) {
      return {name.index, ticked(name.text) + " is a track or place of parts; write " + ticked(name.text + ".part")};
    }
    if (!units_of(name.text, {}).empty()) {
      return {name.index,
              ticked(name.text) + " is a device; name one of its states, as in " + ticked(name.text + ".STATE")};
    }
    return {name.index, missing("symbol " + ticked(name.text), names_.nearest_symbol(name.text))};
  }

  Fault no_unit(const Expression& expression, std::string_view facet) const {
    const Name& device = expression.names.front();
    const std::string nearest = names_.nearest_device(device.text, facet);
    if (!facet.empty() && !units_of(device.text, {}).empty()) {
      return {expression.names[1].index, missing("facet " + ticked(facet) + " of " + ticked(device.text), nearest)};
    }
    if (facet.empty() && names_.symbol(device.text)) {
      return {device.index, ticked(device.text) + " is a symbol and has no states; use its name only"};
    }
    return {device.index, missing("device " + ticked(device.text), nearest)};
  }

  const Names& names_;
};

}  // namespace

std::variant<Tree, Fault> resolve(const Expression& expression, const Names& names) {
  return Resolver(names).resolve(expression);
}

std::variant<Tree, Fault> parse_and_resolve(std::string_view text, const Names& names) {
  auto parsed = parse(text);
  if (auto* fault = std::get_if<Fault>(&parsed)) return std::move(*fault);
  return resolve(std::get<Expression>(parsed), names);
}

}  // namespace symplant::condition
