// Operations by device, group of tasks and index: what events look for.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "pairing/work.hpp"

namespace symplant::pairing {

/// The tasks that exclude each other, of one device.
struct GroupKey {
  std::uint32_t device = 0;
  std::string_view group;
  std::string_view index;  ///< of the operation, where a device has several of one kind: CLAMP1, CLAMP2

  friend bool operator==(const GroupKey& a, const GroupKey& b);
};

/// Operations that exclude each other.
struct OperationGroup {
  GroupKey key;
  std::uint32_t first = kNone;  ///< an operation
  bool numbered = false;        ///< tasks with sequence numbers
  bool fan_out = false;
  bool alone = true;    ///< its device has no operations of this kind with another index
  bool linked = false;  ///< an event has been found
};

class OperationGroups {
 public:
  /// Takes all free operations. `work` must outlive this object.
  explicit OperationGroups(const Work& work);

  const std::vector<OperationGroup>& all() const { return groups_; }
  OperationGroup& at(std::uint32_t group) { return groups_[group]; }

  /// The group of an operation that was free.
  std::uint32_t of_operation(std::uint32_t operation) const;
  /// The group that an event with the task of `event` belongs to in a device; kNone if there is none.
  std::uint32_t find(std::uint32_t device, std::uint32_t event) const;
  /// Whether a device has an operation that excludes the task of `event`, with any index.
  bool has_kind(std::uint32_t device, std::uint32_t event) const;
  /// The kind of a symbol's task.
  std::string_view kind_of(std::uint32_t input) const;

 private:
  bool is_numbered(std::uint32_t input) const;
  GroupKey key_of(std::uint32_t input) const;
  std::uint32_t find(const GroupKey& key) const;
  std::uint32_t find_kind(std::uint32_t device, std::string_view group) const;

  const Work& work_;
  std::vector<OperationGroup> groups_;
  base::IndexTable by_key_;
  base::IndexTable by_kind_;  ///< device and group -> the first of their operations
};

}  // namespace symplant::pairing
