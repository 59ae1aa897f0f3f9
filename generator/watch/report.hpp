// Anomalies as JSON lines, as JUnit XML, and as counts.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "watch/anomaly.hpp"
#include "watch/watcher.hpp"

namespace symplant::watch {

/// One line of a findings file, without its end. O(symbols of the anomaly).
std::string json_line(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution);

/// What of the plant is not watched: `12 devices that no recorded event shows, 2 with custom behavior`. Empty: nothing.
/// O(plant).
std::string not_watched(const model::PlantModel& plant, const std::vector<bool>& recorded);

/// What is kept of all anomalies for the end.
class Tally {
 public:
  void add(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution);

  /// How many there were of this unit and kind, those that follow from others included.
  std::size_t count(std::uint32_t unit, Anomaly::Kind kind) const;
  std::size_t firsts() const { return firsts_; }
  std::size_t following() const { return following_; }

  /// A row for each unit with anomalies, those with the most first: `L_P_CL  2 late, 1 missing  first at 3.2 s`.
  std::vector<std::string> rows(const model::PlantModel& plant, Time resolution) const;
  /// `no anomaly in 412 moves of 20 devices`, `3 anomalies of 2 devices (1 more follows from them) in ...`.
  std::string summary(const Counts& counts) const;
  /// A test case for each unit that moved or has anomalies, and one for the readings.
  std::string junit(const model::PlantModel& plant, const Counts& counts, Time end) const;

 private:
  static constexpr std::size_t kMostTexts = 10;  ///< of each unit, in JUnit
  struct Of {
    std::array<std::size_t, kKindNames.size()> counts{};
    Time first = 0;
    std::size_t all = 0;
    std::string texts;
  };
  std::string counts_words(const Of& of) const;

  std::map<std::uint32_t, Of> units_;  ///< kNone: the readings
  std::size_t firsts_ = 0;
  std::size_t following_ = 0;
};

}  // namespace symplant::watch
