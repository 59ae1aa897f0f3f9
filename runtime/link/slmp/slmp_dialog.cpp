// The conversation with a MELSEC PLC.
#include "symplant/link/slmp/slmp_dialog.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/table_view.hpp"
#include "symplant/link/slmp/cpu_model.hpp"

namespace symplant::link::slmp {

using client::Fault;
using client::Identity;
using client::LaneChange;

namespace {

constexpr std::uint32_t kBitsInCell = 16;
constexpr std::uint16_t kWholeCell = 0xFFFF;
constexpr std::uint16_t kUnsupported = 0xC059;  ///< end code: the command or its subcommand

/// The number of the first device of a word.
std::uint32_t head_of(const Span& span) { return info_of(span.kind).bit ? kBitsInCell * span.first : span.first; }

std::vector<std::uint16_t> owned_bits(const DeviceMap& map) {
  std::vector<std::uint16_t> owned(map.events.bits.size());
  for (const IoPoint& point : map.io.points) {
    if (point.table != Table::discrete_input) continue;
    std::uint16_t& mask = owned[point.number / kBitsInCell];
    mask = static_cast<std::uint16_t>(mask | 1U << (point.number % kBitsInCell));
  }
  return owned;
}

}  // namespace

SlmpDialog::SlmpDialog(const Settings& settings, DeviceMap map)
    : settings_(settings),
      map_(std::move(map)),
      limits_(limits_of(settings.framing)),
      operations_(plan_of(map_.operations)),
      events_(plan_of(map_.events)),
      owned_(owned_bits(map_)),
      exchange_(settings.address, settings.transport, settings.framing, settings.timeout),
      words_(std::max(limits_.words, limits_.block_points)) {}

std::string SlmpDialog::url() const { return "slmp://" + net::format_host_port(settings_.address); }

Fault SlmpDialog::open() {
  skipped_.clear();
  return exchange_.open();
}

/// Not those that cannot succeed before the map or the PLC's parameters change: then there is a new connection.
void SlmpDialog::retry_rejected() noexcept {
  std::erase_if(skipped_, [](const auto& entry) { return entry.second != Remedy::configure; });
}

SlmpDialog::ReadPlan SlmpDialog::plan_of(const Cells& cells) const {
  ReadPlan plan;
  std::set_union(cells.bits.begin(), cells.bits.end(), cells.numbers.begin(), cells.numbers.end(),
                 std::back_inserter(plan.cells));
  plan.targets.resize(plan.cells.size());
  const auto position = [&](const Cell& cell) {
    return std::lower_bound(plan.cells.begin(), plan.cells.end(), cell) - plan.cells.begin();
  };
  for (std::uint32_t i = 0; i < cells.bits.size(); ++i) {
    plan.targets[static_cast<std::size_t>(position(cells.bits[i]))].bits = i;
  }
  for (std::uint32_t i = 0; i < cells.numbers.size(); ++i) {
    plan.targets[static_cast<std::size_t>(position(cells.numbers[i]))].numbers = i;
  }
  plan.transfers = plan_reads(plan.cells, limits_);
  return plan;
}

Fault SlmpDialog::transact(Reply& reply) {
  Fault fault = exchange_.transact(reply);
  if (!fault) requests_.fetch_add(1, std::memory_order_relaxed);
  return fault;
}

void SlmpDialog::note_rejection(const char* doing, const Transfer& transfer, bool of_bits, std::uint16_t end_code) {
  rejected_.fetch_add(1, std::memory_order_relaxed);
  adapt_to(transfer.access, of_bits, end_code);
  const Span& first = transfer.spans.front();
  const Span& last = transfer.spans.back();
  const auto text = [&](Kind kind, std::uint32_t number) {
    return device_text({kind, number}, settings_.framing.family);
  };
  const bool words_of_bits = !of_bits && info_of(last.kind).bit;
  const std::uint32_t size = words_of_bits ? kBitsInCell : 1;
  const std::string from = text(first.kind, size == 1 ? first.first : head_of(first));
  const std::string to = text(last.kind, size * (last.first + last.count) - 1);
  const std::string rest = transfer.spans.size() == 1
                               ? (from == to ? "" : " to " + to)
                               : " to " + to + " (" + std::to_string(transfer.spans.size()) + " areas in one request)";
  rejections_.push_back(std::string("the PLC rejects ") + doing + " " + from + rest + ": " + end_code_text(end_code));
}

Identity SlmpDialog::identify(Fault& fault) {
  exchange_.begin(Command::read_model, false);
  Reply reply;
  fault = transact(reply);
  if (fault) return {};
  Identity identity = identity_of(reply, settings_.framing);
  std::vector<std::uint64_t> bits(image::register_words(static_cast<std::uint32_t>(map_.events.bits.size())));
  std::vector<std::uint64_t> numbers(image::register_words(static_cast<std::uint32_t>(map_.events.numbers.size())));
  fault = read_back(bits, numbers);  // whether the PLC has what is to be written
  if (fault.kind == Fault::Kind::rejected) fault = {};
  return identity;
}

/// The numbers of spans of each kind, before the spans of random and block access.
void SlmpDialog::put_counts(RequestWriter& request, const Transfer& transfer) {
  if (transfer.access == Access::batch) return;
  const auto words = std::count_if(transfer.spans.begin(), transfer.spans.end(), [&](const Span& span) {
    return transfer.access == Access::random ? span.count == 1 : !info_of(span.kind).bit;
  });
  request.put_8(static_cast<std::uint8_t>(words));
  request.put_8(static_cast<std::uint8_t>(transfer.spans.size() - static_cast<std::size_t>(words)));
}

void SlmpDialog::put_span(RequestWriter& request, const Transfer& transfer, const Span& span) {
  request.put_device(span.kind, head_of(span));
  if (transfer.access != Access::random) request.put_16(static_cast<std::uint16_t>(span.count));
}

/// Takes the words of a reply to a reading request; false if it does not hold what was requested.
bool SlmpDialog::take_words(const Transfer& transfer, const Reply& reply) {
  std::size_t size = 0;
  for (const Span& span : transfer.spans) size += span.count;
  DataReader data(reply.data, settings_.framing.code);
  if (!data.holds(size)) return false;
  const std::span words = std::span(words_).first(size);
  if (transfer.access != Access::random) return data.words(words);
  std::size_t at = 0;
  bool valid = true;
  for (const Span& span : transfer.spans) {
    if (span.count == 1) {
      valid = data.words(words.subspan(at, 1)) && valid;
    } else {
      valid = data.low_high(std::span<std::uint16_t, 2>(words.subspan(at, 2))) && valid;
    }
    at += span.count;
  }
  return valid;
}

void SlmpDialog::scatter(const Transfer& transfer, const ReadPlan& plan, const Words& out) const {
  std::size_t base = 0;
  for (const Span& span : transfer.spans) {
    for (std::size_t i = span.item; i < plan.cells.size(); ++i) {
      const Cell& cell = plan.cells[i];
      if (cell.kind != span.kind || cell.word - span.first >= span.count) break;
      const std::uint16_t value = words_[base + cell.word - span.first];
      const Target& target = plan.targets[i];
      if (target.bits != kNowhere) image::set_register(out.bits, target.bits, value);
      if (target.numbers != kNowhere) image::set_register(out.numbers, target.numbers, value);
    }
    base += span.count;
  }
}

Fault SlmpDialog::read_one(const Transfer& transfer, const ReadPlan& plan, const Words& out) {
  constexpr std::array kCommands = {Command::read, Command::read_random, Command::read_blocks};
  RequestWriter& request = exchange_.begin(kCommands[static_cast<std::size_t>(transfer.access)], false);
  put_counts(request, transfer);
  for (const Span& span : transfer.spans) put_span(request, transfer, span);
  Reply reply;
  if (Fault fault = transact(reply)) return fault;
  if (reply.end_code != 0) {
    note_rejection("reading", transfer, false, reply.end_code);
    skipped_[&transfer] = end_code_of(reply.end_code).remedy;
    return {Fault::Kind::rejected};
  }
  if (!take_words(transfer, reply)) {
    return {Fault::Kind::transport, "the PLC's answer has another number of words than requested; connecting again"};
  }
  scatter(transfer, plan, out);
  return {};
}

Fault SlmpDialog::read_all(const ReadPlan& plan, const Words& out) {
  bool any = plan.transfers.empty();
  for (const Transfer& transfer : plan.transfers) {
    if (skipped_.contains(&transfer)) continue;
    Fault fault = read_one(transfer, plan, out);
    if (fault.kind == Fault::Kind::rejected) continue;
    if (fault) return fault;
    any = true;
  }
  return {any ? Fault::Kind::none : Fault::Kind::rejected};
}

/// A PLC that rejects a kind of access gets requests of the other kinds from now on.
void SlmpDialog::adapt_to(Access access, bool of_bits, std::uint16_t end_code) {
  if (end_code != kUnsupported) return;
  if (access == Access::blocks && limits_.blocks != 0) {
    limits_.blocks = 0;
    adapted_ = true;
  }
  if (access == Access::batch && of_bits) limits_.bits = 0;
}

Fault SlmpDialog::read(image::Tables& tables) {
  if (std::exchange(adapted_, false)) {
    skipped_.clear();
    operations_ = plan_of(map_.operations);
    events_ = plan_of(map_.events);
  }
  return read_all(operations_, {tables.coils.words, tables.holding_registers.words});
}

Fault SlmpDialog::read_back(std::span<std::uint64_t> discrete_inputs, std::span<std::uint64_t> input_registers) {
  return read_all(events_, {discrete_inputs, input_registers});
}

/// `whole`: 16 bit devices that are all mapped are written as a word, otherwise bit by bit.
SlmpDialog::Writes SlmpDialog::writes_of(std::span<const LaneChange> changes, bool whole) const {
  Writes writes;
  std::vector<std::pair<Cell, std::uint16_t>> words;
  for (const LaneChange& change : changes) {
    const bool bits = change.lane.table == Table::discrete_input;
    const Cell& cell = (bits ? map_.events.bits : map_.events.numbers)[change.lane.number];
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
  for (std::uint32_t i = 0; i < owned_.size(); ++i) all.push_back({{Table::discrete_input, i}, owned_[i], 0});
  for (std::uint32_t i = 0; i < map_.events.numbers.size(); ++i) {
    all.push_back({{Table::input_register, i}, kWholeCell, 0});
  }
  const auto count = [&](bool whole) {
    const Writes writes = writes_of(all, whole);
    return writes.words_transfers.size() + writes.bit_transfers.size();
  };
  return std::min(count(false), count(true));
}

std::vector<std::string> SlmpDialog::notes() const {
  return client::request_notes(operations_.transfers.size(), requests_to_write(), events_.transfers.size());
}

Fault SlmpDialog::write(std::span<const LaneChange> changes) {
  const auto size = [](const Writes& writes) { return writes.words_transfers.size() + writes.bit_transfers.size(); };
  Writes writes = writes_of(changes, false);
  if (size(writes) > 1 && writes.splits_words) {
    if (Writes other = writes_of(changes, true); size(other) < size(writes)) writes = std::move(other);
  }
  for (const Transfer& transfer : writes.words_transfers) {
    if (Fault fault = write_words(transfer, writes)) return fault;
  }
  for (const Transfer& transfer : writes.bit_transfers) {
    if (Fault fault = write_bits(transfer, writes)) return fault;
  }
  return {};
}

Fault SlmpDialog::write_words(const Transfer& transfer, const Writes& writes) {
  constexpr std::array kCommands = {Command::write, Command::write_random, Command::write_blocks};
  RequestWriter& request = exchange_.begin(kCommands[static_cast<std::size_t>(transfer.access)], false);
  put_counts(request, transfer);
  for (const Span& span : transfer.spans) {
    put_span(request, transfer, span);
    const auto values = std::span(writes.values).subspan(span.item, span.count);
    if (transfer.access == Access::random && span.count == 2) {
      request.put_32(std::uint32_t{values[1]} << 16 | values[0]);
    } else {
      for (const std::uint16_t value : values) request.put_16(value);
    }
  }
  Reply reply;
  if (Fault fault = transact(reply)) return fault;
  if (reply.end_code != 0) note_rejection("writing", transfer, false, reply.end_code);
  return {};
}

Fault SlmpDialog::write_bits(const Transfer& transfer, const Writes& writes) {
  const bool batch = transfer.access == Access::batch;
  RequestWriter& request = exchange_.begin(batch ? Command::write : Command::write_random, true);
  if (batch) {
    const Span& span = transfer.spans.front();
    request.put_device(span.kind, span.first);
    request.put_16(static_cast<std::uint16_t>(span.count));
    request.put_bits(std::span(writes.bit_values).subspan(span.item, span.count));
  } else {
    request.put_8(static_cast<std::uint8_t>(transfer.spans.size()));
    for (const Span& span : transfer.spans) {
      request.put_device(span.kind, span.first);
      request.put_listed_bit(writes.bit_values[span.item] != 0);
    }
  }
  Reply reply;
  if (Fault fault = transact(reply)) return fault;
  if (reply.end_code != 0) note_rejection("writing", transfer, true, reply.end_code);
  return {};
}

}  // namespace symplant::link::slmp
