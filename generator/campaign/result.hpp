// What a run with a fault has shown.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/result_file.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::campaign {

/// The first of these that applies, except `error` (docs/testing-programs.md).
enum class Class : std::uint8_t {
  error,       ///< the run has no result: the program crashed, or it could not run
  violated,    ///< a requirement of the plant is violated
  no_effect,   ///< what the program reads is that of the base case
  detected,    ///< an alarm comes on that is off without the fault
  undetected,  ///< the operations are those of the base case
  stopped,     ///< no operation changes for longer than the longest pause of the base case
  other,
};
inline constexpr std::size_t kClasses = 7;
/// `no effect`
std::string_view class_name(Class one);
/// The class of a name, also with `-` for each blank; nothing for any other text.
std::optional<Class> class_of(std::string_view name);
/// What comes first for a reader: 0 for the worst.
int rank(Class one);

/// A row of the FMEA.
struct Result {
  std::string item;     ///< what fails
  std::string more;     ///< its address and comment
  std::string mode;     ///< how
  std::string phase;    ///< from when on
  tables::Time at = 0;  ///< the same as plant time
  Class is = Class::error;
  std::string seen;                 ///< what the program reads first that differs; empty: nothing
  tables::Time seen_at = -1;        ///< when; -1: never
  std::string reaction;             ///< what the program and the plant do
  std::string requirement;          ///< the first one that is violated; empty: none
  tables::Time violated_at = -1;    ///< when
  std::string failed_step;          ///< of the base case, the first one that fails; empty: none
  std::vector<std::string> alarms;  ///< that come on
  tables::Time detection = -1;      ///< from `seen_at` to the first of them; -1: none comes on
  std::vector<std::string> on;      ///< operations that are on at the end, of what has stopped
  std::string end;                  ///< without such: `works on`, `all off`, `as without the fault`
  std::string command;              ///< repeats the run
  std::string chart = "null";       ///< series and differences, as JSON; `null`: the row has no chart
  bool ran = true;                  ///< false: the base case shows it

  /// `X0012 stuck on, from the start`
  std::string title() const;
  std::string line() const;
  static std::optional<Result> of_line(std::string_view line);
};

inline constexpr const char* kResultKey = "symplant-campaign";
using Results = batch::Results<Result>;

}  // namespace symplant::campaign
