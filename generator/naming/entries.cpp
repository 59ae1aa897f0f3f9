// Reads texts, pairs and sides of a naming.json.
#include "naming/entries.hpp"

#include <nlohmann/json.hpp>

namespace symplant::naming {

using description::member;

std::optional<name::Said> said_of(std::string_view word) {
  if (word == "operation") return name::Direction::operation;
  if (word == "event") return name::Direction::event;
  if (word == "internal") return name::Said();
  return std::nullopt;
}

std::vector<name::DirectionWord> direction_words_of(const Json& object) {
  std::vector<name::DirectionWord> words;
  if (!object.is_object()) return words;
  for (const auto& [word, value] : object.items()) {
    const auto says = value.is_string() ? said_of(value.get_ref<const std::string&>()) : std::nullopt;
    if (says) words.push_back({word, *says});
  }
  return words;
}

std::vector<std::string> texts_of(const Json& object, std::string_view key) {
  std::vector<std::string> texts;
  const Json* array = member(object, key);
  if (array == nullptr || !array->is_array()) return texts;
  for (const Json& text : *array) {
    if (text.is_string()) texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::vector<std::pair<std::string, std::string>> pairs_of(const Json& object, std::string_view key) {
  std::vector<std::pair<std::string, std::string>> pairs;
  const Json* array = member(object, key);
  if (array == nullptr || !array->is_array()) return pairs;
  for (const Json& pair : *array) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) continue;
    pairs.emplace_back(pair[0].get<std::string>(), pair[1].get<std::string>());
  }
  return pairs;
}

std::vector<name::Replacement> replacements_of(const Json& object) {
  std::vector<name::Replacement> replacements;
  for (auto& [expression, replacement] : pairs_of(object, "replace")) {
    replacements.push_back({std::move(expression), std::move(replacement)});
  }
  return replacements;
}

std::optional<bool> optional_flag(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  return value != nullptr && value->is_boolean() ? std::optional(value->get<bool>()) : std::nullopt;
}

}  // namespace symplant::naming
