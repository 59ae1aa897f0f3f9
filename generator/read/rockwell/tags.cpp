// The rows of a Logix export.
#include "read/rockwell/tags.hpp"

#include <algorithm>
#include <string>

#include "read/rockwell/text.hpp"
#include "read/rules/alias_not_resolved.hpp"
#include "read/unique_names.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kMostUnresolved = 1000;  ///< findings; the others are counted

/// The type of rows that name a whole of which the inputs and outputs are parts, if the export gives none.
constexpr std::string_view kStructure = "STRUCTURE";

bool is_of_module(std::string_view name) { return name.find(':') != std::string_view::npos; }

}  // namespace

void RockwellTags::make_rows(std::string_view controller) {
  controller_ = controller;
  const bool has_programs =
      std::any_of(tags_.begin(), tags_.end(), [](const RockwellTag& tag) { return !tag.scope.empty(); });
  resolve();
  take_comments();
  mark_operands();
  base::reserve_large(builder_.table().rows, tags_.size());
  base::reserve_large(builder_.table().extras, aliases_);
  // What was taken in is freed while rows are made, because a list may have a million of them.
  for (const std::string_view operand : tag_operands_) {
    make_row(tags_.front(), operand);
    tags_.pop_front();
  }
  for (const std::uint32_t operand : comment_operands_) {
    make_row(comments_.front(), operand);
    comments_.pop_front();
  }
  describe();
  if (has_programs && controller.empty()) qualify_repeated_names(builder_);
}

/// The scope that qualifies a name: the controller of several, then the program.
std::string_view RockwellTags::scope_of(std::string_view program) {
  if (controller_.empty()) return program;
  return program.empty() ? controller_ : builder_.keep(std::string(controller_) + "." + std::string(program));
}

void RockwellTags::resolve() {
  AliasResolver resolver(builder_.table().arena, tags_.size());
  for (const RockwellTag& tag : tags_) resolver.add(tag.scope, tag.name, tag.target);
  tag_operands_.reserve(tags_.size());
  for (const RockwellTag& tag : tags_) {
    const AliasResolver::Operand operand = resolver.resolve(tag.scope, tag.target.empty() ? tag.name : tag.target);
    tag_operands_.push_back(operand.text);
    if (tag.target.empty()) continue;
    ++aliases_;
    report_unresolved(tag, operand);
  }
  report_further_unresolved();
  operands_.reserve(tags_.size() + comments_.size());
  comment_operands_.reserve(comments_.size());
  for (const RockwellComment& comment : comments_) {
    comment_operands_.push_back(operands_.number_of(resolver.resolve(comment.scope, comment.operand).text));
  }
}

void RockwellTags::report_unresolved(const RockwellTag& tag, const AliasResolver::Operand& operand) {
  const bool missing = operand.outcome == Outcome::unknown_tag && !is_of_module(operand.text);
  if (operand.outcome == Outcome::tag || (operand.outcome == Outcome::unknown_tag && !missing)) return;
  if (++unresolved_ > kMostUnresolved) return;
  std::string message = "the alias `" + std::string(tag.name) + "` of `" + std::string(tag.target) + "` ";
  if (operand.outcome == Outcome::cycle) {
    message += "leads back to itself, so it is counted as memory; name another tag";
  } else if (missing) {
    message += "leads to a tag that the list does not have, so it is counted as memory; export that tag too";
  } else {
    message += "has an operand of more than " + std::to_string(kLongestOperand) +
               " characters, so it is counted as memory; shorten the chain of aliases";
  }
  builder_.report(kAliasNotResolved, std::move(message), builder_.source().span_of(tag.target, tag.whole));
}

void RockwellTags::report_further_unresolved() {
  if (unresolved_ <= kMostUnresolved) return;
  builder_.report(
      kAliasNotResolved,
      std::to_string(unresolved_ - kMostUnresolved) +
          " further aliases lead to no tag of the list, so they are counted as memory; export all tags of the "
          "controller",
      {0, 0});
}

void RockwellTags::take_comments() {
  const auto take = [&](std::uint32_t number, std::string_view text) {
    if (operands_[number].comment.empty()) operands_[number].comment = text;
  };
  for (std::size_t i = 0; i < comments_.size(); ++i) take(comment_operands_[i], comments_[i].text);
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    const RockwellTag& tag = tags_[i];
    if (tag.comment.empty() || (!tag.target.empty() && !is_of_module(tag.name))) continue;
    take(operands_.number_of(tag_operands_[i]), tag.comment);
  }
}

