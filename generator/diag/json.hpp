// Findings as JSON for programs.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// The version of the format; it changes if a reader of the old format would misread the new one.
inline constexpr int kJsonVersion = 1;

/// How many findings are not reported.
struct LeftOut {
  std::size_t by_description = 0;  ///< ignored by plant.json
  std::size_t by_options = 0;      ///< of rules that the command line does not select
};

/// One object: `symplant-diagnostics` (the version), `findings` in the order of `findings`, `counts` by severity and,
/// if not 0, `ignored` (by plant.json) and `left_out` (by options). Lines and columns count from 1, columns in
/// characters; `span` is in bytes of the file's text as UTF-8. A finding in an empty text has no line; one without a
/// source has no file either.
std::string render_json(std::span<const Diagnostic> findings, const LeftOut& left_out = {});
/// The object for the findings of several parts, one part after the other. `plants` are JSON objects on one line each,
/// for the key `plants`; without them there is no such key.
std::string render_json(std::span<const std::span<const Diagnostic>> parts, const LeftOut& left_out,
                        std::span<const std::string> plants = {});

}  // namespace symplant::diag
