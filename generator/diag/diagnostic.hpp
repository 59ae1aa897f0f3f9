// Rules and what they found: values, with stable names and places in the user's files.
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

/// What is known of a rule. Ids and slugs are never reused.
struct RuleInfo {
  std::string_view id;    ///< "SP201"
  std::string_view slug;  ///< "wrong-number-of-levels"
  Severity severity;
  std::string_view summary;  ///< one line, for the catalogue
  std::string_view page;     ///< the manual page, Markdown: what it means, what the model loses, how to mend it
};

/// "error" and so on; nothing for another word.
std::optional<Severity> severity_of_name(std::string_view name);

/// Bytes of a file; `source` may be null where the fault has no place (a file that could not be read).
struct Location {
  std::shared_ptr<const text::SourceFile> source;
  text::Span span;
  /// Where the place in the plant description is known as a JSON pointer only: until Diagnostics::locate() finds it,
  /// `source` and `span` stand for it. Empty else.
  std::string pointer = {};
};

struct Related {
  Location location;
  std::string message;
};

/// Wording: lower case, no full stop, back-ticks round user text; what is there first, then what to do.
struct Diagnostic {
  const RuleInfo* rule = nullptr;
  Severity severity = Severity::error;  ///< the rule's, unless the user sets another
  std::string message;
  Location location;
  std::vector<Related> related;
  std::vector<std::string> about;  ///< the symbols and devices (by path) that the user may name to leave it out
};

/// A finding that the user's settings leave out, and why, in his words.
struct Ignored {
  Diagnostic finding;
  std::string why;
};

/// How many findings one run's options leave out, by option.
struct LeftOutByOption {
  std::size_t not_selected = 0;
  std::size_t ignored = 0;
};

/// Everything found so far.
class Diagnostics {
 public:
  void add(const RuleInfo& rule, std::string message, Location location, std::vector<Related> related = {});
  void add(const RuleInfo& rule, std::vector<std::string> about, std::string message, Location location,
           std::vector<Related> related = {});
  void add(Diagnostic finding);
  void ignore(Diagnostic finding, std::string why);

  /// In the order of their files and of their places in them, those without a place first; of one place in the order of
  /// finding. Files stand in the order of `files`, before them those that are not among them, as they were first found.
  void sort_by_location(std::span<const text::SourceFile* const> files = {});
  /// The pointers of all places, related ones too, that are not yet located: each once, sorted.
  std::vector<std::string> pointers() const;
  /// Gives those places the file and the spans: `spans[i]` is that of the i-th of pointers(); a place without one
  /// stays as it is.
  void locate(const std::shared_ptr<const text::SourceFile>& file, std::span<const std::optional<text::Span>> spans);

  std::span<const Diagnostic> all() const { return all_; }
  std::span<const Ignored> ignored() const { return ignored_; }
  const LeftOutByOption& left_out() const { return left_out_; }
  void leave_out(const LeftOutByOption& more) {
    left_out_.not_selected += more.not_selected;
    left_out_.ignored += more.ignored;
  }
  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  /// Makes findings related rows of others: `into[i]` is the place of the one that takes up the i-th, or i itself. One
  /// that takes up others is taken up by none. It becomes as severe as the most severe of them.
  void fold(std::span<const std::uint32_t> into);

  bool has_errors() const { return count(Severity::error) != 0; }

 private:
  std::vector<Diagnostic> all_;
  std::vector<Ignored> ignored_;
  LeftOutByOption left_out_;
  std::array<std::size_t, 3> counts_{};
};

}  // namespace symplant::diag
