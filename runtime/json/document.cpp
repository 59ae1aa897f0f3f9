// Parses JSON texts.
#include "symplant/json/document.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "symplant/json/counted_text.hpp"

namespace symplant::json {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestWords = 160;
constexpr std::size_t kMostOfAKind = 100;  // faults, so that their locations cost no more than the text

/// Removes bytes that are not a complete UTF-8 character: the library reads, and cuts, byte by byte.
std::string whole_characters(std::string_view text) {
  std::string whole;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    std::size_t end = at + 1;
    while (end < text.size() && end < at + length && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) ++end;
    if (end == at + length && (lead < 0x80 || lead >= 0xC2)) whole.append(text.substr(at, length));
    at = end;
  }
  return whole;
}

/// The library's message without its name and location: "unexpected '}'; expected string literal".
std::string words_of(std::string_view what) {
  for (const std::string_view mark : {" - ", ": ", "] "}) {
    const std::size_t at = what.find(mark, mark == ": " ? what.find("column ") : 0);
    if (at == what.npos) continue;
    what.remove_prefix(at + mark.size());
    break;
  }
  return whole_characters(what.substr(0, kLongestWords)) + (what.size() > kLongestWords ? " ..." : "");
}

/// Builds the value, and finds faults that the library accepts.
class Builder final : public Json::json_sax_t {
 public:
  Builder(std::string_view text, const std::size_t& taken, Document& document)
      : text_(text), taken_(taken), document_(document) {}

  bool null() override { return put(nullptr) != nullptr; }
  bool boolean(bool value) override { return put(value) != nullptr; }
  bool number_integer(number_integer_t value) override { return put(value) != nullptr; }
  bool number_unsigned(number_unsigned_t value) override { return put(value) != nullptr; }
  bool number_float(number_float_t value, const string_t&) override { return put(value) != nullptr; }
  bool string(string_t& value) override {
    refuse_nul(value);
    return put(std::move(value)) != nullptr;
  }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::value_t::object); }
  bool start_array(std::size_t) override { return open(Json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    refuse_nul(name);
    Level& level = open_.back();
    const auto [at, added] = level.value->get_ref<Json::object_t&>().try_emplace(name, nullptr);
    level.key = &at->first;
    if (added) {
      member_ = &at->second;
    } else {
      if (twice_.size() < kMostOfAKind)
        twice_.push_back({{token(), "the key `" + name + "` is repeated; remove one of the two", {}},
                          {pointer(), "its first use is here", 0, true}});
      member_ = &unused_;
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
    const std::size_t end = std::min(position, text_.size());  // after the last byte read
    const std::size_t begin = end == 0 ? 0 : end - 1;
    const std::string hint = ends_list(begin) ? "remove the comma before the closing bracket; " : "";
    document_.faults.push_back({{begin, end}, "this is not valid JSON: " + hint + words_of(error.what()), {}});
    return false;
  }

  /// Adds a fault for every repeated key, with the location of its first use.
  void report_twice() {
    std::vector<Fault> firsts;
    for (const Twice& twice : twice_) firsts.push_back(twice.first);
    const std::vector<Span> locations = spans(text_, firsts);
    for (std::size_t i = 0; i < twice_.size(); ++i) {
      twice_[i].second.related = Related{locations[i], twice_[i].first.message};
      document_.faults.push_back(std::move(twice_[i].second));
    }
  }

 private:
  /// An object or array that is still open.
  struct Level {
    Json* value;
    const std::string* key;  // of an object: the last one read
  };
  struct Twice {
    Placed second;
    Fault first;
  };

  /// Whether there is a closing bracket at `at`, directly after a comma.
  bool ends_list(std::size_t at) const {
    if (at >= text_.size() || (text_[at] != ']' && text_[at] != '}')) return false;
    const std::size_t before = text_.find_last_not_of(" \t\r\n", at - 1);
    return at != 0 && before != text_.npos && text_[before] == ',';
  }

  Span token() const { return {opening_quote(text_, taken_), taken_}; }

  void refuse_nul(const std::string& value) {
    if (value.find('\0') == value.npos || document_.faults.size() >= kMostOfAKind) return;
    document_.faults.push_back({token(), "this text contains a NUL character; remove it", {}});
  }

  template <class Value>
  Json* put(Value&& value) {
    if (open_.empty()) {
      *document_.root = std::forward<Value>(value);
      return document_.root.get();
    }
    if (open_.back().value->is_array()) {
      auto& items = open_.back().value->get_ref<Json::array_t&>();
      items.emplace_back(std::forward<Value>(value));
      return &items.back();
    }
    *member_ = std::forward<Value>(value);
    return member_;
  }

  /// The JSON pointer of the innermost object's last key.
  std::string pointer() const {
    std::string text;
    for (const Level& level : open_) {
      text = level.value->is_array() ? child(text, level.value->size() - 1) : child(text, *level.key);
    }
    return text;
  }

  bool open(Json::value_t kind) {
    if (open_.size() == kMaxDepth) {
      document_.faults.push_back(
          {{taken_ - 1, taken_}, "arrays and objects are nested more than 100 levels deep, the limit is 100", {}});
      return false;
    }
    Json* value = put(Json(kind));
    if (value == &unused_) {  // the next repeated key overwrites it, perhaps inside this value
      unused_values_.push_back(std::make_unique<Json>(kind));
      value = unused_values_.back().get();
    }
    open_.push_back({value, nullptr});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string_view text_;
  const std::size_t& taken_;
  Document& document_;
  std::vector<Level> open_;
  Json* member_ = nullptr;  // of the innermost object: the next value
  Json unused_;             // the value of a repeated key
  std::vector<std::unique_ptr<Json>> unused_values_;
  std::vector<Twice> twice_;
};

}  // namespace

Document::Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

Document parse(std::string_view text) {
  Document document;
  document.root = std::make_unique<Json>();
  std::size_t taken = 0;
  Builder builder(text, taken, document);
  const CountedText begin(text.data(), &taken);
  const CountedText end(text.data() + text.size(), &taken);
  if (!Json::sax_parse(begin, end, &builder, Json::input_format_t::json, true, true)) {
    document.root = nullptr;
  } else {
    builder.report_twice();
  }
  return document;
}

}  // namespace symplant::json
