// Reads an entry of `rules`.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "naming/entries.hpp"

namespace symplant::naming {
namespace {

using description::FaultKind;
using description::member;
using description::Pointer;
using description::text_member;
using description::text_or_empty;
using description::ticked;

name::Source source_of(std::string_view word) {
  if (word == "name") return name::Source::name;
  if (word == "comment") return name::Source::comment;
  if (word == "parent+comment") return name::Source::parent_and_comment;
  return name::Source::name_then_comment;
}

name::Role role_of(std::string_view word) {
  if (word == "operator") return name::Role::operator_panel;
  if (word == "data") return name::Role::data;
  if (word == "interlock") return name::Role::interlock;
  if (word == "constant") return name::Role::constant;
  if (word == "none") return name::Role::none;
  return name::Role::io;
}

/// Whether a pattern has the field, with or without `...` and `:known`.
bool has_field(std::string_view pattern, std::string_view field) {
  const std::string opened = "{" + std::string(field);
  for (std::size_t at = pattern.find(opened); at != pattern.npos; at = pattern.find(opened, at + 1)) {
    const std::size_t after = at + opened.size();
    if (after < pattern.size() && std::string_view("}.:").find(pattern[after]) != std::string_view::npos) return true;
  }
  return false;
}

class RuleEntry {
 public:
  RuleEntry(const Json& entry, const Pointer& here, description::ShapeFaults& faults)
      : entry_(entry), here_(here), faults_(faults) {}

  name::SymbolRule read() {
    rule_.name = text_or_empty(entry_, "name");
    read_patterns();
    read_fields();
    read_classes();
    rule_.replace = replacements_of(entry_);
    rule_.has = texts_of(entry_, "has");
    rule_.side = said_of(text_or_empty(entry_, "side")).value_or(name::Said());
    read_task();
    rule_.exact = description::flag_member(entry_, "exact");
    rule_.unlinked_states = text_or_empty(entry_, "unlinked") == "states";
    rule_.fan_out = description::flag_member(entry_, "fan-out");
    read_role();
    return std::move(rule_);
  }

 private:
  void contradiction(std::string_view key, std::string message) {
    faults_.add(here_ / key, std::move(message), FaultKind::contradiction);
  }

  void read_patterns() {
    const std::string source = text_or_empty(entry_, "source");
    const Json* pattern = member(entry_, "pattern");
    if (pattern == nullptr) return;
    if (pattern->is_string()) rule_.patterns.push_back({source_of(source), pattern->get<std::string>()});
    if (!pattern->is_object()) return;
    if (!source.empty()) contradiction("source", "`pattern` names the sources already; remove `source`");
    if (pattern->empty()) {
      contradiction("pattern",
                    "`pattern` names no source; give it a pattern for `name`, `comment` or `parent+comment`");
    }
    for (const auto& [key, text] : pattern->items()) {
      if (text.is_string()) rule_.patterns.push_back({source_of(key), text.get<std::string>()});
    }
  }

  bool some_pattern_has(std::string_view field) const {
    return std::any_of(rule_.patterns.begin(), rule_.patterns.end(),
                       [&](const name::SourcePattern& one) { return has_field(one.pattern, field); });
  }

  void read_fields() {
    const Json* fields = member(entry_, "fields");
    if (fields == nullptr || !fields->is_object()) return;
    for (const auto& [field, value] : fields->items()) {
      name::FieldRule one;
      one.field = field;
      if (value.is_string()) one.expression = value.get<std::string>();
      one.words = direction_words_of(value);
      if (field == "class" && !one.words.empty()) {
        rule_.classes = std::move(one.words);
      } else {
        rule_.fields.push_back(std::move(one));
      }
    }
  }

  void read_classes() {
    const Json* classes = member(entry_, "classes");
    if (classes == nullptr) return;
    if (!rule_.classes.empty()) {
      contradiction("classes", "`fields` gives the words of `class` already; remove one of the two");
    }
    if (!some_pattern_has("class")) {
      contradiction("classes", "the pattern has no field `{class}`; add it to the pattern, or remove this");
    }
    rule_.classes = direction_words_of(*classes);
  }

  void read_task() {
    const std::string* task = text_member(entry_, "task");
    if (task == nullptr) return;
    if (some_pattern_has("task")) {
      contradiction("task", "the pattern has the field `{task}`, so the task is not fixed; remove one of the two");
    }
    rule_.task = *task;
  }

  void read_role() {
    const std::string role = text_or_empty(entry_, "role");
    rule_.role = role_of(role);
    if (rule_.role != name::Role::io && rule_.fan_out) {
      contradiction("fan-out", "symbols of the role " + ticked(role) + " are never linked; remove `fan-out` or `role`");
    }
    rule_.value = optional_flag(entry_, "value");
    if (rule_.value && rule_.role != name::Role::constant) {
      contradiction("value", "only rules with `\"role\": \"constant\"` have a value; remove it, or add the role");
    }
  }

  const Json& entry_;
  const Pointer& here_;
  description::ShapeFaults& faults_;
  name::SymbolRule rule_;
};

}  // namespace

name::SymbolRule rule_entry(const Json& entry, const Pointer& here, description::ShapeFaults& faults) {
  return RuleEntry(entry, here, faults).read();
}

}  // namespace symplant::naming
