// The differences of two plants as plain values. `before` is the old plant, `after` the new one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::diff {

using model::kNone;

/// What can change in a symbol that is in both plants.
enum class Field : std::uint8_t { name, address, type, initial, comment, other };
inline constexpr std::size_t kFields = 6;

class Fields {
 public:
  void add(Field field) { bits_ |= 1U << static_cast<unsigned>(field); }
  bool has(Field field) const { return (bits_ & (1U << static_cast<unsigned>(field))) != 0; }
  bool empty() const { return bits_ == 0; }

 private:
  unsigned bits_ = 0;
};

/// A row of one of the lists of a plant.
struct RowRef {
  std::uint32_t list = kNone;  ///< index in PlantModel::lists; kNone: the plant does not have the symbol
  std::uint32_t row = 0;       ///< index in the rows of its table

  bool exists() const { return list != kNone; }
  const read::ListRow& in(const model::PlantModel& plant) const { return plant.lists[list].table->rows[row]; }
};

/// A symbol that was added, removed or changed.
struct SymbolChange {
  RowRef before;
  RowRef after;
  Fields fields;  ///< what changed; empty if it was added or removed

  bool added() const { return !before.exists(); }
  bool removed() const { return !after.exists(); }
};

/// Many changes of one cause.
struct Cause {
  enum class Kind : std::uint8_t {
    added,     ///< names that begin with `after`; no old name does
    removed,   ///< names that begin with `before`; no new name does
    replaced,  ///< in names, `after` instead of `before`; `#` is any number that both have
    shifted,   ///< addresses of `before` (inputs, outputs, memory), by `after` (`+4 bytes`)
    retyped,   ///< type `after` instead of `before`
    modelled,  ///< devices with equal changes
  };
  Kind kind = Kind::added;
  std::string before;
  std::string after;
  std::vector<std::uint32_t> members;  ///< indexes of changes, ascending
};
/// The least number of changes that are reported as one cause.
inline constexpr std::size_t kLeastMembers = 4;

/// A part of a model that was gained, lost or changed.
struct ItemChange {
  std::string element;  ///< `state`, `operation`, `transition` ...
  std::string key;      ///< which one: `P1`, `(P1, O_P2) -> P2`; empty if there is only one
  std::optional<std::string> before;
  std::optional<std::string> after;
  bool follows = false;  ///< it follows from another change of the same device: the transitions of a new state
};

/// A device that was added, removed, renamed or changed.
struct DeviceChange {
  std::uint32_t before = kNone;  ///< index in PlantModel::units
  std::uint32_t after = kNone;
  bool renamed = false;
  std::vector<ItemChange> items;

  bool added() const { return before == kNone; }
  bool removed() const { return after == kNone; }
};

struct Difference {
  std::vector<SymbolChange> symbols;  ///< in the order of the new lists, then the removed ones in the old order
  std::vector<Cause> symbol_causes;   ///< by kind, then by the first member
  std::array<std::size_t, 2> rows{};  ///< how many symbols were compared: old, new
  std::vector<DeviceChange> devices;  ///< in the order of the new plant, then the removed ones
  std::vector<Cause> device_causes;
  std::vector<ItemChange> plant;  ///< requirements, followed conditions, material, malfunctions, name
  std::array<std::optional<std::uint64_t>, 2> model_hash;  ///< nothing for a plant with errors
  std::optional<bool> same_model;  ///< compared without the names of the plants; nothing if not comparable

  bool empty() const { return symbols.empty() && devices.empty() && plant.empty() && same_model.value_or(true); }
};

}  // namespace symplant::diff
