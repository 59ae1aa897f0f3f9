// What a server finds in the requests of its clients.
#pragma once

#include <optional>

#include "symplant/link/image/event_reads.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/image/missed_events.hpp"
#include "symplant/link/image/server_findings.hpp"

namespace symplant::link::image {

/// Next to the images of a server; each part says which thread uses it.
struct RequestWatch {
  explicit RequestWatch(const Map& map)
      : reads(map.size(Plane::event_bits)),
        missed(map, reads),
        // Room for every bit of the operations to be missed in one cycle, and for all else.
        found(map.size(Plane::operation_bits) + map.points.size() + 64) {}

  /// The next finding; nothing if there is no new one. For the cycle's thread, after it has taken the operations.
  std::optional<LinkFinding> take() noexcept {
    std::optional<LinkFinding> finding = missed.take();
    return finding ? finding : found.take();
  }

  EventReads reads;
  MissedEvents missed;
  ServerFindings found;
};

}  // namespace symplant::link::image
