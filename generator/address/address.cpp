// Addresses of I/O in any vendor's notation, as one value.
#include "address/address.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "text/ascii.hpp"

namespace symplant::address {

namespace {

using text::upper;

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// All of `digits` as a number; nothing if it is empty, holds another character or exceeds 64 bits.
std::optional<std::uint64_t> number_of(std::string_view digits, int base) {
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, value, base);
  if (fault != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// Distinguishes addresses that have no number on a link: FNV-1a over their parts.
class Key {
 public:
  void add(std::uint64_t part) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ (part & 0xFFU)) * 0x100000001B3U;
      part >>= 8U;
    }
  }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(upper(c))));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

std::optional<Area> iec_area(char letter) {
  switch (upper(letter)) {
    case 'I':
      return Area::input;
    case 'Q':
      return Area::output;
    case 'M':
      return Area::memory;
    default:
      return std::nullopt;
  }
}

std::optional<Size> iec_size(char letter) {
  switch (upper(letter)) {
    case 'X':
      return Size::bit;
    case 'B':
      return Size::byte;
    case 'W':
      return Size::word;
    case 'D':
      return Size::dword;
    case 'L':
      return Size::lword;
    default:
      return std::nullopt;
  }
}

/// The numbers between the dots of `%IX1.2.3`.
struct Parts {
  std::array<std::uint64_t, 8> values{};
  std::size_t count = 0;
};

std::optional<Parts> iec_parts(std::string_view text) {
  Parts parts;
  for (;;) {
    const std::size_t dot = text.find('.');
    const auto value = number_of(text.substr(0, dot), 10);
    if (!value || parts.count == parts.values.size()) return std::nullopt;
    parts.values[parts.count++] = *value;
    if (dot == std::string_view::npos) return parts;
    text.remove_prefix(dot + 1);
  }
}

void set_number(Address& address, const Parts& parts) {
  constexpr std::uint64_t kMaxByte = UINT64_MAX / 8;
  const auto& values = parts.values;
  address.plain = true;
  if (parts.count == 1) {
    address.number = values[0];
  } else if (address.area != Area::memory && address.size == Size::bit && parts.count == 2 && values[1] < 8 &&
             values[0] <= kMaxByte - 1) {
    address.number = 8 * values[0] + values[1];
  } else {
    Key key;
    for (std::size_t i = 0; i < parts.count; ++i) key.add(values[i]);
    if (address.area != Area::memory && address.size != Size::bit && parts.count == 2) {
      key.add(static_cast<std::uint64_t>(address.size));  // %IW5.3 is a bit of a word, not the bit %IX5.3
      address.size = Size::bit;
    }
    address.number = key.value();
    address.plain = false;
  }
}

struct Device {
  std::string_view name;
  int base;  ///< 0: the radix in which the list counts its X and Y
  Area area;
  Size size;
};

/// By first letter, longer names first, so that SB10 is not read as S.
constexpr std::array kDevices{Device{"BL", 10, Area::memory, Size::bit},   Device{"B", 16, Area::memory, Size::bit},
                              Device{"CS", 10, Area::memory, Size::bit},   Device{"CC", 10, Area::memory, Size::bit},
                              Device{"CN", 10, Area::memory, Size::word},  Device{"C", 10, Area::memory, Size::word},
                              Device{"DX", 0, Area::input, Size::bit},     Device{"DY", 0, Area::output, Size::bit},
                              Device{"D", 10, Area::memory, Size::word},   Device{"FX", 10, Area::memory, Size::bit},
                              Device{"FY", 10, Area::memory, Size::bit},   Device{"FD", 10, Area::memory, Size::word},
                              Device{"F", 10, Area::memory, Size::bit},    Device{"I", 10, Area::memory, Size::bit},
                              Device{"LT", 10, Area::memory, Size::dword}, Device{"LC", 10, Area::memory, Size::dword},
                              Device{"LZ", 10, Area::memory, Size::dword}, Device{"L", 10, Area::memory, Size::bit},
                              Device{"M", 10, Area::memory, Size::bit},    Device{"N", 10, Area::memory, Size::bit},
                              Device{"P", 10, Area::memory, Size::bit},    Device{"RD", 10, Area::memory, Size::word},
                              Device{"R", 10, Area::memory, Size::word},   Device{"SM", 10, Area::memory, Size::bit},
                              Device{"SD", 10, Area::memory, Size::word},  Device{"SB", 16, Area::memory, Size::bit},
                              Device{"SW", 16, Area::memory, Size::word},  Device{"ST", 10, Area::memory, Size::word},
                              Device{"S", 10, Area::memory, Size::bit},    Device{"TS", 10, Area::memory, Size::bit},
                              Device{"TC", 10, Area::memory, Size::bit},   Device{"TN", 10, Area::memory, Size::word},
                              Device{"T", 10, Area::memory, Size::word},   Device{"V", 10, Area::memory, Size::bit},
                              Device{"W", 16, Area::memory, Size::word},   Device{"X", 0, Area::input, Size::bit},
                              Device{"Y", 0, Area::output, Size::bit},     Device{"ZR", 10, Area::memory, Size::word},
                              Device{"Z", 10, Area::memory, Size::word}};

