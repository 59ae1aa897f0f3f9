// Operations by device and kind of task: what events look for.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/index_table.hpp"
#include "pairing/work.hpp"

namespace symplant::pairing {

/// Operations of one device whose tasks exclude each other.
struct OperationGroup {
  std::uint32_t device = 0;
  std::string_view kind;        ///< TaskReading::group, with the number of the operation if it has one
  std::uint32_t first = kNone;  ///< an operation
  bool numbered = false;        ///< tasks with sequence numbers
  bool fan_out = false;
  bool linked = false;  ///< an event has been found
};

/// The kinds of operations that an event may report, the best first.
class EventKinds {
 public:
  EventKinds(const Work& work, std::uint32_t event);

  const std::string_view* begin() const { return kinds_.data(); }
  const std::string_view* end() const { return kinds_.data() + count_; }

 private:
  std::array<std::string_view, 3> kinds_;
  std::size_t count_ = 0;
};

class OperationGroups {
 public:
  /// Takes all free operations. `work` must outlive this object.
  explicit OperationGroups(const Work& work);

  const std::vector<OperationGroup>& all() const { return groups_; }
  OperationGroup& at(std::uint32_t group) { return groups_[group]; }

  /// kNone without one.
  std::uint32_t find(std::uint32_t device, std::string_view kind) const;
  /// The group of a device that an event reports; kNone if there is none.
  std::uint32_t find(std::uint32_t device, const EventKinds& kinds) const;
  /// The group of an operation that was free.
  std::uint32_t of_operation(std::uint32_t operation) const;

 private:
  const Work& work_;
  std::vector<OperationGroup> groups_;
  base::IndexTable by_kind_;  ///< by device and kind
};

}  // namespace symplant::pairing
