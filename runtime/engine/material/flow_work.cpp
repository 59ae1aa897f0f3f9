// Parts that change their kind, and parts that are made.
#include <algorithm>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

void Flow::work_on(std::uint32_t location, std::uint32_t index, const tables::WorkRow& row) noexcept {
  std::uint64_t number = 0;
  if (material_->is_track(location)) {
    Part& p = part(location, index);
    cover(location, p);  // it may have passed marks that do not matter for its kind
    p.kind = row.to;
    p.stale = 1;
    number = p.number;
    cover_changed(location, p.tail, p.front);
  } else {
    const std::uint32_t place = material_->place_of(location);
    PlacePart& p = place_part(place, index);
    p.kind = row.to;
    number = p.number;
  }
  count_part(location, row.from, -1);
  count_part(location, row.to, 1);
  note({number, row.to, tables::kNone, tables::kNone, 0, PartChange::What::changed, false});
  engine_.active_ = true;
}

/// True if a part changed.
bool Flow::try_work(std::uint32_t work) noexcept {
  const tables::WorkRow& row = material_->work[work];
  WorkState& state = work_[work];
  if (state.frozen != 0) return false;
  const bool on = holds(row.condition);
  const bool begins = on && state.began == 0;
  state.began = on ? 1 : 0;
  if (!begins) return false;
  bool any = false;
  const std::uint32_t location = row.at.location;
  for (std::uint32_t i = 0; i < parts(location); ++i) {
    if (material_->is_track(location)) {
      const Part& p = part(location, i);
      const Position x = p.at(now());
      const Position at = row.at.at * kMicrometer;
      const bool here = row.at.at == tables::kWhole || (x - length(p.kind) <= at && at <= x);
      if (!here || p.kind != row.from) continue;
    } else if (part_in(material_->place_of(location), i).kind != row.from) {
      continue;
    }
    work_on(location, i, row);
    any = true;
  }
  if (any) content_changed(location);
  return any;
}

std::uint32_t Flow::next_kind(std::uint32_t source) const noexcept {
  const tables::Rows kinds = material_->sources[source].kinds;
  return material_->source_kinds[kinds.first + static_cast<std::uint32_t>(sources_[source].made % kinds.count)];
}

void Flow::try_source(std::uint32_t source) noexcept {
  const tables::SourceRow& row = material_->sources[source];
  SourceState& state = sources_[source];
  state.waiting = 0;
  if (state.due > now() || !holds(row.condition)) return;
  const std::uint32_t kind = next_kind(source);
  const Moving moving{*next_number_ + 1, kind, tables::kNone, 0, false};
  const Position x = arrival(row.to, kind);
  if (!has_room(row.to, x, moving)) {
    state.waiting = 1;
    if (material_->is_track(row.to.location)) due_rooms_.mark(row.to.location);
    return;
  }
  ++*next_number_;
  move(moving, row.to, x);
  ++state.made;
  set_next_due(source);
}

void Flow::set_next_due(std::uint32_t source) noexcept {
  const tables::SourceRow& row = material_->sources[source];
  SourceState& state = sources_[source];
  if (state.made >= row.count || (row.every == 0 && row.count == tables::kAnyNumber)) {
    state.due = tables::kNever;
  } else if (row.every != 0) {
    tables::Time every = row.every;
    if (every < 0) {
      const std::uint64_t start = draw_start(engine_.head_->seed, source_names_[source], 0, state.draws++);
      every = random_time(engine_.tables_.random_times[static_cast<std::size_t>(-1 - every)], start);
    }
    state.due = later(now(), std::max<tables::Time>(1, every));
    set_wheel(first_entry_ + static_cast<std::uint32_t>(material_->tracks.size()) + source, state.due);
  } else {
    due_sources_.mark(source);
  }
}

}  // namespace symplant::engine
