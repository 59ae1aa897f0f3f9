// The variables of the server: their values, statuses and times, as clients read them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symplant/link/image/images.hpp"
#include "symplant/link/image/map.hpp"
#include "symplant/link/opc_ua/data_types.hpp"
#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/link/opc_ua/plant_image.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// A variable of the server.
struct Variable {
  enum class Kind : std::uint8_t {
    operation,  ///< of a symbol, as clients write it
    event,      ///< of a symbol
    output,     ///< of a value
    state,      ///< of a unit, by name
    target,
    moving,
    progress,
    active,      ///< of a written malfunction
    cycles,      ///< of the plant
    plant_time,  ///< of the plant, in s
    frozen,      ///< of the plant
  };
  Kind kind = Kind::operation;
  std::uint32_t of = 0;  ///< point of the map, output, unit or malfunction
  tables::DataType type = tables::DataType::boolean;
  Scalar value = Scalar(0, tables::DataType::boolean);
  const UA_String* text = nullptr;  ///< instead of `value`: the name of a state
  bool decided = false;             ///< by a malfunction
  UA_DateTime since = 0;            ///< of the value or the status; 0: not known
  std::uint32_t monitored = 0;      ///< items that monitor the value
};

/// Used by the server's thread. The cost of an update follows the words that changed.
class Variables {
 public:
  /// All arguments must outlive it. With `initial`, values are good before the first cycle.
  Variables(const tables::PlantTables& tables, const image::Map& map, image::Images& images, PlantImage& plant,
            bool initial);
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;

  /// The variables of the points of the map come first, in their order. None is added later.
  std::span<Variable> all() noexcept { return all_; }

  /// The value as the server gives it to a client; valid until the next update.
  UA_DataValue value_of(const Variable& variable) const noexcept;

  /// Takes the images of the latest cycle, and the operations as written, unless changes of the last images remain.
  /// Calls `changed(variable)` for at most `most` of the monitored variables whose value or status is another one.
  /// Returns whether changes remain.
  template <class Changed>
  bool update(std::size_t most, Changed changed) {
    if (changed_.empty()) take();
    const std::size_t remaining = changed_.size() - std::min(most, changed_.size());
    for (std::size_t i = remaining; i < changed_.size(); ++i) changed(*changed_[i]);
    changed_.resize(remaining);
    return remaining != 0;
  }

  /// The value of an operation that a client has just written: `number` as image::number_of() makes it.
  void wrote(Variable& variable, std::uint64_t number) noexcept;

 private:
  /// The variables that show a word of a plane or of the plant: those of word w are rows[first[w]] up to
  /// rows[first[w + 1]], without the latter.
  struct ByWord {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> rows;
    std::vector<std::uint64_t> seen;  ///< the words at the last update
  };

  void add_states(const tables::PlantTables& tables);
  std::size_t word_of(const Variable& variable) const noexcept;
  ByWord by_word(std::size_t words, std::size_t group) const;
  std::size_t group_of(const Variable& variable) const noexcept;
  void take();
  template <class Refresh>
  void refresh(ByWord& group, std::span<const std::uint64_t> words, Refresh again);
  void refresh_value(Variable& variable, std::span<const std::uint64_t> words) noexcept;
  void refresh_plant(std::span<const std::uint64_t> words);
  void note(Variable& variable, bool changed);
  bool set(Variable& variable, std::uint64_t number) noexcept;

  const tables::PlantTables& tables_;
  const image::Map& map_;
  image::Images& images_;
  PlantImage& plant_;
  bool ready_;
  UA_DateTime time_ = 0;  ///< of the images taken last
  std::vector<Variable> all_;
  std::vector<std::uint32_t> first_states_;  ///< by type, in state_names_
  std::vector<UA_String> state_names_;       ///< views into the tables
  std::array<ByWord, kPlanes + 1> groups_;   ///< of each plane, and of the plant
  std::vector<Variable*> changed_;
};

}  // namespace symplant::link::opc_ua
