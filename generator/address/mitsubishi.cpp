// Converts between the two notations of Mitsubishi's tools.
#include "address/mitsubishi.hpp"

#include <fmt/format.h>

#include "address/bits.hpp"
#include "address/make.hpp"
#include "address/notation.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

/// A device of memory: `%M`, its size, the class before the dot.
struct Class {
  std::string_view name;
  char size;
  std::uint64_t number;
};
constexpr std::array kClasses{Class{"B", 'X', 1}, Class{"D", 'W', 0}, Class{"M", 'X', 0}, Class{"W", 'W', 1}};

/// A device of memory in IEC notation: %MX0.100.
struct ClassAndNumber {
  const Class* device = nullptr;
  char size = 'X';
  std::uint64_t number_of_class = 0;
  std::uint64_t number = 0;
};

template <char kSize>
const auto kSizeOfClass = [](auto& context) { x3::get<ClassAndNumber>(context).size = kSize; };
const auto kIecOfClass = '%' >> letter('M') >> -(letter('X') | (letter('W') | letter('D'))[kSizeOfClass<'W'>]) >>
                         kDecimal[kSet<&ClassAndNumber::number_of_class>] >>
                         '.' >> kDecimal[kSet<&ClassAndNumber::number>];
const auto kDeviceOfClass = OneOf<kClasses>()[kSet<&ClassAndNumber::device>] >> kHexadecimal;

}  // namespace

std::optional<std::string> iec_of_melsec(std::string_view text, Radix radix) {
  text = trimmed(text);
  const auto address = parse_melsec(text, radix);
  if (!address || address->bank == kNoBank) return std::nullopt;
  const bool is_bit = address->size == Size::bit;
  if (address->area != Area::memory) {
    if (!is_bit || text::upper(text.front()) == 'D') return std::nullopt;  // direct access has a class
    return to_text(*address, {Notation::iec});
  }
  ClassAndNumber found;
  if (!matches(text, kDeviceOfClass, found)) return std::nullopt;
  return fmt::format("%M{}{}.{}", found.device->size, found.device->number, address->first_bit / address->element);
}

std::optional<std::string> melsec_of_iec(std::string_view text, Radix radix) {
  text = trimmed(text);
  const Dialect melsec{Notation::melsec, radix};
  const auto address = parse_iec(text);
  if (!address) return std::nullopt;
  if (address->area != Area::memory) {
    const bool is_number = address->bank == kBits && address->element == 1;
    return is_number ? to_text(*address, melsec) : std::nullopt;
  }
  ClassAndNumber written;
  if (!matches(text, kIecOfClass, written)) return std::nullopt;
  for (const Class& candidate : kClasses) {
    if (candidate.size != written.size || candidate.number != written.number_of_class) continue;
    const auto device = parse_melsec(fmt::format("{}0", candidate.name), radix);
    const auto moved = advanced(*device, written.number);
    return moved ? to_text(*moved, melsec) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace symplant::address
