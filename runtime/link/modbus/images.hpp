// The plant's images as a Modbus server's tables, shared between the cycle and the server's thread without a lock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "symplant/link/io_map.hpp"
#include "symplant/link/modbus/codec.hpp"
#include "symplant/link/modbus/numbers.hpp"
#include "symplant/link/modbus/place_set.hpp"
#include "symplant/link/modbus/places.hpp"
#include "symplant/link/modbus/rewriting.hpp"
#include "symplant/link/modbus/status_block.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link::modbus {

/// Coils and holding registers go from the server to the cycle, discrete inputs and input registers back; each way a
/// whole image at a time. At the start operations are off and numbers at their initial values.
class Images {
 public:
  /// `word_order`: of the status block.
  Images(const tables::PlantTables& tables, const IoMap& map, WordOrder word_order = WordOrder::high_first);

  // --- the cycle's thread

  /// Gives the plant the operations that changed since the last call. Costs a comparison of the image, where a newer
  /// one is there, and what changed.
  void read_operations(plant::Plant& plant) noexcept;
  /// Takes the plant's changed events, all of them at the first call, and the status; hands them over.
  void write_events(const plant::Plant& plant, const StatusBlock& status = {}) noexcept;

  // The parts of read_operations(), where a link may be lost.

  /// Takes what the server handed over last, without giving it to the plant. O(1).
  void take_operations() noexcept;
  /// Whether in what was taken all has been written again that was written before the loss of this number.
  bool is_complete(std::uint32_t losses) const noexcept;
  void apply_operations(plant::Plant& plant) noexcept;
  /// Puts operations to zero whose policy it is when their link is lost. What is there acts again with the next
  /// apply_operations(). Costs a look at every word of the image.
  void zero_operations(plant::Plant& plant) noexcept;
  /// Hands over the status alone.
  void write_status(const StatusBlock& status) noexcept;

  // --- the server's thread

  /// The tables to answer one request from; inputs are those of the latest cycle.
  Tables tables() noexcept;
  /// To be called before a request is answered, with how often the link was lost until now. After a loss all that was
  /// written is awaited anew, and operations that went to zero are zero in the tables, too: what nobody writes again
  /// stays so. O(1); after a loss a look at every word of the image.
  void begin_request(std::uint32_t losses) noexcept;
  /// To be called after a request was answered: hands over what it wrote. Returns how many places it wrote that nothing
  /// stands on.
  std::uint32_t written(const Answer& answer) noexcept;
  /// Whether a request that was answered changed the watchdog's register.
  bool changed_watchdog(const Answer& answer) noexcept;
  /// Whether a request touches a place of the table that a symbol or the watchdog stands on. O(count / 64).
  bool is_mapped(Table table, std::uint32_t first, std::uint32_t count) const noexcept {
    return mapped_[static_cast<std::size_t>(table)].has_any(first, count);
  }

 private:
  /// Operations by place: those of place p are rows[first[p]] up to rows[first[p + 1]]. A number stands at each of its
  /// registers.
  struct ByPlace {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> rows;  ///< in points_

    std::span<const std::uint32_t> at(std::uint32_t place) const noexcept;
  };

  static ByPlace by_place(const IoMap& map, Table table);
  std::vector<std::uint64_t> initial_operations() const;
  NumberPlace number_place(const IoPoint& point) const noexcept;
  std::vector<std::uint64_t> zero_masks() const;
  void hand_over() noexcept;
  void change_operations(plant::Plant& plant, std::span<const std::uint64_t> image) noexcept;
  void apply_coils(plant::Plant& plant, std::size_t word, std::uint64_t now, std::uint64_t changed) const noexcept;
  void apply_registers(plant::Plant& plant, std::size_t word, std::span<const std::uint64_t> now) const noexcept;
  void write_event_word(std::uint32_t word, std::uint64_t bits) noexcept;
  void write_input_register(std::uint32_t slot, std::uint64_t value) noexcept;

  const tables::PlantTables& tables_;
  std::vector<IoPoint> points_;
  std::array<std::uint32_t, kTables> sizes_;
  std::size_t coil_words_;      ///< holding registers follow them
  std::size_t discrete_words_;  ///< input registers follow them
  ByPlace coils_;
  ByPlace holding_registers_;
  std::vector<std::uint32_t> place_of_event_;  ///< an event bit: its discrete input, or none
  std::vector<std::uint64_t> applied_;         ///< operations that the plant was given, as in the image
  std::vector<std::uint64_t> zeroed_;          ///< their bits that go to zero when the link is lost
  std::vector<std::uint64_t> scratch_;         ///< of zero_operations()
  std::array<PlaceSet, kTables> mapped_;       ///< places of symbols, and the watchdog's
  std::optional<std::uint32_t> status_block_;
  std::optional<std::uint32_t> watchdog_;
  WordOrder word_order_;
  std::vector<std::uint64_t> events_written_;  ///< the plant's event plane as the image has it
  std::vector<std::uint32_t> point_of_slot_;   ///< a numeric event: its input registers, in points_, or none
  bool first_write_ = true;
  bool behind_ = false;  ///< what was taken may differ from what the plant was given
  Rewriting rewriting_;  ///< of the server's thread
  std::uint32_t losses_seen_ = 0;
  std::uint16_t watchdog_value_ = 0;
  share::SharedWords operations_;  ///< server -> cycle; the tables, then the losses seen, then whether all is rewritten
  share::SharedWords events_;      ///< cycle -> server
};

}  // namespace symplant::link::modbus
