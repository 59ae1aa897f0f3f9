// Lays out and resets the memory of the material flow.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

std::uint32_t size_of(auto rows) noexcept { return static_cast<std::uint32_t>(rows.size()); }

}  // namespace

void Flow::build(Arena& arena) noexcept {
  material_ = &engine_.tables_.material;
  active_ = !material_->empty();
  index_.build(engine_.tables_, arena);
  auto* const names = arena.take<std::uint64_t>(material_->sources.size());
  source_names_ = names;
  if (names == nullptr) return;
  std::string_view rest = material_->source_names;
  for (std::size_t s = 0; s < material_->sources.size() && !rest.empty(); ++s) {
    const std::size_t end = std::min(rest.find('\0'), rest.size() - 1);
    names[s] = upper_case_hash(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
}

void Flow::place(Arena& arena) noexcept {
  due_ends_.take(arena, material_->tracks.size());
  due_transfers_.take(arena, material_->transfers.size());
  due_work_.take(arena, material_->work.size());
  due_sources_.take(arena, material_->sources.size());
  due_speeds_.take(arena, material_->tracks.size());
  moved_tracks_.take(arena, material_->tracks.size());
  due_rooms_.take(arena, material_->tracks.size());
  due_sensors_.take(arena, material_->sensors.size());
  due_counters_.take(arena, material_->counters.size());
  seen_transfers_.take(arena, material_->transfers.size());
  speeds_ = arena.take<Position>(active_ ? tables::kMaxPartsOnTrack : 0);
  most_changes_ = active_ ? kMostByHand + 4 * (size_of(material_->tracks) + size_of(material_->transfers)) +
                                index_.parts_on_tracks + index_.parts_in_places
                          : 0;
  changes_.take(arena, most_changes_);
  due_ = false;
}

void Flow::place_block(Arena& arena, std::uint32_t first_entry) noexcept {
  first_entry_ = first_entry;
  tracks_ = arena.take<TrackState>(material_->tracks.size());
  parts_ = arena.take<Part>(index_.parts_on_tracks);
  places_ = arena.take<PlaceState>(material_->places.size());
  place_parts_ = arena.take<PlacePart>(index_.parts_in_places);
  sources_ = arena.take<SourceState>(material_->sources.size());
  kinds_ = arena.take<KindState>(material_->kinds.size());
  counts_ = arena.take<std::uint64_t>(material_->counters.size());
  next_number_ = arena.take<std::uint64_t>(active_ ? 1 : 0);
  transfers_ = arena.take<TransferState>(material_->transfers.size());
  work_ = arena.take<WorkState>(material_->work.size());
  arena.take<std::uint64_t>(active_ ? 1 : 0);  // what follows is aligned
}

std::uint32_t Flow::wheel_entries() const noexcept { return size_of(material_->tracks) + size_of(material_->sources); }

/// The block is zero.
void Flow::reset() noexcept {
  if (!active_) return;
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) {
    tracks_[t].room_due = tables::kNever;
    tracks_[t].window_begin = -tables::kSecond;  // the first instant begins one
  }
  for (std::uint32_t s = 0; s < material_->sources.size(); ++s) {
    const tables::SourceRow& row = material_->sources[s];
    sources_[s].due = row.count == 0 ? tables::kNever : row.first;
    if (sources_[s].due > 0) set_wheel(first_entry_ + size_of(material_->tracks) + s, sources_[s].due);
  }
  forget_changes();
}

void Flow::mark_all() noexcept {
  if (!active_) return;
  due_ends_.mark_all();
  due_transfers_.mark_all();
  due_work_.mark_all();
  due_sources_.mark_all();
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) all_speeds(t);
  for (std::uint32_t s = 0; s < material_->sensors.size(); ++s) due_sensors_.mark(s);
  for (std::uint32_t c = 0; c < material_->counters.size(); ++c) due_counters_.mark(c);
  due_ = true;
}

}  // namespace symplant::engine
