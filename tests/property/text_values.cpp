// Writes and reads values and signals: a line for each member that is given. Formulas are last on their lines.
#include "property/text_values.hpp"

#include <array>
#include <stdexcept>

#include "property/value_differences.hpp"

namespace symplant::property {
namespace {

using description::GivenSignal;
using description::GivenValue;

constexpr std::array<std::string_view, 11> kKindWords = {
    "parameter", "integral", "lag", "ramp", "delay", "derivative", "is", "position", "noise", "pid", "linear"};

/// Texts and numbers of a value, by their words.
struct TextMember {
  std::string_view word;
  std::string GivenValue::*member;
};
constexpr std::array kTextMembers = {TextMember{"for", &GivenValue::for_each},
                                     TextMember{"unit", &GivenValue::unit},
                                     TextMember{"formula", &GivenValue::formula},
                                     TextMember{"up", &GivenValue::up},
                                     TextMember{"down", &GivenValue::down},
                                     TextMember{"of", &GivenValue::of},
                                     TextMember{"to", &GivenValue::to}};
struct NumberMember {
  std::string_view word;
  std::optional<double> GivenValue::*member;
};
constexpr std::array kNumberMembers = {NumberMember{"start", &GivenValue::start}, NumberMember{"min", &GivenValue::min},
                                       NumberMember{"max", &GivenValue::max}};
struct TimeMember {
  std::string_view word;
  std::optional<tables::Time> GivenValue::*member;
};
constexpr std::array kTimeMembers = {TimeMember{"time", &GivenValue::time}, TimeMember{"ti", &GivenValue::ti},
                                     TimeMember{"step", &GivenValue::step}, TimeMember{"trace", &GivenValue::trace}};
struct MatrixMember {
  std::string_view word;
  description::Matrix GivenValue::*member;
};
constexpr std::array kMatrixMembers = {MatrixMember{"a", &GivenValue::a}, MatrixMember{"b", &GivenValue::b},
                                       MatrixMember{"c", &GivenValue::c}, MatrixMember{"d", &GivenValue::d}};

std::string numbers_text(const auto& numbers) {
  std::string text;
  for (const double number : numbers) text += " " + number_text(number);
  return text;
}

struct ValueLines {
  std::vector<std::string> lines;

  void add(std::string_view word, const std::string& text) {
    lines.push_back("value-" + std::string(word) + " " + text);
  }

  void value(const GivenValue& given) {
    lines.push_back("value " + given.name + " " + std::string(kKindWords[static_cast<std::size_t>(given.kind)]));
    for (const TextMember& each : kTextMembers) {
      if (!(given.*each.member).empty()) add(each.word, given.*each.member);
    }
    for (const NumberMember& each : kNumberMembers) {
      if (given.*each.member) add(each.word, number_text(*(given.*each.member)));
    }
    for (const TimeMember& each : kTimeMembers) {
      if (given.*each.member) add(each.word, std::to_string(*(given.*each.member)));
    }
    if (given.noise != 0) add("noise", number_text(given.noise));
    if (given.kp != 0) add("kp", number_text(given.kp));
    if (given.td != 0) add("td", std::to_string(given.td));
    for (const auto& [state, number] : given.at) add("at", state + " " + number_text(number));
    for (const MatrixMember& each : kMatrixMembers) {
      for (const std::vector<double>& row : given.*each.member) add(each.word, numbers_text(row).substr(1));
    }
    for (const std::string& u : given.u) add("u", u);
    for (const double state : given.start_states) add("state", number_text(state));
    for (const description::GivenChange& change : given.changes) {
      add("when", change.when);
      add("jump", change.to);
    }
  }

