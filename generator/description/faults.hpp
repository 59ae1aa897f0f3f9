// Faults of a description, as they are found.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "description/description.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::description {

/// Text in back-ticks, for a message.
std::string ticked(std::string_view text);

/// "there is no state `X` of `Y`, the nearest is `Z`", from "state `X` of `Y`"; `nearest` may be empty.
std::string missing(const std::string& what, std::string_view nearest);

/// A JSON pointer, grown key by key.
class Pointer {
 public:
  explicit Pointer(std::string text) : text_(std::move(text)) {}
  Pointer operator/(std::string_view key) const;
  Pointer operator/(std::size_t index) const;
  const std::string& text() const { return text_; }

  /// The pattern whose entry it leads into, and which of its keys; null: none.
  const DeviceDescription* pattern() const { return pattern_; }
  DeviceKey key() const { return key_; }

 private:
  friend Pointer key_pointer(const DeviceDescription& device, DeviceKey key);

  std::string text_;
  const DeviceDescription* pattern_ = nullptr;
  DeviceKey key_{};
};

/// "/devices/L_P_D"; of a joined one the most specific of its entries.
Pointer device_pointer(const DeviceDescription& device);
/// "/devices/L_P_*/transitions": of the entry that the key is of.
Pointer key_pointer(const DeviceDescription& device, DeviceKey key);

/// What a name in the entry of a device names.
enum class Named : std::uint8_t { state, operation, event };
std::string_view named_text(Named what);

/// Collects faults. What stands under a pattern is met once a device: it is told once, and what only some of the
/// devices lack is a warning.
class Faults {
 public:
  Faults(std::vector<DescriptionFault>& faults, std::vector<DescriptionFault>& warnings)
      : faults_(faults), warnings_(warnings) {}

  void add(const Pointer& at, std::string message, FaultKind kind = FaultKind::contradiction, std::size_t column = 0);
  void add(DescriptionFault fault) { faults_.push_back(std::move(fault)); }
  void warn(const Pointer& at, std::string message, FaultKind kind) {
    warnings_.push_back({at.text(), std::move(message), 0, kind});
  }

  /// A device is described so: what its patterns' entries name can be lacked.
  void describes(const DeviceDescription& described);
  /// The device of that path lacks what is named at `at`; what names it is left out. Under an exact name that is a
  /// fault, told by `message()`.
  template <class Message>
  void lacks(const Pointer& at, std::string_view path, Named what, std::string_view name, Message&& message) {
    if (at.pattern() == nullptr) {
      add(at, message(), FaultKind::unknown_name);
      return;
    }
    Lack& lack = lacks_[{at.text(), what}];
    if (lack.count++ == 0) {
      lack.pattern = at.pattern();
      lack.key = at.key();
      lack.name = name;
      lack.message = message();
    }
    if (lack.paths.size() < kMostNamed) lack.paths.push_back(path);
  }
  /// Whether any device that matches a pattern has what is named.
  using SomeHave = std::function<bool(std::string_view pattern, Named what, std::string_view name)>;
  /// Reports what devices lack; called once all of them have been described.
  void report_lacks(const SomeHave& some_have);

  /// The nearest of `count` names, `name_at(i)` each. A plant may have a hundred thousand, a description as many slips:
  /// after some millions of comparisons there is no nearest one any more.
  template <class NameAt>
  std::string_view nearest(std::string_view wanted, std::size_t count, NameAt&& name_at) const {
    if (count > comparisons_left_) return {};
    comparisons_left_ -= count;
    tables::NearestName nearest(wanted);
    for (std::size_t i = 0; i < count; ++i) nearest.offer(name_at(i));
    return nearest.name();
  }

 private:
  static constexpr std::size_t kMostNamed = 3;

  /// Something that stands under a pattern and is lacked.
  struct Lack {
    const DeviceDescription* pattern = nullptr;
    DeviceKey key{};
    std::string name;
    std::size_t count = 0;  ///< of devices that lack it
    std::vector<std::string_view> paths;
    std::string message;
  };

  std::vector<DescriptionFault>& faults_;
  std::vector<DescriptionFault>& warnings_;
  std::unordered_map<std::string, std::size_t> reported_;  ///< under a pattern: place -> where in faults_, from 0
  /// How many devices take each key from a pattern's entry.
  std::unordered_map<const DeviceDescription*, std::array<std::size_t, kDeviceKeys>> takers_;
  std::map<std::pair<std::string, Named>, Lack> lacks_;
  mutable std::size_t comparisons_left_ = 4'000'000;
};

}  // namespace symplant::description
