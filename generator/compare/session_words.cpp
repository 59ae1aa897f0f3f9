// Acts at the panel in words.
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compare/session.hpp"

namespace symplant::compare {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostListed = 3;

std::string plain(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "A, B, C and 2 more".
std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (std::size_t i = 0; i < std::min(texts.size(), kMostListed); ++i) all += (i == 0 ? "" : ", ") + texts[i];
  if (texts.size() > kMostListed) all += " and " + std::to_string(texts.size() - kMostListed) + " more";
  return all;
}

/// The members of an object, or the elements of a list, or one value.
std::string listed(const Json& of, std::string_view between) {
  std::vector<std::string> texts;
  if (of.is_object()) {
    for (const auto& [name, value] : of.items()) texts.push_back(name + std::string(between) + plain(value));
  } else if (of.is_array()) {
    std::transform(of.begin(), of.end(), std::back_inserter(texts), plain);
  } else {
    texts.push_back(plain(of));
  }
  return joined(texts);
}

std::string parts(const Json& of) {
  std::vector<std::string> texts;
  for (const Json& part : of.is_array() ? of : Json::array({of})) {
    const bool is_part = part.is_object() && part.contains("at") && part.contains("kind");
    texts.push_back(is_part ? plain(part["kind"]) + " at " + plain(part["at"]) : plain(part));
  }
  return joined(texts);
}

/// What a key of an act does: `begin`, then its value.
struct Verb {
  std::string_view key;
  std::string_view begin;
  std::string_view between;  ///< of a name and its value
};
constexpr Verb kVerbs[] = {
    {"set", "set ", " "},      {"state", "put ", " into "},    {"take", "took a part from ", " "},
    {"force", "forced ", " "}, {"release", "released ", " "},  {"start", "started ", " "},
    {"stop", "stopped ", " "}, {"restart", "restarted ", " "},
};

std::string words_of(const std::string& key, const Json& of) {
  if (key == "put") return "put " + parts(of);
  for (const Verb& verb : kVerbs) {
    if (key == verb.key) return std::string(verb.begin) + listed(of, verb.between);
  }
  return key + " " + of.dump();
}

}  // namespace

bool is_on_plant(const Json& act) {
  constexpr std::string_view kKeys[] = {"set", "state", "put", "take", "force", "release", "restart"};
  return std::any_of(std::begin(kKeys), std::end(kKeys), [&](std::string_view key) { return act.contains(key); });
}

std::string act_words(const Json& act) {
  std::string words;
  for (const auto& [key, of] : act.items()) words += (words.empty() ? "" : ", ") + words_of(key, of);
  return words;
}

}  // namespace symplant::compare
