// "Did you mean": finds the known name that is nearest to a mistyped one.
#pragma once

#include <cstddef>
#include <string_view>

namespace symplant::tables {

/// Keeps the offered name that is nearest to the wanted one, without regard to the case of ASCII letters; of equally
/// near names the first. A letter left out, added or changed, and two adjacent letters exchanged, count one each.
class NearestName {
 public:
  explicit NearestName(std::string_view wanted);

  /// O(product of both lengths); O(1) if the lengths alone show that the name is too far. `name` must outlive the
  /// result.
  void offer(std::string_view name);
  /// Empty if the distance of every offered name exceeds max(1, length of the wanted name / 3).
  std::string_view name() const { return name_; }

 private:
  std::string_view wanted_;
  std::size_t distance_;  ///< a name is accepted only below this distance
  std::string_view name_;
};

}  // namespace symplant::tables
