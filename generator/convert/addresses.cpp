// Addresses in the notations of the targets.
#include "convert/addresses.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "address/notation.hpp"
#include "text/ascii.hpp"

namespace symplant::convert {
namespace {

using address::Address;
using address::Area;
using address::Notation;
using address::Size;

/// %MW5 or `MW 10`: read as the input of the same number, because the value of memory only distinguishes addresses.
/// GX IEC Developer's memory (%MX0.500) has another structure.
std::optional<Address> memory_address(const Symbol& symbol) {
  const std::string_view vendor = symbol.row->vendor_address;
  const std::string_view cell = vendor.empty() ? symbol.row->iec_address : vendor;
  const bool is_iec = symbol.notation == Notation::iec || symbol.notation == Notation::siemens;
  const std::size_t letter = cell.find_first_of("Mm");
  if (!is_iec || letter > 1) return std::nullopt;
  std::string as_input(cell);
  as_input[letter] = 'I';
  auto address = address::parse(as_input, symbol.address_dialect());
  if (!address || address->area != Area::input) return std::nullopt;
  address->area = Area::memory;
  return address;
}

char size_letter(Size size) {
  switch (size) {
    case Size::byte:
      return 'B';
    case Size::word:
      return 'W';
    case Size::dword:
      return 'D';
    case Size::lword:
      return 'L';
    case Size::bit:
      break;
  }
  return 'X';
}

char area_letter(Area area) { return area == Area::input ? 'I' : area == Area::output ? 'Q' : 'M'; }

std::uint64_t bits_of_size(const Address& address) { return static_cast<std::uint64_t>(address.size); }

/// The number of a bit in the image. Nothing if the notation does not define it.
std::optional<std::uint64_t> bit_number(const Address& address, const AddressForm& form) {
  if (address.plain) return address.number;
  const bool is_in_word = address.bank != address::kNoBank && address.bank == address.element;
  return is_in_word && form.bits_in_bytes ? std::optional(address.first_bit) : std::nullopt;
}

/// The number of a byte or word, counted as the form counts. Nothing without one.
std::optional<std::uint64_t> element_number(const Address& address, const AddressForm& form) {
  const std::uint64_t unit = form.counts_bytes ? 8 : bits_of_size(address);
  if (address.bank == address::kBits && form.overlays) {
    return address.first_bit % unit == 0 ? std::optional(address.first_bit / unit) : std::nullopt;
  }
  const std::uint64_t factor = bits_of_size(address) / unit;
  if (!address.plain || address.number > UINT64_MAX / factor) return std::nullopt;
  return address.number * factor;
}

}  // namespace

std::string address_in(const Symbol& symbol, const AddressForm& form) {
  const bool is_memory = symbol.address && symbol.address->area == Area::memory;
  if (is_memory && !form.bits_in_bytes) return {};
  const std::optional<Address> address = is_memory ? memory_address(symbol) : symbol.address;
  if (!address || !address->assigned || (address->size == Size::lword && !form.has_long_words)) return {};
  const bool is_bit = address->size == Size::bit;
  const auto number = is_bit ? bit_number(*address, form) : element_number(*address, form);
  if (!number) return {};
  const char area = area_letter(address->area);
  if (is_bit && form.bits_in_bytes) {
    return fmt::format("%{}{}{}.{}", area, form.names_bits ? "X" : "", *number / 8, *number % 8);
  }
  return fmt::format("%{}{}{}", area, size_letter(address->size), *number);
}

bool is_bit_of_word(const Symbol& symbol) {
  return symbol.address && symbol.address->size == Size::bit && !symbol.address->plain;
}

std::string_view source_address(const Symbol& symbol) {
  const read::ListRow& row = *symbol.row;
  if (row.iec_address.empty() || row.vendor_address.empty()) {
    return row.vendor_address.empty() ? row.iec_address : row.vendor_address;
  }
  const auto vendor = address::parse(row.vendor_address, symbol.address_dialect());
  const bool is_io = symbol.address && symbol.address->area != Area::memory;
  return is_io && vendor != symbol.address ? row.iec_address : row.vendor_address;
}

std::string melsec_device(const Address& address, address::Radix radix) {
  if (address.area == Area::memory || address.size != Size::bit || !address.plain) return {};
  const char letter = address.area == Area::input ? 'X' : 'Y';
  return radix == address::Radix::octal ? fmt::format("{}{:o}", letter, address.number)
                                        : fmt::format("{}{:X}", letter, address.number);
}

}  // namespace symplant::convert
