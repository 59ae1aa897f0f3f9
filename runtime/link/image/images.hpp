// The plant's images as a Modbus server's tables, shared by the cycle and the server's thread without a lock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "symplant/link/image/address_set.hpp"
#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/request_watch.hpp"
#include "symplant/link/image/rewriting.hpp"
#include "symplant/link/image/status_block.hpp"
#include "symplant/link/image/table_view.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link::image {

/// Coils and holding registers go from the server to the cycle, discrete inputs and input registers back; a whole image
/// at a time in each direction. At the start operations are off and numbers have their initial values.
class Images {
 public:
  /// `word_order`: of the status block. `watch`, if it is not null, gets all reads and writes and must outlive this.
  Images(const tables::PlantTables& tables, const IoMap& map, WordOrder word_order = WordOrder::high_first,
         RequestWatch* watch = nullptr);

  // --- the cycle's thread

  /// Applies the operations that changed since the last call to the plant. O(image) if there is a newer image, else
  /// O(1).
  void read_operations(plant::Plant& plant) noexcept;
  /// Publishes the plant's changed events (all of them at the first call) and the status. `now`: for the watch.
  void write_events(const plant::Plant& plant, const StatusBlock& status = {}, tables::Time now = 0) noexcept;

  // The parts of read_operations(), for a link that may be lost.

  /// Takes the latest image of the server, without applying it to the plant. O(1).
  void take_operations() noexcept;
  /// Whether the taken image has everything written again that was written before loss number `losses`.
  bool is_complete(std::uint32_t losses) const noexcept;
  void apply_operations(plant::Plant& plant) noexcept;
  /// Sets operations to zero whose policy on loss is zero. The next apply_operations() applies the image again.
  /// O(image).
  void zero_operations(plant::Plant& plant) noexcept;
  /// Publishes only the status.
  void write_status(const StatusBlock& status) noexcept;

  // --- the server's thread

  /// The tables for one request; inputs are those of the latest cycle.
  Tables tables() noexcept;
  /// To be called before each request is answered, with the number of losses so far. After a loss everything that was
  /// written is awaited again, and operations that went to zero are zero in the tables, too: they stay zero until the
  /// PLC writes them again. O(1); O(image) after a loss.
  void begin_request(std::uint32_t losses) noexcept;
  /// To be called after each request was answered: publishes what it wrote. Returns the number of written addresses
  /// that are not used: neither a symbol nor the watchdog has them, nor are they in a gap of the transfer range.
  std::uint32_t written(Table table, std::uint32_t first, std::uint32_t count, const ClientId& client = {}) noexcept;
  /// To be called last for each request, with what it read.
  void end_request(Table table, std::uint32_t first, std::uint32_t count) noexcept;
  /// To be called instead of written() when all coils and holding registers were written: publishes them at once.
  /// O(image).
  void written_all() noexcept;
  /// Whether the answered request changed the watchdog's register.
  bool changed_watchdog(Table table, std::uint32_t first, std::uint32_t count) noexcept;
  /// Whether a symbol or the watchdog uses one of these addresses. O(count / 64).
  bool is_mapped(Table table, std::uint32_t first, std::uint32_t count) const noexcept {
    return mapped_[static_cast<std::size_t>(table)].has_any(first, count);
  }

 private:
  /// Operations by address: those of address a are rows[first[a]] up to rows[first[a + 1]], without the latter. A
  /// number is listed at each of its registers.
  struct ByAddress {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> rows;  ///< indexes in points_

    std::span<const std::uint32_t> at(std::uint32_t address) const noexcept;
  };

  static ByAddress by_address(const IoMap& map, Table table);
  std::vector<std::uint64_t> initial_operations() const;
  NumberLayout number_layout(const IoPoint& point) const noexcept;
  std::uint64_t released(std::size_t word, std::uint64_t bits) const noexcept;
  std::vector<std::uint64_t> zero_masks() const;
  /// The tables as clients have written them.
  std::span<const std::uint64_t> written_coils() noexcept { return operations_.words().first(coil_words_); }
  std::span<const std::uint64_t> written_registers() noexcept {
    return operations_.words().subspan(coil_words_, applied_.size() - coil_words_);
  }
  void hand_over() noexcept;
  void change_operations(plant::Plant& plant, std::span<const std::uint64_t> image) noexcept;
  void apply_coils(plant::Plant& plant, std::size_t word, std::uint64_t now, std::uint64_t changed) const noexcept;
  void apply_registers(plant::Plant& plant, std::size_t word, std::span<const std::uint64_t> now) const noexcept;
  void write_event_word(std::uint32_t word, std::uint64_t bits) noexcept;
  void watch_pulses(std::uint32_t word, std::uint64_t pulsed) noexcept;
  void write_input_register(std::uint32_t slot, std::uint64_t value) noexcept;

  const tables::PlantTables& tables_;
  std::vector<IoPoint> points_;
  std::array<std::uint32_t, kTables> sizes_;
  std::size_t coil_words_;      ///< holding registers follow them
  std::size_t discrete_words_;  ///< input registers follow them
  ByAddress coils_;
  ByAddress holding_registers_;
  std::vector<std::uint32_t> address_of_event_;  ///< by event bit: its discrete input, or tables::kNone
  std::vector<std::uint64_t> applied_;           ///< the operations of the plant, as in the image
  std::vector<std::uint64_t> initial_;           ///< as before the first write
  std::vector<std::uint64_t> zeroed_;            ///< bits that go to zero when the link is lost
  std::vector<std::uint64_t> scratch_;           ///< memory of zero_operations()
  std::array<AddressSet, kTables> mapped_;       ///< addresses of symbols and of the watchdog
  std::array<AddressSet, kTables> used_;         ///< of coils and holding registers: mapped, or in the transfer range
  std::optional<std::uint32_t> status_block_;
  std::optional<std::uint32_t> watchdog_;
  WordOrder word_order_;
  std::vector<std::uint64_t> events_written_;  ///< event bits of the plant, as in the image
  std::vector<std::uint32_t> point_of_slot_;   ///< by slot of a numeric event: its index in points_, or tables::kNone
  bool first_write_ = true;
  bool behind_ = false;  ///< the taken image may differ from the operations of the plant
  Rewriting rewriting_;  ///< used by the server's thread
  std::uint32_t losses_seen_ = 0;
  std::uint64_t image_ = 0;  ///< number of the published image of operations
  std::uint16_t watchdog_value_ = 0;
  RequestWatch* watch_;            ///< null: none
  share::SharedWords operations_;  ///< server -> cycle: the tables, the losses seen, whether all is rewritten, image_
  share::SharedWords events_;      ///< cycle -> server
};

}  // namespace symplant::link::image
