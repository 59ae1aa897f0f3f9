// MELSEC devices: their codes on the wire, and their texts.
#include "symplant/link/slmp/device.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "symplant/tables/ascii.hpp"

namespace symplant::link::slmp {

namespace {

constexpr std::uint8_t kDecimal = 10;
constexpr std::uint8_t kHexadecimal = 16;
constexpr std::uint8_t kOctal = 8;
constexpr std::uint8_t kInputsOutputs = 0;
constexpr std::uint32_t kBitsPerWord = 16;
constexpr std::uint8_t kMostDigits = 8;

// SH-080008 (MELSEC Communication Protocol), table of device codes.
constexpr std::array kKinds = {
    KindInfo{"X", 0x9C, true, kInputsOutputs, true, false},   KindInfo{"Y", 0x9D, true, kInputsOutputs, true, false},
    KindInfo{"DX", 0xA2, true, kInputsOutputs, false, false}, KindInfo{"DY", 0xA3, true, kInputsOutputs, false, false},
    KindInfo{"M", 0x90, true, kDecimal, true, false},         KindInfo{"L", 0x92, true, kDecimal, true, false},
    KindInfo{"F", 0x93, true, kDecimal, true, false},         KindInfo{"V", 0x94, true, kDecimal, false, false},
    KindInfo{"B", 0xA0, true, kHexadecimal, true, false},     KindInfo{"S", 0x98, true, kDecimal, true, false},
    KindInfo{"SM", 0x91, true, kDecimal, true, false},        KindInfo{"SB", 0xA1, true, kHexadecimal, true, false},
    KindInfo{"TS", 0xC1, true, kDecimal, true, true},         KindInfo{"TC", 0xC0, true, kDecimal, true, true},
    KindInfo{"CS", 0xC4, true, kDecimal, true, true},         KindInfo{"CC", 0xC3, true, kDecimal, true, true},
    KindInfo{"D", 0xA8, false, kDecimal, true, false},        KindInfo{"W", 0xB4, false, kHexadecimal, true, false},
    KindInfo{"R", 0xAF, false, kDecimal, true, false},        KindInfo{"ZR", 0xB0, false, kDecimal, false, false},
    KindInfo{"SD", 0xA9, false, kDecimal, true, false},       KindInfo{"SW", 0xB5, false, kHexadecimal, true, false},
    KindInfo{"TN", 0xC2, false, kDecimal, true, false},       KindInfo{"CN", 0xC5, false, kDecimal, true, false},
};

/// A class of the IEC form, `%MX1.863` (SH-080782, table 4.5.3).
struct IecClass {
  std::uint32_t number;
  std::string_view bit;
  std::string_view word;
};
constexpr std::array kIecClasses = {
    IecClass{0, "M", "D"},   IecClass{1, "B", "W"}, IecClass{2, "S", "R"},    IecClass{3, "TS", "TN"},
    IecClass{4, "CS", "CN"}, IecClass{5, "TC", ""}, IecClass{6, "CC", ""},    IecClass{7, "F", ""},
    IecClass{8, "L", ""},    IecClass{9, "V", ""},  IecClass{10, "SM", "SD"}, IecClass{11, "SB", "SW"},
    IecClass{12, "", "ZR"},
};

/// The whole text as a number below kMostDevices.
std::optional<std::uint32_t> number_in(std::string_view text, std::uint32_t base) {
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, static_cast<int>(base));
  if (text.empty() || error != std::errc() || stop != end || number >= kMostDevices) return std::nullopt;
  return number;
}

/// Splits at the first point; the second part is empty if there is none.
std::pair<std::string_view, std::string_view> split_at_point(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return {text, {}};
  return {text.substr(0, point), text.substr(point + 1)};
}

std::optional<Device> parse_class(std::string_view text, bool bit) {
  const auto [digits, rest] = split_at_point(text);
  const auto of_class = number_in(digits, kDecimal);
  const auto number = number_in(rest, kDecimal);
  const auto* const found = std::find_if(kIecClasses.begin(), kIecClasses.end(),
                                         [&](const IecClass& c) { return of_class && c.number == *of_class; });
  if (found == kIecClasses.end() || !number) return std::nullopt;
  const auto kind = kind_of(bit ? found->bit : found->word);
  if (!kind) return std::nullopt;
  return Device{*kind, *number};
}

/// `IX16`, `Q31`, `MX0.100`, `MW0.100`: the IEC form without its `%`.
std::optional<Device> parse_iec_form(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const char area = text.front();
  text.remove_prefix(1);
  char size = 'X';
  if (text.front() == 'X' || text.front() == 'W' || text.front() == 'D' || text.front() == 'L') {
    size = text.front();
    text.remove_prefix(1);
  }
  if (area == 'M') return parse_class(text, size == 'X');
  if ((area != 'I' && area != 'Q') || size != 'X') return std::nullopt;
  const auto number = number_in(text, kDecimal);
  if (!number) return std::nullopt;
  return Device{*kind_of(area == 'I' ? "X" : "Y"), *number};
}

/// A name and a number: the longest name that leaves a number. `D100.F` is a bit of a word.
std::optional<Device> parse_named(std::string_view text, Family family) {
  std::optional<Device> best;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const auto kind = static_cast<Kind>(i);
    const KindInfo& info = kKinds[i];
    if (info.name.size() <= longest || !text.starts_with(info.name)) continue;
    const auto [digits, bit_digit] = split_at_point(text.substr(info.name.size()));
    const auto number = number_in(digits, base_of(kind, family));
    if (!number || (family == Family::fx5 && !info.fx5)) continue;
    Device device{kind, *number};
    if (text.find('.') != std::string_view::npos) {
      const auto bit = number_in(bit_digit, kHexadecimal);
      if (info.bit || bit_digit.size() != 1 || !bit) continue;
      device.bit = static_cast<std::uint8_t>(*bit);
    }
    best = device;
    longest = info.name.size();
  }
  return best;
}

}  // namespace

