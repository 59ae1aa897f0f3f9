// A line of the text format, word by word.
#pragma once

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>

#include "property/words.hpp"

namespace symplant::property {

/// The words of a line, one after the other. Throws std::runtime_error for a missing or invalid word.
class Line {
 public:
  explicit Line(std::string_view text) : rest_(text) { skip_blanks(); }

  bool at_end() const { return rest_.empty(); }
  std::string word() {
    if (rest_.empty()) throw std::runtime_error("a word is missing");
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(end);
    skip_blanks();
    return taken;
  }
  /// The next word, which remains.
  std::string_view next() const { return rest_.substr(0, rest_.find(' ')); }
  std::string cell() {
    std::string taken = word();
    return taken == "-" ? std::string() : taken;
  }
  std::string all() {
    std::string taken(rest_);
    rest_ = {};
    return taken;
  }
  /// Up to ` while `, which remains.
  std::string condition() {
    std::string taken(rest_.substr(0, std::min(rest_.find(" while "), rest_.size())));
    rest_.remove_prefix(taken.size());
    skip_blanks();
    return taken;
  }
  description::Sequence sequence() {
    const std::string text = word();
    for (const auto each : {description::Sequence::neighbours, description::Sequence::cycle}) {
      if (text == description::sequence_name(each)) return each;
    }
    return description::Sequence::free;
  }
  tables::Time overrun() {
    const std::string text = word();
    return text == "never" ? tables::kNever : number_of<tables::Time>(text);
  }
  template <class Number>
  Number number() {
    return number_of<Number>(word());
  }
  template <class Number>
  static Number number_of(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw std::runtime_error("`" + std::string(text) + "` is no number");
    }
    return number;
  }
  tables::Actuation actuation() {
    const std::string text = word();
    const auto at = std::find(kActuationWords.begin(), kActuationWords.end(), text);
    if (at == kActuationWords.end()) throw std::runtime_error("`" + text + "` is no actuation");
    return static_cast<tables::Actuation>(at - kActuationWords.begin());
  }
  description::Duration duration() {
    std::string text = word();
    const std::size_t first = text.find(':');
    if (text.starts_with("seconds:")) {
      std::replace(text.begin(), text.end(), '~', ' ');
      return description::Duration::seconds(text.substr(first + 1));
    }
    if (first == text.npos) return description::Duration::fixed(number_of<tables::Time>(text));
    const std::size_t second = text.find(':', first + 1);
    if (second == text.npos) throw std::runtime_error("`" + text + "` is no duration");
    description::Duration made;
    made.kind = text[0] == 'u' ? description::Duration::Kind::uniform : description::Duration::Kind::normal;
    const std::string_view view = text;
    made.a = number_of<tables::Time>(view.substr(first + 1, second - first - 1));
    made.b = number_of<tables::Time>(view.substr(second + 1));
    return made;
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }
  std::string_view rest_;
};

}  // namespace symplant::property
