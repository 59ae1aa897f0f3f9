// What was read last, before a recording starts.
#include "record/kept_part.hpp"

#include <algorithm>

namespace symplant::record {

KeptPart::KeptPart(std::size_t symbols, Time length, std::size_t most)
    : length_(length), most_(most), values_(symbols), known_(symbols) {}

void KeptPart::add(const std::vector<Line>& lines, Time now) {
  if (begin_ < 0) begin_ = lines.empty() ? now : lines.front().time;
  lines_.insert(lines_.end(), lines.begin(), lines.end());
  begin_ = std::max(begin_, now - length_);
  while (!lines_.empty() && lines_.front().time <= begin_) drop_first();
  while (lines_.size() > most_) {
    shortened_ = true;
    begin_ = lines_.front().time;
    while (!lines_.empty() && lines_.front().time <= begin_) drop_first();
  }
}

/// The first line becomes a part of the values at the beginning.
void KeptPart::drop_first() {
  const Line& line = lines_.front();
  if (line.symbol == Line::kGap) {
    gap_end_ = line.time + static_cast<Time>(line.value);
  } else {
    values_[line.symbol] = line.value;
    known_[line.symbol] = true;
  }
  lines_.pop_front();
}

}  // namespace symplant::record
