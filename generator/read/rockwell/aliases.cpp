// Resolves aliases of Logix tags to the operands that they name.
#include "read/rockwell/aliases.hpp"

#include <algorithm>

#include "text/ascii.hpp"

namespace symplant::read {

namespace {

constexpr std::uint32_t kNoTag = base::IndexTable::kNothing;

std::uint64_t hash_of_tag(std::string_view scope, std::string_view name) {
  return text::hash_ignoring_case(scope) * 31 + text::hash_ignoring_case(name);
}

}  // namespace

OperandParts split_operand(std::string_view operand) {
  const std::size_t end = std::min(operand.find_first_of(".["), operand.size());
  return {operand.substr(0, end), operand.substr(end)};
}

bool AliasResolver::add(std::string_view scope, std::string_view name, std::string_view target) {
  const auto index = static_cast<std::uint32_t>(tags_.size());
  const std::uint32_t found = by_name_.find_or_add(hash_of_tag(scope, name), index, [&](std::uint32_t other) {
    return text::equal_ignoring_case(tags_[other].name, name) && text::equal_ignoring_case(tags_[other].scope, scope);
  });
  if (found != index) return false;
  tags_.push_back({scope, name, target});
  return true;
}

AliasResolver::Operand AliasResolver::resolve(std::string_view scope, std::string_view operand) {
  const OperandParts parts = split_operand(operand);
  const std::uint32_t tag = find_visible(scope, parts.base);
  if (tag == kNoTag) return {operand, Outcome::unknown_tag};
  const Operand base = of_tag(tag);
  return base.text.data() == tags_[tag].name.data() ? Operand{operand, base.outcome}
                                                    : joined(base, parts.tail, operand);
}

std::uint32_t AliasResolver::find(std::string_view scope, std::string_view name) const {
  return by_name_.find(hash_of_tag(scope, name), [&](std::uint32_t other) {
    return text::equal_ignoring_case(tags_[other].name, name) && text::equal_ignoring_case(tags_[other].scope, scope);
  });
}

std::uint32_t AliasResolver::find_visible(std::string_view scope, std::string_view name) const {
  const std::uint32_t tag = scope.empty() ? kNoTag : find(scope, name);
  return tag == kNoTag ? find({}, name) : tag;
}

/// What a tag without target, or with one that was resolved, names.
AliasResolver::Operand AliasResolver::of_tag(std::uint32_t tag) {
  std::uint32_t next = tag;
  Operand end{};
  path_.clear();
  for (;;) {
    Tag& here = tags_[next];
    if (here.state == State::followed) {
      end = {here.name, Outcome::cycle};
      break;
    }
    if (here.state == State::open && here.target.empty()) {
      here.resolved = of_base(here);
      here.state = State::done;
    }
    if (here.state == State::done) {
      end = here.resolved;
      break;
    }
    here.state = State::followed;
    path_.push_back(next);
    const OperandParts parts = split_operand(here.target);
    next = find_visible(here.scope, parts.base);
    if (next == kNoTag) {
      end = {parts.base, Outcome::unknown_tag};
      break;
    }
  }
  for (; !path_.empty(); path_.pop_back()) {
    Tag& here = tags_[path_.back()];
    end = joined(end, split_operand(here.target).tail, here.name);
    here.resolved = end;
    here.state = State::done;
  }
  return end;
}

AliasResolver::Operand AliasResolver::of_base(const Tag& tag) {
  if (tag.scope.empty()) return {tag.name, Outcome::tag};
  return {arena_.emplace_back("\\").append(tag.scope).append(".").append(tag.name), Outcome::tag};
}

AliasResolver::Operand AliasResolver::joined(const Operand& base, std::string_view tail, std::string_view written) {
  if (base.outcome == Outcome::cycle || base.outcome == Outcome::too_long) return {written, base.outcome};
  if (tail.empty()) return base;
  if (base.text.size() + tail.size() > kLongestOperand) return {written, Outcome::too_long};
  return {arena_.emplace_back(base.text).append(tail), base.outcome};
}

}  // namespace symplant::read