/// Marks the operands that have a row, and all of which such an operand is a part.
void RockwellTags::mark_operands() {
  for (std::size_t i = 0; i < tags_.size(); ++i) {
    if (tags_[i].target.empty() || is_of_module(tags_[i].name) || !is_module_io(tag_operands_[i])) continue;
    ++of_io_;
    const std::uint32_t number = operands_.number_of(tag_operands_[i]);
    operands_[number].has_row = true;
    operands_.mark_wholes(number);
  }
  for (const std::uint32_t number : comment_operands_) {
    if (is_module_io(operands_[number].text)) operands_.mark_wholes(number);
  }
}

void RockwellTags::make_row(const RockwellTag& tag, std::string_view resolved) {
  ListRow& row = builder_.add(tag.whole, tag.line);
  row.name = tag.name;
  row.type = tag.type;
  row.comment = decoded(tag.comment);
  const std::string_view scope = scope_of(tag.scope);
  if (!scope.empty()) builder_.extra(row).scope = scope;
  bool whole = is_of_module(tag.name) || (is_of_module(resolved) && split_operand(resolved).tail.empty());
  if (!tag.target.empty()) {
    const std::uint32_t number = operands_.number_of(resolved);
    fill_alias(row, tag, number);
    if (!whole && operands_[number].is_whole && is_module_io(resolved)) {
      whole = true;
      ++words_of_bits_;
    }
  }
  if (!whole) {
    row.vendor_address = resolved;
  } else if (row.type.empty()) {
    row.type = kStructure;
  }
}

void RockwellTags::fill_alias(ListRow& row, const RockwellTag& tag, std::uint32_t operand) {
  if (row.comment.empty()) row.comment = comment_of(operand);
  RowExtra& extra = builder_.extra(row);
  extra.alias = tag.target;
  extra.parent_comment = comment_of_parent(operand);
}

void RockwellTags::make_row(const RockwellComment& comment, std::uint32_t operand) {
  RockwellOperands::Operand& resolved = operands_[operand];
  if (resolved.has_row || resolved.is_whole || !is_module_io(resolved.text)) return;
  resolved.has_row = true;
  ++rows_of_comments_;
  ListRow& row = builder_.add(comment.whole, comment.line);
  row.name = comment.operand;
  row.vendor_address = resolved.text;
  const std::string_view scope = scope_of(comment.scope);
  if (!scope.empty()) builder_.extra(row).scope = scope;
  if (!text::equal_ignoring_case(comment.operand, resolved.text)) builder_.extra(row).alias = comment.operand;
  row.comment = comment_of(operand);
  const std::string_view parent = comment_of_parent(operand);
  if (!parent.empty()) builder_.extra(row).parent_comment = parent;
}

std::string_view RockwellTags::decoded(std::string_view text) {
  const bool has_escape = texts_ == Texts::escaped && text.find('$') != std::string_view::npos;
  return has_escape ? builder_.keep(decode_rockwell_text(text)) : text;
}

std::string_view RockwellTags::comment_of(std::uint32_t number) {
  RockwellOperands::Operand& operand = operands_[number];
  if (!operand.comment_decoded) {
    operand.comment = decoded(operand.comment);
    operand.comment_decoded = true;
  }
  return operand.comment;
}

std::string_view RockwellTags::comment_of_parent(std::uint32_t operand) {
  for (std::uint32_t parent = operands_.parent_of(operand); parent != RockwellOperands::kNone;
       parent = operands_.parent_of(parent)) {
    const std::string_view comment = comment_of(parent);
    if (!comment.empty()) return comment;
  }
  return {};
}

void RockwellTags::describe() {
  builder_.decide("tags: " + std::to_string(tag_operands_.size() - aliases_) + " tags, " + std::to_string(aliases_) +
                  " aliases, " + std::to_string(of_io_) + " of them of inputs and outputs of modules");
  builder_.decide("comments on operands: " + std::to_string(comment_operands_.size()) + ", of which " +
                  std::to_string(rows_of_comments_) +
                  " name inputs and outputs that have no alias and are rows; the others describe memory or other rows");
  if (words_of_bits_ != 0) {
    builder_.decide("aliases of words whose bits are rows: " + std::to_string(words_of_bits_) + ", kept as structures");
  }
}

}  // namespace symplant::read
