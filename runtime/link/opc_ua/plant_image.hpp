// What clients of the server see of the plant in addition to its symbols, shared by the cycle and the server's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/share/shared_words.hpp"

namespace symplant::link::opc_ua {

/// What a unit does, in one word.
struct UnitState {
  std::uint8_t state = 0;   ///< in which it is settled, or from which it moves
  std::uint8_t target = 0;  ///< to which it moves; `state` if it is settled
  bool moving = false;
  std::uint16_t progress = 0;  ///< of the move, in thousandths
};

constexpr std::uint64_t pack(const UnitState& unit) noexcept {
  return std::uint64_t{unit.state} | std::uint64_t{unit.target} << 8 | std::uint64_t{unit.moving} << 16 |
         std::uint64_t{unit.progress} << 32;
}
constexpr UnitState unpack_unit(std::uint64_t word) noexcept {
  return {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8), (word >> 16 & 1) != 0,
          static_cast<std::uint16_t>(word >> 32)};
}

/// Where the words are. In this order: cycles, time, plant time, frozen; the outputs of values; the units; a bit for
/// each point of the map that a malfunction decides; a bit for each written malfunction that is active.
struct PlantWords {
  static constexpr std::size_t kCycles = 0;     ///< cycles so far; 0: none yet
  static constexpr std::size_t kTime = 1;       ///< of the clock of this computer at the last cycle, in ns since 1970
  static constexpr std::size_t kPlantTime = 2;  ///< in ns
  static constexpr std::size_t kFrozen = 3;     ///< 0 or 1

  PlantWords(const tables::PlantTables& tables, const image::Map& map) noexcept;

  std::size_t outputs;  ///< the first one
  std::size_t units;
  std::size_t decided;
  std::size_t active;
  std::size_t end;
};

/// The cycle writes, the server's thread reads, both wait-free. A cycle costs at most a look at kUnitsOfCycle units and
/// kOutputsOfCycle outputs, in turn, so that in a larger plant these are some cycles late; the rest follows the
/// changes.
class PlantImage {
 public:
  static constexpr std::uint32_t kUnitsOfCycle = 256;
  static constexpr std::uint32_t kOutputsOfCycle = 512;

  /// The tables and the map must outlive it.
  PlantImage(const tables::PlantTables& tables, const image::Map& map);

  // --- the cycle's thread

  /// To be called before the events of the same cycle are published.
  void write(const plant::Plant& plant, const exec::CycleStatus& status) noexcept;

  // --- the server's thread

  /// Takes the image of the latest cycle; false if there is no newer one.
  bool take() noexcept { return words_.update(); }
  std::span<const std::uint64_t> words() const noexcept { return words_.latest(); }
  const PlantWords& at() const noexcept { return at_; }

 private:
  void set(std::size_t word, std::uint64_t value) noexcept;
  void set_bit(std::size_t first, std::uint32_t bit, bool on) noexcept;
  void write_units(const plant::Plant& plant) noexcept;
  void write_outputs(const plant::Plant& plant) noexcept;
  void write_malfunctions(const plant::Plant& plant) noexcept;

  const tables::PlantTables& tables_;
  const PlantWords at_;
  std::vector<std::uint32_t> first_event_;  ///< by symbol: the first point of an event of its address; tables::kNone
  std::vector<std::uint32_t> next_event_;   ///< by point: the next point of an event of its address; tables::kNone
  std::vector<engine::ActiveMalfunction> active_;  ///< as written last
  std::uint32_t next_unit_ = 0;
  std::uint32_t next_output_ = 0;
  share::SharedWords words_;
};

}  // namespace symplant::link::opc_ua
