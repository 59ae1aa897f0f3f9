// Finds the events that came and went between two reads of their discrete input.
#include "symplant/link/image/missed_events.hpp"

#include "symplant/link/image/table_view.hpp"
#include "symplant/tables/missed_pulse.hpp"

namespace symplant::link::image {

MissedEvents::MissedEvents(const IoMap& map, EventReads& reads)
    : reads_(reads),
      symbols_(map.sizes[static_cast<std::size_t>(Table::discrete_input)], tables::kNone),
      begun_(symbols_.size()),
      known_(symbols_.size(), Known::nothing) {
  std::size_t addresses = 0;
  for (const IoPoint& point : map.points) {
    if (point.table != Table::discrete_input || symbols_[point.number] != tables::kNone) continue;
    symbols_[point.number] = point.symbol;
    ++addresses;
  }
  ended_.reserve(2 * addresses);
}

std::optional<LinkFinding> MissedEvents::take() noexcept {
  while (next_ < ended_.size()) {
    const Ended& ended = ended_[next_++];
    if (!is_missed(ended)) continue;
    const tables::Time every = reads_.every(ended.address);
    if (every < 0) continue;
    const tables::MissedPulse pulse{ended.on, ended.length, every};
    return LinkFinding{tables::FindingKind::not_read, symbols_[ended.address], pack(pulse)};
  }
  return std::nullopt;
}

/// Whether no read got this value, and the last one before got the other value.
bool MissedEvents::is_missed(const Ended& ended) noexcept {
  Known& known = known_[ended.address];
  const Known value = ended.on ? Known::on : Known::off;
  if (!ended.in_image) {
    if (reads_.was_read(ended.address, !ended.on)) known = ended.on ? Known::off : Known::on;
  } else if (!reads_.is_noted(requests_) || reads_.was_read(ended.address, ended.on)) {
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

void MissedEvents::changed(std::uint32_t address, bool on) noexcept {
  add({address, !on, true, now_ - begun_[address]});
  begun_[address] = now_;
  reads_.begin_value(address / kBitsPerWord, std::uint64_t{1} << (address % kBitsPerWord), on);
}

void MissedEvents::pulsed(std::uint32_t address, bool on) noexcept { add({address, !on, false, 0}); }

}  // namespace symplant::link::image
