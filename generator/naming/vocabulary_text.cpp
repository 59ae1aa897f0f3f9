// Writes the words that ship.
#include "naming/vocabulary_text.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "name/vocabulary.hpp"

namespace symplant::naming {
namespace {

using Json = nlohmann::ordered_json;

Json words_json(std::span<const std::string_view> words) {
  return Json(std::vector<std::string_view>(words.begin(), words.end()));
}

Json classes_json(const name::BuiltInWords& words, name::Direction side) {
  Json json = Json::array();
  for (const name::BuiltInWords::ClassWord& one : words.classes) {
    if (one.side == side) json.push_back(one.word);
  }
  return json;
}

/// Each motion with the words that mean it.
Json motions_json(const name::BuiltInWords& words) {
  Json json = Json::object();
  for (const name::BuiltInWords::Pair& pair : words.pairs) {
    for (const std::string_view word : {pair.rest, pair.other}) json[std::string(word)] = Json::array();
  }
  for (const name::BuiltInWords::Synonym& synonym : words.synonyms) {
    json[std::string(synonym.canonical)].push_back(synonym.words);
  }
  return json;
}

}  // namespace

std::string vocabulary_text() {
  const name::BuiltInWords& words = name::built_in_words();
  Json pairs = Json::array();
  for (const name::BuiltInWords::Pair& pair : words.pairs) pairs.push_back({pair.rest, pair.other});
  const std::vector<std::pair<std::string_view, Json>> members = {
      {"pairs", pairs},
      {"synonyms", motions_json(words)},
      {"operation-affixes", words_json(words.operation_affixes)},
      {"event-affixes", words_json(words.event_affixes)},
      {"operation-classes", classes_json(words, name::Direction::operation)},
      {"event-classes", classes_json(words, name::Direction::event)},
      {"operator", words_json(words.panel)},
      {"alarm", words_json(words.alarm)},
      {"diagnosis", words_json(words.diagnosis)},
      {"data", words_json(words.data)},
      {"parts", words_json(words.parts)},
      {"spare", words_json(words.spare)},
      {"healthy", words_json(words.healthy)},
      {"interlock", words_json(words.interlock)},
      {"mutual", words_json(words.mutual)},
      {"echo", words_json(words.echo)},
      {"start", words_json(words.start)},
      {"done", words_json(words.done)},
      {"reset", words_json(words.reset)}};
  std::string text;
  for (const auto& [key, value] : members) {
    text.append(text.empty() ? "{ " : ",\n  ").append(Json(key).dump()).append(": ").append(value.dump());
  }
  return text + " }\n";
}

}  // namespace symplant::naming
