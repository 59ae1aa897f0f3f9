// A plant, a scenario and how both are written as files: plain values, so that parts can be removed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "property/plant_text.hpp"

namespace symplant::property::files {

/// A symbol's name and its value: 0 or 1, two's complement, or the bits of a double.
using Setting = std::pair<std::string, std::uint64_t>;

/// A step of a scenario.
struct Step {
  enum class When : std::uint8_t { at, plus, wait };
  When when = When::plus;
  std::optional<tables::Time> time;  ///< of `at` and `plus`: always set; of `wait`: its `within`
  std::string wait;                  ///< a condition
  std::vector<Setting> set;
  std::vector<std::pair<std::string, std::string>> states;  ///< device and state
  std::vector<std::pair<std::string, std::string>> put;     ///< location (TRACK, TRACK@POSITION or PLACE) and kind
  std::vector<std::string> take;                            ///< locations
  std::vector<Setting> force;
  std::vector<std::string> release;
  std::vector<std::string> stop;   ///< malfunctions, as users name them
  std::vector<std::string> start;  ///< malfunctions
  std::vector<Setting> expect;     ///< symbols with their values
  std::string expect_condition;    ///< or a condition

  friend bool operator==(const Step&, const Step&) = default;
};

/// How the files are written. The same for the same seed.
struct Style {
  std::uint64_t seed = 0;
  bool patterns = true;   ///< keys of devices are spread over patterns; else each is under the device's name
  bool decorated = true;  ///< comments, any order of keys, any case of names, any unit of durations
};

struct FileCase {
  PlantText plant;
  Style style;
  std::vector<Step> steps;
  std::uint64_t seed = 0;  ///< of the run
  std::optional<tables::Time> until;
};

/// The input files of a run of the tool.
struct Files {
  std::vector<std::string> lists;  ///< one or two
  std::string plant;
  std::string scenario;
  std::uint64_t seed = 0;
  std::optional<tables::Time> until;
};

}  // namespace symplant::property::files
