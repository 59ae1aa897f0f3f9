// Compiles a naming rule and collects its faults.
#include "name/compiled_naming.hpp"

#include <algorithm>
#include <utility>

#include "name/exact_levels.hpp"
#include "name/naming_parts.hpp"
#include "text/folding.hpp"
#include "text/pattern.hpp"

namespace symplant::name {
namespace {

std::string index_pointer(std::string_view list, std::size_t index, std::string_view key = {}) {
  std::string pointer = "/" + std::string(list) + "/" + std::to_string(index);
  if (!key.empty()) pointer.append("/").append(key);
  return pointer;
}

std::string_view source_key(Source source) {
  switch (source) {
    case Source::name:
      return "name";
    case Source::comment:
      return "comment";
    case Source::parent_and_comment:
      return "parent+comment";
    case Source::name_then_comment:
      break;
  }
  return "";
}

Replacements compiled_replacements(const std::vector<Replacement>& replacements, const std::string& pointer,
                                   std::vector<NamingFault>& faults) {
  std::vector<std::pair<std::size_t, std::string>> found;
  Replacements compiled(replacements, found);
  for (const auto& [index, reason] : found) {
    faults.push_back({pointer + "/" + std::to_string(index),
                      "`" + replacements[index].expression + "` cannot be used: " + reason + "; correct it"});
  }
  return compiled;
}

/// The field of a name in JSON; nothing if it is not a field of patterns.
std::optional<Field> field_of(std::string_view name) {
  for (std::size_t i = 0; i < kFields; ++i) {
    const auto field = static_cast<Field>(i);
    if (field != Field::x && field_name(field) == name) return field;
  }
  return std::nullopt;
}

CompiledRule compiled_rule(std::string_view list, const SymbolRule& rule, std::size_t index, const NamingParts& parts,
                           std::vector<NamingFault>& faults) {
  CompiledRule compiled{
      {}, {}, RuleFields(rule, parts.vocabulary), Replacements(), RequiredWords(rule.has, parts.separators)};
  if (rule.exact) {
    auto levels = exact_levels(rule);
    if (levels) {
      compiled.levels = std::move(*levels);
    } else {
      faults.push_back({index_pointer(list, index) + levels.error().pointer, levels.error().message});
    }
    return compiled;
  }
  compiled.replace = compiled_replacements(rule.replace, index_pointer(list, index, "replace"), faults);
  std::array<bool, kFields> has{};
  for (const SourcePattern& source : rule.patterns) {
    std::string pointer = index_pointer(list, index, "pattern");
    // If the pattern is a text, the pointer refers to no value, and its parent is meant.
    if (const std::string_view key = source_key(source.source); !key.empty()) pointer.append("/").append(key);
    auto pattern = Pattern::compile(source.pattern, parts.separators, {});
    if (!pattern) {
      faults.push_back({std::move(pointer), pattern.error().message, pattern.error().offset});
      continue;
    }
    for (std::size_t i = 0; i < kFields; ++i) has[i] = has[i] || pattern->has(static_cast<Field>(i));
    compiled.patterns.push_back({source.source, std::move(*pattern)});
  }
  for (const FieldRule& field : rule.fields) {
    const std::string pointer = index_pointer(list, index, "fields") + "/" + field.field;
    const std::optional<Field> known = field_of(field.field);
    if (!known || !has[static_cast<std::size_t>(*known)]) {
      faults.push_back({pointer, "`" + field.field + "` is not a field of this rule's pattern; remove it"});
    } else if (!field.expression.empty()) {
      const std::string reason = compiled.fields.add_expression(*known, field.expression);
      if (!reason.empty()) {
        faults.push_back({pointer, "`" + field.expression + "` is not a regular expression: " + reason});
      }
    }
  }
  return compiled;
}

}  // namespace

NamingParts::NamingParts(const Naming& naming)
    : separators(naming.separators),
      vocabulary(naming.tasks, {}),
      replace(compiled_replacements(naming.normalise.replace, "/normalise/replace", faults)) {
  for (const std::string& pattern : naming.ignore) {
    std::string folded = text::folded(text::normal_form(pattern));
    const bool written = !folded.empty() &&
                         (separators.length_at(folded, 0) != 0 || separators.length_at(folded, folded.size() - 1) != 0);
    (written ? ignore_written : ignore).push_back(std::move(folded));
  }
  for (std::size_t i = 0; i < naming.rules.size(); ++i) {
    rules.push_back(compiled_rule("rules", naming.rules[i], i, *this, faults));
  }
  for (std::size_t i = 0; i < naming.rest.size(); ++i) {
    rest.push_back(compiled_rule("rest", naming.rest[i], i, *this, faults));
  }
  for (std::size_t i = 0; i < naming.archetypes.size(); ++i) {
    std::vector<Pattern>& texts = archetypes.emplace_back();
    for (const auto& [role, text] : naming.archetypes[i].texts) {
      auto pattern = Pattern::compile(text, separators, {.archetype = true});
      if (pattern) {
        texts.push_back(std::move(*pattern));
      } else {
        faults.push_back({index_pointer("archetypes", i, archetype_role_name(role)), pattern.error().message,
                          pattern.error().offset});
      }
    }
  }
  for (const auto& [level, text] : naming.fixed) {
    if (level <= Level::device) fixed[static_cast<std::size_t>(level)] = text::normal_form(text);
  }
}

CompiledNaming::CompiledNaming(Naming naming)
    : naming_(std::move(naming)), parts_(std::make_unique<NamingParts>(naming_)) {}
CompiledNaming::~CompiledNaming() = default;

std::shared_ptr<const CompiledNaming> CompiledNaming::compile(Naming naming, std::vector<NamingFault>& faults) {
  std::shared_ptr<const CompiledNaming> compiled(new CompiledNaming(std::move(naming)));
  const std::vector<NamingFault>& found = compiled->parts_->faults;
  faults.insert(faults.end(), found.begin(), found.end());
  return found.empty() ? compiled : nullptr;
}

const Vocabulary& CompiledNaming::vocabulary() const { return parts_->vocabulary; }

const LevelRule* CompiledNaming::levels() const {
  return parts_->rules.size() == 1 && parts_->rules.front().levels ? &*parts_->rules.front().levels : nullptr;
}

std::string_view archetype_role_name(ArchetypeRole role) {
  constexpr std::array<std::string_view, kArchetypeRoles> kNames = {
      "operation", "event", "start", "busy", "done", "ack", "reset", "a", "b", "at_a", "at_b", "on", "is_on"};
  return kNames[static_cast<std::size_t>(role)];
}

namespace {

/// Texts of archetypes have no field but `{x}`, which may be anything.
class AnyField : public FieldTest {
 public:
  bool fits(Field, const PreparedText&, std::size_t, std::size_t, bool, bool) const override { return true; }
};

}  // namespace

struct ArchetypeText::Work {
  const Pattern* pattern = nullptr;
  const Separators* separators = nullptr;
  PreparedText text;
};

ArchetypeText::ArchetypeText(const CompiledNaming& naming, std::size_t archetype, std::size_t text)
    : work_(std::make_unique<Work>()) {
  work_->pattern = &naming.parts().archetypes[archetype][text];
  work_->separators = &naming.parts().separators;
}
ArchetypeText::~ArchetypeText() = default;
ArchetypeText::ArchetypeText(ArchetypeText&&) noexcept = default;
ArchetypeText& ArchetypeText::operator=(ArchetypeText&&) noexcept = default;

bool ArchetypeText::matches(std::string_view task, std::string& x) const {
  PreparedText& text = work_->text;
  text.prepare(task, *work_->separators);
  Captures captures;
  if (!work_->pattern->match(text, AnyField(), captures)) return false;
  const Capture& capture = captures[static_cast<std::size_t>(Field::x)];
  x = capture.set ? text::folded(joined_words(text, capture.begin, capture.end, '_')) : std::string();
  return true;
}

}  // namespace symplant::name
