// Names that differ by a slip from those that are meant.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/spelling/device_classes.hpp"

namespace symplant::check {

/// A word at one level of some symbols' names that was most likely meant to be another.
struct Slip {
  enum class Why : std::uint8_t {
    complements,  ///< the device that is meant has just the other sides of these symbols
    lacks,        ///< the device that is meant lacks exactly these symbols
    common,       ///< the word that is meant is far more common, and it has no such symbol yet
  };
  name::Level level{};
  Why why{};
  std::string_view written;            ///< as the first of the symbols has it
  std::string meant;                   ///< instead
  std::string meant_path;              ///< the device that is meant
  std::uint32_t meant_device = 0;      ///< a device of DeviceClasses, or model::kNone if there is none yet
  std::uint64_t others = 0;            ///< how many devices (of a task: symbols) have the word that is meant
  std::vector<std::uint32_t> symbols;  ///< all that have the slip, ascending
};

/// All slips in lines, processes, devices and tasks, by their first symbols. Two words are held against each other only
/// where they differ by one slip (near_words.hpp), so this costs O(symbols), and for the words O(their letters).
std::vector<Slip> find_slips(const model::PlantModel& plant, const DeviceClasses& classes);

}  // namespace symplant::check
