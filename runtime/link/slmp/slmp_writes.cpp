// What an SLMP link writes, and what happens if the PLC refuses it.
#include <algorithm>
#include <array>

#include "symplant/link/slmp/refusal.hpp"
#include "symplant/link/slmp/slmp_dialog.hpp"

namespace symplant::link::slmp {

using client::Answer;
using client::Fault;
using client::LaneChange;

/// `whole`: 16 bit devices that are all mapped are written as a word, otherwise bit by bit.
SlmpDialog::Writes SlmpDialog::writes_of(std::span<const LaneChange> changes, bool whole) const {
  Writes writes;
  std::vector<std::pair<Cell, std::uint16_t>> words;
  for (const LaneChange& change : changes) {
    const bool bits = change.lane.plane == Plane::event_bits;
    const Cell& cell = cell_of(change.lane);
    const bool all_bits = bits && owned_[change.lane.number] == kWholeCell;
    const bool word = !bits || !info_of(cell.kind).bit || (whole && all_bits);
    writes.splits_words = writes.splits_words || (all_bits && !word);
    if (word) words.emplace_back(cell, change.value);
    for (std::uint32_t bit = 0; !word && bit < kBitsInCell; ++bit) {
      if ((change.mask >> bit & 1) == 0) continue;
      writes.bits.push_back({cell.kind, kBitsInCell * cell.word + bit});
      writes.bit_values.push_back(static_cast<std::uint8_t>(change.value >> bit & 1));
    }
  }
  std::sort(words.begin(), words.end());
  for (const auto& [cell, value] : words) {
    writes.cells.push_back(cell);
    writes.values.push_back(value);
  }
  writes.words_transfers = plan_writes(writes.cells, limits_);
  writes.bit_transfers = plan_bit_writes(writes.bits, limits_);
  return writes;
}

/// For all events.
std::size_t SlmpDialog::requests_to_write() const {
  std::vector<LaneChange> all;
  for (std::uint32_t i = 0; i < owned_.size(); ++i) all.push_back({{Plane::event_bits, i}, owned_[i], 0});
  for (const NumberCell& number : map_.events.numbers)
    all.push_back({{Plane::event_numbers, number.lane}, kWholeCell, 0});
  const auto count = [&](bool whole) {
    const Writes writes = writes_of(all, whole);
    return writes.words_transfers.size() + writes.bit_transfers.size();
  };
  return std::min(count(false), count(true));
}

Fault SlmpDialog::write(std::span<const LaneChange> changes, std::vector<client::Unwritten>& unwritten) {
  const auto size = [](const Writes& writes) { return writes.words_transfers.size() + writes.bit_transfers.size(); };
  Writes writes = writes_of(changes, false);
  if (size(writes) > 1 && writes.splits_words) {
    if (Writes other = writes_of(changes, true); size(other) < size(writes)) writes = std::move(other);
  }
  const Writing writing{writes, changes, unwritten};
  for (const Transfer& transfer : writes.words_transfers) {
    if (Fault fault = write_words(transfer, writing)) return fault;
  }
  for (const Transfer& transfer : writes.bit_transfers) {
    if (Fault fault = write_bits(transfer, writing)) return fault;
  }
  return {};
}

Fault SlmpDialog::write_words(const Transfer& transfer, const Writing& writing) {
  constexpr std::array kCommands = {Command::write, Command::write_random, Command::write_blocks};
  RequestWriter& request = exchange_.begin(kCommands[static_cast<std::size_t>(transfer.access)], false);
  put_counts(request, transfer);
  for (const Span& span : transfer.spans) {
    put_span(request, transfer, span);
    const auto values = std::span(writing.writes.values).subspan(span.item, span.count);
    if (transfer.access == Access::random && span.count == 2) {
      request.put_32(std::uint32_t{values[1]} << 16 | values[0]);
    } else {
      for (const std::uint16_t value : values) request.put_16(value);
    }
  }
  return confirm(transfer, false, writing);
}

Fault SlmpDialog::write_bits(const Transfer& transfer, const Writing& writing) {
  const bool batch = transfer.access == Access::batch;
  RequestWriter& request = exchange_.begin(batch ? Command::write : Command::write_random, true);
  if (batch) {
    const Span& span = transfer.spans.front();
    request.put_device(span.kind, span.first);
    request.put_16(static_cast<std::uint16_t>(span.count));
    request.put_bits(std::span(writing.writes.bit_values).subspan(span.item, span.count));
  } else {
    request.put_8(static_cast<std::uint8_t>(transfer.spans.size()));
    for (const Span& span : transfer.spans) {
      request.put_device(span.kind, span.first);
      request.put_listed_bit(writing.writes.bit_values[span.item] != 0);
    }
  }
  return confirm(transfer, true, writing);
}

/// Sends the request that was built. With 3E a late answer to a reading could come instead of the confirmation.
Fault SlmpDialog::confirm(const Transfer& transfer, bool of_bits, const Writing& writing) {
  Reply reply;
  if (Fault fault = transact(reply)) return fault;
  if (reply.end_code == 0) {
    if (reply.data.empty()) return {};
    return {Fault::Kind::transport, "the PLC answers a request to write with values; connecting again"};
  }
  rejected_.fetch_add(1, std::memory_order_relaxed);
  if (adapt_to(transfer.access, of_bits, reply.end_code)) {
    refuse(transfer, of_bits, {{}, Answer::busy, {}}, writing);
  } else {
    const tables::Refusal refusal = note_rejection(true, transfer, of_bits, reply.end_code);
    refuse(transfer, of_bits, {{}, answer_of(reply.end_code), refusal}, writing);
  }
  return {};
}

/// Notes the changes in a transfer, which the PLC did not take.
void SlmpDialog::refuse(const Transfer& transfer, bool of_bits, const client::Unwritten& why, const Writing& writing) {
  const auto holds = [&](const Cell& cell, std::uint32_t bit) {
    const std::uint32_t number = of_bits ? kBitsInCell * cell.word + bit : cell.word;
    return std::any_of(transfer.spans.begin(), transfer.spans.end(),
                       [&](const Span& span) { return span.kind == cell.kind && number - span.first < span.count; });
  };
  for (const LaneChange& change : writing.changes) {
    const bool bits = change.lane.plane == Plane::event_bits;
    const Cell& cell = cell_of(change.lane);
    if (of_bits && !(bits && info_of(cell.kind).bit)) continue;
    client::Unwritten part = why;
    part.change = change;
    for (std::uint32_t bit = 0; bit < kBitsInCell; ++bit) {
      if (!holds(cell, bit)) part.change.mask = static_cast<std::uint16_t>(part.change.mask & ~(1U << bit));
    }
    if (part.change.mask != 0) writing.unwritten.push_back(part);
  }
}

}  // namespace symplant::link::slmp
