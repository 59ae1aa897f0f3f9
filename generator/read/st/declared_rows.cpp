// The rows of a table from declarations in Structured Text.
#include "read/st/declared_rows.hpp"

#include <utility>

#include "read/cells/one_line.hpp"
#include "read/rules/cell_too_long.hpp"
#include "read/rules/header_alone.hpp"
#include "read/rules/row_not_understood.hpp"
#include "read/rules/unclosed_comment.hpp"
#include "read/unique_names.hpp"

namespace symplant::read {

void DeclaredRows::read(text::Span range, std::string_view scope) {
  origin_ = {};
  scope_ = scope;
  entered_ = false;
  read_declarations(builder_.text(), range, *this);
}

void DeclaredRows::read_copy(std::string_view text, text::Span origin, std::string_view scope) {
  origin_ = origin;
  scope_ = scope;
  entered_ = false;
  read_declarations(text, {0, text.size()}, *this);
}

std::optional<SymbolTable> DeclaredRows::finish() {
  if (builder_.table().rows.empty()) {
    const bool is_of_br = builder_.source().path().ends_with(".var");
    builder_.report(kHeaderAlone,
                    locals_ == 0 ? "the file declares no variable; export the list of global variables"
                                 : "the file has " + std::to_string(locals_) +
                                       " local variables, but none with an address (`AT %IX0.0`) and no `VAR_GLOBAL`; "
                                       "export the list of global variables" +
                                       (is_of_br ? "; of B&R Automation Studio give the I/O mapping (IoMap.iom)" : ""),
                    builder_.source().span_of(builder_.source().line_at(0)));
    return std::nullopt;
  }
  builder_.decide("variables: " + std::to_string(builder_.table().rows.size()) + " global or with an address, " +
                  std::to_string(locals_) + " local ones without an address left out, " + std::to_string(faults_) +
                  " declarations not readable");
  qualify_repeated_names(builder_);
  return builder_.finish();
}

void DeclaredRows::declared(const VariableBlock& block, const Declaration& declaration) {
  if (block.kind != VariableBlock::Kind::global && declaration.address.empty()) {
    locals_ += declaration.names.size();
    return;
  }
  enter(block);
  const text::Span whole = in_file(declaration.whole);
  ListRow common{};
  common.klass = klass_;
  common.vendor_address = cell(declaration.address);
  common.type = cell(declaration.type);
  if (declaration.initial.size() <= kLongestCell) common.initial = cell(declaration.initial);  // else of an array
  common.comment = cell(declaration.comment);
  common.line = lines_.line_at(whole.begin);
  common.whole = whole;
  common.extra = scope_extra_;
  if (!declaration.link.empty()) {
    common.extra = kNoExtra;
    builder_.extra(common) = {.parent_comment = cell(declaration.link), .scope = block_scope_, .alias = {}};
  }
  for (const std::string_view name : declaration.names) {
    ListRow& row = builder_.add(whole, common.line);
    row = common;
    row.name = cell(name);
  }
}

void DeclaredRows::enter(const VariableBlock& block) {
  if (klass_ != block.klass) klass_ = builder_.keep(block.klass);
  if (entered_ && written_scope_.data() == block.scope.data()) return;
  entered_ = true;
  written_scope_ = block.scope;
  block_scope_ = block.scope.empty() ? scope_ : cell(block.scope);
  scope_extra_ = builder_.extra_for_scope(block_scope_);
}

void DeclaredRows::faulty(text::Span where, std::string fault) {
  ++faults_;
  builder_.report(kRowNotUnderstood, std::move(fault), in_file(where));
}

void DeclaredRows::unclosed_comment(text::Span where) {
  builder_.report(kUnclosedComment, "this comment is never closed, so declarations may be missing; close it",
                  in_file(where));
}

/// A cell of the text that is read; text of a copy becomes a cell in the file or in the table.
std::string_view DeclaredRows::cell(std::string_view view) {
  if (view.empty()) return {};
  const text::Span span = origin_.end != 0 ? text::Span{std::string_view::npos, 0} : builder_.source().span_of(view);
  return one_line(builder_, span.begin, view);
}

}  // namespace symplant::read
