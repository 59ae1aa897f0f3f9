// Reads VCD files as symplant writes them.
#include "recording/read_vcd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <istream>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "recording/collector.hpp"

namespace symplant::recording {
namespace {

using tables::Time;

constexpr std::size_t kMostBits = 64;

/// The words of a line.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
  return words;
}

/// The number of the variable with an identifier, as trace::vcd_identifier() makes it.
std::uint64_t variable_number(std::string_view identifier) {
  constexpr std::size_t kMostDigits = 8;  // no overflow
  std::uint64_t number = 0;
  identifier = identifier.substr(0, kMostDigits);
  for (std::size_t i = identifier.size(); i-- != 0;) {
    const auto digit = static_cast<std::uint64_t>(static_cast<unsigned char>(identifier[i]) - '!');
    number = i + 1 == identifier.size() ? digit : (number + 1) * 94 + digit;
  }
  return number;
}

class VcdReader {
 public:
  VcdReader(std::istream& file, const std::string& name) : file_(file) { read_.recording.name = name; }

  ReadRecording run() {
    std::string wrong;
    while (wrong.empty() && std::getline(file_, line_)) {
      ++number_;
      if (!line_.empty() && line_.back() == '\r') line_.pop_back();
      const bool is_open = file_.eof() && has_values_;
      if (!line_.empty() && !(is_open && may_be_cut(line_))) {
        wrong = has_values_ ? take(line_) : take_header(words_of(line_));
        if (wrong.empty() || !is_open) continue;
      }
      if (!is_open) continue;
      wrong.clear();
      read_.warnings.push_back(at_line("the last line is cut off, and is left out"));
    }
    if (wrong.empty() && !has_values_) wrong = "the header is not complete: `$enddefinitions $end` is missing";
    if (!wrong.empty()) read_.error = at_line(wrong);
    changes_.finish();
    return std::move(read_);
  }

 private:
  struct Variable {
    std::string name;
    bool is_bit = false;
    bool is_signed = false;
    std::size_t width = 0;
    bool is_symbol = false;
    std::optional<double> value;
  };

  std::string at_line(std::string_view text) const {
    return fmt::format("{}:{}: {}", read_.recording.name, number_, text);
  }

  std::string take_header(const std::vector<std::string_view>& words) {
    if (words.empty()) return "";
    const std::string_view what = words[0];
    if (what == "$timescale") return take_scale(words);
    if (what == "$scope") scopes_.emplace_back(words.size() > 2 ? words[2] : "");
    if (what == "$upscope" && !scopes_.empty()) scopes_.pop_back();
    if (what == "$comment" && words.size() > 1 && words[1] == "signed") {
      for (std::size_t i = 2; i < words.size(); ++i) signed_.emplace(words[i]);
    }
    if (what == "$var") return take_variable(words);
    if (what == "$enddefinitions") end_header();
    return "";
  }

  std::string take_scale(const std::vector<std::string_view>& words) {
    if (words.size() == 4 && words[1] == "1" && words[2] == "ns") return "";
    return "the time scale is not `1 ns`; only VCD files that symplant wrote are read";
  }

