// Loops, blocked transfers, and the digest of the material flow.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/material/flow.hpp"

namespace symplant::engine {

/// Resets the step counts. A frozen transfer or work keeps the number of its loop there.
void Flow::forget_steps() noexcept {
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    if (transfers_[t].frozen == 0) transfers_[t].steps = 0;
  }
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) {
    if (work_[w].frozen == 0) work_[w].steps = 0;
  }
}

bool Flow::has_loop() const noexcept {
  const auto acted_often = [](const auto& state) { return state.frozen == 0 && state.steps >= kLoopSteps; };
  return std::any_of(transfers_, transfers_ + material_->transfers.size(), acted_often) ||
         std::any_of(work_, work_ + material_->work.size(), acted_often);
}

void Flow::freeze_loop(std::uint8_t loop) noexcept {
  const auto look = [loop](auto& state) {
    if (state.frozen != 0 || state.steps < kLoopSteps) return;
    state.frozen = kFrozenInThisInstant;
    state.steps = loop;
  };
  std::for_each(transfers_, transfers_ + material_->transfers.size(), look);
  std::for_each(work_, work_ + material_->work.size(), look);
}

void Flow::close_loops() noexcept {
  const auto close = [](auto& state) {
    if (state.frozen != 0) state.frozen = kFrozenBefore;
  };
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) close(tracks_[t]);
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) close(transfers_[t]);
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) close(work_[w]);
}

bool Flow::is_blocked(std::uint32_t transfer) const noexcept {
  const tables::TransferRow& row = material_->transfers[transfer];
  const TransferState& state = transfers_[transfer];
  if (row.condition == tables::kNone || state.frozen != 0 || state.moved != 0 || !truth(row.condition)) return false;
  const Candidate found = candidate(row.from);
  if (found.index == tables::kNone || row.to.location == tables::kOut) return false;
  return !has_room(row.to, arrival(row.to, found.kind), {0, found.kind, row.from.location, found.index, false});
}

void Flow::close_blocked(List<std::uint32_t>& begun) noexcept {
  seen_transfers_.take_all([&](std::uint32_t transfer) {
    const bool blocked = is_blocked(transfer);
    if (blocked && transfers_[transfer].blocked == 0) begun.add(transfer);
    transfers_[transfer].blocked = blocked ? 1 : 0;
  });
}

void Flow::hash_track(tables::Fnv1a64& hash, std::uint32_t track) const noexcept {
  hash.u32(tracks_[track].size);
  for (std::uint32_t i = 0; i < tracks_[track].size; ++i) {
    const Part& p = part(track, i);
    hash.u64(p.number);
    hash.u32(p.kind);
    hash.u64(static_cast<std::uint64_t>(p.x0));
    hash.time(p.t0);
    hash.time(p.v);
  }
  hash.byte(tracks_[track].frozen != 0 ? 1 : 0);
}

void Flow::hash(tables::Fnv1a64& hash) const noexcept {
  if (!active_) return;
  for (std::uint32_t t = 0; t < material_->tracks.size(); ++t) hash_track(hash, t);
  for (std::uint32_t p = 0; p < material_->places.size(); ++p) {
    hash.u32(places_[p].size);
    for (std::uint32_t i = 0; i < places_[p].size; ++i) {
      hash.u64(part_in(p, i).number);
      hash.u32(part_in(p, i).kind);
    }
  }
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    const TransferState& state = transfers_[t];
    hash.byte(static_cast<std::uint8_t>(state.permission | state.moved << 1 | (state.frozen != 0 ? 4 : 0)));
  }
  for (std::uint32_t w = 0; w < material_->work.size(); ++w) {
    hash.byte(static_cast<std::uint8_t>(work_[w].began | (work_[w].frozen != 0 ? 2 : 0)));
  }
  for (std::uint32_t s = 0; s < material_->sources.size(); ++s) {
    hash.time(sources_[s].due);
    hash.u64(sources_[s].made);
    hash.u32(sources_[s].draws);
    hash.byte(0);  // a source is never frozen
  }
  hash.u64(*next_number_ + 1);
}

void Flow::hash_blocked(tables::Fnv1a64& hash) const noexcept {
  for (std::uint32_t t = 0; t < material_->transfers.size(); ++t) {
    if (transfers_[t].blocked == 0) continue;
    hash.byte(3);
    hash.u32(t);
  }
}

}  // namespace symplant::engine
