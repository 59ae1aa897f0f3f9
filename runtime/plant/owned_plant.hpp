// A plant that allocates its own memory.
#pragma once

#include <cstddef>
#include <span>

#include "symplant/plant/plant.hpp"

namespace symplant::plant {

namespace detail {
/// A base class, so that the memory is allocated before the plant that uses it. Owns it without <memory>, which takes
/// half of the time to compile a small generated plant.
class PlantMemory {
 public:
  PlantMemory(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours)
      : size_(Plant::memory_size(tables, behaviours)),
        bytes_(new std::max_align_t[size_ / sizeof(std::max_align_t) + 1]()) {}
  ~PlantMemory() { delete[] bytes_; }
  PlantMemory(const PlantMemory&) = delete;
  PlantMemory& operator=(const PlantMemory&) = delete;

  std::span<std::byte> span() const { return {reinterpret_cast<std::byte*>(bytes_), size_}; }

 private:
  std::size_t size_;
  std::max_align_t* bytes_;
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
