// Writes and reads malfunctions. Names have no blanks.
#include "property/text_malfunctions.hpp"

#include <array>
#include <stdexcept>
#include <string_view>

#include "property/value_differences.hpp"

namespace symplant::property {
namespace {

constexpr std::array<std::string_view, 7> kMalfunctionWords = {"slower", "stuck", "force",  "flicker",
                                                               "lose",   "set",   "distort"};
constexpr std::string_view kSeveral = "effects";

std::string of_cell(const std::string& content) { return content.empty() ? "-" : content; }

std::string effect_text(const description::GivenEffect& given) {
  const tables::MalfunctionKind kind = given.kinds.front();
  const std::string text(kMalfunctionWords[static_cast<std::size_t>(kind)]);
  switch (kind) {
    case tables::MalfunctionKind::slower:
      return text + " " + std::to_string(given.factor);
    case tables::MalfunctionKind::stuck:
      return text + " " + of_cell(given.state);
    case tables::MalfunctionKind::force:
    case tables::MalfunctionKind::set:
      return text;
    case tables::MalfunctionKind::flicker:
      return text + " " + given.flicker.symbol + " " + property::text_of(*given.flicker.every) + " " +
             std::to_string(given.flicker.shows);
    case tables::MalfunctionKind::lose:
      return text + " " + of_cell(given.lose);
    case tables::MalfunctionKind::distort:
      return text + " " + given.distort.symbol + " " + number_text(given.distort.gain) + " " +
             number_text(given.distort.offset) + " " + number_text(given.distort.drift);
  }
  return text;
}

void add_effect_lines(const std::string& word, const description::GivenEffect& given, std::vector<std::string>& lines) {
  for (const std::string& device : given.of) lines.push_back(word + "-of " + device);
  for (const auto& [symbol, value] : given.force) lines.push_back(word + "-value " + symbol + " " + value.number);
  for (const auto& [value, number] : given.set) lines.push_back(word + "-set " + value + " " + number_text(number));
}

void read_effect(const std::string& word, Line& line, description::GivenEffect& given) {
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
  } else if (word == "distort") {
    given.distort.symbol = line.word();
    for (double* number : {&given.distort.gain, &given.distort.offset, &given.distort.drift}) {
      *number = line.number<double>();
    }
  } else if (given.kinds.empty()) {
    throw std::runtime_error("`" + word + "` is no kind of malfunction");
  }
}

description::GivenForcedValue value_in(Line& line) {
  description::GivenForcedValue value;
  value.number = value.shown = line.word();
  if (value.number == "true" || value.number == "false") value.bit = value.number == "true";
  value.holds = value.number == "hold";
  return value;
}

}  // namespace

std::vector<std::string> malfunction_lines(const std::vector<description::GivenMalfunction>& malfunctions) {
  std::vector<std::string> lines;
  for (const description::GivenMalfunction& given : malfunctions) {
    const bool several = !given.effects.empty();
    lines.push_back("malfunction " + given.name + " " + (several ? std::string(kSeveral) : effect_text(given.one)));
    add_effect_lines("malfunction", given.one, lines);
    for (const description::GivenEffect& effect : given.effects) {
      lines.push_back("effect " + effect_text(effect));
      add_effect_lines("effect", effect, lines);
    }
    if (!given.when.empty()) lines.push_back((given.during ? "malfunction-while " : "malfunction-when ") + given.when);
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
    description::GivenMalfunction& given = malfunctions.emplace_back();
    given.name = line.word();
    const std::string kind = line.word();
    if (kind != kSeveral) read_effect(kind, line, given.one);
    return;
  }
  if (malfunctions.empty()) throw std::runtime_error("`" + word + "` without a malfunction");
  description::GivenMalfunction& given = malfunctions.back();
  if (word == "effect") {
    description::GivenEffect& effect = given.effects.emplace_back();
    read_effect(line.word(), line, effect);
    return;
  }
  description::GivenEffect& effect = word.starts_with("effect-") ? given.effects.back() : given.one;
  if (word.ends_with("-of")) {
    effect.of.push_back(line.word());
    effect.of_is_list = true;
  } else if (word.ends_with("-value")) {
    std::string symbol = line.word();
    effect.force.emplace_back(std::move(symbol), value_in(line));
  } else if (word.ends_with("-set")) {
    std::string value = line.word();
    effect.set.emplace_back(std::move(value), line.number<double>());
  } else if (word == "malfunction-while") {
    given.when = line.all();
    given.during = true;
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
