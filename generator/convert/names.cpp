// The names that a target gets: changed only where it needs that, and unique.
#include "convert/names.hpp"

#include <cstdint>
#include <utility>

#include "convert/identifiers.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::convert {

const NameRule kIecNames{
    is_iec_identifier, iec_identifier, SIZE_MAX,
    Loss{"name is changed", "names are changed", "a variable has a unique identifier of letters, digits and `_`"}};
const NameRule kTiaNames{
    is_tia_name, tia_name, 128,
    Loss{"name is changed", "names are changed", "a tag has a unique name of at most 128 characters without `\"`"}};

Names::Names(const Symbols& symbols, std::span<const std::uint32_t> written, const NameRule& rule, Report& report)
    : symbols_(symbols), by_name_(written.size()) {
  std::vector<std::uint32_t> others;
  for (const std::uint32_t index : written) {
    const std::string_view name = symbols.all[index].row->name;
    if (!rule.accepts(name) || !take(index, name)) others.push_back(index);
  }
  for (const std::uint32_t index : others) {
    const std::string made = unique(index, rule);
    report.rename(symbols.all[index].row->name, made, rule.renamed);
  }
}

std::string_view Names::operator[](std::uint32_t index) const {
  const auto changed = changed_.find(index);
  return changed == changed_.end() ? symbols_.all[index].row->name : std::string_view(changed->second);
}

bool Names::take(std::uint32_t index, std::string_view name) {
  const auto has_name = [&](std::uint32_t other) { return text::equal_ignoring_case((*this)[other], name); };
  return by_name_.find_or_add(text::hash_ignoring_case(name), index, has_name) == index;
}

std::string Names::unique(std::uint32_t index, const NameRule& rule) {
  const std::string made = rule.make(symbols_.all[index].row->name);
  std::string& name = changed_[index] = made;
  std::size_t& next = next_.try_emplace(text::to_lower(made), 2).first->second;
  while (!take(index, name)) {
    const std::string number = "_" + std::to_string(next++);
    name.assign(text::first_code_points(made, rule.longest - number.size())).append(number);
  }
  return name;
}

}  // namespace symplant::convert
