// The single faults of a plant.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::campaign {

/// One thing that may fail, and how.
struct Fault {
  enum class Mode : std::uint8_t {
    stuck_on,   ///< a BOOL input
    stuck_off,  ///< a BOOL input
    loose,      ///< a BOOL input: a contact that shows the opposite for 80 ms every second
    held,       ///< a numeric input keeps its number
    stuck,      ///< a device or a track does not move
    slow,       ///< its moves take three times as long
    lost,       ///< a controller exchanges nothing
    described,  ///< a malfunction of plant.json, or of a file
  };
  Mode mode = Mode::stuck_on;
  std::string item;                    ///< a symbol, a device, a track or a controller; of `described` what it acts on
  std::string more;                    ///< the address and the comment of a symbol; else empty
  std::string malfunction;             ///< the name that starts it
  std::vector<std::uint32_t> symbols;  ///< inputs that it acts on
  std::vector<std::uint32_t> units;    ///< devices that it acts on
  std::vector<std::uint32_t> controllers = {};  ///< that it cuts off, so that their programs read nothing
  std::uint32_t begins = tables::kNone;         ///< the malfunction whose start in the base case begins it; kNone: none
};

/// `stuck on`, `loose contact`; of `described` the name of the malfunction.
std::string mode_words(const Fault& fault);

/// Adds the malfunctions that campaigns need and that not every plant has: `SYMBOL loose`, `SYMBOL held`, `track TRACK
/// stuck`, `track TRACK slow`, `CONTROLLER lost`. The
/// plant's malfunctions from `own` on are of a file of faults: they no longer start by themselves; instead one without
/// effects, `NAME (condition)`, starts when the condition of `when` or `while` begins to hold. Returns the names among
/// these that the plant has already; they stay as they are. O(symbols).
std::vector<std::string> add_malfunctions(model::PlantModel& plant, std::size_t own);

/// Every single fault of a plant with those malfunctions, in a fixed order: of inputs, devices, tracks, controllers,
/// then the first `described` malfunctions of the plant, which it had before. Of symbols on one address the first one
/// counts for all. O(plant).
std::vector<Fault> faults_of(const model::PlantModel& plant, std::size_t described);
/// The malfunctions `from` to `to` - 1 of a plant as faults. O(plant).
std::vector<Fault> described_faults(const model::PlantModel& plant, std::size_t from, std::size_t to);

/// By symbol: a number of the station, line and process, that is in its name; kNone without one. O(symbols).
std::vector<std::uint32_t> stations_of(const model::PlantModel& plant);

}  // namespace symplant::campaign
