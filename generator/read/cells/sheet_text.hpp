// The XML parts of a workbook: sheets, rows and strings, read in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace symplant::read {

struct SheetPart {
  std::string name;
  std::string path;  ///< in the archive
};

/// The sheets that `xl/workbook.xml` lists, with their paths by its relations. The error is a message.
base::Result<std::vector<SheetPart>, std::string> sheet_parts(const std::string& book, const std::string& relations);

/// The strings that cells refer to by number.
class SharedStrings {
 public:
  explicit SharedStrings(std::uint64_t most) : most_(most) {}

  /// Takes whole elements from the front of `rest` and leaves what is incomplete. Returns what is wrong.
  std::optional<std::string> take_from(std::string& rest);
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::uint64_t most_;  ///< bytes of all texts
  std::uint64_t size_ = 0;
  std::vector<std::string> texts_;
};

/// The rows of a sheet as lines of cells separated by TAB.
class SheetText {
 public:
  SheetText(const std::vector<std::string>& strings, std::uint64_t most) : strings_(strings), most_(most) {}

  /// Takes whole rows from the front of `rest` and leaves what is incomplete. Returns what is wrong.
  std::optional<std::string> take_from(std::string& rest);
  std::size_t size() const { return text_.size(); }
  std::string take() { return std::move(text_); }

 private:
  friend class RowWriter;

  const std::vector<std::string>& strings_;
  std::uint64_t most_;       ///< bytes of text
  std::uint32_t lines_ = 0;  ///< rows written
  std::string text_;
};

}  // namespace symplant::read
