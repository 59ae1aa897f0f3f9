// Writes and reads malfunctions. Names have no blanks.
#include "property/text_malfunctions.hpp"

#include <array>
#include <stdexcept>
#include <string_view>

namespace symplant::property {
namespace {

constexpr std::array<std::string_view, 5> kMalfunctionWords = {"slower", "stuck", "force", "flicker", "lose"};

std::string of_cell(const std::string& content) { return content.empty() ? "-" : content; }

std::string head_of(const description::GivenMalfunction& given) {
  const tables::MalfunctionKind kind = given.kinds.front();
  std::string text = "malfunction " + given.name + " " + std::string(kMalfunctionWords[static_cast<std::size_t>(kind)]);
  switch (kind) {
    case tables::MalfunctionKind::slower:
      return text + " " + std::to_string(given.factor);
    case tables::MalfunctionKind::stuck:
      return text + " " + of_cell(given.state);
    case tables::MalfunctionKind::force:
      return text;
    case tables::MalfunctionKind::flicker:
      return text + " " + given.flicker.symbol + " " + property::text_of(*given.flicker.every) + " " +
             std::to_string(given.flicker.shows);
    case tables::MalfunctionKind::lose:
      return text + " " + of_cell(given.lose);
  }
  return text;
}

void read_head(Line& line, description::GivenMalfunction& given) {
  given.name = line.word();
  const std::string word = line.word();
  for (std::size_t i = 0; i < kMalfunctionWords.size(); ++i) {
    if (kMalfunctionWords[i] == word) given.kinds = {static_cast<tables::MalfunctionKind>(i)};
  }
  if (word == "slower") {
    given.factor = line.number<std::uint32_t>();
  } else if (word == "stuck") {
    given.state = line.cell();
  } else if (word == "flicker") {
    given.flicker.symbol = line.word();
    given.flicker.every = line.duration();
    given.flicker.shows = line.number<tables::Time>();
  } else if (word == "lose") {
    given.lose = line.cell();
  } else if (word != "force") {
    throw std::runtime_error("`" + word + "` is no kind of malfunction");
  }
}

description::GivenForcedValue value_in(Line& line) {
  description::GivenForcedValue value;
  value.number = value.shown = line.word();
  if (value.number == "true" || value.number == "false") value.bit = value.number == "true";
  return value;
}

}  // namespace

std::vector<std::string> malfunction_lines(const std::vector<description::GivenMalfunction>& malfunctions) {
  std::vector<std::string> lines;
  for (const description::GivenMalfunction& given : malfunctions) {
    lines.push_back(head_of(given));
    for (const std::string& device : given.of) lines.push_back("malfunction-of " + device);
    for (const auto& [symbol, value] : given.force) {
      lines.push_back("malfunction-value " + symbol + " " + value.number);
    }
    if (!given.when.empty()) lines.push_back("malfunction-when " + given.when);
    if (given.chance) lines.push_back("malfunction-chance " + property::text_of(*given.chance));
    if (given.lasts) lines.push_back("malfunction-lasts " + property::text_of(*given.lasts));
    if (!given.becomes) continue;
    lines.push_back("malfunction-becomes " + std::to_string(given.becomes->after) + " " + given.becomes->start);
    if (!given.becomes->unless.empty()) lines.push_back("malfunction-unless " + given.becomes->unless);
  }
  return lines;
}

void read_malfunction(const std::string& word, Line& line, std::vector<description::GivenMalfunction>& malfunctions) {
  if (word == "malfunction") {
    read_head(line, malfunctions.emplace_back());
    return;
  }
  if (malfunctions.empty()) throw std::runtime_error("`" + word + "` without a malfunction");
  description::GivenMalfunction& given = malfunctions.back();
  if (word == "malfunction-of") {
    given.of.push_back(line.word());
    given.of_is_list = true;
  } else if (word == "malfunction-value") {
    std::string symbol = line.word();
    given.force.emplace_back(std::move(symbol), value_in(line));
  } else if (word == "malfunction-when") {
    given.when = line.all();
  } else if (word == "malfunction-chance") {
    given.chance = line.duration();
  } else if (word == "malfunction-lasts") {
    given.lasts = line.duration();
  } else if (word == "malfunction-becomes") {
    given.becomes.emplace();
    given.becomes->after = line.number<tables::Time>();
    given.becomes->start = line.word();
  } else if (word == "malfunction-unless" && given.becomes) {
    given.becomes->unless = line.all();
  } else {
    throw std::runtime_error("`" + word + "`");
  }
}

}  // namespace symplant::property
