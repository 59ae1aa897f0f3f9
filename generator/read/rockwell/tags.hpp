// The rows of a Logix export: tags, aliases and comments on operands become rows of a symbol table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string_view>
#include <vector>

#include "read/rockwell/aliases.hpp"
#include "read/rockwell/operands.hpp"
#include "read/table_builder.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

/// A tag as an export declares it. Views must outlive the table: they point into the file or are kept by the builder.
struct RockwellTag {
  std::string_view scope;  ///< the program; empty: the controller
  std::string_view name;
  std::string_view type;     ///< empty for an alias
  std::string_view target;   ///< the operand that an alias names; empty: no alias
  std::string_view comment;  ///< as written
  std::uint32_t line = 0;
  text::Span whole;
};

/// A comment on a member, an element or a bit of a tag.
struct RockwellComment {
  std::string_view scope;
  std::string_view operand;
  std::string_view text;  ///< as written
  std::uint32_t line = 0;
  text::Span whole;
};

/// Collects what an export declares, then makes the rows:
/// - each tag and alias is a row; an alias has the operand that it names in the end as its address, but a whole module
///   and a word whose bits are rows have the type STRUCTURE and no address;
/// - a comment on module I/O that no alias names, and of which no row is a part, is a row with the operand as name;
/// - all other comments are used where an alias has no comment itself, or as the comment of the part's parent.
/// A tag of a program has the name `PROGRAM.NAME` if another scope has a tag of that name.
class RockwellTags {
 public:
  enum class Texts : std::uint8_t { plain, escaped };

  RockwellTags(TableBuilder& builder, Texts texts) : builder_(builder), texts_(texts) {}

  void add(const RockwellTag& tag) { tags_.push_back(tag); }
  void add(const RockwellComment& comment) { comments_.push_back(comment); }

  /// Makes the rows of all that was added, and the decisions about them. Once. `controller`: of one of several in the
  /// list, which is part of the scope of its tags; repeated names are then qualified by the caller.
  void make_rows(std::string_view controller = {});

 private:
  using Outcome = AliasResolver::Outcome;

  void resolve();
  void take_comments();
  void mark_operands();
  std::string_view scope_of(std::string_view program);
  void make_row(const RockwellTag& tag, std::string_view resolved);
  void fill_alias(ListRow& row, const RockwellTag& tag, std::uint32_t operand);
  void make_row(const RockwellComment& comment, std::uint32_t operand);
  void report_unresolved(const RockwellTag& tag, const AliasResolver::Operand& operand);
  void report_further_unresolved();
  void describe();

  std::string_view decoded(std::string_view text);
  std::string_view comment_of(std::uint32_t operand);
  std::string_view comment_of_parent(std::uint32_t operand);

  TableBuilder& builder_;
  Texts texts_;
  std::string_view controller_;
  std::deque<RockwellTag> tags_;
  std::deque<RockwellComment> comments_;
  std::vector<std::string_view> tag_operands_;   ///< for each tag, resolved
  std::vector<std::uint32_t> comment_operands_;  ///< for each comment, resolved
  RockwellOperands operands_;
  std::size_t of_io_ = 0;  ///< aliases of module I/O
  std::size_t aliases_ = 0;
  std::size_t rows_of_comments_ = 0;
  std::size_t words_of_bits_ = 0;  ///< aliases of which other rows are parts
  std::size_t unresolved_ = 0;     ///< aliases that lead to no tag
};

}  // namespace symplant::read
