// The conversation with a PLC that is a Modbus TCP server.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/request_list.hpp"
#include "symplant/link/modbus/client_exchange.hpp"
#include "symplant/link/modbus/client_plan.hpp"
#include "symplant/link/modbus/client_settings.hpp"
#include "symplant/link/modbus/io_map.hpp"

namespace symplant::link::modbus {

class ModbusDialog final : public client::Dialog {
 public:
  /// `placed`: the result of image_of() for `map`.
  ModbusDialog(const ClientSettings& settings, const IoMap& map, const image::Map& placed);

  /// The requests that the map needs.
  std::vector<std::string> notes() const;

  std::string url() const override;
  client::Fault open() override { return exchange_.open(); }
  void close() noexcept override { exchange_.close(); }
  /// Modbus has nothing to compare: always unverifiable. Reads the operations and what is to be written, once.
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
  std::string functions() const override;
  void interrupt() noexcept override { exchange_.interrupt(); }
  std::uint64_t requests() const noexcept override { return requests_.load(std::memory_order_relaxed); }
  std::uint64_t rejected() const noexcept override { return rejected_.load(std::memory_order_relaxed); }

 private:
  static ClientRequest request_of(ClientRequest::Kind kind, Area area, const AddressRange& range) {
    return {kind, area, static_cast<std::uint16_t>(range.first), static_cast<std::uint16_t>(range.count)};
  }
  using Items = std::vector<AddressRange>;
  /// The two tables of one direction: what is mapped in each area, and the requests that read it.
  struct Direction {
    Table bits = Table::coil;
    Table numbers = Table::holding_register;
    std::array<Items, kAreas> items = {};
    std::vector<std::uint32_t> lanes = {};  ///< by register of `numbers`, as lanes_of()
    client::RequestList<ClientRequest> requests = {};
  };
  using Words = client::Words;
  class Reading;
  /// The changes of a call of write(), and those that the PLC did not take.
  struct Writing {
    std::span<const client::LaneChange> changes;
    std::vector<client::Unwritten>& unwritten;
  };
  /// What is written at an address: a run of registers, or one coil.
  struct Piece {
    AddressRange range;
    std::array<std::uint16_t, kStatusWords> values = {};
  };

  void add_items(Direction& direction, const IoMap& map) const;
  static void plan_reads(Direction& direction);
  client::Fault read_all(Direction& direction, const Words& out, tables::Time now);
  static std::span<const AddressRange> items_in(const Direction& direction, const ClientRequest& request);
  void take(const Direction& direction, const ClientReply& reply, const ClientRequest& request, const Words& out) const;
  void report(const Direction& direction, const ClientRequest& request);
  void take_packed(Table table, const ClientReply& reply, const ClientRequest& request,
                   std::span<std::uint64_t> bits) const;
  void take_numbers(const Direction& direction, const ClientReply& reply, const ClientRequest& request,
                    std::span<std::uint64_t> numbers) const;
  AddressRange registers_in(Table table, const ClientRequest& request) const;
  void leave_out(const Direction& direction, const ClientRequest& request);
  void add_coils(std::span<const client::LaneChange> changes);
  void add_packed(std::span<const client::LaneChange> changes);
  void add_numbers(std::span<const client::LaneChange> changes);
  client::Fault write_area(Area area, std::uint32_t most, const Writing& writing);
  client::Fault write_range(Area area, const PlannedRange& planned, const Writing& writing);
  client::Fault write_pieces(Area area, const PlannedRange& planned, const Writing& writing);
  void refuse(const ClientRequest& request, std::uint8_t code, const AddressRange& range, const Writing& writing);
  std::uint32_t address_in(const client::LaneChange& change, std::uint32_t bit) const;
  client::Fault transact(const ClientRequest& request, std::span<const std::uint16_t> values, ClientReply& reply);
  tables::Refusal note_rejection(const ClientRequest& request, std::uint8_t code);
  const Placement& placement(Table table) const { return *settings_.placements[static_cast<std::size_t>(table)]; }
  std::uint16_t in_order(std::uint16_t bits) const noexcept;
  std::uint16_t on_wire(std::uint16_t value) const noexcept;

  ClientSettings settings_;
  std::array<std::uint32_t, kTables> sizes_;
  Direction operations_{.bits = Table::coil, .numbers = Table::holding_register};
  Direction events_{.bits = Table::discrete_input, .numbers = Table::input_register};
  std::vector<std::uint16_t> owned_;      ///< by 16 discrete inputs: the mapped ones
  std::vector<bool> continues_;           ///< by input register: it belongs to the number that begins before it
  std::vector<std::uint32_t> registers_;  ///< by lane of the event numbers: its input register
  std::vector<Piece> pieces_;             ///< of one write(), for one area
  std::vector<AddressRange> ranges_;      ///< of pieces_
  std::vector<std::uint16_t> values_;
  ClientExchange exchange_;
  bool mute_ = false;                  ///< function 43 got no valid answer; it is not asked again
  std::array<bool, kAreas> singly_{};  ///< values are written by function 5 or 6, since the PLC lacks 15 or 16
  std::map<std::uint8_t, bool> has_;   ///< by function that was used: whether the PLC has it
  tables::Refusal refusal_;            ///< of the latest reading that was refused
  std::vector<client::Rejection> rejections_;
  std::vector<client::LeftOut> left_out_;
  client::ReadObserver* observer_ = nullptr;
  std::atomic<std::uint64_t> requests_{0};
  std::atomic<std::uint64_t> rejected_{0};
};

}  // namespace symplant::link::modbus
