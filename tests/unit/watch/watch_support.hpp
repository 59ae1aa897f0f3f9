// A plant, a recording as text, and its anomalies as lines.
#pragma once

#include <string>
#include <vector>

#include "../compare/compare_support.hpp"
#include "support/described_plant.hpp"
#include "watch/report.hpp"
#include "watch/shadow.hpp"
#include "watch/statistics.hpp"
#include "watch/words.hpp"

namespace symplant::test {

inline const std::vector<std::string> kClamp = {"L_P_CL_I_OPEN", "L_P_CL_I_CLOSED", "L_P_CL_O_OPEN", "L_P_CL_O_CLOSED"};
inline constexpr const char* kBistable = R"("devices": {"L_P_CL": {"actuation": "bistable"}})";
/// Read every 10 ms.
inline constexpr const char* kEvery10 = R"(,"cycle":10000000)";

class Watched {
 public:
  Watched(const std::vector<std::string>& names, const std::string& members) : plant_(bits(names), members) {}

  std::vector<watch::Anomaly> anomalies(const recording::Recording& recording) const {
    const observe::Matched matched = observe::match(model(), recording);
    const watch::Margin margin{0.2, recording.resolution};
    std::vector<watch::Anomaly> found;
    watch::Shadow shadow(model(), matched.recorded, margin, learned,
                         [&](const watch::Anomaly& anomaly) { found.push_back(anomaly); });
    watch::follow(recording, matched, shadow);
    return found;
  }

  /// One line each: `late L_P_CL OPEN->CLOSED at 1400`, `<1` at its end if it follows from anomaly 1.
  std::string found(const std::string& changes, const std::string& header = kEvery10) const {
    std::string text;
    for (const watch::Anomaly& one : anomalies(recorded(trace_text(changes, header)))) {
      text += (text.empty() ? "" : "\n") + line(one);
    }
    return text;
  }

  /// As sentences.
  std::string sentences(const std::string& changes, const std::string& header = kEvery10) const {
    const recording::Recording recording = recorded(trace_text(changes, header));
    std::string text;
    for (const watch::Anomaly& one : anomalies(recording)) {
      text += (text.empty() ? "" : "\n") + watch::sentence(model(), one, recording.resolution);
    }
    return text;
  }

  const model::PlantModel& model() const { return plant_.compiled().plant; }

  std::vector<watch::Statistic> learned;

 private:
  std::string line(const watch::Anomaly& one) const {
    std::string text(watch::kind_name(one.kind));
    text += " " + watch::name_of(model(), one);
    if (one.unit != watch::kNone) {
      const auto state = [&](std::uint32_t s) {
        return s == watch::kNone ? std::string("?") : model().units[one.unit].states[s].name;
      };
      text += " " + state(one.move.from) + "->" + state(one.move.to);
      if (one.part == watch::Anomaly::Part::leaving) text += " leaving";
    }
    text += " at " + std::to_string(one.time / tables::kMillisecond);
    return one.follows == 0 ? text : text + " <" + std::to_string(one.follows);
  }

  DescribedPlant plant_;
};

}  // namespace symplant::test
