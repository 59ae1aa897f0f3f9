// Finds the events that came and went between two reads of them.
#include "symplant/link/image/missed_events.hpp"

#include "symplant/link/image/words.hpp"
#include "symplant/tables/missed_pulse.hpp"

namespace symplant::link::image {

MissedEvents::MissedEvents(const Map& map, EventReads& reads)
    : reads_(reads),
      symbols_(map.size(Plane::event_bits), tables::kNone),
      begun_(symbols_.size()),
      known_(symbols_.size(), Known::nothing) {
  std::size_t positions = 0;
  for (const Point& point : map.points) {
    if (point.plane != Plane::event_bits || symbols_[point.position] != tables::kNone) continue;
    symbols_[point.position] = point.symbol;
    ++positions;
  }
  ended_.reserve(2 * positions);
}

std::optional<LinkFinding> MissedEvents::take() noexcept {
  while (next_ < ended_.size()) {
    const Ended& ended = ended_[next_++];
    if (!is_missed(ended)) continue;
    const tables::Time every = reads_.every(ended.position);
    if (every < 0) continue;
    const tables::MissedPulse pulse{ended.on, ended.length, every};
    return LinkFinding{tables::FindingKind::not_read, symbols_[ended.position], pack(pulse)};
  }
  return std::nullopt;
}

/// Whether no read got this value, and the last one before got the other value.
bool MissedEvents::is_missed(const Ended& ended) noexcept {
  Known& known = known_[ended.position];
  const Known value = ended.on ? Known::on : Known::off;
  if (!ended.in_image) {
    if (reads_.was_read(ended.position, !ended.on)) known = ended.on ? Known::off : Known::on;
  } else if (!reads_.is_noted(requests_) || reads_.was_read(ended.position, ended.on)) {
    known = value;
  }
  return known != value;
}

void MissedEvents::begin_image(tables::Time now) noexcept {
  ended_.clear();
  next_ = 0;
  now_ = now;
  reads_.set_time(now);
}

void MissedEvents::changed(std::uint32_t position, bool on) noexcept {
  add({position, !on, true, now_ - begun_[position]});
  begun_[position] = now_;
  reads_.begin_value(position / kBitsPerWord, std::uint64_t{1} << (position % kBitsPerWord), on);
}

void MissedEvents::pulsed(std::uint32_t position, bool on) noexcept { add({position, !on, false, 0}); }

}  // namespace symplant::link::image
