// The rows of a table from declarations in Structured Text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "read/line_counter.hpp"
#include "read/st/declarations.hpp"
#include "read/table_builder.hpp"

namespace symplant::read {

/// Adds a row for each variable of VAR_GLOBAL, and for each one with an address in any other block; counts the others.
class DeclaredRows : public DeclarationVisitor {
 public:
  explicit DeclaredRows(TableBuilder& builder) : builder_(builder), lines_(builder.text()) {}

  /// Reads a range of the file. Ranges must follow one another. `scope` is that of variables outside of any program.
  void read(text::Span range, std::string_view scope);
  /// Reads a text that is not in the file as such, but comes from `origin`, to which findings point.
  void read_copy(std::string_view text, text::Span origin, std::string_view scope);

  /// Makes repeated names unique, and returns the table; nothing, with an error, if there is no row.
  std::optional<SymbolTable> finish();

  void declared(const VariableBlock& block, const Declaration& declaration) override;
  void faulty(text::Span where, std::string fault) override;
  void unclosed_comment(text::Span where) override;

 private:
  text::Span in_file(text::Span where) const { return origin_.end != 0 ? origin_ : where; }
  std::string_view cell(std::string_view view);
  void enter(const VariableBlock& block);

  TableBuilder& builder_;
  LineCounter lines_;
  std::string_view scope_;                ///< outside of any program
  text::Span origin_;                     ///< of a copy; else empty
  std::string_view klass_;                ///< of the last block, kept
  bool entered_ = false;                  ///< the members below are those of a block of this text
  std::string_view written_scope_;        ///< of the last block, in the text
  std::string_view block_scope_;          ///< that scope as a cell
  std::uint32_t scope_extra_ = kNoExtra;  ///< for rows that have only a scope
  std::size_t locals_ = 0;
  std::size_t faults_ = 0;
};

}  // namespace symplant::read
