// Findings as text for people: the message, the row, the location underlined.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

struct TextOptions {
  bool colour = false;
  bool all = false;  ///< all findings in their order, with all related rows
  // Without `all`: the most important findings; the others are counted by rule at the end.
  std::size_t most = 7;          ///< the most findings shown
  std::size_t most_errors = 20;  ///< the most findings shown if all of them are errors
  std::size_t most_lines = 34;   ///< the most lines shown, but for the first finding
  Severity least = Severity::warning;
};

/// `file:line:column: warning: message [SP201 wrong-number-of-levels]`, the row with the location underlined, then the
/// related locations as notes. Without `all` the errors come first, then what concerns the most symbols. A finding in
/// an empty text has no line, one without a source has no file. Unsafe characters are shown as `<U+XXXX>`. O(findings *
/// log(findings) + length of the lines shown).
std::string render_text(std::span<const Diagnostic> findings, const TextOptions& options = {});

}  // namespace symplant::diag
