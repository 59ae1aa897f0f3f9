// Decides what the fields of a rule may hold.
#include <re2/re2.h>

#include <algorithm>

#include "name/naming_parts.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

/// The words of a direction field that gives none.
const std::vector<std::pair<std::string, Side>>& usual_directions() {
  static const std::vector<std::pair<std::string, Side>> words = {
      {"I", Side::event},      {"X", Side::event},     {"E", Side::event},      {"DI", Side::event},
      {"AI", Side::event},     {"SI", Side::event},    {"O", Side::operation},  {"Q", Side::operation},
      {"Y", Side::operation},  {"A", Side::operation}, {"DO", Side::operation}, {"AO", Side::operation},
      {"SO", Side::operation}, {"M", Side::internal}};
  return words;
}

template <class Map>
std::optional<Side> side_in(const Map& map, std::string_view word) {
  const auto found = map.find(std::string(word));
  if (found == map.end()) return std::nullopt;
  return found->second;
}

}  // namespace

RuleFields::RuleFields(const SymbolRule& rule, const Vocabulary& vocabulary) : vocabulary_(&vocabulary) {
  const std::vector<std::pair<std::string, Side>>* words = &usual_directions();
  for (const FieldRule& field : rule.fields) {
    if (field.field == field_name(Field::direction) && !field.words.empty()) words = &field.words;
  }
  for (const auto& [word, side] : *words) {
    directions_.emplace(text::normal_form(word), side);
    folded_directions_.emplace(text::folded(text::normal_form(word)), side);
  }
  for (const auto& [word, side] : rule.classes) classes_.emplace(text::folded(text::normal_form(word)), side);
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
  if (field == Field::klass && !class_side(text.folded().substr(begin, end - begin))) return false;
  if (known && !fits_known(text, begin, end)) return false;
  const re2::RE2* expression = expressions_[static_cast<std::size_t>(field)].get();
  if (expression == nullptr) return true;
  return re2::RE2::FullMatch(re2::StringPiece(text.shown().data() + begin, end - begin), *expression);
}

bool RuleFields::fits_direction(const PreparedText& text, std::size_t begin, std::size_t end, bool fused) const {
  const auto part = [&](std::string_view whole) { return whole.substr(begin, end - begin); };
  if (!direction_side(part(text.shown()), part(text.folded()), fused)) return false;
  // A fused prefix is not the begin of a longer word: `iConv`, but not `indicator`.
  return !fused || end == text.size() || text.shown()[end] < 'a' || text.shown()[end] > 'z';
}

std::optional<Side> RuleFields::direction_side(std::string_view shown, std::string_view folded, bool fused) const {
  return fused ? side_in(directions_, shown) : side_in(folded_directions_, folded);
}

std::optional<Side> RuleFields::class_side(std::string_view folded) const {
  return classes_.empty() ? vocabulary_->class_side(folded) : side_in(classes_, folded);
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
      if (!is_motion && !(is_number && has_motion) && !vocabulary_->is_affix(word, Side::event) &&
          !vocabulary_->is_affix(word, Side::operation)) {
        return false;
      }
      has_motion = has_motion || is_motion;
    }
    at = run;
  }
  return has_motion;
}

}  // namespace symplant::name
