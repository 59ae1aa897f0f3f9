// The tables of a Modbus server: what its clients see of a link's images, and what they have written.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "symplant/link/image/images.hpp"
#include "symplant/link/image/position_set.hpp"
#include "symplant/link/image/request_watch.hpp"
#include "symplant/link/image/rewriting.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/link/modbus/operation_writes.hpp"
#include "symplant/link/modbus/tables.hpp"

namespace symplant::link::modbus {

/// Coils and discrete inputs are the bits of the images, and input registers read the numbers of the images. Holding
/// registers are separate memory, which also keeps gaps and numbers that are only partly written; what is written of a
/// number goes to the image. Used by the server's thread.
class ServerTables {
 public:
  /// `placed`: image_of(tables, map), of which the images were made. `watch`, if it is not null, gets all reads and
  /// writes. Images and watch must outlive this.
  ServerTables(const tables::PlantTables& tables, const IoMap& map, const image::Map& placed, image::Images& images,
               image::RequestWatch* watch = nullptr);

  /// The tables for one request; inputs are those of the latest cycle.
  Tables tables() noexcept;
  /// To be called before each request is answered, with the number of losses so far. After a loss everything that was
  /// written is awaited again, and operations that went to zero are zero in the tables, too. O(1); O(image) after a
  /// loss.
  void begin_request(std::uint32_t losses) noexcept;
  /// To be called after each request was answered: publishes what it wrote. Returns the number of written addresses
  /// that are not used: neither a symbol nor the watchdog has them, nor are they in a gap of the transfer range.
  std::uint32_t written(Table table, std::uint32_t first, std::uint32_t count, const ClientId& client = {}) noexcept;
  /// To be called last for each request, with what it read.
  void end_request(Table table, std::uint32_t first, std::uint32_t count) noexcept;
  /// Whether the answered request changed the watchdog's register.
  bool changed_watchdog(Table table, std::uint32_t first, std::uint32_t count) noexcept;
  /// Whether a symbol or the watchdog uses one of these addresses. O(count / 64).
  bool is_mapped(Table table, std::uint32_t first, std::uint32_t count) const noexcept {
    return mapped_[static_cast<std::size_t>(table)].has_any(first, count);
  }
  /// A client has closed its connection.
  void left(const ClientId& client) noexcept {
    if (writes_) writes_->left(client);
  }

 private:
  void take_operations() noexcept;
  void put_registers(std::uint32_t first, std::uint32_t count) noexcept;

  image::Images& images_;
  image::RequestWatch* watch_;  ///< null: none
  std::array<std::uint32_t, kTables> sizes_;
  std::vector<std::uint64_t> holding_registers_;  ///< as clients have written them
  std::vector<std::uint32_t> holding_lanes_;      ///< as lanes_of()
  std::vector<std::uint32_t> input_lanes_;
  std::array<image::PositionSet, kTables> mapped_;  ///< addresses of symbols and of the watchdog
  std::array<image::PositionSet, kTables> used_;  ///< of coils and holding registers: mapped, or in the transfer range
  std::optional<std::uint32_t> watchdog_;
  std::uint16_t watchdog_value_ = 0;
  image::Rewriting rewriting_;
  std::optional<OperationWrites> writes_;
};

}  // namespace symplant::link::modbus
