// Collects the faults of a description.
#pragma once

#include <array>
#include <concepts>
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

/// "state `X` of `Y` not found; did you mean `Z`?", from "state `X` of `Y`"; `nearest` may be empty.
std::string missing(const std::string& what, std::string_view nearest);

/// A JSON pointer, extended key by key. Keys must outlive it: only text() copies them, since few pointers become the
/// location of a fault.
class Pointer {
 public:
  explicit Pointer(std::string begin) : begin_(std::move(begin)) {}
  Pointer operator/(std::string_view key) const { return grown({key, 0}); }
  template <std::same_as<std::string> Key>
  Pointer operator/(Key&& key) const = delete;  // the key would not outlive the pointer
  Pointer operator/(std::size_t index) const { return grown({{}, index}); }
  /// O(the text).
  std::string text() const;

  /// A pointer into an entry that is resolved for each device or symbol that the pattern matches. The pattern must
  /// outlive it.
  Pointer matched_by(std::string_view pattern) const;

  /// The pattern whose entry it points into; null if there is none.
  const DeviceDescription* pattern() const { return pattern_; }
  DeviceKey key() const { return key_; }
  /// The text of that pattern, or of matched_by(); empty: none.
  std::string_view pattern_text() const { return pattern_ == nullptr ? matched_by_ : pattern_->path; }

 private:
  friend Pointer key_pointer(const DeviceDescription& device, DeviceKey key);

  /// A key; an index if `key.data()` is null.
  struct Step {
    std::string_view key;
    std::size_t index = 0;
  };
  Pointer grown(const Step& step) const;

  std::string begin_;
  std::array<Step, 6> steps_{};
  std::size_t count_ = 0;
  const DeviceDescription* pattern_ = nullptr;
  std::string_view matched_by_;
  DeviceKey key_{};
  bool fixed_ = false;  ///< the operator `/` does not extend it
};

/// "/devices/L_P_D"; for a joined description its most specific entry.
Pointer device_pointer(const DeviceDescription& device);
/// "/devices/L_P_*/transitions": in the entry that gives the key. For a key that the naming rule gives, the pointer to
/// the device.
Pointer key_pointer(const DeviceDescription& device, DeviceKey key);

/// The kind of thing that a name in the entry of a device refers to.
enum class Named : std::uint8_t { state, operation, event };
std::string_view named_text(Named what);

/// Collects faults. An entry under a pattern is resolved for each matching device, but its fault is reported once. A
/// name that only some of the devices lack is a warning.
class Faults {
 public:
  Faults(std::vector<DescriptionFault>& faults, std::vector<DescriptionFault>& warnings)
      : faults_(faults), warnings_(warnings) {}

  void add(const Pointer& at, std::string message, FaultKind kind = FaultKind::contradiction, std::size_t column = 0);
  void add(DescriptionFault fault) { faults_.push_back(std::move(fault)); }
  void warn(const Pointer& at, std::string message, FaultKind kind) {
    warnings_.push_back({at.text(), std::move(message), 0, kind});
  }

  /// Counts a device for each pattern entry that it takes a key from.
  void describes(const DeviceDescription& described);
  /// Records that the device of that path lacks the name at `at`, which is left out for it. Under an exact device name
  /// this is a fault with the text of `message()`.
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
  /// Whether any device that matches a pattern has the name.
  using SomeHave = std::function<bool(std::string_view pattern, Named what, std::string_view name)>;
  /// Reports the names that devices lack. Call once, after all devices have been described.
  void report_lacks(const SomeHave& some_have);

  /// The nearest of `count` names, each given by `name_at(i)`. Returns an empty name after some millions of
  /// comparisons: a plant may have a hundred thousand names, and a description as many typing mistakes.
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

  /// A name under a pattern that devices lack.
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
  std::unordered_map<std::string, std::size_t> reported_;  ///< under a pattern: location -> index in faults_
  /// The number of devices that take each key from a pattern's entry.
  std::unordered_map<const DeviceDescription*, std::array<std::size_t, kDeviceKeys>> takers_;
  std::map<std::pair<std::string, Named>, Lack> lacks_;
  mutable std::size_t comparisons_left_ = 4'000'000;
};

}  // namespace symplant::description
