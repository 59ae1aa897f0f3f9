// Finds words that account for symbols.
#include "infer/roles.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "infer/causes.hpp"
#include "infer/words.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {
namespace {

/// Words that give one side's symbols a role.
struct RoleWords {
  std::string_view name;
  std::span<const std::string_view> words;
  std::optional<name::Side> side;
  name::Role role;
  std::optional<bool> value;
};

std::vector<RoleWords> role_words() {
  const name::BuiltInWords& known = name::built_in_words();
  return {{"diagnosis", known.diagnosis, name::Side::event, name::Role::constant, false},
          {"alarms", known.alarm, name::Side::event, name::Role::constant, false},
          {"alarm lamps", known.alarm, name::Side::operation, name::Role::operator_panel, std::nullopt},
          {"interlocks", known.interlock, std::nullopt, name::Role::data, std::nullopt},
          {"data", known.data, std::nullopt, name::Role::data, std::nullopt},
          {"parts", known.parts, name::Side::event, name::Role::operator_panel, std::nullopt}};
}

/// Whether a text ends in a word of contacts that are on in a healthy plant: those are asked for, never set off.
bool ends_healthy(const std::vector<std::string>& words, const name::Vocabulary& vocabulary) {
  return !words.empty() && has_word({words.back()}, name::built_in_words().healthy, vocabulary);
}

/// The words of a list that occur on a side, but not in a paired symbol.
std::vector<std::string> free_words(const RoleWords& role, const std::vector<SampleWords>& texts,
                                    const Applied& applied, const name::Vocabulary& vocabulary) {
  std::vector<std::string> found;
  for (const std::string_view word : role.words) {
    std::size_t free = 0;
    bool paired = false;
    for (const SampleWords& text : texts) {
      if (role.side && *role.side != (text.operation ? name::Side::operation : name::Side::event)) continue;
      const pairing::Account account = applied.pairing.accounts[text.sample];
      if (account == pairing::Account::ignored || !contains(text.words, word, vocabulary)) continue;
      const bool healthy = role.role == name::Role::constant && ends_healthy(text.words, vocabulary);
      paired = paired || healthy || account == pairing::Account::paired;
      if (account > pairing::Account::data) ++free;
      if (paired) break;
    }
    if (!paired && free != 0) found.emplace_back(word);
  }
  return found;
}

}  // namespace

std::vector<name::SymbolRule> panel_rules(const name::Naming& frame, std::span<const Sample> samples) {
  const name::Vocabulary vocabulary(frame.tasks, {});
  std::vector<name::SymbolRule> rules;
  for (const name::Source source : {name::Source::comment, name::Source::name}) {
    const std::vector<SampleWords> texts = words_of(samples, source, frame, vocabulary);
    name::SymbolRule rule;
    for (const std::string_view word : name::built_in_words().panel) {
      const auto has = [&](const SampleWords& text) { return contains(text.words, word, vocabulary); };
      if (std::any_of(texts.begin(), texts.end(), has)) rule.has.emplace_back(word);
    }
    if (rule.has.empty()) continue;
    rule.name = "panel";
    rule.patterns.push_back({source, "*"});
    rule.role = name::Role::operator_panel;
    rules.push_back(std::move(rule));
  }
  return rules;
}

name::Naming with_roles(const name::Naming& naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  if (compiled == nullptr) return naming;
  const Applied applied = apply(compiled, samples);
  name::Naming result = naming;
  std::vector<name::SymbolRule> roles;
  for (const name::Source source : {name::Source::comment, name::Source::name}) {
    const std::vector<SampleWords> texts = words_of(samples, source, naming, compiled->vocabulary());
    for (const RoleWords& role : role_words()) {
      name::SymbolRule rule;
      rule.has = free_words(role, texts, applied, compiled->vocabulary());
      if (rule.has.empty()) continue;
      rule.name = role.name;
      rule.patterns.push_back({source, "*"});
      rule.side = role.side;
      rule.role = role.role;
      rule.value = role.value;
      roles.push_back(std::move(rule));
    }
  }
  result.rules.insert(result.rules.begin(), roles.begin(), roles.end());
  return result;
}

}  // namespace symplant::infer
