// Writes conditions in their grammar.
#include "model/condition_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <string_view>
#include <variant>

#include "model/classify.hpp"
#include "symplant/condition/expression.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::model {
namespace {

using condition::Atom;
using condition::Tree;

/// The least value of an integer type.
std::string least_of(tables::DataType type) {
  using tables::DataType;
  const bool is_signed =
      type == DataType::sint || type == DataType::int_ || type == DataType::dint || type == DataType::lint;
  if (!is_signed) return "0";
  return fmt::format("{}", static_cast<std::int64_t>(~std::uint64_t{0} << (data_type_bits(type) - 1)));
}

bool is_word(std::string_view name) {
  return text::equal_ignoring_case(name, "and") || text::equal_ignoring_case(name, "or") ||
         text::equal_ignoring_case(name, "not");
}

bool begins_with_digit(std::string_view name) { return !name.empty() && name.front() >= '0' && name.front() <= '9'; }

/// Whether the grammar reads a name without quotes, apart from its keywords.
bool is_plain(std::string_view name) {
  const auto ascii_letter = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  if (name.empty()) return false;
  if (std::all_of(name.begin(), name.end(), ascii_letter)) return true;
  if (std::any_of(name.begin(), name.end(),
                  [&](char c) { return !ascii_letter(c) && static_cast<unsigned char>(c) < 0x80; })) {
    return false;
  }
  return condition::parse(name).index() == 0;  // the grammar decides which Unicode characters are letters
}

class ConditionWriter {
 public:
  ConditionWriter(const PlantModel& plant, std::size_t longest) : plant_(plant), longest_(longest) {}

  std::string write(const Tree& tree) {
    add(tree);
    if (out_.size() <= longest_) return std::move(out_);
    std::size_t cut = longest_;
    while (cut > 0 && text::is_continuation(out_[cut])) --cut;
    return out_.substr(0, cut) + " ...";
  }

 private:
  void add(const Tree& tree) {
    if (out_.size() > longest_) return;
    switch (tree.kind) {
      case Tree::Kind::constant:
        add_constant(tree);
        return;
      case Tree::Kind::atom:
        add(tree.atom);
        return;
      case Tree::Kind::negation: {
        const Tree::Kind kind = tree.children.front().kind;
        out_ += "not ";
        add_operand(tree.children.front(), kind != Tree::Kind::atom && kind != Tree::Kind::constant);
        return;
      }
      case Tree::Kind::all:
      case Tree::Kind::any:
        for (std::size_t i = 0; i < tree.children.size() && out_.size() <= longest_; ++i) {
          if (i != 0) out_ += tree.kind == Tree::Kind::all ? " and " : " or ";
          const Tree::Kind kind = tree.children[i].kind;
          add_operand(tree.children[i], kind == Tree::Kind::any || kind == tree.kind);
        }
        return;
    }
  }

  void add_operand(const Tree& tree, bool in_parentheses) {
    if (in_parentheses) out_ += '(';
    add(tree);
    if (in_parentheses) out_ += ')';
  }

  void add(const Atom& atom) {
    switch (atom.kind) {
      case Atom::Kind::settled:
        add_path(plant_.units[atom.of]);
        out_ += '.';
        add_name(plant_.units[atom.of].states[atom.state].name, false);
        return;
      case Atom::Kind::moving:
        add_path(plant_.units[atom.of]);
        out_ += ".moving";
        return;
      case Atom::Kind::bit:
        add_name(plant_.symbols[atom.of].name(), true);
        return;
      case Atom::Kind::number:
        add_operand_name(plant_.symbols[atom.of].name(), false);
        out_.append(" ").append(comparison_text(atom.comparison)).append(" ").append(operand_text(atom));
        return;
      case Atom::Kind::parts:
        add_parts(atom);
        return;
      case Atom::Kind::compare:
        add_side(atom.left, false);
        out_.append(" ").append(comparison_text(atom.comparison)).append(" ");
        add_side(atom.right, true);
        if (atom.tolerance != 0) out_ += fmt::format(" +- {}", atom.tolerance);
        return;
    }
  }

