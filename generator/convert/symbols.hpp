// The rows of all lists of a plant, as the writers take them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "address/address.hpp"
#include "address/notation.hpp"
#include "read/symbol_table.hpp"

namespace symplant::convert {

/// What a row declares. An input or output has a type that symplant serves; all other rows are internal.
enum class Kind : std::uint8_t { input, output, internal, constant };

struct Symbol {
  const read::ListRow* row = nullptr;                   ///< name, type, initial value and comment as they were read
  const read::RowExtra* extra = nullptr;                ///< never null in symbols_of()
  address::Notation notation = address::Notation::iec;  ///< of the row's vendor address
  const address::IoRanges* io_words = nullptr;          ///< of its list: which words of CIO are inputs or outputs
  Kind kind = Kind::internal;
  bool octal = false;  ///< X and Y of its list count in octal
  std::optional<address::Address> address;

  /// How its vendor address is read.
  address::Dialect address_dialect() const {
    return {notation, octal ? address::Radix::octal : address::Radix::hexadecimal, io_words};
  }
};

/// One list of a plant.
struct List {
  std::shared_ptr<const read::SymbolTable> table;
  std::string controller;            ///< the controller that it belongs to; empty: the default one
  std::optional<address::Radix> xy;  ///< how X and Y count if no row proves it
};

struct Symbols {
  std::vector<std::shared_ptr<const read::SymbolTable>> tables;  ///< hold what the symbols point to
  std::vector<Symbol> all;                                       ///< in the order of lists and rows
  std::size_t controllers = 0;
  std::deque<read::ListRow> rows;  ///< rows of symbols that were renamed
  std::deque<std::string> texts;   ///< the new names
};

/// O(rows).
Symbols symbols_of(std::span<const List> lists);

}  // namespace symplant::convert
