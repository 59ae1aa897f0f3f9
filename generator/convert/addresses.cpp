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
  auto address = address::parse(as_input, symbol.notation, address::Radix::hexadecimal);
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

}  // namespace

std::string address_in(const Symbol& symbol, const AddressForm& form) {
  const bool is_memory = symbol.address && symbol.address->area == Area::memory;
  if (is_memory && !form.bits_in_bytes) return {};
  const std::optional<Address> address = is_memory ? memory_address(symbol) : symbol.address;
  if (!address || !address->plain || (address->size == Size::lword && !form.has_long_words)) return {};
  const char area = area_letter(address->area);
  if (address->size == Size::bit && form.bits_in_bytes) {
    const std::string_view bit = form.names_bits ? "X" : "";
    return fmt::format("%{}{}{}.{}", area, bit, address->number / 8, address->number % 8);
  }
  const std::uint64_t bytes = form.counts_bytes ? static_cast<std::uint64_t>(address->size) / 8 : 1;
  if (address->number > UINT64_MAX / bytes) return {};
  return fmt::format("%{}{}{}", area, size_letter(address->size), address->number * bytes);
}

std::string_view source_address(const Symbol& symbol) {
  const read::ListRow& row = *symbol.row;
  if (row.iec_address.empty() || row.vendor_address.empty()) {
    return row.vendor_address.empty() ? row.iec_address : row.vendor_address;
  }
  const address::Radix radix = symbol.octal ? address::Radix::octal : address::Radix::hexadecimal;
  const auto vendor = address::parse(row.vendor_address, symbol.notation, radix);
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
