// What names in braces mean in the entry of a pattern.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "text/braces.hpp"
#include "text/pattern.hpp"

namespace symplant::model {

/// A device, or a symbol, that a pattern matches. Views point into the plant.
class MatchedNames {
 public:
  /// A unit that the pattern matches by the path of its device, or else by its own. O(paths * pattern).
  static MatchedNames of(const PlantModel& plant, const Unit& unit, std::string_view pattern);
  static MatchedNames of(const Symbol& symbol, std::string_view pattern);

  /// Replaces {line}, {process}, {device}, {self} and {1}, {2}, ... A level that the naming rule does not know is
  /// unknown.
  text::Replaced replace(std::string_view text) const;
  /// What can be in braces, for a message.
  std::string choices() const;

 private:
  std::string_view line_;
  std::string_view process_;
  std::string_view device_;
  std::string_view self_;
  std::vector<std::string_view> shares_;  ///< of the wildcards
};

/// Calls `function(unit)` for one unit of each device that a pattern matches; false if there is no such device.
/// O(units * pattern).
template <class Function>
bool for_each_device(const PlantModel& plant, std::string_view pattern, Function function) {
  std::unordered_set<std::string_view> devices;
  for (const Unit& unit : plant.units) {
    if (text::matches_pattern(unit.device_path(), pattern) && devices.insert(unit.device_path()).second) function(unit);
  }
  return !devices.empty();
}

/// Names that entries of patterns make and that the plant may lack. An entry is left out, with a warning, for the
/// devices that lack it; if all that the pattern matches lack it, that is an error.
class MadeNames {
 public:
  /// Devices, or symbols, take the entry at `at`.
  void takes(const description::Pointer& at, std::size_t count = 1) { entries_[at.text()].takers += count; }
  /// A device, or symbol, lacks what the entry at `at` names: `message` says what is missing. `text` is what the entry
  /// of a device has at `at`.
  void lacks(const description::Pointer& at, std::string_view path, std::string message, std::string_view text = {});
  /// Whether the plant has what `text` names for any device that the pattern of `at` matches.
  using SomeHave = std::function<bool(const description::Pointer& at, const std::string& text)>;
  void report(description::Faults& faults, const SomeHave& some_have) const;

 private:
  struct Entry {
    std::size_t takers = 0;
    std::size_t lacking = 0;
    std::vector<std::string> paths;  ///< of the first few devices that lack it
    std::string message;             ///< for the first of them
    std::string text;
    std::optional<description::Pointer> pattern;  ///< of the entry, if it is one of a device
  };
  std::map<std::string, Entry> entries_;  ///< by location
};

}  // namespace symplant::model
