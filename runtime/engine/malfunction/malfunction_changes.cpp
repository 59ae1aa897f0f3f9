// Starts and ends malfunctions: from outside, at their times, and by their conditions.
#include <algorithm>
#include <cstring>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/engine/malfunction/malfunctions.hpp"

namespace symplant::engine {
namespace {

/// MalfunctionState::wishes
constexpr std::uint8_t kStarts = 1;
constexpr std::uint8_t kEnds = 2;

constexpr std::uint32_t kLeastOfLoop = 3;  ///< starts and ends within kLoopWindow of each member of a loop

}  // namespace

tables::Time Malfunctions::now() const noexcept { return engine_.head_->now; }

const ActiveMalfunction* Malfunctions::find(std::uint32_t number) const noexcept {
  const ActiveMalfunction* const end = active_ + head_->active;
  const auto* const found =
      std::find_if(active_, active_ + head_->active, [&](const ActiveMalfunction& a) { return a.number == number; });
  return found == end ? nullptr : found;
}

bool Malfunctions::is_active(std::uint32_t number) const noexcept {
  return numbers_.is_written(number) ? states_[number].active != 0 : find(number) != nullptr;
}

tables::Time Malfunctions::next_due(std::uint32_t number) const noexcept {
  if (!numbers_.is_written(number)) return tables::kNever;
  const MalfunctionState& state = states_[number];
  tables::Time due = std::min(state.due, state.becomes);
  for (std::uint32_t e = 0; e < state.begun; ++e) due = std::min(due, effect_state(number, e).due);
  return due;
}

tables::Time Malfunctions::drawn(std::uint32_t number, tables::Time time, std::uint16_t stream,
                                 std::uint32_t& draws) noexcept {
  if (time >= 0) return time;
  const std::uint64_t start = draw_start(engine_.head_->seed, name_hashes_[number], stream, draws++);
  return std::max<tables::Time>(1, random_time(tables_.random_times[static_cast<std::size_t>(-1 - time)], start));
}

/// The time that is `time` of the tables from now; kNever if it is not given.
tables::Time Malfunctions::after(std::uint32_t number, tables::Time time, std::uint16_t stream) noexcept {
  return time == 0 ? tables::kNever : later(now(), drawn(number, time, stream, states_[number].draws[stream]));
}

/// When the symbol of a flicker shows the opposite next.
tables::Time Malfunctions::next_flicker(std::uint32_t number, std::uint32_t effect) noexcept {
  const auto stream = static_cast<std::uint16_t>(kEveryStream + effect);
  const tables::Time every = tables_.malfunctions.effects_of(number)[effect].every;
  return later(now(), drawn(number, every, stream, effect_state(number, effect).draws));
}

bool Malfunctions::start(std::uint32_t number, By by) noexcept {
  if (!numbers_.exists(number)) return false;
  if (is_active(number)) return true;
  if (numbers_.is_written(number) && states_[number].frozen != 0) return true;
  if (!numbers_.is_written(number)) {
    if (head_->ordinary == tables::kMostOrdinaryMalfunctions) return false;
    ++head_->ordinary;
  } else {
    MalfunctionState& state = states_[number];
    state.active = 1;
    state.wishes = 0;
    state.since = now();
    state.due = after(number, row(number).lasts, kLastsStream);
    state.becomes = row(number).after == 0 ? tables::kNever : later(now(), row(number).after);
    seen_.mark(number);
  }
  active_[head_->active++] = {now(), number, by, {}};
  affect(number);
  note(number, true, by);
  return true;
}

bool Malfunctions::stop(std::uint32_t number, By by) noexcept {
  if (!numbers_.exists(number)) return false;
  if (!is_active(number)) return true;
  if (numbers_.is_written(number)) states_[number].waits = row(number).during ? 1 : 0;
  end(number, by);
  return true;
}

void Malfunctions::end(std::uint32_t number, By by) noexcept {
  const ActiveMalfunction* const found = find(number);
  const std::size_t behind = static_cast<std::size_t>(active_ + head_->active - found) - 1;
  std::memmove(active_ + (found - active_), found + 1, behind * sizeof(ActiveMalfunction));
  --head_->active;
  if (numbers_.is_written(number)) {
    MalfunctionState& state = states_[number];
    state.active = state.wishes = 0;
    state.since = 0;
    state.becomes = tables::kNever;
    state.due = after(number, row(number).chance, kChanceStream);
  } else {
    --head_->ordinary;
  }
  release(number);
  note(number, false, by);
}

void Malfunctions::note(std::uint32_t number, bool active, By by) noexcept {
  engine_.head_->waits |= kActed;
  engine_.suspects_ |= kMalfunctionsChanged;
  const bool outside = by == By::hand || by == By::scenario;
  if (numbers_.is_written(number)) count(number);
  if (outside) set_next();
  if (outside && is_loop()) head_->pending = 1;
  if (changes_.size < (outside ? kMostByHand : most_changes_)) changes_.add({number, active, by});
}

/// The millisecond begins with the first start or end after the one before.
void Malfunctions::count(std::uint32_t number) noexcept {
  if (now() - head_->window_begin >= kLoopWindow) {
    head_->window_begin = now();
    head_->counted = 0;
    for (std::uint32_t m = 0; m < written_; ++m) states_[m].counted = 0;
  }
  ++states_[number].counted;
  ++head_->counted;
}

/// Ends those that started or ended again and again. They stay inactive until reset.
void Malfunctions::freeze_loop() noexcept {
  bool any = false;
  for (std::uint32_t m = 0; m < written_; ++m) {
    MalfunctionState& state = states_[m];
    if (state.frozen != 0 || state.counted < kLeastOfLoop) continue;
    if (state.active != 0) end(m, By::end);
    state.frozen = kFrozenInThisInstant;
    state.due = tables::kNever;
    state.wishes = 0;
    any = true;
  }
  if (!any) return;
  if (engine_.loops_ != 0xFF) ++engine_.loops_;
  head_->loop = engine_.loops_;
  engine_.suspects_ |= suspect(tables::FindingKind::instantaneous_loop);
}

void Malfunctions::close_loops() noexcept {
  for (std::uint32_t m = 0; m < written_; ++m) {
    if (states_[m].frozen != 0) states_[m].frozen = kFrozenBefore;
  }
}

void Malfunctions::set_next() noexcept {
  head_->next = tables::kNever;
  for (std::uint32_t m = 0; m < written_; ++m) head_->next = std::min(head_->next, next_due(m));
}

void Malfunctions::begin() noexcept {
  if (head_->next > now() && head_->pending == 0) return;
  head_->pending = 0;
  for (std::uint32_t m = 0; m < written_; ++m) begin_one(m);
  if (is_loop()) freeze_loop();
  set_next();
}

/// What ends an active one comes first; it then does nothing else in this instant.
void Malfunctions::begin_one(std::uint32_t number) noexcept {
  MalfunctionState& state = states_[number];
  const std::uint8_t wishes = state.wishes;
  state.wishes = 0;
  if (state.active != 0) {
    if ((wishes & kEnds) != 0) {
      end(number, By::condition);
    } else if (state.due <= now()) {
      end(number, By::end);
    } else if (state.becomes <= now()) {
      become(number);
    } else {
      flicker(number);
    }
  } else if (state.due <= now()) {
    start(number, By::chance);
  } else if ((wishes & kStarts) != 0) {
    state.by_itself = now();
    start(number, By::condition);
  }
}

void Malfunctions::become(std::uint32_t number) noexcept {
  end(number, By::becomes);
  start(row(number).next, By::becomes);
}

void Malfunctions::flicker(std::uint32_t number) noexcept {
  for (std::uint32_t e = 0; e < states_[number].begun; ++e) {
    EffectState& state = effect_state(number, e);
    if (state.due > now()) continue;
    const tables::EffectRow& effect = tables_.malfunctions.effects_of(number)[e];
    state.shows ^= 1;
    state.due = state.shows != 0 ? later(now(), effect.shows) : next_flicker(number, e);
    override_again(effect.subject);
  }
}

void Malfunctions::close() noexcept {
  seen_.take_all([this](std::uint32_t m) {
    close(m);
    if (states_[m].wishes != 0) head_->pending = 1;
  });
}

/// A malfunction starts by its `when` once at a time, so that those of several cannot start each other for ever.
void Malfunctions::close(std::uint32_t number) noexcept {
  MalfunctionState& state = states_[number];
  const tables::MalfunctionRow& row = this->row(number);
  const bool holds = row.condition != tables::kNone && engine_.truth(row.condition);
  const bool begins = holds && state.held == 0;
  state.held = holds ? 1 : 0;
  if (row.during) {
    if (!holds) state.waits = 0;
    if (state.active != 0 && !holds) state.wishes |= kEnds;
    if (state.active == 0 && holds && state.waits == 0 && state.frozen == 0) state.wishes |= kStarts;
    return;
  }
  const bool may_start = state.active == 0 && state.frozen == 0 && state.by_itself != now();
  if (begins && may_start) state.wishes |= kStarts;
  if (state.active != 0 && row.unless != tables::kNone && engine_.truth(row.unless)) state.wishes |= kEnds;
}

}  // namespace symplant::engine
