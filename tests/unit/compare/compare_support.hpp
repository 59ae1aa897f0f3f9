// Traces as short texts, and their differences as lines.
#pragma once

#include <sstream>
#include <string>

#include "compare/difference.hpp"
#include "compare/words.hpp"
#include "recording/read.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::test {

/// "10 X 1; 11 X 0; 12 N 5.5": changes at times in ms; X and Y are BOOL, other names are numbers. "20 body@BELT" is a
/// part that arrives; "30" alone is the time of the last line.
inline std::string trace_text(const std::string& changes, const std::string& more = "") {
  std::string text = "{\"symplant-trace\":1" + more + "}\n";
  std::istringstream all(changes);
  for (std::string change; std::getline(all, change, ';');) {
    std::istringstream words(change);
    long time = 0;
    std::string name;
    std::string value;
    words >> time >> name >> value;
    text += "{\"t\":" + std::to_string(time * 1'000'000);
    if (const std::size_t at = name.find('@'); at != name.npos) {
      text += ",\"part\":1,\"kind\":\"" + name.substr(0, at) + "\",\"to\":\"" + name.substr(at + 1) + "\"";
    } else if (!name.empty()) {
      const bool is_bit = name[0] == 'X' || name[0] == 'Y';
      text += ",\"symbol\":\"" + name + "\",\"value\":" + (!is_bit ? value : value == "1" ? "true" : "false");
    }
    text += "}\n";
  }
  return text;
}

inline recording::Recording recorded(const std::string& text, const std::string& name = "trace") {
  std::istringstream file(text);
  recording::ReadRecording read = recording::read_recording(file, name);
  INFO(read.error);
  REQUIRE(read.error.empty());
  return std::move(read.recording);
}

struct Compared {
  Compared(const std::string& expected_changes, const std::string& actual_changes, const compare::Options& options = {},
           const std::string& more_expected = "", const std::string& more_actual = "")
      : expected(recorded(trace_text(expected_changes, more_expected), "good.jsonl")),
        actual(recorded(trace_text(actual_changes, more_actual), "run.jsonl")),
        comparison(compare::compare(expected, actual, options)) {}
  Compared(const Compared&) = delete;
  Compared& operator=(const Compared&) = delete;

  /// A sentence a line.
  std::string lines() const {
    std::string text;
    for (const compare::Difference& difference : comparison.differences) {
      text += (text.empty() ? "" : "\n") + compare::sentence(difference);
    }
    return text;
  }

  recording::Recording expected;
  recording::Recording actual;
  compare::Comparison comparison;
};

inline std::string differences(const std::string& expected, const std::string& actual,
                               const compare::Options& options = {}) {
  return Compared(expected, actual, options).lines();
}

}  // namespace symplant::test
