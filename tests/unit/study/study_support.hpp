// Recordings as short texts.
#pragma once

#include <sstream>
#include <string>

#include "recording/read.hpp"
#include "support/catch.hpp"
#include "support/described_plant.hpp"

namespace symplant::test {

/// "0 A on; 10 N 5.5": changes at times in ms; "30" alone is the time of the last line.
inline std::string recording_text(const std::string& changes, const std::string& more = ",\"recorded\":true") {
  std::string text = "{\"symplant-trace\":1" + more + "}\n";
  std::istringstream all(changes);
  for (std::string change; std::getline(all, change, ';');) {
    std::istringstream words(change);
    long time = 0;
    std::string name;
    std::string value;
    words >> time >> name >> value;
    if (value == "on") value = "true";
    if (value == "off") value = "false";
    text += "{\"t\":" + std::to_string(time * 1'000'000);
    if (!name.empty()) text += ",\"symbol\":\"" + name + "\",\"value\":" + value;
    text += "}\n";
  }
  return text;
}

inline recording::Recording recording_of(const std::string& changes, const std::string& more = ",\"recorded\":true") {
  std::istringstream file(recording_text(changes, more));
  recording::ReadRecording read = recording::read_recording(file, "recording");
  INFO(read.error);
  REQUIRE(read.error.empty());
  return std::move(read.recording);
}

/// `1000 on, 2000 off`: the changes of a symbol, times in ms; empty: it has none.
inline std::string changes_of(const recording::Recording& recording, const std::string& name) {
  const recording::Series* const series = recording.find({name, recording::Series::Kind::boolean, {}, {}, {}});
  std::ostringstream text;
  if (series == nullptr) return "";
  for (const recording::Series::Change& change : series->changes) {
    text << (text.tellp() == 0 ? "" : ", ") << change.time / tables::kMillisecond << " ";
    if (series->kind == recording::Series::Kind::boolean) {
      text << (change.value != 0 ? "on" : "off");
    } else {
      text << change.value;
    }
  }
  return text.str();
}

}  // namespace symplant::test
