// A plant that allocates its own memory.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "symplant/plant/plant.hpp"

namespace symplant::plant {

namespace detail {
/// A base class, so that the memory is allocated before the plant that uses it.
struct PlantMemory {
  PlantMemory(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours)
      : size(Plant::memory_size(tables, behaviours)),
        bytes(std::make_unique<std::max_align_t[]>(size / sizeof(std::max_align_t) + 1)) {}

  std::span<std::byte> span() const { return {reinterpret_cast<std::byte*>(bytes.get()), size}; }

  std::size_t size;
  std::unique_ptr<std::max_align_t[]> bytes;
};
}  // namespace detail

/// Only the constructor allocates, and may throw std::bad_alloc. `tables` and `behaviours` must outlive the plant.
class OwnedPlant : private detail::PlantMemory, public Plant {
 public:
  explicit OwnedPlant(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours = {})
      : PlantMemory(tables, behaviours), Plant(tables, PlantMemory::span(), behaviours) {}
  explicit OwnedPlant(const tables::PlantTables&&,
                      std::span<const engine::Behaviour> = {}) = delete;  // tables must outlive it
};

}  // namespace symplant::plant
