// A plant with its own memory, for who does not want to place it himself.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "symplant/plant/plant.hpp"

namespace symplant::plant {

namespace detail {
/// A base so that the memory is there before the plant that lies in it.
struct PlantMemory {
  PlantMemory(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours)
      : size(Plant::memory_size(tables, behaviours)),
        bytes(std::make_unique<std::max_align_t[]>(size / sizeof(std::max_align_t) + 1)) {}

  std::span<std::byte> span() const { return {reinterpret_cast<std::byte*>(bytes.get()), size}; }

  std::size_t size;
  std::unique_ptr<std::max_align_t[]> bytes;
};
}  // namespace detail

/// Allocates once, when it is made; throws std::bad_alloc there and nothing later. `tables` must outlive it.
class OwnedPlant : private detail::PlantMemory, public Plant {
 public:
  explicit OwnedPlant(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours = {})
      : PlantMemory(tables, behaviours), Plant(tables, PlantMemory::span(), behaviours) {}
  explicit OwnedPlant(const tables::PlantTables&&,
                      std::span<const engine::Behaviour> = {}) = delete;  // would not outlive it
};

}  // namespace symplant::plant
