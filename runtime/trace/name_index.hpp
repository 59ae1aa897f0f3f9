// Finds a text in a blob of names by its index.
#pragma once

#include <cstddef>
#include <mutex>
#include <string_view>
#include <vector>

namespace symplant::trace {

/// Views into the blob, which must outlive it. The first look-up builds the index, O(blob), since most runs look up no
/// name; others are O(1). Several threads may look up at the same time.
class NameIndex {
 public:
  explicit NameIndex(std::string_view blob) : blob_(blob) {}

  /// Empty if the blob has fewer texts.
  std::string_view operator[](std::size_t index) const;

 private:
  static constexpr std::size_t kStep = 16;  ///< every sixteenth text is in the index

  /// The position after the text at `at`, which ends with a NUL or with the blob.
  std::size_t after(std::size_t at) const;

  std::string_view blob_;
  mutable std::once_flag made_;
  mutable std::vector<std::size_t> starts_;
};

}  // namespace symplant::trace
