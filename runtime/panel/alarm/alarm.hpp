// An alarm of the plant.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/tables/alarm_priority.hpp"
#include "symplant/tables/finding.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::panel {

/// What an alarm is about.
struct Alarm {
  enum class Source : std::uint8_t {
    alarm,        ///< one of `alarms` of the description
    requirement,  ///< a violated requirement
    finding,      ///< another finding
  };
  std::string name;     ///< unique
  std::string of = {};  ///< the name of its symbol, value, device, requirement, ...
  std::string text = {};
  Source source = Source::finding;
  tables::AlarmPriority priority = tables::AlarmPriority::medium;
  std::uint32_t station = tables::kNone;  ///< as put_stations() counts them; kNone: none
  tables::FindingKind kind = {};          ///< of a finding or a requirement
  std::vector<std::uint32_t> about = {};  ///< as trace::FoundThing::of
};

}  // namespace symplant::panel
