// A station with a program, whose signals can be defective: it makes labelled recordings.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "recording/recording.hpp"

namespace symplant::property {

/// What a defect sees of the station.
struct Scene {
  tables::Time now = 0;
  tables::Time begin = 0;  ///< of the cycle
  int cycle = 0;
  std::vector<tables::Time> since;  ///< by symbol: when its real level changed last
};

/// What goes wrong in every cycle for which `in` holds. Symbols are names without `L_P_`.
struct Defect {
  std::string name;
  std::string device;  ///< without `L_P_`; empty: no device, the recording itself
  std::function<bool(int cycle)> in = [](int) { return true; };
  /// The level that program and recording see of an event, of its real one; empty: the same.
  std::function<bool(const Scene&, const std::string& symbol, bool level)> event = {};
  /// The level that the plant gets of an operation, of the one that program and recording see.
  std::function<bool(const Scene&, const std::string& symbol, bool level)> operation = {};
  std::function<bool(const Scene&)> frozen = {};   ///< no event reaches the program
  std::function<bool(const Scene&)> stopped = {};  ///< the program does not run
  std::function<bool(const Scene&)> unread = {};   ///< nothing is recorded
  tables::Time jump = 0;                           ///< by so much the recorder's clock is wrong after a third
};

/// Clamp, drill, motor, pusher and belt.
model::PlantModel station();

struct StationCycle {
  tables::Time begin = 0;
  tables::Time end = 0;
  bool defective = false;
};

struct LabelledRecording {
  recording::Recording recording;
  std::vector<StationCycle> cycles;
};

/// Runs the station for some cycles and reads it every 50 ms. Its times are random, +-5 %.
LabelledRecording record_station(std::uint64_t seed, int cycles, const Defect& defect);

/// Blocked sensor, communication error, worn belt, and 20 other kinds.
std::vector<Defect> station_defects();

}  // namespace symplant::property
