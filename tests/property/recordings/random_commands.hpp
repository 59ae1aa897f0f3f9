// A PLC program that commands the devices of a random plant.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"
#include "property/dice.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::property {

/// How a program commands.
enum class Commands : std::uint8_t {
  closed_loop,  ///< one device state after the other, each after the arrival of the one before, or after a timeout
  wild,         ///< any operation at any time
};

/// Reads events and writes operations, device by device, as a scan of a PLC does.
class RandomCommands {
 public:
  /// `plant`: with the true times, from which timeouts follow.
  RandomCommands(std::uint64_t seed, const model::PlantModel& plant, const tables::PlantTables& tables, Commands kind);

  void scan(plant::Plant& plant, tables::Time now);

 private:
  struct Commanded {
    std::uint32_t unit = 0;
    std::uint32_t operation = tables::kNone;  ///< index in Unit::operations; kNone: none is on
    std::vector<std::uint32_t> shows;         ///< events of the states to which it leads
    tables::Time timeout = 0;
    tables::Time until = 0;      ///< nothing happens before
    tables::Time clear_at = -1;  ///< < 0: not
    bool waits = false;          ///< for one of `shows`
  };

  void command(plant::Plant& plant, Commanded& of, tables::Time now);
  void write(plant::Plant& plant, std::uint32_t symbol, bool on);
  bool is_on(const plant::Plant& plant, std::uint32_t symbol) const;
  void clear(plant::Plant& plant, const Commanded& of);
  void scan_wild(plant::Plant& plant);
  tables::Time within(tables::Time most) {
    return static_cast<tables::Time>(dice_.below(static_cast<std::size_t>(most)));
  }

  Dice dice_;
  const model::PlantModel& plant_;
  const tables::PlantTables& tables_;
  const Commands kind_;
  std::vector<Commanded> units_;
  std::vector<std::uint32_t> numbers_;  ///< numeric operations
  std::vector<std::uint32_t> bits_;     ///< BOOL operations
  tables::Time next_number_ = 0;
};

}  // namespace symplant::property
