// The result of a case of a suite.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/result_file.hpp"
#include "suite/suite.hpp"

namespace symplant::suite {

struct Result {
  enum class Verdict : std::uint8_t {
    passed,
    failed,  ///< an expectation, a requirement, a difference, the limit
    error,   ///< it could not run: bad input, a program that crashed
  };
  enum class Reference : std::uint8_t {
    none,     ///< there is no reference trace: only expectations and requirements judge
    same,     ///< the case does what the reference trace has
    differs,  ///< it does not
    added,    ///< --update wrote the first one
    updated,  ///< --update wrote another one
  };
  std::string name;  ///< of the case
  Speed speed = Speed::normal;
  Verdict verdict = Verdict::error;
  Reference reference = Reference::none;
  double seconds = 0;                 ///< of the wall clock
  std::vector<std::string> messages;  ///< why it did not pass; with --update, what changed
  std::string chart;                  ///< both traces and the differences, as JSON for the page; empty: none

  /// `start`, `start on the fast plant`
  std::string title() const;
  /// As one line of JSON, without its end.
  std::string line() const;
  /// Nothing if the text is not such a line.
  static std::optional<Result> of_line(std::string_view line);
};

/// How many messages a result has at most, and one more that counts the others.
inline constexpr std::size_t kMostMessages = 20;
/// The lines of a text as messages.
std::vector<std::string> message_lines(const std::string& text);

std::string_view verdict_name(Result::Verdict verdict);

/// The key of files of results.
inline constexpr const char* kResultKey = "symplant-test";
using Results = batch::Results<Result>;

}  // namespace symplant::suite
