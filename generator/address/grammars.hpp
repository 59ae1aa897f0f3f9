// Reads and writes the addresses of each notation. Each grammar is in a separate .cpp file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "address/address.hpp"
#include "address/dialect.hpp"

namespace symplant::address {

// Readers: nothing if the text is not an address of the notation. They neither allocate nor throw.

/// English and German mnemonics, with or without `%`: I0.0, E 2.6, PIW 64, %IW64:P; M, L, T, C, DB and blocks are
/// memory. Bytes are numbered: IW64 is bytes 64 and 65.
std::optional<Address> parse_siemens(std::string_view text);
/// Resolved tags: Local:1:I.Data.0; files of PLC-5 and SLC: I:1/0. Texts without a module are memory.
std::optional<Address> parse_rockwell(std::string_view text);
/// Words and bits of CS, CJ and CP CPUs: 1052.02, W10.00, D20042. CIO is memory outside of `ranges`.
std::optional<Address> parse_omron(std::string_view text, const IoRanges* ranges);
/// Reference numbers of 5 or 6 digits: 10001, 400001, with a bit 30001.3.
std::optional<Address> parse_modbus(std::string_view text);

/// Like parse_iec() and parse_melsec(), but always by the grammar; those functions use it only for unusual addresses.
/// For tests.
std::optional<Address> parse_iec_by_grammar(std::string_view text);
std::optional<Address> parse_melsec_by_grammar(std::string_view text, Radix radix);

// Writers: nothing if the notation has no such address, or the value does not hold its text.

std::optional<std::string> iec_text(const Address& address, Radix);
std::optional<std::string> melsec_text(const Address& address, Radix radix);
std::optional<std::string> siemens_text(const Address& address, Radix);
std::optional<std::string> omron_text(const Address& address, Radix);
std::optional<std::string> modbus_text(const Address& address, Radix);

}  // namespace symplant::address
