// The rows of a Logix export.
#include "read/rockwell_tags.hpp"

#include <algorithm>
#include <string>

#include "read/rockwell_text.hpp"
#include "read/rules/alias_not_resolved.hpp"

namespace symplant::read {

namespace {

/// The type of rows that name a whole of which the inputs and outputs are parts, if the export gives none.
constexpr std::string_view kStructure = "STRUCTURE";

bool is_of_module(std::string_view name) { return name.find(':') != std::string_view::npos; }

/// Whether an operand is a part of a module's input or output tag: `Local:1:I.Data.0`, `Box:O1.Data[2].7`.
bool is_module_io(std::string_view operand) {
  const OperandParts parts = split_operand(operand);
  const std::size_t colon = parts.base.rfind(':');
  if (parts.tail.empty() || colon == std::string_view::npos || colon + 1 == parts.base.size()) return false;
  const char area = text::upper(parts.base[colon + 1]);
  const std::string_view number = parts.base.substr(colon + 2);
  return (area == 'I' || area == 'O') && std::all_of(number.begin(), number.end(), text::is_digit);
}

/// The operand without its last member, element or bit; empty for a tag, and for what is no operand by its length.
std::string_view parent_operand(std::string_view operand) {
  if (operand.size() > kLongestOperand) return {};
  const std::size_t end = operand.find_last_of(".[");
  return end == std::string_view::npos ? std::string_view() : operand.substr(0, end);
}

std::string counted_items(std::size_t count, const std::string& what) { return std::to_string(count) + " " + what; }

}  // namespace

void RockwellTags::make_rows() {
  declare();
  index_texts();
  index_operands();
  builder_.table().rows.reserve(tags_.size());
  for (std::size_t i = 0; i < tags_.size(); ++i) make_row(tags_[i], tag_operands_[i]);
  for (std::size_t i = 0; i < comments_.size(); ++i) make_row(comments_[i], comment_operands_[i]);
  describe();
}

void RockwellTags::declare() {
  for (const RockwellTag& tag : tags_) {
    aliases_.add(tag.scope, tag.name, tag.target);
    const auto [first, added] = scope_of_name_.try_emplace(tag.name, tag.scope);
    if (!added && !text::equal_ignoring_case(first->second, tag.scope)) repeated_.insert(tag.name);
  }
  tag_operands_.reserve(tags_.size());
  for (const RockwellTag& tag : tags_) {
    const AliasResolver::Operand operand = aliases_.resolve(tag.scope, tag.target.empty() ? tag.name : tag.target);
    tag_operands_.push_back(operand.text);
    if (tag.target.empty()) continue;
    ++aliases_count_;
    report_unresolved(tag, operand.outcome);
  }
  comment_operands_.reserve(comments_.size());
  for (const RockwellComment& comment : comments_) {
    comment_operands_.push_back(aliases_.resolve(comment.scope, comment.operand).text);
  }
}

void RockwellTags::report_unresolved(const RockwellTag& tag, AliasResolver::Outcome outcome) {
  using Outcome = AliasResolver::Outcome;
  const bool missing = outcome == Outcome::unknown_tag && !is_of_module(tag_operands_.back());
  if (outcome == Outcome::tag || (outcome == Outcome::unknown_tag && !missing)) return;
  std::string message = "the alias `" + std::string(tag.name) + "` of `" + std::string(tag.target) + "` ";
  if (outcome == Outcome::cycle) {
    message += "leads back to itself, so it is counted as memory; name another tag";
  } else if (missing) {
    message += "leads to a tag that the list does not have, so it is counted as memory; export that tag too";
  } else {
    message += "has an operand of more than " + std::to_string(kLongestOperand) +
               " characters, so it is counted as memory; shorten the chain of aliases";
  }
  builder_.report(kAliasNotResolved, std::move(message), builder_.source().span_of(tag.target, tag.whole));
}

void RockwellTags::index_texts() {
  const auto add = [&](std::string_view operand, std::string_view text) {
    if (!text.empty()) text_of_operand_.try_emplace(operand, Text{text, false});
  };
  text_of_operand_.reserve(comments_.size());
  for (std::size_t i = 0; i < comments_.size(); ++i) add(comment_operands_[i], comments_[i].text);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    if (tags_[i].target.empty() || is_of_module(tags_[i].name)) add(tag_operands_[i], tags_[i].comment);
  }
}

