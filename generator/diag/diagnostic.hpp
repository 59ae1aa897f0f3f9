// Rules and findings: values with stable names and locations in the user's files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/source_file.hpp"

namespace symplant::diag {

enum class Severity { note, warning, error };

std::string_view severity_name(Severity severity);

/// The properties of a rule. Ids and slugs are never reused.
struct RuleInfo {
  std::string_view id;    ///< "SP201"
  std::string_view slug;  ///< "wrong-number-of-levels"
  Severity severity;
  std::string_view summary;  ///< one line, for the catalogue
  std::string_view page;     ///< the manual page, Markdown: meaning, what the model loses, how to fix it
};

/// The severity of "note", "warning" or "error"; nothing for any other word.
std::optional<Severity> severity_of_name(std::string_view name);

/// Bytes of a file. `source` is null if the finding has no location (a file that could not be read).
struct Location {
  std::shared_ptr<const text::SourceFile> source;
  text::Span span;
  /// A JSON pointer into the plant description, until Diagnostics::locate() sets `source` and `span` from it; else
  /// empty.
  std::string pointer = {};
};

struct Related {
  Location location;
  std::string message;
};

/// Wording of messages: lower case, no full stop, back-ticks round user text; what is wrong, then what to do.
struct Diagnostic {
  const RuleInfo* rule = nullptr;
  Severity severity = Severity::error;  ///< the rule's, unless the user sets another one
  std::string message;
  Location location;
  std::vector<Related> related;
  std::vector<std::string> about;  ///< the symbols and devices (paths) by which the user can ignore the finding
};

/// A finding that plant.json ignores, and the reason given there.
struct Ignored {
  Diagnostic finding;
  std::string why;
};

/// How many findings the options of a run leave out, by option.
struct LeftOutByOption {
  std::size_t not_selected = 0;
  std::size_t ignored = 0;
};

/// The findings so far.
class Diagnostics {
 public:
  void add(const RuleInfo& rule, std::string message, Location location, std::vector<Related> related = {});
  void add(const RuleInfo& rule, std::vector<std::string> about, std::string message, Location location,
           std::vector<Related> related = {});
  void add(Diagnostic finding);
  void ignore(Diagnostic finding, std::string why);

  /// Sorts by file and location; findings without a location come first, findings of one location keep their order. The
  /// order of files is that of `files`; before them come other files, in the order of their first finding.
  void sort_by_location(std::span<const text::SourceFile* const> files = {});
  /// The pointers of all locations, related ones too, that are not yet located: unique and sorted.
  std::vector<std::string> pointers() const;
  /// Sets file and span of those locations: `spans[i]` is the span of the i-th of pointers(). A location without a span
  /// does not change.
  void locate(const std::shared_ptr<const text::SourceFile>& file, std::span<const std::optional<text::Span>> spans);

  std::span<const Diagnostic> all() const { return all_; }
  std::span<const Ignored> ignored() const { return ignored_; }
  const LeftOutByOption& left_out() const { return left_out_; }
  void leave_out(const LeftOutByOption& more) {
    left_out_.not_selected += more.not_selected;
    left_out_.ignored += more.ignored;
  }
  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  /// Makes findings related rows of others: `into[i]` is the index of the finding that absorbs the i-th, or i. A
  /// finding that absorbs others must not be absorbed itself. It gets the highest severity of them.
  void fold(std::span<const std::uint32_t> into);

  bool has_errors() const { return count(Severity::error) != 0; }

 private:
  std::vector<Diagnostic> all_;
  std::vector<Ignored> ignored_;
  LeftOutByOption left_out_;
  std::array<std::size_t, 3> counts_{};
};

}  // namespace symplant::diag
