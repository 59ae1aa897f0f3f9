// Decides what a recording has, and writes it.
#include "record/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "recording/is_gap.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::record {
namespace {

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
      known_(names.tables().symbols.size()),
      interval_(what_.every) {
  state_.resolution = what_.every;
}

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
    note_interval();
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
  if (!batch.after_loss) {
    interval_.add(batch.first - begun);
    if (!is_gap(batch.first - begun)) return std::nullopt;
  }
  return Line{before, static_cast<std::uint64_t>(batch.first - before), Line::kGap};
}

bool Writer::is_gap(Time distance) const { return recording::is_gap(distance, interval_.now()); }

/// A reader of the file must not take its times for more exact than they are, also if there is no last line.
void Writer::note_interval() {
  if (interval_.count() < note_at_) return;
  note_at_ = 2 * interval_.count();
  const Time resolution = interval_.reached();
  if (resolution <= state_.resolution) return;
  state_.resolution = resolution;
  last_line_ = std::max(last_line_, std::min(latest_, end_) - zero_);
  trace_->interval(last_line_, resolution);
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
  file_->replace();
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
  if (trace_ && what_.until && !has_ended() && now > end_ + kLastImage && is_gap(now - end_)) finish(end_);
}

void Writer::finish(Time now) {
  if (trace_ && !ended_) {
    end(std::min(state_.is_lost || is_gap(now - latest_) ? now : latest_, end_));
  }
  flush();
}

/// The last lines.
void Writer::end(Time time) {
  ended_ = true;
  const Time reached = std::min(latest_, time);
  if (state_.is_lost || is_gap(time - reached)) {
    write({reached, static_cast<std::uint64_t>(time - reached), Line::kGap}, false);
  }
  state_.length = time - zero_;
  state_.resolution = interval_.reached();
  trace_->end(std::max(state_.length, last_line_), state_.resolution > what_.every ? state_.resolution : 0);
}

void Writer::flush() {
  if (trace_) trace_->flush();
}

}  // namespace symplant::record