void RockwellTags::index_operands() {
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    if (tags_[i].target.empty() || is_of_module(tags_[i].name) || !is_module_io(tag_operands_[i])) continue;
    ++of_io_;
    io_operands_.insert(tag_operands_[i]);
    add_wholes(tag_operands_[i]);
  }
  for (const std::string_view operand : comment_operands_) {
    if (is_module_io(operand)) add_wholes(operand);
  }
}

/// Marks all of which an operand is a part.
void RockwellTags::add_wholes(std::string_view operand) {
  do operand = parent_operand(operand);
  while (is_module_io(operand) && io_wholes_.insert(operand).second);
}

void RockwellTags::make_row(const RockwellTag& tag, std::string_view resolved) {
  ListRow& row = builder_.add(tag.whole, tag.line);
  row.name = name_of(tag);
  row.type = tag.type;
  row.comment = decoded(tag.comment);
  if (!tag.scope.empty()) builder_.extra(row).scope = tag.scope;
  const bool whole_module = is_of_module(tag.name) || (is_of_module(resolved) && split_operand(resolved).tail.empty());
  const bool word_of_bits = !whole_module && io_wholes_.contains(resolved);
  if (word_of_bits) ++words_of_bits_;
  if (whole_module || word_of_bits) {
    if (row.type.empty()) row.type = kStructure;
  } else {
    row.vendor_address = resolved;
  }
  if (!tag.target.empty()) fill_alias(row, tag, resolved);
}

void RockwellTags::fill_alias(ListRow& row, const RockwellTag& tag, std::string_view resolved) {
  if (row.comment.empty()) row.comment = text_of(resolved);
  RowExtra& extra = builder_.extra(row);
  extra.alias = tag.target;
  extra.parent_comment = text_of_parent(resolved);
}

void RockwellTags::make_row(const RockwellComment& comment, std::string_view resolved) {
  if (!is_module_io(resolved) || io_wholes_.contains(resolved) || !io_operands_.insert(resolved).second) return;
  ++rows_of_comments_;
  ListRow& row = builder_.add(comment.whole, comment.line);
  row.name = comment.operand;
  row.vendor_address = resolved;
  row.comment = text_of(resolved);
  const std::string_view parent = text_of_parent(resolved);
  if (!parent.empty()) builder_.extra(row).parent_comment = parent;
  if (!comment.scope.empty()) builder_.extra(row).scope = comment.scope;
  if (!text::equal_ignoring_case(comment.operand, resolved)) builder_.extra(row).alias = comment.operand;
}

std::string_view RockwellTags::name_of(const RockwellTag& tag) {
  if (tag.scope.empty() || !repeated_.contains(tag.name)) return tag.name;
  return builder_.keep(std::string(tag.scope).append(".").append(tag.name));
}

std::string_view RockwellTags::decoded(std::string_view text) {
  const bool has_escape = texts_ == Texts::escaped && text.find('$') != std::string_view::npos;
  return has_escape ? builder_.keep(decode_rockwell_text(text)) : text;
}

std::string_view RockwellTags::text_of(std::string_view operand) {
  const auto found = text_of_operand_.find(operand);
  if (found == text_of_operand_.end()) return {};
  if (!found->second.decoded) found->second = {decoded(found->second.text), true};
  return found->second.text;
}

std::string_view RockwellTags::text_of_parent(std::string_view operand) {
  for (operand = parent_operand(operand); !operand.empty(); operand = parent_operand(operand)) {
    const std::string_view text = text_of(operand);
    if (!text.empty()) return text;
  }
  return {};
}

void RockwellTags::describe() {
  const std::size_t all = tags_.size();
  builder_.decide("tags: " + counted_items(all - aliases_count_, "tags, ") +
                  counted_items(aliases_count_, "aliases, ") + std::to_string(of_io_) +
                  " of them of inputs and outputs of modules");
  builder_.decide("comments on operands: " + std::to_string(comments_.size()) + ", of which " +
                  std::to_string(rows_of_comments_) +
                  " name inputs and outputs that have no alias and are rows; the others describe memory or other rows");
  if (words_of_bits_ != 0) {
    builder_.decide("aliases of words whose bits are rows: " + std::to_string(words_of_bits_) + ", kept as structures");
  }
  if (!repeated_.empty()) {
    builder_.decide("names in several programs: " + std::to_string(repeated_.size()) +
                    "; their rows are named `PROGRAM.NAME`");
  }
}

}  // namespace symplant::read
