// The formats of a difference. Each is in its file.
#pragma once

#include <string>

#include "base/text_source.hpp"
#include "diff/difference.hpp"

namespace symplant::diff {

/// A difference and its plants. `before_name` and `after_name` are the files that the user named.
struct Comparison {
  const model::PlantModel& before;
  const model::PlantModel& after;
  const Difference& difference;
  std::string before_name;
  std::string after_name;
};

/// The version of the JSON form.
inline constexpr int kJsonVersion = 1;

/// For people at a terminal, at most 20 lines for each kind of change unless `all`.
void write_text(const Comparison& comparison, bool all, base::TextSink& sink);
/// For programs: every change, and the causes with all their members.
void write_json(const Comparison& comparison, base::TextSink& sink);
/// For a pull request: a line, and tables of at most 50 rows, collapsed if they are long.
void write_markdown(const Comparison& comparison, base::TextSink& sink);

}  // namespace symplant::diff
