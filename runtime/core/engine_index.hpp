// What the engine looks up while it runs, worked out once from the tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "symplant/core/arena.hpp"
#include "symplant/core/tables.hpp"

namespace symplant::core {

/// A type's transitions by the state they start from, and its operations as masks (bit o: operation o).
struct TypeIndex {
  const Transition* transitions;
  const std::uint32_t* from_begin;  ///< a state -> its first place in from_order; one more at the end
  const std::uint16_t* from_order;  ///< transition numbers by the state they start from, in table order
  const std::uint64_t* starts;      ///< a state -> the operations that are the `on` of a transition from it
  const std::uint64_t* leads;       ///< a state -> the operations leading to it
  const bool* automatic;            ///< a state -> has an automatic transition
  const std::uint64_t* enter;
  const std::uint64_t* leave;
  std::uint64_t operations;  ///< all of them
  std::uint8_t rest;
  Actuation actuation;

  std::span<const std::uint16_t> from(std::uint8_t state) const noexcept {
    return {from_order + from_begin[state], from_order + from_begin[state + 1]};
  }
};

/// A symbol's place, with the one that leads all symbols of its address.
struct SharedPlace {
  std::uint32_t place;   ///< a bit, or kSharedSlot + a slot
  std::uint32_t leader;  ///< likewise
};
inline constexpr std::uint32_t kSharedSlot = 0x8000'0000;

/// All symbols of one direction that share an address with others; empty in almost every plant.
class SharedPlaces {
 public:
  void build(const PlantTables& tables, Direction direction, Arena& arena) noexcept;

  bool empty() const noexcept { return size_ == 0; }
  /// All places of the address that `place` stands on, itself included; empty where it has its address for itself.
  /// O(log shared symbols).
  std::span<const SharedPlace> with(std::uint32_t place) const noexcept;

 private:
  const SharedPlace* by_place_ = nullptr;
  const SharedPlace* by_leader_ = nullptr;
  std::size_t size_ = 0;
};

struct EngineIndex {
  void build(const PlantTables& tables, Arena& arena) noexcept;

  const TypeIndex* types = nullptr;
  const std::uint32_t* unit_of_operation = nullptr;  ///< an operation's bit -> its unit, or kNoUnit
  SharedPlaces shared_operations;
  SharedPlaces shared_events;
};

}  // namespace symplant::core