const KindInfo& info_of(Kind kind) noexcept { return kKinds[kind]; }

std::optional<Kind> kind_of(std::string_view name) noexcept {
  const auto* const found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const KindInfo& info) { return info.name == name; });
  if (found == kKinds.end()) return std::nullopt;
  return static_cast<Kind>(found - kKinds.begin());
}

std::optional<Kind> kind_with_code(std::uint8_t code) noexcept {
  const auto* const found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const KindInfo& info) { return info.code == code; });
  if (found == kKinds.end()) return std::nullopt;
  return static_cast<Kind>(found - kKinds.begin());
}

std::uint32_t base_of(Kind kind, Family family) noexcept {
  const std::uint8_t base = kKinds[kind].base;
  if (base != kInputsOutputs) return base;
  return family == Family::fx5 ? kOctal : kHexadecimal;
}

std::optional<Device> parse_device(std::string_view text, Family family) {
  const std::string upper = tables::to_upper(text);
  std::string_view rest = upper;
  if (rest.starts_with('%')) return parse_iec_form(rest.substr(1));
  const bool grouped = rest.size() > 2 && rest[0] == 'K' && rest[1] > '0' && rest[1] <= '0' + kMostDigits;
  if (!grouped) return parse_named(rest, family);
  auto device = parse_named(rest.substr(2), family);
  if (!device || !info_of(device->kind).bit) return std::nullopt;
  device->digits = static_cast<std::uint8_t>(rest[1] - '0');
  return device;
}

std::string device_text(const Device& device, Family family) {
  const std::uint32_t base = base_of(device.kind, family);
  std::array<char, 2 * kBitsPerWord> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), device.number, static_cast<int>(base)).ptr;
  std::string text = device.digits == 0 ? std::string() : "K" + std::to_string(device.digits);
  text += info_of(device.kind).name;
  text += tables::to_upper(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
  if (device.bit != Device::kNoBit) text.append(".") += "0123456789ABCDEF"[device.bit];
  return text;
}

}  // namespace symplant::link::slmp
