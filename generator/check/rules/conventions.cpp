// Rules: naming conventions that the user gives. Without them these rules report nothing.
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

#include "check/rule.hpp"
#include "text/ascii.hpp"
#include "text/pattern.hpp"
#include "text/shape.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

using Convention = description::GivenCheck::Convention;

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/// The part of a name that a person has chosen: without the program or structure in front, and without an index.
std::string_view own_part(std::string_view name) {
  if (name.ends_with(']')) name = name.substr(0, name.rfind('['));
  return name.substr(name.rfind('.') + 1);
}

bool fits(const Convention& convention, const read::ListRow& row, const Symbol* symbol) {
  const auto is_of = [&](const std::string& type) { return text::equal_ignoring_case(type, row.type); };
  if (!convention.types.empty() && std::ranges::none_of(convention.types, is_of)) return false;
  if (convention.operation && symbol == nullptr) return false;
  if (convention.operation && *convention.operation != (symbol->direction == Direction::operation)) return false;
  return convention.symbols.empty() || text::matches_pattern(row.name, convention.symbols);
}

/// Calls `visit` with each row, its symbol (null for an internal row), and each convention that fits it.
template <class Visit>
void visit_rows(const Find& find, Visit visit) {
  const std::vector<Convention>& conventions = find.plant.description->check.conventions;
  if (conventions.empty()) return;
  auto next = find.symbols.begin();  // in the order of lists and rows
  for (const model::PlantList& list : find.plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      const bool is_io = next != find.symbols.end() && next->row == &row;
      const Symbol* symbol = is_io ? &*next++ : nullptr;
      if (row.is_named_by_address()) continue;
      for (const Convention& convention : conventions) {
        if (fits(convention, row, symbol)) visit(row, symbol, convention);
      }
    }
  }
}

/// "prefix x b, 3 to 24".
std::string content_of(const Convention& convention) {
  std::string content;
  const auto add = [&](std::string_view text) { content.append(content.empty() ? "" : ", ").append(text); };
  if (!convention.prefix.empty()) add(fmt::format("prefix {}", fmt::join(convention.prefix, " ")));
  if (!convention.suffix.empty()) add(fmt::format("suffix {}", fmt::join(convention.suffix, " ")));
  if (!convention.letters.empty()) add(convention.letters);
  if (convention.least != 0 || convention.most != 0) add(fmt::format("{} to {}", convention.least, convention.most));
  return content;
}

/// Findings of one convention and one type are shown as one.
Finding at(const Find& find, const read::ListRow& row, const Convention& convention) {
  Finding finding = find.at(row, row.name);
  finding.as.subjects.shape = fmt::format("convention # ({}), {}", content_of(convention), text::shape_of(row.type));
  return finding;
}

std::string quoted(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    all += fmt::format("{}`{}`", all.empty() ? "" : &text == &texts.back() ? " or " : ", ", text);
  }
  return all;
}

/// "`speed` of the type `INT`".
std::string named(const read::ListRow& row) {
  return row.type.empty() ? fmt::format("`{}`", row.name) : fmt::format("`{}` of the type `{}`", row.name, row.type);
}

void name_affix(const Find& find) {
  visit_rows(find, [&](const read::ListRow& row, const Symbol* symbol, const Convention& convention) {
    const std::string_view name = own_part(row.name);
    const auto begins = [&](const std::string& prefix) { return name.starts_with(prefix); };
    const auto ends = [&](const std::string& suffix) { return name.ends_with(suffix); };
    const bool prefix = convention.prefix.empty() || std::ranges::any_of(convention.prefix, begins);
    const bool suffix = convention.suffix.empty() || std::ranges::any_of(convention.suffix, ends);
    if (prefix && suffix) return;
    Finding finding = at(find, row, convention);
    const auto at_own = static_cast<std::size_t>(name.data() - row.name.data());
    std::string better(row.name);
    if (!suffix) better.insert(at_own + name.size(), convention.suffix.front());
    if (!prefix) better.insert(at_own, convention.prefix.front());
    if (symbol != nullptr) finding.rename(*symbol, better);
    finding.say(
        "{} does not {}; a convention wants that: write `{}`", named(row),
        prefix   ? "end with " + quoted(convention.suffix)
        : suffix ? "begin with " + quoted(convention.prefix)
                 : fmt::format("begin with {} and end with {}", quoted(convention.prefix), quoted(convention.suffix)),
        better);
  });
}

/// What is wrong with the letters of a name; empty if nothing is.
std::string_view wrong_letters(std::string_view name, std::string_view letters) {
  if (letters == "upper") return std::ranges::any_of(name, is_small) ? "small letters" : "";
  if (letters == "lower") return std::ranges::any_of(name, is_capital) ? "capitals" : "";
  if (letters.empty() || name.empty()) return "";
  if (name.find('_') != std::string_view::npos) return "a `_`";
  if (letters == "camel") return is_capital(name.front()) ? "a capital in front" : "";
  return is_small(name.front()) ? "a small letter in front" : "";
}

void name_letters(const Find& find) {
  visit_rows(find, [&](const read::ListRow& row, const Symbol* symbol, const Convention& convention) {
    const std::string_view name = own_part(row.name);
    const std::string_view wrong = wrong_letters(name, convention.letters);
    if (wrong.empty()) return;
    Finding finding = at(find, row, convention);
    const auto at_own = static_cast<std::size_t>(name.data() - row.name.data());
    if (symbol != nullptr && (convention.letters == "upper" || convention.letters == "lower")) {
      const std::string better = convention.letters == "upper" ? text::to_upper(name) : text::to_lower(name);
      finding.rename(*symbol, std::string(row.name).replace(at_own, name.size(), better));
    }
    finding.say("{} has {}; a convention wants {} letters", named(row), wrong, convention.letters);
  });
}

void name_length(const Find& find) {
  visit_rows(find, [&](const read::ListRow& row, const Symbol*, const Convention& convention) {
    const std::size_t length = text::count_code_points(own_part(row.name));
    const bool is_long = convention.most != 0 && length > convention.most;
    if (length >= convention.least && !is_long) return;
    at(find, row, convention)
        .say("{} has {} characters; a convention wants {} {}", named(row), length, is_long ? "at most" : "at least",
             is_long ? convention.most : convention.least);
  });
}

constexpr std::string_view kGiven =
    "The conventions are given in plant.json, `conventions` in the section `check`, or by `check --conventions FILE`. "
    "Each says for which symbols it is: by type, direction or pattern.";

constexpr std::string_view kLoss = "Nothing: a convention is for people.";

constexpr Rule kConventionRules[] = {
    {"SP220", "name-affix", kWarning, name_affix, "a name lacks the prefix or suffix of a convention", kGiven, kLoss,
     "Rename the symbol; `--rename-map` lists the new names."},
    {"SP221", "name-letters", kWarning, name_letters, "a name has other letters than a convention wants", kGiven, kLoss,
     "Rename the symbol."},
    {"SP222", "name-length", kWarning, name_length, "a name is shorter or longer than a convention wants", kGiven,
     kLoss, "Rename the symbol."},
};

}  // namespace

std::span<const Rule> convention_rules() { return kConventionRules; }

}  // namespace symplant::check
