// Finds the columns of a GX IEC list, by its header or by its cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "text/source_file.hpp"

namespace symplant::read {

enum class GxField : std::uint8_t { klass, name, vendor_address, iec_address, type, initial, comment };
inline constexpr std::size_t kGxFields = 7;
inline constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// Columns count from 0.
class GxColumns {
 public:
  GxColumns() { columns_.fill(kNoColumn); }
  std::size_t operator[](GxField field) const { return columns_[static_cast<std::size_t>(field)]; }
  void set(GxField field, std::size_t column) { columns_[static_cast<std::size_t>(field)] = column; }
  bool has(GxField field) const { return (*this)[field] != kNoColumn; }
  bool holds(std::size_t column) const;
  std::size_t count() const;

 private:
  std::array<std::size_t, kGxFields> columns_{};
};

struct GxLayout {
  GxColumns columns;
  char delimiter = ',';
  std::optional<std::uint32_t> header_line;  ///< nothing: the list has no header
  std::string header_name;                   ///< the header of the identifier column
  std::size_t rows_begin = 0;                ///< offset of the first row after header and titles
  std::uint32_t rows_line = 1;
};

/// The result of examining the first rows.
struct GxSearch {
  std::optional<GxLayout> layout;
  std::optional<text::Span> nameless_header;  ///< a header without a column of identifiers
  std::optional<std::size_t> unclosed_quote;  ///< the search ended at a quote that is never closed
};

/// Searches the first rows for a header, else for a class column (VAR_GLOBAL ...), with each delimiter.
GxSearch find_gx_layout(std::string_view text);

/// %I, %Q or %M.
bool looks_like_iec_address(std::string_view cell);
/// Up to three letters, then hexadecimal digits: X1F, Y0001, ZR100.
bool looks_like_vendor_address(std::string_view cell);

/// The columns in words, such as `class 1, identifier 2`.
std::string describe(const GxColumns& columns);

}  // namespace symplant::read
