// A difference in words, for the formats that people read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "diff/formats.hpp"

namespace symplant::diff {

/// A piece of a text. Names and texts of the user are `quoted`: each format encodes them.
struct Piece {
  std::string text;
  bool quoted = false;
};
using Words = std::vector<Piece>;

/// The changes of one kind.
struct Section {
  std::string title;          ///< `48 symbols renamed`
  std::vector<Words> causes;  ///< a sentence for each common cause
  std::vector<std::string> columns;
  std::vector<std::vector<Words>> rows;  ///< one cell for each column; changes with a cause have no row
  std::size_t more = 0;                  ///< how many rows are left out
};

struct Report {
  Words head;           ///< what was compared
  std::string summary;  ///< all counts in one line
  std::vector<Section> sections;
};

/// The report with at most `most` rows in each section. With `all`, changes with a cause also have a row.
Report report_of(const Comparison& comparison, std::size_t most, bool all);

/// `12 symbols`, `1 symbol`.
std::string counted(std::size_t count, std::string_view noun);

}  // namespace symplant::diff
