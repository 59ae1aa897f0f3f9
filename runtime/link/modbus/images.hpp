// The plant's images as a Modbus server's tables, shared between the cycle and the server's thread without a lock.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/core/plant.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/link/modbus/codec.hpp"
#include "symplant/link/modbus/numbers.hpp"
#include "symplant/link/modbus/places.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link::modbus {

/// Coils and holding registers go from the server to the cycle, discrete inputs and input registers back; each way a
/// whole image at a time. At the start operations are off and numbers at their initial values.
class Images {
 public:
  Images(const core::PlantTables& tables, const IoMap& map);

  // --- the cycle's thread

  /// Gives the plant the operations that changed since the last call. Costs a comparison of the image, where a newer
  /// one is there, and what changed.
  void read_operations(core::Plant& plant) noexcept;
  /// Takes the plant's changed events, all of them at the first call.
  void write_events(const core::Plant& plant) noexcept;

  // --- the server's thread

  /// The tables to answer one request from; inputs are those of the latest cycle.
  Tables tables() noexcept;
  /// To be called after a request was answered: hands over what it wrote. Returns how many places it wrote that no
  /// symbol stands on.
  std::uint32_t written(const Answer& answer) noexcept;

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
  void apply_coils(core::Plant& plant, std::size_t word, std::uint64_t now, std::uint64_t changed) const noexcept;
  void apply_registers(core::Plant& plant, std::size_t word, std::span<const std::uint64_t> now) const noexcept;
  void write_event_word(std::uint32_t word, std::uint64_t bits) noexcept;
  void write_input_register(std::uint32_t slot, std::uint64_t value) noexcept;

  const core::PlantTables& tables_;
  std::vector<IoPoint> points_;
  std::array<std::uint32_t, kTables> sizes_;
  std::size_t coil_words_;      ///< holding registers follow them
  std::size_t discrete_words_;  ///< input registers follow them
  ByPlace coils_;
  ByPlace holding_registers_;
  std::vector<std::uint32_t> place_of_event_;  ///< an event bit: its discrete input, or none
  std::vector<std::uint64_t> applied_;         ///< operations that the plant was given, as in the image
  std::vector<std::uint64_t> events_written_;  ///< the plant's event plane as the image has it
  std::vector<std::uint32_t> point_of_slot_;   ///< a numeric event: its input registers, in points_, or none
  bool first_write_ = true;
  share::SharedWords operations_;  ///< server -> cycle
  share::SharedWords events_;      ///< cycle -> server
};

}  // namespace symplant::link::modbus
