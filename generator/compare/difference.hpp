// How one recorded run differs from another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/recording.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::compare {

using recording::kLatestTime;
using recording::Recording;
using recording::Series;

struct Difference {
  enum class Kind : std::uint8_t {
    missing,        ///< EXPECTED has a change that ACTUAL does not have
    unexpected,     ///< ACTUAL has a change that EXPECTED does not have
    late,           ///< ACTUAL has it after its time
    early,          ///< ACTUAL has it before its time
    deviates,       ///< a number differs by more than the tolerance, for longer than the window
    expected_ends,  ///< ACTUAL has changes after the end of EXPECTED
    actual_ends,    ///< EXPECTED has changes after the end of ACTUAL
  };
  Kind kind = Kind::missing;
  const Series* of = nullptr;  ///< the element that differs; null: the whole trace
  tables::Time time = 0;       ///< of EXPECTED's change; unexpected: of ACTUAL's; ends: of the last line
  tables::Time by = 0;         ///< late, early: the difference; deviates, a pulse: how long
  double expected = 0;         ///< the value; deviates: where the difference is greatest
  double actual = 0;
  bool is_pulse = false;      ///< missing, unexpected: the change and the change back
  std::size_t changes = 0;    ///< ends: how many changes of the other follow
  tables::Time exact_to = 0;  ///< times are; 0: to 1 ns
};

enum class Align : std::uint8_t {
  none,    ///< times are compared as they are
  symbol,  ///< times count from the first time that a symbol comes on
  follow,  ///< times count from the last change that both have
};

struct Options {
  std::optional<tables::Time> window;  ///< nothing: 0 in virtual time, else twice the coarser resolution
  double tolerance = 0.01;             ///< of numbers, as a share of EXPECTED's span
  Align align = Align::none;
  std::string align_symbol;         ///< for Align::symbol
  std::vector<std::string> only;    ///< patterns of names; empty: all
  std::vector<std::string> ignore;  ///< patterns of names
};

/// `none`, `follow`; any other text is the name of a symbol.
Align align_of(std::string_view text);
/// Whether the patterns choose a symbol or location. O(patterns).
bool is_chosen(const Options& options, const std::string& name);
/// Reads a share: `2.5%` is 0.025. Only `0` needs no `%`. Nothing for any other text.
std::optional<double> parse_tolerance(std::string_view text);

/// The result of compare(). Both traces must outlive it.
struct Comparison {
  const Recording* expected = nullptr;
  const Recording* actual = nullptr;
  tables::Time window = 0;
  std::vector<const Series*> compared;      ///< EXPECTED's, then those that only ACTUAL has
  std::vector<const Series*> not_recorded;  ///< elements that one trace, a recording, does not have
  std::size_t changes = 0;                  ///< of EXPECTED, up to the end of the comparison
  std::vector<Difference> differences;      ///< by time
  std::string error;                        ///< why the traces could not be compared; empty: they were
  std::string warning;                      ///< what may be a mistake of the user; empty: no warning
};

/// Removes what is missing or unexpected within the window before the earlier end: its counterpart may come after it.
void drop_unsure(Comparison& comparison);

/// Compares two traces. A pulse that a recording cannot have seen, as it is shorter than the window and than two of its
/// resolutions, is no difference. O(changes * log(differences)).
Comparison compare(const Recording& expected, const Recording& actual, const Options& options);

}  // namespace symplant::compare