  void signal(const GivenSignal& given) {
    const auto add_signal = [&](const std::string& text) { lines.push_back("signal-" + text); };
    lines.push_back("signal " + given.symbol);
    add_signal("of " + given.of);
    if (given.from) add_signal("from" + numbers_text(*given.from));
    if (given.to) add_signal("to" + numbers_text(*given.to));
    if (given.limit) add_signal("limit" + numbers_text(*given.limit));
    if (given.noise != 0) add_signal("noise " + number_text(given.noise));
    if (given.every) add_signal("every " + std::to_string(*given.every));
  }
};

void read_kind(Line& line, GivenValue& given) {
  given.name = line.word();
  const std::string word = line.word();
  for (std::size_t i = 0; i < kKindWords.size(); ++i) {
    if (kKindWords[i] != word) continue;
    given.kind = static_cast<tables::ValueKind>(i);
    return;
  }
  throw std::runtime_error("`" + word + "` is no kind of value");
}

/// False if no table has the word.
bool read_member(const std::string& word, Line& line, GivenValue& given) {
  for (const TextMember& each : kTextMembers) {
    if (each.word == word) return given.*each.member = line.all(), true;
  }
  for (const NumberMember& each : kNumberMembers) {
    if (each.word == word) return given.*each.member = line.number<double>(), true;
  }
  for (const TimeMember& each : kTimeMembers) {
    if (each.word == word) return given.*each.member = line.number<tables::Time>(), true;
  }
  for (const MatrixMember& each : kMatrixMembers) {
    if (each.word != word) continue;
    std::vector<double>& row = (given.*each.member).emplace_back();
    while (!line.at_end()) row.push_back(line.number<double>());
    return true;
  }
  return false;
}

void read_other_member(const std::string& word, Line& line, GivenValue& given) {
  if (word == "noise") {
    given.noise = line.number<double>();
  } else if (word == "kp") {
    given.kp = line.number<double>();
  } else if (word == "td") {
    given.td = line.number<tables::Time>();
  } else if (word == "at") {
    std::string state = line.word();
    given.at.emplace_back(std::move(state), line.number<double>());
  } else if (word == "u") {
    given.u.push_back(line.all());
  } else if (word == "state") {
    given.start_states.push_back(line.number<double>());
  } else if (word == "when") {
    given.changes.emplace_back().when = line.all();
  } else if (word == "jump" && !given.changes.empty()) {
    given.changes.back().to = line.all();
  } else {
    throw std::runtime_error("`" + word + "` of a value");
  }
}

std::array<double, 2> two_numbers(Line& line) {
  const double first = line.number<double>();
  return {first, line.number<double>()};
}

void read_signal_member(const std::string& word, Line& line, GivenSignal& given) {
  if (word == "of") {
    given.of = line.all();
  } else if (word == "from") {
    given.from = two_numbers(line);
  } else if (word == "to") {
    given.to = two_numbers(line);
  } else if (word == "limit") {
    given.limit = two_numbers(line);
  } else if (word == "noise") {
    given.noise = line.number<double>();
  } else if (word == "every") {
    given.every = line.number<tables::Time>();
  } else {
    throw std::runtime_error("`" + word + "` of a signal");
  }
}

}  // namespace

std::vector<std::string> value_lines(const description::Description& description) {
  ValueLines all;
  for (const std::string& symbol : description.plain) all.lines.push_back("plain " + symbol);
  for (const GivenValue& given : description.values) all.value(given);
  for (const GivenSignal& given : description.signals) all.signal(given);
  return all.lines;
}

bool is_value_word(const std::string& word) {
  return word == "plain" || word == "value" || word.starts_with("value-") || word == "signal" ||
         word.starts_with("signal-");
}

void read_value(const std::string& word, Line& line, description::Description& description) {
  if (word == "plain") {
    description.plain.push_back(line.word());
  } else if (word == "value") {
    read_kind(line, description.values.emplace_back());
  } else if (word == "signal") {
    description.signals.emplace_back().symbol = line.word();
  } else if (word.starts_with("value-") && !description.values.empty()) {
    const std::string member = word.substr(6);
    if (!read_member(member, line, description.values.back())) {
      read_other_member(member, line, description.values.back());
    }
  } else if (word.starts_with("signal-") && !description.signals.empty()) {
    read_signal_member(word.substr(7), line, description.signals.back());
  } else {
    throw std::runtime_error("`" + word + "`");
  }
}

}  // namespace symplant::property
