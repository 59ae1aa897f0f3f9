// The conversation with a MELSEC PLC.
#include "symplant/link/slmp/slmp_dialog.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/image/words.hpp"
#include "symplant/link/slmp/cpu_model.hpp"
#include "symplant/link/slmp/refusal.hpp"

namespace symplant::link::slmp {

using client::Answer;
using client::Fault;
using client::Identity;

namespace {

constexpr std::uint16_t kUnsupported = 0xC059;  ///< end code: the command or its subcommand

/// The number of the first device of a word.
std::uint32_t head_of(const Span& span) { return info_of(span.kind).bit ? kBitsInCell * span.first : span.first; }

std::vector<std::uint16_t> owned_bits(const DeviceMap& map) {
  std::vector<std::uint16_t> owned(map.events.bits.size());
  for (const image::Point& point : map.image.points) {
    if (point.plane != Plane::event_bits) continue;
    std::uint16_t& mask = owned[point.position / kBitsInCell];
    mask = static_cast<std::uint16_t>(mask | 1U << (point.position % kBitsInCell));
  }
  return owned;
}

std::vector<Cell> cells_by_lane(const DeviceMap& map) {
  std::vector<Cell> cells(std::size_t{image::kLanesPerWord} * map.image.size(Plane::event_numbers));
  for (const NumberCell& number : map.events.numbers) cells[number.lane] = number.cell;
  return cells;
}

}  // namespace

SlmpDialog::SlmpDialog(const Settings& settings, DeviceMap map)
    : settings_(settings),
      map_(std::move(map)),
      limits_(limits_of(settings.framing)),
      operations_(plan_of(map_.operations)),
      events_(plan_of(map_.events)),
      owned_(owned_bits(map_)),
      number_cells_(cells_by_lane(map_)),
      exchange_(settings),
      words_(std::max(limits_.words, limits_.block_points)) {}

std::string SlmpDialog::url() const { return "slmp://" + net::format_host_port(settings_.address); }

Fault SlmpDialog::open() { return exchange_.open(); }

void SlmpDialog::retry_rejected() noexcept {
  operations_.requests.retry();
  events_.requests.retry();
}

SlmpDialog::ReadPlan SlmpDialog::plan_of(const Cells& cells) const {
  ReadPlan plan;
  plan.cells = cells.bits;
  for (const NumberCell& number : cells.numbers) plan.cells.push_back(number.cell);
  std::sort(plan.cells.begin(), plan.cells.end());
  plan.cells.erase(std::unique(plan.cells.begin(), plan.cells.end()), plan.cells.end());
  plan.targets.resize(plan.cells.size());
  plan.continues.resize(plan.cells.size());
  const auto position = [&](const Cell& cell) {
    return static_cast<std::size_t>(std::lower_bound(plan.cells.begin(), plan.cells.end(), cell) - plan.cells.begin());
  };
  for (std::uint32_t i = 0; i < cells.bits.size(); ++i) plan.targets[position(cells.bits[i])].bits = i;
  std::uint32_t before = kNowhere;  // the number of the cell before
  for (const NumberCell& number : cells.numbers) {
    const std::uint32_t own = number.lane / image::kLanesPerWord;
    plan.targets[position(number.cell)].numbers = number.lane;
    plan.continues[position(number.cell)] = std::exchange(before, own) == own;
  }
  plan.requests = client::RequestList<Transfer>(plan_reads(plan.cells, limits_));
  return plan;
}

Fault SlmpDialog::transact(Reply& reply) {
  Fault fault = exchange_.transact(reply);
  if (!fault) requests_.fetch_add(1, std::memory_order_relaxed);
  return fault;
}

tables::Refusal SlmpDialog::refusal_to(bool writing, const Transfer& transfer, bool of_bits,
                                       std::uint16_t end_code) const {
  const Span& first = transfer.spans.front();
  const Device device{first.kind, of_bits ? first.first : head_of(first)};
  return refusal_of({writing, transfer.access, device}, settings_.framing.family, end_code);
}

tables::Refusal SlmpDialog::note_rejection(bool writing, const Transfer& transfer, bool of_bits,
                                           std::uint16_t end_code) {
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
  const tables::Refusal refusal = refusal_to(writing, transfer, of_bits, end_code);
  rejections_.push_back({answer_of(end_code), refusal,
                         std::string("the PLC rejects ") + (writing ? "writing " : "reading ") + from + rest + ": " +
                             end_code_text(end_code, settings_.framing)});
  return refusal;
}

Identity SlmpDialog::identify(Fault& fault) {
  exchange_.begin(Command::read_model, false);
  Reply reply;
  fault = transact(reply);
  if (fault) return {};
  Identity identity = identity_of(reply, settings_.framing);
  std::vector<std::uint64_t> bits(image::bit_words(map_.image.size(Plane::event_bits)));
  std::vector<std::uint64_t> numbers(map_.image.size(Plane::event_numbers));
  fault = read_back({bits, numbers}, 0);  // whether the PLC has what is to be written
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
      if (target.bits != kNowhere) image::set_lane(out.bits, target.bits, value);
      if (target.numbers != kNowhere) image::set_lane(out.numbers, target.numbers, value);
    }
    base += span.count;
  }
}

