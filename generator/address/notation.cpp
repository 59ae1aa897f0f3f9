// The table of notations.
#include "address/notation.hpp"

#include <array>

#include "address/grammars.hpp"

namespace symplant::address {

namespace {

using Writer = std::optional<std::string> (*)(const Address& address, Radix radix);

/// In the order of Notation; a resolved tag is only in its text.
constexpr std::array<Writer, 6> kWriters{iec_text, melsec_text, siemens_text, nullptr, omron_text, modbus_text};

}  // namespace

std::optional<Address> parse(std::string_view text, const Dialect& dialect) {
  switch (dialect.notation) {
    case Notation::iec:
      return parse_iec(text);
    case Notation::melsec:
      return parse_melsec(text, dialect.radix);
    case Notation::siemens:
      return parse_siemens(text);
    case Notation::rockwell:
      return parse_rockwell(text);
    case Notation::omron:
      return parse_omron(text, dialect.ranges);
    case Notation::modbus:
      return parse_modbus(text);
  }
  return std::nullopt;
}

std::optional<std::string> to_text(const Address& address, const Dialect& dialect) {
  const Writer writer = kWriters[static_cast<std::size_t>(dialect.notation)];
  return writer == nullptr ? std::nullopt : writer(address, dialect.radix);
}

}  // namespace symplant::address
