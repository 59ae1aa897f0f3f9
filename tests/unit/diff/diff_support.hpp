// Two plants of lists or descriptions in memory, and their difference in short words.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "diff/compare.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/strings.hpp"
#include "support/tool.hpp"

namespace symplant::test {

/// Two plants and their difference, which refers to them.
struct Two {
  Analysed before;
  Analysed after;
  diff::Difference difference;

  const model::PlantModel& old_plant() const { return before.model(); }
  const model::PlantModel& new_plant() const { return after.model(); }
};

inline Two compared(Analysed before, Analysed after) {
  Two two{std::move(before), std::move(after), {}};
  two.difference = diff::compare({two.old_plant()}, {two.new_plant()});
  return two;
}

/// Two tables with the columns Name, Address, Type, Comment.
inline Two compared(const std::string& before, const std::string& after) {
  const std::string head = "Name,Address,Type,Comment\n";
  return compared(analyse_text(head + before), analyse_text(head + after));
}

inline Two compared_rows(const std::vector<Row>& before, const std::vector<Row>& after) {
  return compared(analyse_rows(before), analyse_rows(after));
}

/// `+A`, `-A`, `A>B` for each changed symbol, with the changed fields: `A>A address type`.
inline std::vector<std::string> words(const Two& two) {
  const std::vector<std::string> fields{"name", "address", "type", "initial", "comment", "other"};
  std::vector<std::string> all;
  for (const diff::SymbolChange& change : two.difference.symbols) {
    std::string text;
    if (change.added()) {
      text = fmt::format("+{}", change.after.in(two.new_plant()).name);
    } else if (change.removed()) {
      text = fmt::format("-{}", change.before.in(two.old_plant()).name);
    } else {
      text = fmt::format("{}>{}", change.before.in(two.old_plant()).name, change.after.in(two.new_plant()).name);
      for (std::size_t field = 0; field < fields.size(); ++field) {
        if (change.fields.has(static_cast<diff::Field>(field))) text += " " + fields[field];
      }
    }
    all.push_back(text);
  }
  return all;
}

using Texts = std::vector<std::string>;

}  // namespace symplant::test
