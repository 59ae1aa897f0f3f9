// The conversation with a MELSEC PLC: reads and writes the cells of a map.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/request_list.hpp"
#include "symplant/link/slmp/end_code.hpp"
#include "symplant/link/slmp/exchange.hpp"
#include "symplant/link/slmp/map.hpp"
#include "symplant/link/slmp/plan.hpp"

namespace symplant::link::slmp {

class SlmpDialog final : public client::Dialog {
 public:
  SlmpDialog(const Settings& settings, DeviceMap map);

  /// The requests that the map needs.
  std::vector<std::string> notes() const;

  std::string url() const override;
  client::Fault open() override;
  void close() noexcept override { exchange_.close(); }
  client::Identity identify(client::Fault& fault) override;
  client::Fault read(const client::Words& operations, tables::Time now) override;
  client::Fault write(std::span<const client::LaneChange> changes, std::vector<client::Unwritten>& unwritten) override;
  client::Fault read_back(const client::Words& events, tables::Time now) override;
  void observe(client::ReadObserver* observer) noexcept override { observer_ = observer; }
  void retry_rejected() noexcept override;
  bool is_dividing() const noexcept override {
    return operations_.requests.is_dividing() || events_.requests.is_dividing();
  }
  std::vector<client::Rejection> take_rejections() override { return std::exchange(rejections_, {}); }
  std::vector<client::LeftOut> take_left_out() override { return std::exchange(left_out_, {}); }
  void interrupt() noexcept override { exchange_.interrupt(); }
  std::uint64_t requests() const noexcept override { return requests_.load(std::memory_order_relaxed); }
  std::uint64_t rejected() const noexcept override { return rejected_.load(std::memory_order_relaxed); }

 private:
  /// Where a word of memory goes in the images: lanes of one or both planes, or kNowhere.
  struct Target {
    std::uint32_t bits = kNowhere;
    std::uint32_t numbers = kNowhere;
  };
  /// The cells of one direction, the requests that read them, and where the words go.
  struct ReadPlan {
    std::vector<Cell> cells;
    std::vector<Target> targets;
    std::vector<bool> continues;  ///< by cell: it belongs to the number that begins before it
    client::RequestList<Transfer> requests;
  };
  class Reading;
  using Words = client::Words;

  ReadPlan plan_of(const Cells& cells) const;
  client::Fault read_all(ReadPlan& plan, const Words& out, tables::Time now);
  static void put_counts(RequestWriter& request, const Transfer& transfer);
  static void put_span(RequestWriter& request, const Transfer& transfer, const Span& span);
  bool take_words(const Transfer& transfer, const Reply& reply);
  void report(const Transfer& transfer, const ReadPlan& plan);
  void scatter(const Transfer& transfer, const ReadPlan& plan, const Words& out) const;

  /// The changes of one write(), and the requests that write them.
  struct Writes {
    std::vector<Cell> cells;
    std::vector<std::uint16_t> values;
    std::vector<Bit> bits;
    std::vector<std::uint8_t> bit_values;
    std::vector<Transfer> words_transfers;
    std::vector<Transfer> bit_transfers;
    bool splits_words = false;  ///< some bits could be written as whole words
  };
  const Cell& cell_of(const client::Lane& lane) const {
    return lane.plane == Plane::event_bits ? map_.events.bits[lane.number] : number_cells_[lane.number];
  }
  Writes writes_of(std::span<const client::LaneChange> changes, bool whole) const;
  std::size_t requests_to_write() const;
  /// The changes of a request to write, and those that the PLC did not take.
  struct Writing {
    const Writes& writes;
    std::span<const client::LaneChange> changes;
    std::vector<client::Unwritten>& unwritten;
  };
  client::Fault write_words(const Transfer& transfer, const Writing& writing);
  client::Fault write_bits(const Transfer& transfer, const Writing& writing);
  client::Fault confirm(const Transfer& transfer, bool of_bits, const Writing& writing);
  void refuse(const Transfer& transfer, bool of_bits, const client::Unwritten& why, const Writing& writing);

  bool adapt_to(Access access, bool of_bits, std::uint16_t end_code);

  client::Fault transact(Reply& reply);
  tables::Refusal refusal_to(bool writing, const Transfer& transfer, bool of_bits, std::uint16_t end_code) const;
  tables::Refusal note_rejection(bool writing, const Transfer& transfer, bool of_bits, std::uint16_t end_code);

  Settings settings_;
  DeviceMap map_;
  Limits limits_;
  bool adapted_ = false;  ///< the limits have changed since the requests to read were planned
  ReadPlan operations_;
  ReadPlan events_;
  std::vector<std::uint16_t> owned_;  ///< by bit cell of the events: its mapped bits
  std::vector<Cell> number_cells_;    ///< by lane of the event numbers
  Exchange exchange_;
  std::vector<std::uint16_t> words_;  ///< of the latest reply, in the order of its spans
  tables::Refusal refusal_;           ///< of the latest reading that was refused
  std::vector<client::Rejection> rejections_;
  std::vector<client::LeftOut> left_out_;
  client::ReadObserver* observer_ = nullptr;
  std::atomic<std::uint64_t> requests_{0};
  std::atomic<std::uint64_t> rejected_{0};
};

}  // namespace symplant::link::slmp
