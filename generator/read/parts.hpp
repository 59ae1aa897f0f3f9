// Texts that hold several lists one after the other.
#pragma once

#include <cstddef>
#include <vector>

#include "address/address.hpp"
#include "read/symbol_table.hpp"

namespace symplant::read {

/// The rows at which another list begins: below a repeated header, else where I/O addresses start over, that is where
/// most of the next rows have addresses of the rows before. O(rows).
std::vector<std::size_t> find_parts(const SymbolTable& table, address::Radix radix);

/// Removes all rows but those of one part, counted from 1. False if there is no such part.
bool keep_part(SymbolTable& table, std::size_t part, const std::vector<std::size_t>& begins);

}  // namespace symplant::read
