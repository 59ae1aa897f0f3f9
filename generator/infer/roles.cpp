// Finds words that account for symbols.
#include "infer/roles.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
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
  std::optional<name::Direction> side;
  name::Role role;
  std::optional<bool> value;
};

std::vector<RoleWords> role_words() {
  const name::BuiltInWords& known = name::built_in_words();
  return {{"diagnosis", known.diagnosis, name::Direction::event, name::Role::constant, false},
          {"alarms", known.alarm, name::Direction::event, name::Role::constant, false},
          {"alarm lamps", known.alarm, name::Direction::operation, name::Role::operator_panel, std::nullopt},
          {"interlocks", known.interlock, std::nullopt, name::Role::interlock, std::nullopt},
          {"data", known.data, std::nullopt, name::Role::data, std::nullopt},
          {"parts", known.parts, name::Direction::event, name::Role::operator_panel, std::nullopt}};
}

/// The words of a list that occur in symbols that nothing links.
std::vector<std::string> found_words(const RoleWords& role, const std::vector<SampleWords>& texts,
                                     const Applied& applied, const name::Vocabulary& vocabulary) {
  std::vector<std::string> found;
  for (const std::string_view word : role.words) {
    const auto has = [&](const SampleWords& text) {
      if (role.side && *role.side != (text.operation ? name::Direction::operation : name::Direction::event))
        return false;
      return is_left_over(applied.pairing.accounts[text.sample]) && contains(text.words, word, vocabulary);
    };
    if (std::any_of(texts.begin(), texts.end(), has)) found.emplace_back(word);
  }
  return found;
}

/// Which of the two sides' texts with a word have to be, half of them at least, texts of the other side.
enum class Half : std::uint8_t { of_one_side, of_each_side };

/// Rules for the words that symbols of both sides with one text have.
std::vector<name::SymbolRule> mirrored_words(const name::Naming& frame, std::span<const Sample> samples,
                                             const RoleWords& role, Half half) {
  const name::Vocabulary vocabulary(frame.tasks, {});
  std::vector<name::SymbolRule> rules;
  for (const name::Source source : {name::Source::comment, name::Source::name}) {
    const std::vector<SampleWords> texts = words_of(samples, source, frame, vocabulary);
    const std::vector<SampleWords> sideless = without_sides(texts, vocabulary);
    name::SymbolRule rule;
    for (const std::string_view word : role.words) {
      std::array<std::set<std::vector<std::string>>, 2> sides;  // events, operations
      for (std::size_t i = 0; i < texts.size(); ++i) {
        if (contains(texts[i].words, word, vocabulary)) sides[texts[i].operation ? 1 : 0].insert(sideless[i].words);
      }
      const auto both = static_cast<std::size_t>(
          std::count_if(sides[0].begin(), sides[0].end(), [&](const auto& words) { return sides[1].contains(words); }));
      const auto [fewer, more] = std::minmax({sides[0].size(), sides[1].size()});
      if (both > 0 && 2 * both >= (half == Half::of_one_side ? fewer : more)) rule.has.emplace_back(word);
    }
    if (rule.has.empty()) continue;
    rule.name = role.name;
    rule.patterns.push_back({source, "*"});
    rule.side = role.side;
    rule.role = role.role;
    rules.push_back(std::move(rule));
  }
  return rules;
}

/// Contacts that are on in a healthy plant are asked for: no other word decides on them. Nothing without such contacts.
std::optional<name::SymbolRule> healthy_contacts(name::Source source, const std::vector<SampleWords>& texts,
                                                 const Applied& applied, const name::Vocabulary& vocabulary) {
  std::string words;
  for (const std::string_view word : name::built_in_words().healthy) {
    const auto ends = [&](const SampleWords& text) {
      return !text.operation && is_left_over(applied.pairing.accounts[text.sample]) &&
             contains({text.words.back()}, word, vocabulary);
    };
    if (std::none_of(texts.begin(), texts.end(), ends)) continue;
    words.append(words.empty() ? "" : "|").append(quoted(word));
  }
  if (words.empty()) return std::nullopt;
  name::SymbolRule rule;
  rule.name = "questions";
  rule.patterns.push_back({source, "*_(" + words + ")"});
  rule.side = name::Direction::event;
  rule.role = name::Role::none;
  return rule;
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

std::vector<name::SymbolRule> interlock_rules(const name::Naming& frame, std::span<const Sample> samples) {
  const name::BuiltInWords& known = name::built_in_words();
  return mirrored_words(frame, samples, {"interlocks", known.mutual, std::nullopt, name::Role::interlock, std::nullopt},
                        Half::of_one_side);
}

std::vector<name::SymbolRule> indicator_rules(const name::Naming& frame, std::span<const Sample> samples) {
  const name::BuiltInWords& known = name::built_in_words();
  std::vector<name::SymbolRule> rules =
      mirrored_words(frame, samples,
                     {"alarm lamps", known.alarm, name::Direction::operation, name::Role::operator_panel, std::nullopt},
                     Half::of_each_side);
  for (name::SymbolRule& rule : mirrored_words(
           frame, samples, {"reset lamps", known.reset, std::nullopt, name::Role::operator_panel, std::nullopt},
           Half::of_each_side)) {
    rules.push_back(std::move(rule));
  }
  return rules;
}

name::Naming with_roles(const name::Naming& naming, std::span<const Sample> samples) {
  std::vector<name::NamingFault> faults;
  const auto compiled = name::CompiledNaming::compile(naming, faults);
  if (compiled == nullptr) return naming;
  const Applied applied = apply_rule(compiled, samples);
  name::Naming result = naming;
  for (const name::Source source : {name::Source::comment, name::Source::name}) {
    const std::vector<SampleWords> texts = words_of(samples, source, naming, compiled->vocabulary());
    if (texts.size() * 20 < samples.size()) continue;
    auto questions = healthy_contacts(source, texts, applied, compiled->vocabulary());
    if (questions) result.rest.push_back(std::move(*questions));
    for (const RoleWords& role : role_words()) {
      name::SymbolRule rule;
      rule.has = found_words(role, texts, applied, compiled->vocabulary());
      if (rule.has.empty()) continue;
      rule.name = role.name;
      rule.patterns.push_back({source, "*"});
      rule.side = role.side;
      rule.role = role.role;
      rule.value = role.value;
      result.rest.push_back(std::move(rule));
    }
  }
  return result;
}

}  // namespace symplant::infer