  void add_side(const condition::Quantity& quantity, bool on_right) {
    using Kind = condition::Quantity::Kind;
    switch (quantity.kind) {
      case Kind::number:
        out_ += fmt::format("{}", quantity.number);
        return;
      case Kind::output:
        out_ += output_name(plant_, quantity.of);
        return;
      case Kind::symbol:
        add_operand_name(plant_.symbols[quantity.of].name(), on_right);
        return;
      case Kind::parts:
      case Kind::weight:
        add_operand_name(plant_.material.location_name(quantity.of), on_right);
        out_ += quantity.kind == Kind::parts ? ".parts" : ".weight";
        return;
    }
  }

  void add_parts(const Atom& atom) {
    add_name(plant_.material.location_name(atom.of), true);
    out_ += '.';
    if (atom.part != kNone) {
      add_name(plant_.material.kinds[atom.part].name, false);
    } else if (atom.comparison == tables::Comparison::greater_equal && atom.operand == 1) {
      out_ += "part";
    } else {
      out_.append("parts ").append(comparison_text(atom.comparison)).append(" ").append(operand_text(atom));
    }
  }

  void add_path(const Unit& unit) {
    add_name(unit.device_path(), true);
    if (unit.facet == nullptr || unit.facet->name.empty()) return;
    out_ += '.';
    add_name(unit.facet->name, false);
  }

  void add_constant(const Tree& tree) {
    if (tree.atom.kind == Atom::Kind::parts) {
      add_name(plant_.material.location_name(tree.atom.of), true);
      out_ += tree.value ? ".parts >= 0" : ".parts < 0";
      return;
    }
    if (tree.atom.kind != Atom::Kind::number) {
      out_ += tree.value ? "always" : "never";
      return;
    }
    add_operand_name(plant_.symbols[tree.atom.of].name(), false);
    out_.append(tree.value ? " >= " : " < ").append(least_of(plant_.symbols[tree.atom.of].type));
  }

  void add_name(std::string_view name, bool first) {
    if (is_plain(name) && !(first && is_word(name))) {
      out_ += name;
    } else {
      add_quoted(name);
    }
  }

  /// A name at the start of an operand, which must not read as a number.
  void add_operand_name(std::string_view name, bool on_right) {
    if (on_right ? begins_with_digit(name) : condition::Number::read(name).has_value()) {
      add_quoted(name);
    } else {
      add_name(name, true);
    }
  }

  void add_quoted(std::string_view name) {
    out_ += '\'';
    for (const char c : name) out_.append(c == '\'' ? 2 : 1, c);
    out_ += '\'';
  }

  const PlantModel& plant_;
  const std::size_t longest_;
  std::string out_;
};

}  // namespace

std::string_view comparison_text(tables::Comparison comparison) {
  switch (comparison) {
    case tables::Comparison::less:
      return "<";
    case tables::Comparison::less_equal:
      return "<=";
    case tables::Comparison::equal:
      return "=";
    case tables::Comparison::greater_equal:
      return ">=";
    case tables::Comparison::greater:
      return ">";
  }
  return "?";
}

std::string operand_text(const Atom& atom) {
  switch (atom.number) {
    case tables::NumberKind::signed_integer:
      return fmt::format("{}", static_cast<std::int64_t>(atom.operand));
    case tables::NumberKind::unsigned_integer:
      return fmt::format("{}", atom.operand);
    case tables::NumberKind::real:
      return fmt::format("{}", std::bit_cast<double>(atom.operand));
  }
  return "?";
}

std::string condition_text(const Tree& tree, const PlantModel& plant, std::size_t longest) {
  return ConditionWriter(plant, longest).write(tree);
}

}  // namespace symplant::model
