// Faults of a description, as they are found.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/description.hpp"
#include "symplant/condition/nearest.hpp"

namespace symplant::model {

/// Text in back-ticks, for a message.
std::string quoted(std::string_view text);

/// "there is no state `X` of `Y`, the nearest is `Z`", from "state `X` of `Y`"; `nearest` may be empty.
std::string missing(const std::string& what, std::string_view nearest);

class Faults {
 public:
  explicit Faults(std::vector<DescriptionFault>& faults) : faults_(faults) {}

  void add(std::string pointer, std::string message, std::size_t column = 0) {
    faults_.push_back({std::move(pointer), std::move(message), column});
  }

  /// The nearest of `count` names, `name_at(i)` each. A plant may have a hundred thousand, a description as many slips:
  /// after some millions of comparisons there is no nearest one any more.
  template <class NameAt>
  std::string_view nearest(std::string_view wanted, std::size_t count, NameAt&& name_at) const {
    if (count > comparisons_left_) return {};
    comparisons_left_ -= count;
    condition::NearestName nearest(wanted);
    for (std::size_t i = 0; i < count; ++i) nearest.offer(name_at(i));
    return nearest.name();
  }

 private:
  std::vector<DescriptionFault>& faults_;
  mutable std::size_t comparisons_left_ = 4'000'000;
};

/// A JSON pointer, grown key by key.
class Pointer {
 public:
  explicit Pointer(std::string text) : text_(std::move(text)) {}
  Pointer operator/(std::string_view key) const;
  Pointer operator/(std::size_t index) const { return Pointer(text_ + "/" + std::to_string(index)); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// "/devices/L_P_D"
Pointer device_pointer(const DeviceDescription& device);

}  // namespace symplant::model
