// Decides what a recording has, and writes it.
#include "record/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "symplant/tables/duration.hpp"

namespace symplant::record {
namespace {

constexpr Time kGapIntervals = 3;
/// An image that was requested before the end may still come.
constexpr Time kLastImage = tables::kSecond;

}  // namespace

Writer::Writer(trace::OutputFile file, const trace::PlantNames& names, What what)
    : names_(names),
      what_(std::move(what)),
      file_(std::move(file)),
      history_(names),
      kept_(names.tables().symbols.size(), what_.before),
      values_(names.tables().symbols.size()),
      known_(names.tables().symbols.size()) {}

void Writer::take(const Batch& batch) {
  if (has_ended()) return;
  const std::optional<Line> gap = gap_before(batch);
  state_.has_images = true;
  state_.is_lost = false;
  if (trace_ && batch.first > end_) {
    if (gap) write({gap->time, static_cast<std::uint64_t>(end_ - gap->time), Line::kGap}, false);
    return end(end_);
  }
  for (const Line& line : batch.lines) {
    if (line.time > end_) break;
    values_[line.symbol] = line.value;
    if (!known_[line.symbol]) ++state_.symbols;
    known_[line.symbol] = true;
  }
  if (!trace_) {
    wait_for_start(batch, gap);
  } else {
    if (gap) write(*gap, false);
    for (const Line& line : batch.lines) {
      if (line.time <= end_) write(line, false);
    }
    trace_->part(std::max(latest_ - zero_, last_line_), history_);
    if (what_.stop && what_.stop->holds(values_)) end(latest_);
  }
  if (!trace_ || ended_) return;
  state_.length = std::min(latest_, end_) - zero_;
  if (latest_ >= end_) end(end_);
}

/// The time without a reading before this image, if it is a gap.
std::optional<Line> Writer::gap_before(const Batch& batch) {
  const Time before = std::exchange(latest_, batch.last);
  const Time begun = std::exchange(begun_, batch.first);
  if (before < 0) return std::nullopt;
  if (!batch.reconnected) {
    const Time distance = batch.first - begun;
    least_ = least_ < 0 ? distance : std::min(least_, distance);
    if (distance <= kGapIntervals * std::max(what_.every, least_)) return std::nullopt;
  }
  return Line{before, static_cast<std::uint64_t>(batch.first - before), Line::kGap};
}

void Writer::wait_for_start(const Batch& batch, const std::optional<Line>& gap) {
  if (!what_.start) {
    start(batch.first, batch.first);
    for (const Line& line : batch.lines) write(line, true);
    return;
  }
  if (gap) kept_.add({*gap}, batch.last);
  kept_.add(batch.lines, batch.last);
  if (!what_.start->holds(values_)) return;
  start(kept_.begin(), batch.last);
  write_kept();
}

/// `begin`: t = 0; `now`: when the recording starts, for its length.
void Writer::start(Time begin, Time now) {
  zero_ = begin;
  state_.has_started = true;
  state_.kept = now - begin;
  if (what_.until) end_ = now + *what_.until;
  trace_.emplace(std::move(*file_), names_.tables(), what_.model_hash,
                 trace::RecordedFrom{what_.link, what_.every, what_.utc(begin)});
}

void Writer::write_kept() {
  for (std::uint32_t symbol = 0; symbol < known_.size(); ++symbol) {
    if (kept_.is_known(symbol)) write({zero_, kept_.value(symbol), symbol}, true);
  }
  if (kept_.gap_end() > zero_) {
    write({zero_, static_cast<std::uint64_t>(kept_.gap_end() - zero_), Line::kGap}, false);
  }
  for (const Line& line : kept_.lines()) write(line, false);
  if (kept_.is_shortened()) {
    message_ = fmt::format("warning: only the last {} before the start were kept, since more than {} symbols changed",
                           tables::duration_text(state_.kept), KeptPart::kMost);
  }
  kept_ = KeptPart(0, 0);
}

void Writer::write(const Line& line, bool is_first) {
  last_line_ = std::max(last_line_, line.time - zero_);
  if (line.symbol == Line::kGap) {
    ++state_.gaps;
    state_.gap_time += static_cast<Time>(line.value);
    return trace_->gap(line.time - zero_, static_cast<Time>(line.value));
  }
  if (!is_first) ++state_.changes;
  const trace::Record record{line.time - zero_, line.value, line.symbol};
  history_.apply(record);
  trace_->write(record);
}

void Writer::look(Time now) {
  if (trace_ && what_.until && !has_ended() && now > end_ + std::max(kLastImage, kGapIntervals * what_.every))
    finish(end_);
}

void Writer::finish(Time now) {
  if (trace_ && !ended_) {
    const bool is_gap = state_.is_lost || now - latest_ > kGapIntervals * std::max(what_.every, least_);
    end(std::min(is_gap ? now : latest_, end_));
  }
  flush();
}

/// The last lines.
void Writer::end(Time time) {
  ended_ = true;
  const Time reached = std::min(latest_, time);
  if (state_.is_lost || time - reached > kGapIntervals * std::max(what_.every, least_)) {
    write({reached, static_cast<std::uint64_t>(time - reached), Line::kGap}, false);
  }
  state_.length = time - zero_;
  trace_->end(std::max(state_.length, last_line_));
}

void Writer::flush() {
  if (trace_) trace_->flush();
}

}  // namespace symplant::record
