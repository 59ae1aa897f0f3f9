// The state of a plant as a file: --save, --resume, the panel's snapshots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/plant/plant.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::trace {

/// A saved state of a plant.
struct Snapshot {
  std::vector<std::byte> block;  ///< Plant::save()
  std::uint64_t model_hash = 0;
  tables::Time time = 0;  ///< plant time

  static Snapshot of(const plant::Plant& plant);
};

/// Writes a snapshot of the plant of this name: a line of JSON, then the block. The file is complete or unchanged.
/// Returns the reason of a failure, or an empty text. O(block).
std::string write_snapshot(const std::string& path, std::string_view plant_name, const Snapshot& snapshot);

/// What write_snapshot() writes. O(block).
std::string snapshot_bytes(std::string_view plant_name, const Snapshot& snapshot);

struct ReadSnapshot {
  Snapshot snapshot;
  std::string error;  ///< empty: the snapshot is valid
};
/// Reads a snapshot for a plant of this model. Refuses a file of another model, of another version of symplant, and a
/// damaged one. O(file), at most `block` bytes and a line.
ReadSnapshot read_snapshot(const std::string& path, std::uint64_t model_hash, std::size_t block);

}  // namespace symplant::trace
