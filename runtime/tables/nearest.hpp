// "Did you mean": the name that a slip of the keyboard most likely stood for.
#pragma once

#include <cstddef>
#include <string_view>

namespace symplant::tables {

/// Of the names offered the one nearest to the wanted one, without regard to the case of ASCII letters; the first of
/// several. Letters left out, added, changed, and two side by side exchanged count one each.
class NearestName {
 public:
  explicit NearestName(std::string_view wanted);

  /// O(both lengths) and less where the lengths alone say that it is too far. `name` must outlive the answer.
  void offer(std::string_view name);
  /// Empty where none is nearer than a third of its length (at least one slip).
  std::string_view name() const { return name_; }

 private:
  std::string_view wanted_;
  std::size_t distance_;  ///< only what is below counts
  std::string_view name_;
};

}  // namespace symplant::tables
