// Decides which rows are I/O.
#include "model/classify.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string>

#include "text/ascii.hpp"
#include "text/truth.hpp"

namespace symplant::model {
namespace {

using tables::DataType;

bool starts_with_ignoring_case(std::string_view text, std::string_view prefix) {
  return text.size() >= prefix.size() && text::equal_ignoring_case(text.substr(0, prefix.size()), prefix);
}

bool is_signed(DataType type) {
  return type == DataType::sint || type == DataType::int_ || type == DataType::dint || type == DataType::lint;
}

std::optional<std::uint64_t> integer(std::string_view text, DataType type) {
  int radix = 10;
  bool negative = false;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  if (starts_with_ignoring_case(text, "16#")) radix = 16;
  if (starts_with_ignoring_case(text, "8#")) radix = 8;
  if (starts_with_ignoring_case(text, "2#")) radix = 2;
  if (radix != 10) text.remove_prefix(text.find('#') + 1);
  std::string digits;
  for (const char c : text) {
    if (c != '_') digits += c;
  }
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, radix);
  if (error != std::errc{} || end != digits.data() + digits.size() || digits.empty()) return std::nullopt;
  const int bits = data_type_bits(type);
  const std::uint64_t all = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  const std::uint64_t most = is_signed(type) && radix == 10 ? all / 2 + (negative ? 1 : 0) : all;
  if (value > most || (negative && !is_signed(type))) return std::nullopt;
  if (negative) value = ~value + 1;
  if (is_signed(type) && radix != 10 && (value & (all / 2 + 1)) != 0) value |= ~all;  // the sign, as 16#FFFF has it
  return value;
}

std::optional<std::uint64_t> truth(std::string_view text) {
  if (text == "1" || text == "0") return text == "1" ? 1 : 0;
  const auto word = text::truth_of(text);
  return word ? std::optional<std::uint64_t>(*word ? 1 : 0) : std::nullopt;
}

/// `12.5`, or `12,5` of a tool whose language writes a comma.
std::optional<std::uint64_t> number_of_real(std::string_view text) {
  std::string point(text);
  if (text.find('.') == text.npos) std::replace(point.begin(), point.end(), ',', '.');
  text = point;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return std::bit_cast<std::uint64_t>(value);
}

/// Whether equal values mean equal addresses. Addresses in memory have only a comparable area.
bool can_compare(const address::Address& a, const address::Address& b) {
  if (a.area != b.area) return true;
  return a.area != address::Area::memory && a.plain && b.plain && a.size == b.size;
}

/// Rows that prove one of the two radices.
struct RadixProof {
  std::size_t count = 0;
  const read::ListRow* proof = nullptr;  ///< the first of them
};

struct RadixVotes {
  RadixProof hexadecimal;
  RadixProof octal;
  const read::ListRow* not_octal = nullptr;  ///< the first row with a digit of 8 to F, without an IEC address

  void take(const read::ListRow& row, RadixChoice& choice) {
    const char first = row.vendor_address.empty() ? '\0' : text::upper(row.vendor_address.front());
    if (first != 'X' && first != 'Y') return;
    const auto as_hexadecimal = address::parse_melsec(row.vendor_address, address::Radix::hexadecimal);
    if (!as_hexadecimal || as_hexadecimal->number < 8) return;  // equal in both radices
    const auto iec = address::parse_iec(row.iec_address);
    if (iec && iec == as_hexadecimal) return add(hexadecimal, row);
    const auto as_octal = address::parse_melsec(row.vendor_address, address::Radix::octal);
    if (iec && iec == as_octal) return add(octal, row);
    if (!iec && choice.matters_in == nullptr) choice.matters_in = &row;
    if (!iec && !as_octal && not_octal == nullptr) not_octal = &row;
  }

  static void add(RadixProof& vote, const read::ListRow& row) {
    ++vote.count;
    if (vote.proof == nullptr) vote.proof = &row;
  }
};

/// A direction and what says it.
struct Named {
  tables::Direction direction;
  DirectionBy by;
};

tables::Direction direction_of(const address::Address& address) {
  return address.area == address::Area::output ? tables::Direction::operation : tables::Direction::event;
}

bool is_constant(std::string_view klass) {
  constexpr std::string_view kConstant = "CONSTANT";
  const auto is_letter = [](char written, char capital) { return text::upper(written) == capital; };
  return std::search(klass.begin(), klass.end(), kConstant.begin(), kConstant.end(), is_letter) != klass.end();
}

/// Fills in a symbol but for its reading; returns the reason if the row is not one.
std::optional<InternalReason> classify_named(const read::ListRow& row, const RowAddress& address, bool given_io,
                                             const std::optional<Named>& named, Symbol& symbol) {
  if (is_constant(row.klass)) return InternalReason::constant;
  const bool internal = address.address && address.address->area == address::Area::memory;
  if (internal && !given_io) return InternalReason::memory;

  std::optional<DataType> type = data_type(row.type);
  if (row.type.empty()) {
    const auto size = address.address ? address.address->size : address::Size::bit;
    type = size == address::Size::bit     ? DataType::boolean
           : size == address::Size::byte  ? DataType::byte
           : size == address::Size::word  ? DataType::word
           : size == address::Size::dword ? DataType::dword
                                          : DataType::lword;
  }
  if (!type) return InternalReason::type;

  symbol.row = &row;
  symbol.type = *type;
  symbol.address = address.address;
  if (symbol.address && !symbol.address->sized)
    symbol.address->size = static_cast<address::Size>(data_type_bits(*type));
  symbol.address_is_iec = address.address && address.cell.data() == row.iec_address.data();
  if (!named) return InternalReason::no_direction;
  symbol.direction = named->direction;
  symbol.direction_by = named->by;
  const auto initial = initial_value(row.initial, *type);
  symbol.initial_known = initial.has_value();
  symbol.initial = initial.value_or(0);
  return std::nullopt;
}

/// A holding register (40001) is memory, but an output if a name or the description says that it is an operation.
RowAddress with_output_register(RowAddress address) {
  if (address.address && address.address->bank == address::kHoldingRegisters)
    address.address = address::as_output_register(*address.address);
  return address;
}

}  // namespace

