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
#include <utility>
#include <vector>

#include "text/source_file.hpp"

namespace symplant::diag {

enum class Severity { note, warning, error };

std::string_view severity_name(Severity severity);

/// What a rule is about, causes first: a finding follows only from one of a lower rank.
enum class Rank : std::uint8_t {
  address,    ///< the addresses of a row
  name,       ///< the spelling of a name
  row,        ///< rows and symbols that the model leaves out
  direction,  ///< a name and an address of different directions
  value,      ///< an initial value
  words,      ///< two words for one state
  repeated,   ///< a sequence number twice
  gap,        ///< a sequence number missing
  siblings,   ///< what similar devices have
  last,       ///< all others: they explain nothing
};

/// What an error of a rule means for the plant.
enum class Effect : std::uint8_t {
  no_plant,      ///< there is no valid plant: the rule cannot be ignored
  no_plant_yet,  ///< there is a valid plant if the rule is ignored
  served,        ///< there is a valid plant, whose symbols can be served
};

/// The properties of a rule. Ids and slugs are never reused.
struct RuleInfo {
  std::string_view id;    ///< "SP201"
  std::string_view slug;  ///< "wrong-number-of-levels"
  Severity severity;
  std::string_view summary;  ///< one line, for the catalogue
  std::string_view page;     ///< the manual page, Markdown: the meaning of the rule, or the whole page
  Rank rank = Rank::last;
  std::string_view loses = {};       ///< what the model loses, if the page does not say it
  std::string_view fix = {};         ///< how to fix it
  Effect effect = Effect::no_plant;  ///< what an error of the rule means
};

/// The manual page with all of its sections, in lines of at most 120 characters if a section is one line.
std::string manual_page(const RuleInfo& rule);

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

/// A new name that a finding proposes for a symbol.
struct Rename {
  std::string from;
  std::string to;
  std::string address;  ///< as the list writes it; empty without one
  bool safe = false;    ///< the list itself proves it; else a person decides
};

/// What a finding is about. Names compare without regard to case.
struct Subject {
  enum class Kind : std::uint8_t {
    device,       ///< a device, by its path
    symbol,       ///< a symbol of the list
    missing,      ///< a symbol that the list does not have, by the name that it would have
    address,      ///< the address of the symbol of this name
    model,        ///< what is derived for the device of this path: states, transitions, a missing side
    name,         ///< a symbol whose name breaks the naming rule: it may be any missing one with a similar name
    requirement,  ///< a requirement of the plant description
    value,        ///< a value of the plant description
  };
  static constexpr std::size_t kKinds = 8;
  Kind kind;
  std::string name;

  bool operator==(const Subject&) const = default;
};

/// The subjects of a finding.
struct Subjects {
  std::vector<Subject> about;     ///< what the user may name to ignore the finding; they make its fingerprint
  std::vector<Subject> explains;  ///< a finding that follows any of these may follow from this one
  std::vector<Subject> follows;   ///< what the finding may be a consequence of
  /// The shape of the name of the first of `about`, such as `ST#_CLAMP#_O_ADV`, or of the type of its device. Findings
  /// of one rule and one shape become one finding; empty if the finding stays single.
  std::string shape = {};
};

/// Wording of messages: lower case, no full stop, back-ticks round user text; what is wrong, then what to do.
struct Diagnostic {
  const RuleInfo* rule = nullptr;
  Severity severity = Severity::error;  ///< the rule's, unless the user sets another one
  std::string message;
  Location location;
  std::vector<Related> related;
  Subjects subjects;
  /// Findings that follow from this one, until show_consequences() makes related rows of them.
  std::vector<Diagnostic> consequences = {};
  std::size_t shown_consequences = 0;  ///< how many of the related rows were findings
  std::vector<Rename> renames = {};
  std::size_t count = 1;  ///< findings of one shape that this one includes
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
  std::size_t consequences = 0;  ///< findings that follow from the ignored ones
  std::size_t baseline = 0;

  std::size_t total() const { return not_selected + ignored + consequences + baseline; }
};

/// The findings so far.
class Diagnostics {
 public:
  void add(const RuleInfo& rule, std::string message, Location location, std::vector<Related> related = {});
  /// The finding is valid until the next one is added.
  Diagnostic& add(const RuleInfo& rule, Subjects subjects, std::string message, Location location,
                  std::vector<Related> related = {});
  void add(Diagnostic finding);
  /// Adds the findings of others, in their order.
  void add(Diagnostics&& others);
  void ignore(Diagnostic finding, std::string why);

  /// Sorts by file and location; findings without a location come first, findings of one location keep their order. The
  /// order of files is that of `files`; before them come other files, in the order of their first finding.
  void sort_by_location(std::span<const text::SourceFile* const> files = {});
  /// The pointers of all locations, related ones too, that are not yet located: unique and sorted.
  std::vector<std::string> pointers() const;
  /// Sets file and span of the locations of pointers(): `locations[i]` is that of the i-th of pointers().
  void locate(std::span<const Location> locations);

  std::span<const Diagnostic> all() const { return all_; }
  /// Removes all findings, to add some of them again.
  std::vector<Diagnostic> take() {
    counts_ = {};
    return std::exchange(all_, {});
  }
  std::span<const Ignored> ignored() const { return ignored_; }
  const LeftOutByOption& left_out() const { return left_out_; }
  void leave_out(const LeftOutByOption& more) {
    left_out_.not_selected += more.not_selected;
    left_out_.ignored += more.ignored;
    left_out_.consequences += more.consequences;
    left_out_.baseline += more.baseline;
  }
  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  /// Makes findings consequences of others: `into[i]` is the index of the finding that takes the i-th, or i itself. No
  /// finding takes one that takes others.
  void fold(std::span<const std::uint32_t> into);
  /// Turns all consequences into related rows. A finding becomes as severe as the most severe of them.
  void show_consequences();

  bool has_errors() const { return count(Severity::error) != 0; }

 private:
  std::vector<Diagnostic> all_;
  std::vector<Ignored> ignored_;
  LeftOutByOption left_out_;
  std::array<std::size_t, 3> counts_{};
};

}  // namespace symplant::diag
