// Findings that a plant has had before: `--baseline`.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "base/result.hpp"
#include "diag/diagnostic.hpp"

namespace symplant::findings {

/// Counts findings by plant, rule, and the shape or name of what they are about. Rows do not count, so that a list may
/// be sorted. A baseline only shrinks: what it does not have is reported.
class Baseline {
 public:
  /// A baseline that has every finding, to write the first file.
  Baseline() = default;
  /// From the text of a file. On error, findings of its rule (SP627) in the file.
  static base::Result<Baseline, diag::Diagnostics> read(std::shared_ptr<const text::SourceFile> file);

  /// Removes the findings that it has, with what follows from them, and counts them as left out. If there are more
  /// findings of a kind than it counts, all of them are reported, since it is not known which are new. Errors that make
  /// a valid plant impossible stay. O(findings * log(entries)).
  diag::Diagnostics apply(const std::string& plant, diag::Diagnostics findings);
  /// Adds one finding (SP626) if it has findings that were not found.
  void report_stale(diag::Diagnostics& findings) const;

  /// The text of a file with those findings of the baseline that were found, and their number.
  std::string text() const;
  std::size_t size() const;

 private:
  struct Count {
    std::size_t given = 0;
    std::size_t found = 0;
  };
  std::size_t kept(const Count& count) const {
    return file_ == nullptr ? count.found : std::min(count.found, count.given);
  }

  std::shared_ptr<const text::SourceFile> file_;                               ///< null: it has every finding
  std::map<std::tuple<std::string, std::string, std::string>, Count> counts_;  ///< by plant, id of the rule, identity
};

}  // namespace symplant::findings
