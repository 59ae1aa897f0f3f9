// Groups symbols by shape.
#include "score/shapes.hpp"

#include <algorithm>
#include <utility>

#include "name/naming.hpp"
#include "text/ascii.hpp"
#include "text/shape.hpp"

namespace symplant::score {

bool reads_comments_only(const model::PlantModel& plant) {
  const std::vector<name::SymbolRule>& rules = plant.naming().rules;
  return !rules.empty() && std::all_of(rules.begin(), rules.end(), [](const name::SymbolRule& rule) {
    return std::all_of(rule.patterns.begin(), rule.patterns.end(), [](const name::SourcePattern& pattern) {
      return pattern.source == name::Source::comment || pattern.source == name::Source::parent_and_comment;
    });
  });
}

std::string_view known_text(const model::PlantModel& plant, const model::Symbol& symbol, bool by_comment) {
  const bool wanted = by_comment || (plant.levels() == nullptr && symbol.row->is_named_by_address());
  return wanted && !symbol.row->comment.empty() ? symbol.row->comment : symbol.name();
}

Shapes::Shapes(const model::PlantModel& plant) : plant_(plant), by_comment_(reads_comments_only(plant)) {}

void Shapes::add(std::uint32_t symbol, Account account) {
  text_ = text::shape_of(known_text(plant_, plant_.symbols[symbol], by_comment_));
  const auto next = static_cast<std::uint32_t>(shapes_.size());
  const std::uint64_t hash = text::hash_ignoring_case(text_) + static_cast<std::uint64_t>(account);
  const std::uint32_t index = table_.find_or_add(hash, next, [&](std::uint32_t other) {
    return shapes_[other].account == account && text::equal_ignoring_case(shapes_[other].text, text_);
  });
  if (index == next) shapes_.push_back({text_, account, 0, symbol});
  ++shapes_[index].count;
}

std::vector<Shape> Shapes::take() {
  std::stable_sort(shapes_.begin(), shapes_.end(), [](const Shape& a, const Shape& b) { return a.count > b.count; });
  return std::move(shapes_);
}

std::vector<Shape> left_over_shapes(const model::PlantModel& plant, const PlantScore& score) {
  Shapes shapes(plant);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    if (is_left_over(score.accounts[i])) shapes.add(i, score.accounts[i]);
  }
  return shapes.take();
}

}  // namespace symplant::score
