// Keeps the levels of each device once, and numbers devices.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <string_view>

#include "base/index_table.hpp"
#include "name/reading.hpp"
#include "name/text_store.hpp"

namespace symplant::name {

/// Levels that differ only in the case of letters are one device.
class DeviceStore {
 public:
  enum class Case {
    ascii,
    unicode
  };  ///< whose case is ignored: ASCII letters, or all that Unicode's folding makes equal

  explicit DeviceStore(Case ignored) : ignored_(ignored) {}

  using Texts = std::array<std::string_view, 3>;  ///< line, process, device

  /// If `path` is not empty, it is the joined text, and the texts must outlive the store; else they are copied.
  /// O(texts).
  const DeviceLevels* find_or_add(const Texts& texts, std::string_view path);
  std::uint32_t size() const { return devices_; }

 private:
  const DeviceLevels* add(const Texts& texts, std::string_view path);
  std::uint64_t hash_of(std::string_view level) const;
  bool is_same(std::string_view a, std::string_view b) const;

  Case ignored_;
  std::deque<DeviceLevels> levels_;  ///< by exact spelling
  base::IndexTable by_text_;
  std::uint32_t devices_ = 0;
  TextStore texts_;
  base::IndexTable by_folded_;          ///< the first of `levels_` of each device
  base::IndexTable by_process_;         ///< the first of `levels_` of each line and process
  const DeviceLevels* last_ = nullptr;  ///< rows of one device are mostly adjacent
};

}  // namespace symplant::name
