// Reads and writes addresses of any notation, and recognizes them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "address/address.hpp"
#include "address/dialect.hpp"

namespace symplant::address {

/// Reads an address. Nothing if the text is not one of the notation. Neither allocates nor throws.
std::optional<Address> parse(std::string_view text, const Dialect& dialect);

/// Writes an address in the notation. `parse` reads the text as an equal address. Nothing if the notation has no such
/// address, or the value does not hold its text (Local:1:I.Data, %IX1.2.3).
std::optional<std::string> to_text(const Address& address, const Dialect& dialect);

/// The notation that reads most of the cells, at least half of those that are not empty. Nothing if none does, or if
/// two read equally many and disagree about the area of a cell. SIMATIC's `%I0.0` is valid in IEC 61131-3 as well: it
/// is SIMATIC's unless the cells have other forms of IEC 61131-3.
std::optional<Notation> likely_notation(std::span<const std::string_view> cells);

/// How certainly a text is an address, and not a name: 0 no, 1 perhaps (M1, D10, 40001), 2 yes (X1F, %IX0.5, I 0.0).
int address_strength(std::string_view text);
inline bool looks_like_address(std::string_view text) { return address_strength(text) == 2; }

}  // namespace symplant::address
