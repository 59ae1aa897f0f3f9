// Decides what the fields of a rule may hold.
#include <re2/re2.h>

#include <algorithm>

#include "name/naming_parts.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

/// The words of a direction field that gives none.
const std::vector<DirectionWord>& usual_directions() {
  static const std::vector<DirectionWord> words = {
      {"I", Direction::event},      {"X", Direction::event},      {"E", Direction::event},
      {"DI", Direction::event},     {"AI", Direction::event},     {"SI", Direction::event},
      {"O", Direction::operation},  {"Q", Direction::operation},  {"Y", Direction::operation},
      {"A", Direction::operation},  {"DO", Direction::operation}, {"AO", Direction::operation},
      {"SO", Direction::operation}, {"M", std::nullopt}};
  return words;
}

template <class Map>
std::optional<Said> said_in(const Map& map, std::string_view word) {
  const auto found = map.find(std::string(word));
  if (found == map.end()) return std::nullopt;
  return found->second;
}

}  // namespace

RuleFields::RuleFields(const SymbolRule& rule, const Vocabulary& vocabulary) : vocabulary_(&vocabulary) {
  const std::vector<DirectionWord>* words = &usual_directions();
  for (const FieldRule& field : rule.fields) {
    if (field.field == field_name(Field::direction) && !field.words.empty()) words = &field.words;
  }
  for (const auto& [word, says] : *words) {
    directions_.emplace(text::normal_form(word), says);
    folded_directions_.emplace(text::folded(text::normal_form(word)), says);
  }
  for (const auto& [word, says] : rule.classes) classes_.emplace(text::folded(text::normal_form(word)), says);
}
RuleFields::~RuleFields() = default;
RuleFields::RuleFields(RuleFields&&) noexcept = default;

std::string RuleFields::add_expression(Field field, std::string_view expression) {
  re2::RE2::Options options(re2::RE2::Quiet);
  options.set_case_sensitive(false);
  auto compiled = std::make_unique<re2::RE2>(re2::StringPiece(expression.data(), expression.size()), options);
  if (!compiled->ok()) return compiled->error();
  expressions_[static_cast<std::size_t>(field)] = std::move(compiled);
  return {};
}

bool RuleFields::fits(Field field, const PreparedText& text, std::size_t begin, std::size_t end, bool known,
                      bool fused) const {
  if (field == Field::x) return true;
  if (field == Field::direction && !fits_direction(text, begin, end, fused)) return false;
  if (field == Field::klass && !class_said(text.folded().substr(begin, end - begin))) return false;
  if (known && !fits_known(text, begin, end)) return false;
  const re2::RE2* expression = expressions_[static_cast<std::size_t>(field)].get();
  if (expression == nullptr) return true;
  return re2::RE2::FullMatch(re2::StringPiece(text.shown().data() + begin, end - begin), *expression);
}

bool RuleFields::fits_direction(const PreparedText& text, std::size_t begin, std::size_t end, bool fused) const {
  const auto part = [&](std::string_view whole) { return whole.substr(begin, end - begin); };
  if (!direction_said(part(text.shown()), part(text.folded()), fused)) return false;
  // A fused prefix is not the begin of a longer word: `iConv`, but not `indicator`.
  return !fused || end == text.size() || text.shown()[end] < 'a' || text.shown()[end] > 'z';
}

std::optional<Said> RuleFields::direction_said(std::string_view shown, std::string_view folded, bool fused) const {
  return fused ? said_in(directions_, shown) : said_in(folded_directions_, folded);
}

std::optional<Said> RuleFields::class_said(std::string_view folded) const {
  return classes_.empty() ? vocabulary_->class_said(folded) : said_in(classes_, folded);
}

bool RuleFields::fits_known(const PreparedText& text, std::size_t begin, std::size_t end) const {
  bool has_motion = false;  // one: two motions are a device and its task
  for (std::size_t at = begin; at < end;) {
    const std::size_t run = std::min(text.run_end(at), end);
    if (!text.is_separator(at)) {
      const std::string_view word = text.folded().substr(at, run - at);
      const bool is_motion = vocabulary_->motion(word).has_value();
      const bool is_number = std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
      if (is_motion && has_motion) return false;
      if (!is_motion && !(is_number && has_motion) && !vocabulary_->is_affix(word, Direction::event) &&
          !vocabulary_->is_affix(word, Direction::operation)) {
        return false;
      }
      has_motion = has_motion || is_motion;
    }
    at = run;
  }
  return has_motion;
}

}  // namespace symplant::name
