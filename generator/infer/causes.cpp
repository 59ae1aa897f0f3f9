// Judges differences of words by the words that ship.
#include "infer/causes.hpp"

#include <algorithm>
#include <span>

#include "infer/words.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {
namespace {

bool only(const std::vector<std::string>& words, std::initializer_list<std::span<const std::string_view>> lists) {
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(lists.begin(), lists.end(), [&](std::span<const std::string_view> list) {
      return std::find(list.begin(), list.end(), word) != list.end();
    });
  });
}

bool only_class(const std::vector<std::string>& words, name::Direction side) {
  const auto classes = name::built_in_words().classes;
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(classes.begin(), classes.end(), [&](const name::BuiltInWords::ClassWord& known) {
      return known.word == word && known.side == side;
    });
  });
}

/// Operations of a difference whose words do not say that one side causes the other.
constexpr std::size_t kLeastUnknown = 5;

}  // namespace

bool has_word(const std::vector<std::string>& words, std::span<const std::string_view> list,
              const name::Vocabulary& vocabulary) {
  return std::any_of(list.begin(), list.end(),
                     [&](std::string_view known) { return contains(words, known, vocabulary); });
}

Cause cause_of(const Difference& difference, const name::Vocabulary& vocabulary) {
  const name::BuiltInWords& known = name::built_in_words();
  const std::vector<std::string>& operation = difference.operation;
  const std::vector<std::string>& event = difference.event;
  if (has_word(event, known.alarm, vocabulary) || has_word(event, known.panel, vocabulary)) return Cause::none;
  if (has_word(operation, known.alarm, vocabulary) || has_word(operation, known.panel, vocabulary)) return Cause::none;
  if (!event.empty() && has_word(event, known.echo, vocabulary)) return Cause::echo;
  const std::string command = joined_words(operation);
  const std::string report = joined_words(event);
  const auto says_so = [&](const name::BuiltInWords::Cause& cause) {
    return cause.operation == command && cause.event == report;
  };
  if (std::any_of(known.causes.begin(), known.causes.end(), says_so)) return Cause::echo;
  if (event.empty() && has_word(operation, known.echo, vocabulary)) return Cause::ack;
  if (has_word(event, known.done, vocabulary) && !operation.empty()) return Cause::work;
  const bool operation_side =
      only(operation, {known.operation_affixes}) || only_class(operation, name::Direction::operation);
  const bool event_side = only(event, {known.event_affixes}) || only_class(event, name::Direction::event);
  if (operation_side && event_side) return Cause::sides;
  if (has_word(event, known.healthy, vocabulary)) return Cause::none;
  return Cause::unknown;
}

bool is_credible(const Difference& difference, Cause cause) {
  return cause != Cause::none && (cause != Cause::unknown || difference.support >= kLeastUnknown);
}

}  // namespace symplant::infer