/// The index in kDevices at which the devices of a letter begin; after the last letter its size.
constexpr auto kDevicesOf = [] {
  std::array<std::uint8_t, 27> begins{};
  for (std::size_t letter = 0; letter <= 26; ++letter) {
    std::size_t at = 0;
    while (at < kDevices.size() && kDevices[at].name[0] < static_cast<char>('A' + letter)) ++at;
    begins[letter] = static_cast<std::uint8_t>(at);
  }
  return begins;
}();

bool begins_with(std::string_view text, std::string_view name) {
  return text.size() > name.size() &&
         std::equal(name.begin(), name.end(), text.begin(), [](char a, char b) { return a == upper(b); });
}

/// Reads a device with this name and the number after it; a word of memory may have a bit (D10.5, W0.F).
std::optional<Address> parse_device(std::string_view text, const Device& device, Radix radix) {
  const int base = device.base != 0 ? device.base : static_cast<int>(radix);
  std::string_view digits = text.substr(device.name.size());
  std::optional<std::uint64_t> bit;
  if (device.area == Area::memory && device.size == Size::word) {
    const std::size_t dot = digits.find('.');
    if (dot != std::string_view::npos) {
      bit = number_of(digits.substr(dot + 1), 16);
      if (!bit || *bit > 15) return std::nullopt;
      digits = digits.substr(0, dot);
    }
  }
  const auto number = number_of(digits, base);
  if (!number) return std::nullopt;
  Address address{device.area, bit ? Size::bit : device.size, *number, true};
  if (device.area == Area::memory) {
    Key key;
    key.add(device.name);
    key.add(*number);
    if (bit) key.add(*bit);
    address.number = key.value();
  }
  return address;
}

/// U6\G100 (a module's buffer) and J1\B1F (another network's device): memory.
std::optional<Address> parse_remote(std::string_view text, std::size_t backslash) {
  const std::string_view where = text.substr(0, backslash);
  const std::string_view what = text.substr(backslash + 1);
  const char kind = upper(where.front());
  Key key;
  key.add(text.substr(0, 1));
  if (kind == 'U' && what.size() > 1 && upper(what.front()) == 'G') {
    const auto module = number_of(where.substr(1), 16);
    const auto number = number_of(what.substr(1), 10);
    if (!module || !number) return std::nullopt;
    key.add(*module);
    key.add(*number);
    return Address{Area::memory, Size::word, key.value(), true};
  }
  if (kind != 'J') return std::nullopt;
  const auto network = number_of(where.substr(1), 10);
  if (!network || what.find('\\') != std::string_view::npos) return std::nullopt;
  const auto device = parse_melsec(what, Radix::hexadecimal);
  if (!device) return std::nullopt;
  key.add(*network);
  key.add(static_cast<std::uint64_t>(device->area));
  key.add(device->number);
  return Address{Area::memory, device->size, key.value(), true};
}

}  // namespace

std::optional<Address> parse_iec(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 3 || text.front() != '%') return std::nullopt;
  const auto area = iec_area(text[1]);
  if (!area) return std::nullopt;
  const auto size = iec_size(text[2]);
  const auto parts = iec_parts(text.substr(size ? 3 : 2));
  if (!parts) return std::nullopt;
  Address address{*area, size.value_or(Size::bit), 0, true};
  set_number(address, *parts);
  return address;
}

std::optional<Address> parse_melsec(std::string_view text, Radix radix) {
  text = trimmed(text);
  const std::size_t backslash = text.find('\\');
  if (backslash != std::string_view::npos && backslash > 0) return parse_remote(text, backslash);
  const char first = text.empty() ? '\0' : upper(text.front());
  if (first < 'A' || first > 'Z') return std::nullopt;
  const auto letter = static_cast<std::size_t>(first - 'A');
  for (std::size_t i = kDevicesOf[letter]; i < kDevicesOf[letter + 1]; ++i) {
    if (!begins_with(text, kDevices[i].name)) continue;
    if (const auto address = parse_device(text, kDevices[i], radix)) return address;
  }
  return std::nullopt;
}

}  // namespace symplant::address
