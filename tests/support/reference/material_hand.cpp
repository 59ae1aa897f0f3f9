// Parts that are put and taken by hand.
#include "support/reference/material.hpp"
#include "support/reference/reference.hpp"

namespace symplant::reference {

// On a copy of the world: nothing changes if it is refused.
bool Plant::put(const tables::PartLocation& to, std::uint32_t kind) {
  World next = world_;
  if (model_.material.is_track(to.location)) put_overshot(*rules_, next, to.location, counters);
  for (const TailWorld& tail : world_.material.tails) {
    if (tail.on == to.location) put_overshot(*rules_, next, tail.to, counters);
  }
  if (!has_room(*rules_, next, {to, false, kind, 0}, next.time)) {
    ++counters[Counted::put_refused];
    return false;
  }
  make_part(*rules_, next, to, kind, true, next.material.by_hand);
  next.instant_pending = true;
  world_ = next;
  ++counters[Counted::put_by_hand];
  return true;
}

bool Plant::take(const tables::PartLocation& from) {
  World next = world_;
  if (model_.material.is_track(from.location)) put_overshot(*rules_, next, from.location, counters);
  const auto part = part_to_take(*rules_, next, from);
  if (!part) {
    ++counters[Counted::take_refused];
    return false;
  }
  const PartWorld it = next.material.at(from.location)[*part];
  const PartTarget out{{tables::kOut, tables::kWhole}, false, it.kind, it.number};
  move_part(*rules_, next, from.location, *part, out, true, next.material.by_hand);
  next.instant_pending = true;
  world_ = next;
  ++counters[Counted::taken_by_hand];
  return true;
}

}  // namespace symplant::reference
