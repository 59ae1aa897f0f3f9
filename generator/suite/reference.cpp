// Makes reference traces from traces.
#include "suite/reference.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "symplant/tables/pattern.hpp"

namespace symplant::suite {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The name that a line is about: `"symbol":"NAME"`, or the location to which a part comes.
std::string name_of(const std::string& line) {
  constexpr std::string_view kSymbol = "\"symbol\":\"";
  const std::size_t at = line.find(kSymbol);
  if (at != line.npos) {
    const std::size_t begin = at + kSymbol.size();
    const std::size_t end = line.find('"', begin);
    if (end != line.npos && line.find('\\', begin) > end) return line.substr(begin, end - begin);
  }
  const OrderedJson json = OrderedJson::parse(line, nullptr, false);
  if (!json.is_object()) return "";
  if (json.contains("symbol") && json["symbol"].is_string()) return json["symbol"];
  if (json.contains("part") && json.contains("to") && json["to"].is_string()) return json["to"];
  return "";
}

class Choice {
 public:
  explicit Choice(const Chosen& chosen) : chosen_(chosen) {}

  bool has(const std::string& name) {
    if (name.empty()) return false;
    const auto [at, is_new] = known_.try_emplace(name, false);
    if (is_new) at->second = decide(name);
    return at->second;
  }

 private:
  bool decide(const std::string& name) const {
    if (chosen_.only->empty()) return chosen_.operations.contains(name);
    return std::any_of(chosen_.only->begin(), chosen_.only->end(),
                       [&](const std::string& pattern) { return tables::matches_pattern(name, pattern); });
  }

  const Chosen& chosen_;
  std::unordered_map<std::string, bool> known_;
};

}  // namespace

std::string reference_text(std::istream& trace, const Chosen& chosen, tables::Time end) {
  std::string line;
  if (!std::getline(trace, line)) return "";
  OrderedJson header = OrderedJson::parse(line, nullptr, false);
  if (!header.is_object()) return "";
  header.erase("programs");
  header["end"] = end;
  std::string text = header.dump() + "\n";
  Choice choice(chosen);
  while (std::getline(trace, line)) {
    if (choice.has(name_of(line))) text += line + "\n";
  }
  return text;
}

std::string plant_of(std::istream& trace) {
  std::string line;
  std::getline(trace, line);
  const OrderedJson header = OrderedJson::parse(line, nullptr, false);
  const bool named = header.is_object() && header.contains("plant") && header["plant"].is_string();
  return named ? header["plant"].get<std::string>() : "";
}

}  // namespace symplant::suite
