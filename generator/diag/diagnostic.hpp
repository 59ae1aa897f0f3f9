// Rules and what they found: values, with stable names and places in the user's files.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_file.hpp"

namespace symplant::diag {

enum class Severity { note, warning, error };

std::string_view severity_name(Severity severity);

/// What is known of a rule. Ids and slugs are never reused.
struct RuleInfo {
  std::string_view id;    ///< "SP201"
  std::string_view slug;  ///< "wrong-number-of-levels"
  Severity severity;
  std::string_view summary;  ///< one line, for the catalogue
  std::string_view page;     ///< the manual page, Markdown: what it means, what the model loses, how to mend it
};

/// Bytes of a file; `source` may be null where the fault has no place (a file that could not be read).
struct Place {
  std::shared_ptr<const base::SourceFile> source;
  base::Span span;
};

struct Related {
  Place place;
  std::string message;
};

/// Wording: lower case, no full stop, back-ticks round user text; what is there first, then what to do.
struct Diagnostic {
  const RuleInfo* rule;
  std::string message;
  Place place;
  std::vector<Related> related;
};

/// Everything found so far.
class Diagnostics {
 public:
  void add(const RuleInfo& rule, std::string message, Place place, std::vector<Related> related = {});

  /// In the order of their files and of their places in them, those without a place first; of one place in the order of
  /// finding. Files stand in the order of `files`, before them those that are not among them, as they were first found.
  void sort_by_place(std::span<const base::SourceFile* const> files = {});

  std::span<const Diagnostic> all() const { return all_; }
  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  bool has_errors() const { return count(Severity::error) != 0; }

 private:
  std::vector<Diagnostic> all_;
  std::array<std::size_t, 3> counts_{};
};

}  // namespace symplant::diag
