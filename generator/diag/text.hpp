// Findings as text for people: the message, the row, the place underlined.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

struct TextOptions {
  bool colour = false;
  /// After so many findings of one rule the rest of them are counted in one line at the end; 0 shows all.
  std::size_t fold_after = 20;
  std::size_t fold_notes_after = 3;  ///< the same for notes, which a long list has hundreds of; never more than above
};

/// `file:line:column: warning: message [SP201 wrong-number-of-levels]`, the row with the place underlined, then the
/// related places as notes. A finding in an empty text has no line, one without a source no file. What is unsafe to
/// print is shown as `<U+XXXX>`. O(findings), and the length of their lines.
std::string render_text(std::span<const Diagnostic> findings, const TextOptions& options = {});

}  // namespace symplant::diag
