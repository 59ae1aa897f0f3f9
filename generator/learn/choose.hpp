// Decides which operation drives each event.
#pragma once

#include <cstdint>
#include <vector>

#include "learn/causes.hpp"

namespace symplant::learn {

/// The causes of an event's changes to on, and to off, the most probable first.
struct EventCauses {
  std::uint32_t event;
  std::vector<Cause> on;
  std::vector<Cause> off;
};

/// The operations that may drive an event, after all that the recording shows. One: it does. Several: they change
/// together, so that the recording does not show which.
struct Choice {
  std::vector<Cause> causes;
};

/// For each event. What has no cause that it follows has an empty choice. `used`: operations that names pair.
/// O(events * candidates).
std::vector<Choice> choose(const std::vector<EventCauses>& events, const std::vector<bool>& used,
                           const Timeline& timeline);

}  // namespace symplant::learn
