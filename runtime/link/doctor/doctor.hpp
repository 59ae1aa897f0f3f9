// Examines a link against a live PLC, without a plant.
#pragma once

#include <atomic>
#include <variant>

#include "symplant/link/doctor/report.hpp"
#include "symplant/link/link.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::doctor {

struct Options {
  tables::Time duration = 5 * tables::kSecond;  ///< how long values are watched, or a server listens
  bool write_test = false;                      ///< write each event, compare, and restore it
  const std::atomic<bool>* stop = nullptr;      ///< ends it early, with what was found so far; may be null
};

/// A client link connects, identifies the PLC, reads all mapped points and watches them; it writes only for the write
/// test. A server link listens and notes what the PLC touches. Blocks for the duration and the timeouts of the link.
/// Errors are those of opening the link.
std::variant<Report, LinkError> examine(const LinkChoice& link, const tables::PlantTables& tables,
                                        const Options& options);

}  // namespace symplant::link::doctor
