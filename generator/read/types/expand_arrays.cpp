// Gives each element of an array of inputs or outputs a row.
#include "read/types/expand_arrays.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "address/bits.hpp"
#include "address/notation.hpp"
#include "read/rules/array_too_large.hpp"
#include "read/types/array_type.hpp"
#include "read/types/data_types.hpp"

namespace symplant::read {
namespace {

using address::Address;
using address::Dialect;
using address::Notation;

/// The address of an array's first element, and how the others are written.
struct FirstAddress {
  Address address;
  Dialect dialect;
  std::string_view cell;
  bool in_iec_column = false;
};

class ArrayExpander {
 public:
  ArrayExpander(SymbolTable& table, address::Radix radix, diag::Diagnostics& diagnostics)
      : table_(table), dialect_{table.notation, radix}, diagnostics_(diagnostics) {}

  void run() {
    std::vector<ListRow> rows;
    rows.reserve(table_.rows.size());
    for (const ListRow& row : table_.rows) {
      const auto array = may_be_array(row.type) ? parse_array_type(row.type) : std::nullopt;
      const auto first = array ? first_address(row, *array) : std::nullopt;
      if (first) {
        expand(row, *array, *first, rows);
      } else {
        rows.push_back(row);
      }
    }
    table_.rows = std::move(rows);
    if (arrays_ != 0) {
      table_.decisions.push_back("arrays of inputs or outputs: " + std::to_string(arrays_) + ", with " +
                                 std::to_string(elements_) + " elements");
    }
  }

 private:
  /// Nothing if the array is no input or output, or if its other elements have no addresses.
  std::optional<FirstAddress> first_address(const ListRow& row, const ArrayType& array) const {
    std::optional<FirstAddress> first;
    // The IEC address alone is enough, and its number does not depend on how X and Y count.
    for (const bool iec_column : {true, false}) {
      const std::string_view cell = iec_column ? row.iec_address : row.vendor_address;
      if (cell.empty() || first) continue;
      const Dialect iec{Notation::iec};
      first = read_first(cell, iec_column ? iec : dialect_);
      if (!first) first = read_first(cell, iec_column ? dialect_ : iec);
      if (first) first->in_iec_column = iec_column;
    }
    if (!first || first->address.area == address::Area::memory) return std::nullopt;
    const int bits = data_type_bits(array.type);
    if (first->address.sized && static_cast<int>(first->address.size) != bits) return std::nullopt;
    if (first->address.assigned && !address::to_text(first->address, first->dialect)) return std::nullopt;
    return first;
  }

  static std::optional<FirstAddress> read_first(std::string_view cell, const Dialect& dialect) {
    const auto address = address::parse(cell, dialect);
    if (!address) return std::nullopt;
    return FirstAddress{*address, dialect, cell};
  }

  void expand(const ListRow& row, const ArrayType& array, const FirstAddress& first, std::vector<ListRow>& rows) {
    const std::uint64_t wanted = array.count(kMostElements + 1);
    const std::uint64_t count = std::min({wanted, kMostElements, kMostElementsOfList - elements_});
    std::vector<std::int64_t> index;
    for (const ArrayType::Dimension& dimension : array.dimensions) index.push_back(dimension.first);
    std::uint64_t made = 0;
    for (; made < count; ++made) {
      const auto address = text_of(first, made);
      if (!address) break;
      ListRow element = row;
      element.name = keep(std::string(row.name) + index_text(index));
      element.vendor_address = first.in_iec_column ? std::string_view() : *address;
      element.iec_address = first.in_iec_column ? *address : std::string_view();
      element.type = array.element;
      element.initial = {};
      rows.push_back(element);
      advance(index, array);
    }
    ++arrays_;
    elements_ += made;
    if (made < wanted) report_cut(row, made, made < count);
  }

  std::optional<std::string_view> text_of(const FirstAddress& first, std::uint64_t element) {
    if (!first.address.assigned || element == 0) return first.cell;
    const auto address = address::advanced(first.address, element);
    auto text = address ? address::to_text(*address, first.dialect) : std::nullopt;
    if (!text) return std::nullopt;
    return keep(std::move(*text));
  }

  static std::string index_text(const std::vector<std::int64_t>& index) {
    std::string text;
    for (const std::int64_t at : index) text.append(text.empty() ? "[" : ",").append(std::to_string(at));
    return text + "]";
  }

  static void advance(std::vector<std::int64_t>& index, const ArrayType& array) {
    for (std::size_t d = index.size(); d-- > 0;) {
      if (index[d] != array.dimensions[d].last) {
        ++index[d];
        return;
      }
      index[d] = array.dimensions[d].first;
    }
  }

  void report_cut(const ListRow& row, std::uint64_t made, bool at_end) {
    const bool of_list = elements_ == kMostElementsOfList;
    diagnostics_.add(
        kArrayTooLarge,
        "`" + std::string(row.name) + "` is `" + std::string(row.type) + "`: " +
            (made == 0 ? "all of its elements are" : "its elements after the first " + std::to_string(made) + " are") +
            " left out, since " +
            (at_end    ? "addresses end there"
             : of_list ? "the arrays of a list may have " + std::to_string(kMostElementsOfList)
                       : "an array may have " + std::to_string(kMostElements)) +
            "; declare what is wired of the others as symbols of elementary types",
        {table_.source, table_.source->span_of(row.type, row.whole)});
  }

  std::string_view keep(std::string text) { return table_.arena.emplace_back(std::move(text)); }

  SymbolTable& table_;
  const Dialect dialect_;
  diag::Diagnostics& diagnostics_;
  std::size_t arrays_ = 0;
  std::uint64_t elements_ = 0;
};

}  // namespace

void expand_arrays(SymbolTable& table, address::Radix radix, diag::Diagnostics& diagnostics) {
  const auto is_array = [](const ListRow& row) { return may_be_array(row.type); };
  if (std::none_of(table.rows.begin(), table.rows.end(), is_array)) return;
  ArrayExpander(table, radix, diagnostics).run();
}

}  // namespace symplant::read
