// Findings as JSON for programs.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// The version of the form; it changes where a reader of the old form would be misled.
inline constexpr int kJsonVersion = 1;

/// How many findings are not among those told.
struct LeftOut {
  std::size_t by_description = 0;  ///< ignored by plant.json
  std::size_t by_options = 0;      ///< of rules that are not chosen on the command line
};

/// One object: `symplant-diagnostics` (the version), `findings` in the order of finding, `counts` by severity and,
/// where there are any, `ignored` (by plant.json) and `left_out` (by options). Lines and columns count from 1, columns
/// in characters; `span` is in bytes of the file's text as UTF-8. A finding in an empty text has no line; one without a
/// source has no file either.
std::string render_json(std::span<const Diagnostic> findings, const LeftOut& left_out = {});
/// The same of the findings of several parts, one behind the other.
std::string render_json(std::span<const std::span<const Diagnostic>> parts, const LeftOut& left_out);

}  // namespace symplant::diag
