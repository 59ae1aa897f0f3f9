// Sentences about anomalies.
#pragma once

#include <string>

#include "watch/anomaly.hpp"

namespace symplant::watch {

/// A time in seconds, not finer than the resolution of what was read: `1.42 s`.
std::string seconds(Time time, Time resolution);

/// `BB_CL1_I_OPEN (X10, list.csv:14)`, without what it lacks.
std::string symbol_words(const model::PlantModel& plant, std::uint32_t symbol);

/// The unit's path; `readings` for an anomaly of no unit.
std::string name_of(const model::PlantModel& plant, const Anomaly& anomaly);

/// What happened, what is allowed, what to check: without the time.
std::string words(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution);

/// words() with the time: `at 12.35 s: BB_CL1 arrived late in CLOSED: ...`.
std::string sentence(const model::PlantModel& plant, const Anomaly& anomaly, Time resolution);

}  // namespace symplant::watch
