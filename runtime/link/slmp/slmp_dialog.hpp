// The conversation with a MELSEC PLC: reads and writes the cells of a map.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
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
  client::Fault read(image::Tables& tables) override;
  client::Fault write(std::span<const client::LaneChange> changes) override;
  client::Fault read_back(std::span<std::uint64_t> discrete_inputs, std::span<std::uint64_t> input_registers) override;
  void retry_rejected() noexcept override;
  std::vector<std::string> take_rejections() override { return std::exchange(rejections_, {}); }
  void interrupt() noexcept override { exchange_.interrupt(); }
  std::uint64_t requests() const noexcept override { return requests_.load(std::memory_order_relaxed); }
  std::uint64_t rejected() const noexcept override { return rejected_.load(std::memory_order_relaxed); }

 private:
  /// Where a word of memory goes in the images: lanes of one or both tables, or kNowhere.
  struct Target {
    std::uint32_t bits = kNowhere;
    std::uint32_t numbers = kNowhere;
  };
  /// The cells of one direction, the requests that read them, and what becomes of the words.
  struct ReadPlan {
    std::vector<Cell> cells;
    std::vector<Target> targets;
    std::vector<Transfer> transfers;
  };
  struct Words {
    std::span<std::uint64_t> bits;
    std::span<std::uint64_t> numbers;
  };

  ReadPlan plan_of(const Cells& cells) const;
  client::Fault read_all(const ReadPlan& plan, const Words& out);
  client::Fault read_one(const Transfer& transfer, const ReadPlan& plan, const Words& out);
  static void put_counts(RequestWriter& request, const Transfer& transfer);
  static void put_span(RequestWriter& request, const Transfer& transfer, const Span& span);
  bool take_words(const Transfer& transfer, const Reply& reply);
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
  Writes writes_of(std::span<const client::LaneChange> changes, bool whole) const;
  std::size_t requests_to_write() const;
  client::Fault write_words(const Transfer& transfer, const Writes& writes);
  client::Fault write_bits(const Transfer& transfer, const Writes& writes);

  void adapt_to(Access access, bool of_bits, std::uint16_t end_code);

  client::Fault transact(Reply& reply);
  void note_rejection(const char* doing, const Transfer& transfer, bool of_bits, std::uint16_t end_code);

  Settings settings_;
  DeviceMap map_;
  Limits limits_;
  bool adapted_ = false;  ///< the limits have changed since the requests to read were planned
  ReadPlan operations_;
  ReadPlan events_;
  std::vector<std::uint16_t> owned_;  ///< by bit cell of the events: its mapped bits
  Exchange exchange_;
  std::vector<std::uint16_t> words_;           ///< of the latest reply, in the order of its spans
  std::map<const Transfer*, Remedy> skipped_;  ///< requests to read that the PLC rejects
  std::vector<std::string> rejections_;
  std::atomic<std::uint64_t> requests_{0};
  std::atomic<std::uint64_t> rejected_{0};
};

}  // namespace symplant::link::slmp
