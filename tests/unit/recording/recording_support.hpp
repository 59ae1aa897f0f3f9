// Recordings as short texts.
#pragma once

#include <sstream>
#include <string>

#include "recording/read.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::test {

inline recording::ReadRecording read_csv_text(const std::string& text, const recording::ReadOptions& options = {}) {
  std::istringstream file(text);
  return recording::read_recording(file, "t.csv", options);
}

/// A line for each series, with times in ms, then the end and the resolution, then warnings. Or the error.
inline std::string csv(const std::string& text, const recording::ReadOptions& options = {}) {
  const recording::ReadRecording read = read_csv_text(text, options);
  if (!read.error.empty()) return read.error;
  std::ostringstream all;
  const auto ms = [](tables::Time time) { return static_cast<double>(time) / 1e6; };
  for (const recording::Series& series : read.recording.series) {
    all << series.name << (series.kind == recording::Series::Kind::boolean ? " bool" : " number");
    for (const auto& change : series.changes) all << " " << ms(change.time) << "=" << change.value;
    all << "\n";
  }
  all << "end " << ms(read.recording.end) << ", resolution " << ms(read.recording.resolution) << "\n";
  for (const std::string& warning : read.warnings) all << warning << "\n";
  return all.str();
}

}  // namespace symplant::test