std::optional<std::uint64_t> initial_value(std::string_view text, DataType type) {
  if (text.empty()) return 0;
  if (type == DataType::boolean && text::equal_ignoring_case(text, "FALSE")) return 0;  // most have it
  if (const std::size_t hash = text.find('#'); hash != text.npos && data_type(text.substr(0, hash))) {
    text.remove_prefix(hash + 1);  // INT#5, WORD#16#FF
  }
  if (type == DataType::boolean) {
    return truth(text);
  }
  if (type == DataType::real || type == DataType::lreal) {
    if (starts_with_ignoring_case(text, "E") && text.size() > 1) text.remove_prefix(1);  // MELSEC: E3.14
    return number_of_real(text);
  }
  if (starts_with_ignoring_case(text, "K")) return integer(text.substr(1), type);
  if (starts_with_ignoring_case(text, "H")) return integer("16#" + std::string(text.substr(1)), type);
  return integer(text, type);
}

RowAddress row_address(const read::ListRow& row, const address::Dialect& dialect) {
  RowAddress result;
  const auto take = [&](std::string_view cell, const std::optional<address::Address>& address) {
    if (address) {
      result.address = address;
      result.cell = cell;
    } else {
      result.bad_cell = cell;
    }
  };
  if (!row.vendor_address.empty()) {
    const auto vendor = address::parse(row.vendor_address, dialect);
    take(row.vendor_address, vendor ? vendor : address::parse_iec(row.vendor_address));
  }
  const std::optional<address::Address> vendor = result.address;
  if (!row.iec_address.empty()) {  // its number is certainly decimal, so it has priority over the vendor's
    auto iec = address::parse_iec(row.iec_address);
    if (!iec && row.vendor_address.empty()) iec = address::parse(row.iec_address, dialect);
    take(row.iec_address, iec);
    if (vendor && iec && can_compare(*vendor, *iec)) {
      result.vendor = vendor;
      result.contradicts = *vendor != *iec;
    }
  }
  return result;
}

std::optional<InternalReason> classify(const read::ListRow& row, const name::Reading& reading,
                                       const RowAddress& written, Symbol& symbol) {
  const bool is_operation = reading.given_io && reading.given_direction == tables::Direction::operation;
  const RowAddress address = is_operation ? with_output_register(written) : written;
  std::optional<Named> named;
  const bool by_address = !reading.is_read() || reading.direction_by == name::Evidence::address;
  if (reading.given_io) {
    named = Named{reading.given_direction, DirectionBy::description};
  } else if (by_address && address.address) {
    named = Named{direction_of(*address.address), DirectionBy::address};
  } else if (reading.is_read()) {
    named = Named{*reading.direction, DirectionBy::name};
  }
  if (reading.levels != nullptr) symbol.reading = {reading.levels, reading.task->text};
  if (const auto reason = classify_named(row, address, reading.given_io, named, symbol)) return reason;
  symbol.named = reading.direction_of_name.value_or(symbol.direction);
  if (!reading.is_read()) symbol.account = name::account_of(reading, symbol.type == DataType::boolean);
  return std::nullopt;
}

RadixChoice choose_radix(std::span<const read::SymbolTable* const> tables, std::optional<address::Radix> forced) {
  RadixChoice choice;
  RadixVotes votes;
  for (const read::SymbolTable* table : tables) {
    if (table->notation != address::Notation::melsec) continue;
    for (const read::ListRow& row : table->rows) votes.take(row, choice);
  }
  if (votes.octal.count != votes.hexadecimal.count) {
    const bool octal = votes.octal.count > votes.hexadecimal.count;
    choice.radix = octal ? address::Radix::octal : address::Radix::hexadecimal;
    choice.by = RadixChoice::By::rows;
    choice.proof = octal ? votes.octal.proof : votes.hexadecimal.proof;
  } else if (forced) {
    choice.radix = *forced;
    choice.by = RadixChoice::By::option;
  } else if (votes.not_octal != nullptr) {
    choice.by = RadixChoice::By::rows;
    choice.proof = votes.not_octal;
  }
  return choice;
}

}  // namespace symplant::model
