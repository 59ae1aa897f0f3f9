// Pieces of files: times and names as people write them, a device's keys as JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "property/dice.hpp"
#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"
#include "support/reference/patterns.hpp"

namespace symplant::property::files {

using reference::fits;
using reference::literals;

/// By key: the values of an entry of `devices`.
using Keys = std::map<std::string, nlohmann::json>;

/// Writes things in one of several forms with the same meaning.
class Sayer {
 public:
  Sayer(const Style& style, std::string_view of, Counts& counts);

  std::string time(tables::Time time);
  /// A time, or `never` for kNever.
  std::string overrun(tables::Time overrun);
  /// A length in um.
  std::string length(std::int64_t length);
  /// A speed in um/s; in m/min perhaps one that is rounded down to it.
  std::string speed(std::int64_t speed);
  /// TRACK, TRACK@POSITION with whole um, PLACE or `out`. A position with braces stays.
  std::string location(const std::string& location);
  std::string sequence(description::Sequence sequence);
  nlohmann::json duration(const description::Duration& duration);
  std::string name(const std::string& name);
  /// All values that differ from the default. `units`: the paths of all devices.
  Keys keys(const description::DeviceDescription& device, const std::vector<std::string>& units);
  nlohmann::json requirement(const description::GivenRequirement& requirement);
  /// In the given form; counts what it uses.
  std::string condition(const std::string& text);

  Dice dice;

 private:
  nlohmann::json transition(const description::GivenTransition& given);
  nlohmann::json switched(const std::vector<std::pair<std::string, bool>>& events);
  nlohmann::json disabled(const std::string& own, const std::vector<std::string>& devices,
                          const std::vector<std::string>& units);

  bool decorated_;
  Counts& counts_;
};

/// A pattern that matches the path.
std::string random_pattern(Dice& dice, const std::string& path);
}  // namespace symplant::property::files
