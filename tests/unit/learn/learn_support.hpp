// Plants, recordings as texts, and what is learned from them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "../observe/observe_support.hpp"
#include "learn/formats.hpp"
#include "learn/learn.hpp"
#include "learn/learned_file.hpp"
#include "learn/words.hpp"

namespace symplant::test {

inline constexpr tables::Time kMilli = tables::kMillisecond;

/// A header of a recording that is read every 50 ms.
inline constexpr const char* kEvery50 = R"(,"recorded":true,"every":50000000)";

/// A clamp that is OPEN at first, then closes and opens: by pairs of the times from command to arrival, in ms. Each
/// command comes 100 ms after the last arrival; the clamp leaves `delay` later.
inline std::string clamp_moves(const std::vector<std::pair<int, int>>& moves, int delay = 0) {
  std::string text = "0 O_OPEN 1; 0 O_CLOSED 0; 0 I_OPEN 1; 0 I_CLOSED 0";
  int now = 0;
  const auto add = [&](const std::string& what) { text += "; " + std::to_string(now) + " " + what; };
  for (const auto& [closing, opening] : moves) {
    for (const bool closes : {true, false}) {
      now += 100;
      add(closes ? "O_OPEN 0" : "O_CLOSED 0");
      add(closes ? "O_CLOSED 1" : "O_OPEN 1");
      now += delay;
      add(closes ? "I_OPEN 0" : "I_CLOSED 0");
      now += (closes ? closing : opening) - delay;
      add(closes ? "I_CLOSED 1" : "I_OPEN 1");
    }
  }
  return text;
}

/// A trace of BOOL symbols: "100 O_OPEN 0; ..." with a prefix before each name.
inline std::string bit_trace(const std::string& changes, const std::string& prefix, const std::string& header = "") {
  std::string text = "{\"symplant-trace\":1" + header + "}\n";
  std::istringstream all(changes);
  for (std::string change; std::getline(all, change, ';');) {
    std::istringstream words(change);
    long time = 0;
    std::string name;
    std::string value;
    words >> time >> name >> value;
    text += "{\"t\":" + std::to_string(time * kMilli) + ",\"symbol\":\"" + prefix + name +
            "\",\"value\":" + (value == "1" ? "true" : "false") + "}\n";
  }
  return text;
}

class LearnedFrom {
 public:
  LearnedFrom(const std::vector<std::string>& names, const std::string& members, const std::vector<std::string>& traces)
      : plant_(bits(names), members) {
    for (std::size_t i = 0; i < traces.size(); ++i) {
      recording::Recording recording = recorded(traces[i], "folder/line" + std::to_string(i + 1) + ".jsonl");
      observe::Matched matched = observe::match(model(), recording);
      inputs_.push_back({std::move(recording), std::move(matched)});
    }
    learned = learn::learn_times(model(), inputs_);
  }

  const model::PlantModel& model() const { return plant_.compiled().plant; }

  /// `L_P_CL OPEN->CLOSED takes 0.8 s (4: 0.8 s 0.8 s 0.8 s)`: a line a time, with n, min, median and max.
  std::string times() const {
    std::string text;
    for (const learn::TimeRow& row : learn::time_rows(learned)) {
      const learn::Statistics& of = row.time->statistics;
      text += learn::group_title(*row.group) + (row.of.empty() ? "" : " " + row.of) + " " + std::string(row.kind) +
              " " + learn::duration_words(row.time->proposed) + " (" + std::to_string(of.count) + ": " + ms(of.min) +
              " " + ms(of.median) + " " + ms(of.max) + ")\n";
    }
    return text;
  }

  learn::Learned learned;

 private:
  DescribedPlant plant_;
  std::vector<learn::Input> inputs_;
};

}  // namespace symplant::test
