// Reads and writes the keys of `times`.
#include "elements/times/key.hpp"

#include <utility>

namespace symplant::description {
namespace {

constexpr std::string_view kArrow = "->";
constexpr std::string_view kOn = " on ";

class KeyReader {
 public:
  explicit KeyReader(std::string_view text) : rest_(text) {}

  std::optional<TimesKey> read() {
    TimesKey key;
    key.from = name(kArrow);
    if (key.from.empty() || !take(kArrow)) return std::nullopt;
    key.to = name(kOn);
    if (key.to.empty()) return std::nullopt;
    if (take(kOn)) key.on = name({});
    const bool ended = rest_.find_first_not_of(' ') == rest_.npos;
    return ended && !given_without_name_ ? std::optional(std::move(key)) : std::nullopt;
  }

 private:
  /// The name in front, without its quotes: without quotes up to `end`, if that is there. Empty if nothing is in front.
  std::string name(std::string_view end) {
    skip_blanks();
    std::string name = rest_.starts_with('\'') ? quoted() : plain(end);
    given_without_name_ = given_without_name_ || name.empty();
    return name;
  }

  std::string plain(std::string_view end) {
    const std::string_view name = rest_.substr(0, end.empty() ? rest_.npos : rest_.find(end));
    if (name.find('\'') != name.npos) return {};
    rest_.remove_prefix(name.size());
    return std::string(name.substr(0, name.find_last_not_of(' ') + 1));
  }

  std::string quoted() {
    std::string name;
    for (std::size_t i = 1; i < rest_.size(); ++i) {
      if (rest_[i] == '\'' && !rest_.substr(i + 1).starts_with('\'')) {
        rest_.remove_prefix(i + 1);
        return name;
      }
      name += rest_[i];
      if (rest_[i] == '\'') ++i;
    }
    return {};
  }

  bool take(std::string_view word) {
    if (word.front() != ' ') skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  void skip_blanks() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }

  std::string_view rest_;
  bool given_without_name_ = false;
};

std::string name_text(const std::string& name) {
  const bool plain = name.find('\'') == name.npos && name.find(kArrow) == name.npos && name.find(kOn) == name.npos;
  if (plain) return name;
  std::string text = "'";
  for (const char c : name) text.append(c == '\'' ? 2 : 1, c);
  return text + "'";
}

}  // namespace

std::optional<TimesKey> times_key_of(std::string_view text) { return KeyReader(text).read(); }

std::string times_key_text(const TimesKey& key) {
  std::string text = name_text(key.from) + std::string(kArrow) + name_text(key.to);
  return key.on.empty() ? text : text + std::string(kOn) + name_text(key.on);
}

}  // namespace symplant::description