/// Marks what a request has read by taking an answer in which all bits are set.
void SlmpDialog::report(const Transfer& transfer, const ReadPlan& plan) {
  std::fill(words_.begin(), words_.end(), kWholeCell);
  scatter(transfer, plan, observer_->marks());
  observer_->answered(exchange_.sent(), exchange_.answered());
}

/// Sends the requests of one direction.
class SlmpDialog::Reading {
 public:
  Reading(SlmpDialog& dialog, const ReadPlan& plan, const Words& out) : dialog_(dialog), plan_(plan), out_(out) {}

  Fault send(const Transfer& transfer, bool first, Answer& answer) {
    constexpr std::array kCommands = {Command::read, Command::read_random, Command::read_blocks};
    RequestWriter& request = dialog_.exchange_.begin(kCommands[static_cast<std::size_t>(transfer.access)], false);
    put_counts(request, transfer);
    for (const Span& span : transfer.spans) put_span(request, transfer, span);
    Reply reply;
    if (Fault fault = dialog_.transact(reply)) return fault;
    if (reply.end_code != 0) {
      answer = refused(transfer, first, reply.end_code);
      return {};
    }
    if (!dialog_.take_words(transfer, reply)) {
      return {Fault::Kind::transport, "the PLC's answer has another number of words than requested; connecting again"};
    }
    dialog_.scatter(transfer, plan_, out_);
    if (dialog_.observer_ != nullptr) dialog_.report(transfer, plan_);
    return {};
  }

  /// A number stays in one part.
  std::vector<Transfer> parts(const Transfer& transfer, Answer /*answer*/) const {
    const std::vector<std::uint32_t> cells = cells_in(transfer);
    std::size_t middle = cells.size() / 2;
    while (middle < cells.size() && plan_.continues[cells[middle]]) ++middle;
    if (middle == cells.size()) {
      for (middle = cells.size() / 2; middle > 0 && plan_.continues[cells[middle]];) --middle;
    }
    if (middle == 0) return {};
    std::vector<Transfer> halves = transfers_of(std::span(cells).first(middle));
    for (Transfer& other : transfers_of(std::span(cells).subspan(middle))) halves.push_back(std::move(other));
    return halves;
  }

  /// Events are not left out because they cannot be read back.
  void leave_out(const Transfer& transfer) {
    if (&plan_ != &dialog_.operations_) return;
    const auto add = [&](Plane plane, std::uint32_t lane) {
      if (lane != kNowhere) dialog_.left_out_.push_back({{{plane, lane}, kWholeCell, 0}, dialog_.refusal_});
    };
    for (const std::uint32_t cell : cells_in(transfer)) {
      add(Plane::operation_bits, plan_.targets[cell].bits);
      add(Plane::operation_numbers, plan_.targets[cell].numbers);
    }
  }

 private:
  Answer refused(const Transfer& transfer, bool first, std::uint16_t end_code) {
    dialog_.rejected_.fetch_add(1, std::memory_order_relaxed);
    if (dialog_.adapt_to(transfer.access, false, end_code)) return Answer::busy;
    dialog_.refusal_ = dialog_.refusal_to(false, transfer, false, end_code);
    if (first) dialog_.note_rejection(false, transfer, false, end_code);
    return answer_of(end_code);
  }

  /// Indexes of the cells that a transfer reads, in ascending order.
  std::vector<std::uint32_t> cells_in(const Transfer& transfer) const {
    std::vector<std::uint32_t> cells;
    for (const Span& span : transfer.spans) {
      for (std::uint32_t i = span.item; i < plan_.cells.size(); ++i) {
        const Cell& cell = plan_.cells[i];
        if (cell.kind != span.kind || cell.word - span.first >= span.count) break;
        cells.push_back(i);
      }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  std::vector<Transfer> transfers_of(std::span<const std::uint32_t> indexes) const {
    std::vector<Cell> cells;
    for (const std::uint32_t index : indexes) cells.push_back(plan_.cells[index]);
    std::vector<Transfer> transfers = plan_reads(cells, dialog_.limits_);
    for (Transfer& transfer : transfers) {
      for (Span& span : transfer.spans) span.item = indexes[span.item];
    }
    return transfers;
  }

  SlmpDialog& dialog_;
  const ReadPlan& plan_;
  const Words& out_;
};

Fault SlmpDialog::read_all(ReadPlan& plan, const Words& out, tables::Time now) {
  Reading reading(*this, plan, out);
  return plan.requests.run(now, reading);
}

/// A PLC that rejects a kind of access gets requests of the other kinds from now on. True if it does not have this one.
bool SlmpDialog::adapt_to(Access access, bool of_bits, std::uint16_t end_code) {
  if (end_code != kUnsupported) return false;
  if (access == Access::blocks && limits_.blocks != 0) {
    limits_.blocks = 0;
    adapted_ = true;
    return true;
  }
  if (access != Access::batch || !of_bits || limits_.bits == 0) return false;
  limits_.bits = 0;
  return true;
}

Fault SlmpDialog::read(const Words& operations, tables::Time now) {
  if (std::exchange(adapted_, false)) {
    operations_ = plan_of(map_.operations);
    events_ = plan_of(map_.events);
  }
  return read_all(operations_, operations, now);
}

Fault SlmpDialog::read_back(const Words& events, tables::Time now) { return read_all(events_, events, now); }

std::vector<std::string> SlmpDialog::notes() const {
  return client::request_notes(operations_.requests.size(), requests_to_write(), events_.requests.size());
}

}  // namespace symplant::link::slmp
