// The columns of a table of symbols, and the words by which headers name them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "read/cells/csv.hpp"

namespace symplant::read {

enum class Field : std::uint8_t { klass, name, vendor_address, iec_address, type, initial, comment, scope };
inline constexpr std::size_t kFields = 8;
inline constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// The column of each field, counted from 0.
class Columns {
 public:
  Columns() { columns_.fill(kNoColumn); }
  std::size_t operator[](Field field) const { return columns_[static_cast<std::size_t>(field)]; }
  void set(Field field, std::size_t column) { columns_[static_cast<std::size_t>(field)] = column; }
  bool has(Field field) const { return (*this)[field] != kNoColumn; }
  bool has_address() const { return has(Field::vendor_address) || has(Field::iec_address); }
  bool holds(std::size_t column) const;
  std::size_t count() const;

 private:
  std::array<std::size_t, kFields> columns_{};
};

/// "identifier", "vendor address" ...
std::string_view field_name(Field field);

/// The columns in words: "class 1, identifier 2 `Label Name`"; with the header's words if there is a header.
std::string describe(const Columns& columns, std::span<const std::string> header = {});

/// The columns of the fields, short: "name `Tag`, address `Operand`, type `Typ`"; without a header by numbers.
std::string summary_of(const Columns& columns, std::span<const std::string> header);

/// Two columns that name one field equally well.
struct Rivals {
  Field field{};
  std::size_t first = kNoColumn;
  std::size_t second = kNoColumn;
};

struct NamedColumns {
  Columns columns;
  std::optional<Rivals> rivals;  ///< of the identifiers or the addresses; the first of two counts in `columns`
};

/// The columns that a row would name if it were a header, by words in the languages of the tools.
NamedColumns named_columns(const CsvRow& row);

/// The cell as it is compared with the words of headers: lower case, without blanks, dots, `-`, `_` and `/`, and
/// without a language or unit in brackets behind it: `Comment [en-US]`.
std::string header_word(std::string_view cell);

/// VAR, VAR_GLOBAL, VAR_GLOBAL_CONSTANT ...
bool is_class(std::string_view cell);
/// BOOL, Int, `ARRAY [0..7] OF BOOL`, `Word [Signed]` ...
bool is_type(std::string_view cell);
/// %I, %Q or %M.
bool looks_like_iec_address(std::string_view cell);
/// Up to three letters, then hexadecimal digits: X1F, Y0001, ZR100.
bool looks_like_vendor_address(std::string_view cell);

}  // namespace symplant::read
