// Locates values in a JSON text: reads the text a second time, only if it has faults.
#include "symplant/json/location.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "symplant/json/counted_text.hpp"

namespace symplant::json {
namespace {

using Json = nlohmann::json;

constexpr Span kNowhere{static_cast<std::size_t>(-1), 0};

/// The values to locate, and their parents, as a tree.
struct Wanted {
  std::map<std::string, std::unique_ptr<Wanted>, std::less<>> below;
  Wanted* above = nullptr;
  Span key = kNowhere;
  Span value = kNowhere;
};

bool known(const Span& span) { return span.begin != kNowhere.begin; }

std::string unescaped(std::string_view text) {
  std::string key;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '~' && i + 1 < text.size() && (text[i + 1] == '0' || text[i + 1] == '1');
    key += escape ? (text[++i] == '0' ? '~' : '/') : text[i];
  }
  return key;
}

Wanted* grow(Wanted& root, std::string_view pointer) {
  Wanted* at = &root;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    std::unique_ptr<Wanted>& next = at->below[unescaped(pointer.substr(1, end - 1))];
    if (next == nullptr) {
      next = std::make_unique<Wanted>();
      next->above = at;
    }
    at = next.get();
    pointer.remove_prefix(end);
  }
  return at;
}

bool of_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E'; }

/// Walks through the tree in parallel with the text.
class Walker final : public Json::json_sax_t {
 public:
  Walker(std::string_view text, const std::size_t& taken, Wanted& root) : text_(text), taken_(taken), next_(&root) {}

  bool null() override { return scalar(4); }
  bool boolean(bool value) override { return scalar(value ? 4 : 5); }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
  bool string(string_t&) override { return scalar(taken_ - opening_quote(text_, taken_)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = open_.back();
    next_ = below(level, name);
    if (next_ != nullptr && !known(next_->key)) next_->key = {opening_quote(text_, taken_), taken_};
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  struct Level {
    Wanted* wanted;
    bool array;
    std::size_t count;  // of an array: its items so far
  };

  static Wanted* below(const Level& level, std::string_view name) {
    if (level.wanted == nullptr) return nullptr;
    const auto found = level.wanted->below.find(name);
    return found == level.wanted->below.end() ? nullptr : found->second.get();
  }

  /// The tree node of the next value, or null.
  Wanted* wanted() {
    if (open_.empty() || !open_.back().array) return next_;
    Level& level = open_.back();
    const std::size_t index = level.count++;
    return level.wanted == nullptr || level.wanted->below.empty() ? nullptr : below(level, std::to_string(index));
  }

  bool scalar(std::size_t size) { return ends_at(taken_, size); }

  bool number() {
    std::size_t end = taken_;
    while (end > 0 && !of_number(text_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && of_number(text_[begin - 1])) --begin;
    return ends_at(end, end - begin);
  }

  bool ends_at(std::size_t end, std::size_t size) {
    Wanted* value = wanted();
    if (value != nullptr && !known(value->value)) value->value = {end - size, end};
    return true;
  }

  bool open(bool array) {
    Wanted* value = wanted();
    if (value != nullptr && !known(value->value)) {
      value->value = known(value->key) ? value->key : Span{taken_ - 1, taken_};
    }
    open_.push_back({value, array, 0});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string_view text_;
  const std::size_t& taken_;
  std::vector<Level> open_;
  Wanted* next_;
};

Span span_of(const Wanted* wanted, bool at_key) {
  for (; wanted != nullptr; wanted = wanted->above) {
    if (at_key && known(wanted->key)) return wanted->key;
    if (known(wanted->value)) return wanted->value;
  }
  return {0, 0};
}

/// Maps byte `column` of a decoded text to an offset in its source (without the quotes).
std::size_t source_byte(std::string_view source, std::size_t column) {
  std::size_t decoded = 0;
  std::size_t at = 0;
  while (at < source.size() && decoded < column) {
    if (source[at] != '\\' || at + 1 >= source.size()) {
      ++at;
      ++decoded;
    } else if (source[at + 1] != 'u' || at + 6 > source.size()) {
      at += 2;
      ++decoded;
    } else {
      const unsigned long unit = std::stoul(std::string(source.substr(at + 2, 4)), nullptr, 16);
      const bool pair = unit >= 0xD800 && unit < 0xDC00;
      decoded += pair ? 4U : unit < 0x80 ? 1U : unit < 0x800 ? 2U : 3U;
      at += pair ? 12 : 6;
    }
  }
  return std::min(at, source.size());
}

}  // namespace

std::vector<Span> spans(std::string_view text, std::span<const Fault> faults) {
  Wanted root;
  std::vector<const Wanted*> wanted;
  wanted.reserve(faults.size());
  for (const Fault& fault : faults) wanted.push_back(grow(root, fault.pointer));
  std::size_t taken = 0;
  Walker walker(text, taken, root);
  if (!faults.empty()) {
    Json::sax_parse(CountedText(text.data(), &taken), CountedText(text.data() + text.size(), &taken), &walker,
                    Json::input_format_t::json, true, true);
  }
  std::vector<Span> found;
  found.reserve(faults.size());
  for (std::size_t i = 0; i < faults.size(); ++i) found.push_back(span_of(wanted[i], faults[i].at_key));
  return found;
}

std::vector<Placed> locate(std::string_view text, std::span<const Fault> faults) {
  const std::vector<Span> found = spans(text, faults);
  std::vector<Placed> placed;
  placed.reserve(faults.size());
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Span span = found[i];
    if (faults[i].column != 0 && !faults[i].at_key && span.end > span.begin + 1 && text[span.begin] == '"') {
      const std::string_view source = text.substr(span.begin + 1, span.end - span.begin - 2);
      span.begin += 1 + source_byte(source, faults[i].column);
    }
    placed.push_back({span, faults[i].message, {}});
  }
  return placed;
}

LineColumn line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t start = lines == 0 ? (text.starts_with("\xEF\xBB\xBF") ? 3 : 0) : before.rfind('\n') + 1;
  const std::string_view line = before.substr(std::min(start, before.size()));
  const auto letters =
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return {lines + 1, static_cast<std::size_t>(letters) + 1};
}

std::string child(std::string_view pointer, std::string_view key) {
  std::string text(pointer);
  text += '/';
  for (const char c : key) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

std::string child(std::string_view pointer, std::size_t index) {
  return std::string(pointer) + "/" + std::to_string(index);
}

}  // namespace symplant::json
