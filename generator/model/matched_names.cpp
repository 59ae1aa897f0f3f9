// What names in braces mean in the entry of a pattern.
#include "model/matched_names.hpp"

#include <charconv>
#include <utility>

#include "text/pattern.hpp"

namespace symplant::model {
namespace {

constexpr std::size_t kMostNamed = 3;

const SymbolReading& reading_of(const PlantModel& plant, const Unit& unit) {
  return plant.symbols[unit.first_symbol()].reading;
}

}  // namespace

MatchedNames MatchedNames::of(const PlantModel& plant, const Unit& unit, std::string_view pattern) {
  MatchedNames names;
  const SymbolReading& reading = reading_of(plant, unit);
  names.line_ = reading.line();
  names.process_ = reading.process();
  names.device_ = unit.device;
  names.self_ = unit.device_path();
  names.shares_ = text::wildcard_shares(unit.device_path(), pattern);
  if (names.shares_.empty()) names.shares_ = text::wildcard_shares(unit.path, pattern);
  return names;
}

MatchedNames MatchedNames::of(const Symbol& symbol, std::string_view pattern) {
  MatchedNames names;
  names.line_ = symbol.reading.line();
  names.process_ = symbol.reading.process();
  names.device_ = symbol.reading.device();
  names.self_ = symbol.reading.device_path();
  names.shares_ = text::wildcard_shares(symbol.name(), pattern);
  return names;
}

text::Replaced MatchedNames::replace(std::string_view text) const {
  return text::replace_braces(text, [&](std::string_view name) -> std::optional<std::string_view> {
    const auto level = [](std::string_view value) {
      return value.empty() ? std::nullopt : std::optional<std::string_view>(value);
    };
    if (name == "line") return level(line_);
    if (name == "process") return level(process_);
    if (name == "device") return level(device_);
    if (name == "self") return level(self_);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size() || number == 0 || number > shares_.size()) return {};
    return shares_[number - 1];
  });
}

std::string MatchedNames::choices() const {
  std::string text;
  const auto add = [&](std::string_view name) {
    text.append(text.empty() ? "" : ", ").append("`{").append(name).append("}`");
  };
  for (const auto& [name, value] :
       {std::pair("line", line_), {"process", process_}, {"device", device_}, {"self", self_}}) {
    if (!value.empty()) add(name);
  }
  for (std::size_t i = 0; i < shares_.size(); ++i) add(std::to_string(i + 1));
  return text;
}

void MadeNames::lacks(const description::Pointer& at, std::string_view path, std::string message,
                      std::string_view text) {
  Entry& entry = entries_[at.text()];
  if (entry.lacking++ == 0) {
    entry.message = std::move(message);
    entry.text = text;
    if (at.pattern() != nullptr) entry.pattern = at;
  }
  if (entry.paths.size() < kMostNamed) entry.paths.emplace_back(path);
}

void MadeNames::report(description::Faults& faults, const SomeHave& some_have) const {
  for (const auto& [at, entry] : entries_) {
    if (entry.lacking == 0) continue;
    // A match that overrides the entry may have what it names.
    const bool all_lack = entry.lacking == entry.takers;
    if (all_lack && !(entry.pattern && some_have(*entry.pattern, entry.text))) {
      std::string message = entry.message;
      if (entry.takers == 2) message += " (the other match lacks it too)";
      if (entry.takers > 2) message += " (the other " + std::to_string(entry.takers - 1) + " matches lack it too)";
      faults.add(description::DescriptionFault{at, std::move(message), 0, description::FaultKind::unknown_name});
      continue;
    }
    // A near name would be that of another device.
    std::string message = entry.message.substr(0, entry.message.find("; did you mean"));
    message += "; the entry is left out for ";
    for (std::size_t i = 0; i < entry.paths.size(); ++i) {
      message.append(i == 0 ? "" : ", ").append(description::ticked(entry.paths[i]));
    }
    if (entry.lacking > entry.paths.size()) {
      message.append(" and ").append(std::to_string(entry.lacking - entry.paths.size())).append(" more");
    }
    if (all_lack) {
      message += "; the other matches override it";
    } else {
      message.append(", ").append(std::to_string(entry.lacking)).append(" of the ");
      message.append(std::to_string(entry.takers)).append(" matches");
    }
    faults.warn(description::Pointer(at), std::move(message), description::FaultKind::left_out);
  }
}

}  // namespace symplant::model
