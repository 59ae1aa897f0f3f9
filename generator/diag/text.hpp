// Findings as text for people: the message, the row, the location underlined.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

struct TextOptions {
  bool colour = false;
  /// The most findings shown for one rule; the rest are counted in one line at the end. 0 shows all.
  std::size_t fold_after = 20;
  std::size_t fold_notes_after = 3;     ///< the same for notes, of which a long list has hundreds; at most `fold_after`
  std::size_t fold_related_after = 10;  ///< the same for the related rows of one finding, unless fold_after is 0
};

/// `file:line:column: warning: message [SP201 wrong-number-of-levels]`, the row with the location underlined, then the
/// related locations as notes. A finding in an empty text has no line, one without a source has no file. Unsafe
/// characters are shown as `<U+XXXX>`. O(findings + length of their lines).
std::string render_text(std::span<const Diagnostic> findings, const TextOptions& options = {});

}  // namespace symplant::diag