  std::string take_variable(const std::vector<std::string_view>& words) {
    Variable variable;
    if (words.size() != 6) return "a variable has a type, a size, an identifier and a name";
    const std::string_view type = words[1];
    const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), variable.width);
    if (error != std::errc() || variable.width == 0 || variable.width > kMostBits) {
      return fmt::format("the size `{}` is not a number from 1 to {}", words[2], kMostBits);
    }
    if (type == "string") first_string_ = std::min(first_string_, variable_number(words[3]));
    variable.name = words[4];
    variable.is_bit = type == "wire" && variable.width == 1;
    // Malfunctions have a scope in that of the plant.
    variable.is_symbol = (type == "wire" || type == "real") && !(scopes_.size() == 2 && scopes_[1] == "malfunctions");
    if (!variables_.emplace(std::string(words[3]), std::move(variable)).second) {
      return fmt::format("two variables have the identifier `{}`", words[3]);
    }
    return "";
  }

  /// Symbols are numbered first, then devices, whose states are strings, then all others.
  void end_header() {
    has_values_ = true;
    for (auto& [identifier, variable] : variables_) {
      if (variable_number(identifier) >= first_string_) variable.is_symbol = false;
      variable.is_signed = signed_.contains(identifier);
    }
  }

  /// Whether a change without a line end has an identifier with which a longer one begins.
  bool may_be_cut(std::string_view line) const {
    if (line[0] == '#' || line[0] == '$') return false;
    const std::size_t blank = line.find(' ');
    const std::string_view identifier = line.substr(blank == line.npos ? 1 : blank + 1);
    return std::any_of(variables_.begin(), variables_.end(), [&](const auto& variable) {
      return variable.first.size() > identifier.size() && variable.first.starts_with(identifier);
    });
  }

  std::string take(std::string_view line) {
    switch (line[0]) {
      case '$':
        if (line.starts_with("$version")) return "another VCD file begins here: read one at a time";
        return "";
      case '#':
        return take_time(line.substr(1));
      case '0':
      case '1':
        return take_value(line.substr(1), line.substr(0, 1), 2);
      case 'b':
      case 'r':
      case 's': {
        const std::size_t blank = line.find(' ');
        if (blank == line.npos) return fmt::format("the change `{}` has no identifier", line);
        return take_value(line.substr(blank + 1), line.substr(1, blank - 1), line[0] == 'b' ? 2 : 10);
      }
      default:
        return fmt::format("`{}` is not a time or a change as symplant writes them", line);
    }
  }

  std::string take_time(std::string_view digits) {
    Time time = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), time);
    if (error != std::errc() || end != digits.data() + digits.size() || time < 0 || time > kLatestTime) {
      return fmt::format("the time `#{}` is not a number of ns up to {}", digits, kLatestTime);
    }
    if (time < time_) return "this time is before that above";
    time_ = read_.recording.end = time;
    return "";
  }

  std::string take_value(std::string_view identifier, std::string_view text, int base) {
    key_ = identifier;
    const auto found = variables_.find(key_);
    if (found == variables_.end()) return fmt::format("there is no variable with the identifier `{}`", identifier);
    Variable& variable = found->second;
    if (!variable.is_symbol) return "";
    const auto value = base == 2 ? bits(text, variable) : real(text);
    if (!value) return fmt::format("`{}` cannot have the value `{}`", variable.name, text);
    // A trace has no line for what is off or 0 at the start.
    const double before = variable.value.value_or(0);
    variable.value = value;
    if (*value == before) return "";
    const auto kind = variable.is_bit ? Series::Kind::boolean : Series::Kind::number;
    changes_.add(changes_.symbol(kind, variable.name), time_, *value);
    return "";
  }

  static std::optional<double> bits(std::string_view text, const Variable& variable) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 2);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (variable.is_signed && variable.width < kMostBits && (value >> (variable.width - 1) & 1U) != 0) {
      value |= ~std::uint64_t{0} << variable.width;
    }
    return variable.is_signed ? static_cast<double>(static_cast<std::int64_t>(value)) : static_cast<double>(value);
  }

  static std::optional<double> real(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
  }

  std::istream& file_;
  ReadRecording read_;
  Collector changes_{read_.recording};
  std::string line_;
  std::size_t number_ = 0;
  Time time_ = 0;
  bool has_values_ = false;  ///< the header is complete
  std::vector<std::string> scopes_;
  std::unordered_set<std::string> signed_;               ///< identifiers
  std::unordered_map<std::string, Variable> variables_;  ///< by identifier
  std::uint64_t first_string_ = std::numeric_limits<std::uint64_t>::max();
  std::string key_;  ///< reused
};

}  // namespace

ReadRecording read_vcd(std::istream& file, const std::string& name, const ReadOptions&) {
  return VcdReader(file, name).run();
}

}  // namespace symplant::recording
