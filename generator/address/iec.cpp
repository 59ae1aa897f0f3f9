// The grammar of IEC 61131-3 addresses.
#include <fmt/format.h>

#include <utility>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

struct AreaLetter {
  std::string_view name;
  Area area;
};
/// Those of IEC 61131-3, and the memories of XG5000 and Unity Pro.
constexpr std::array kAreas{AreaLetter{"F", Area::memory}, AreaLetter{"I", Area::input},  AreaLetter{"K", Area::memory},
                            AreaLetter{"L", Area::memory}, AreaLetter{"M", Area::memory}, AreaLetter{"N", Area::memory},
                            AreaLetter{"Q", Area::output}, AreaLetter{"R", Area::memory}, AreaLetter{"S", Area::memory},
                            AreaLetter{"U", Area::memory}, AreaLetter{"W", Area::memory}};

struct SizeLetter {
  std::string_view name;
  Size size;
};
constexpr std::array kSizes{SizeLetter{"B", Size::byte}, SizeLetter{"D", Size::dword}, SizeLetter{"L", Size::lword},
                            SizeLetter{"W", Size::word}, SizeLetter{"X", Size::bit}};

/// An address as it is written: the numbers between the dots of `%IX1.2.3`.
struct IecText {
  Area area = Area::memory;
  char letter = 'M';
  Size size = Size::bit;
  bool has_size = false;
  bool assigned = true;
  std::array<std::uint64_t, 8> parts{};
  std::size_t count = 0;
  std::string_view channel;  ///< of a module of B&R: `."IF3.ST1".DigitalInput01`, `.IF3.ST1.DigitalInput01`
};

const auto kIecSize = [](auto& context) {
  x3::get<IecText>(context).size = x3::_attr(context)->size;
  x3::get<IecText>(context).has_size = true;
};
const auto kIecPart = [](auto& context) {
  auto& written = x3::get<IecText>(context);
  x3::_pass(context) = written.count < written.parts.size();
  if (written.count < written.parts.size()) written.parts[written.count++] = x3::_attr(context);
};
const auto kUnassigned = [](auto& context) { x3::get<IecText>(context).assigned = false; };

const auto kIecArea = [](auto& context) {
  x3::get<IecText>(context).area = x3::_attr(context)->area;
  x3::get<IecText>(context).letter = x3::_attr(context)->name.front();
};
const auto kIecChannel = [](auto& context) {
  const auto& written = x3::_attr(context);
  x3::get<IecText>(context).channel = {written.begin(), static_cast<std::size_t>(written.end() - written.begin())};
};
const auto kChannelName = x3::ascii::alpha >> *(x3::ascii::alnum | x3::char_('_'));
const auto kModule = x3::lit('"') >> +(x3::char_ - '"') >> '"' | kChannelName;
const auto kChannel = x3::raw['.' >> kModule >> +('.' >> kChannelName)];

const auto kIec = '%' >> OneOf<kAreas>()[kIecArea] >> -OneOf<kSizes>()[kIecSize] >>
                  (kDecimal[kIecPart] % '.' | x3::lit('*')[kUnassigned] | kChannel[kIecChannel]);

Address of_parts(const IecText& written) {
  Key key;
  for (std::size_t i = 0; i < written.count; ++i) key.add(written.parts[i]);
  return keyed(written.area, written.size, key);
}

Address of_memory(const IecText& written) {
  if (written.letter != 'M') {
    Key key;
    key.add(static_cast<std::uint64_t>(static_cast<unsigned char>(written.letter)));
    for (std::size_t i = 0; i < written.count; ++i) key.add(written.parts[i]);
    return keyed(Area::memory, written.size, key);
  }
  // %MX5 and %MW5 are plain numbers; the classes of %MX0.500 are those of the vendor.
  return written.count == 1 ? numbered(written.area, written.size, written.parts[0]) : of_parts(written);
}

Address of_element_and_bit(const IecText& written) {
  const auto [element, bit] = std::pair(written.parts[0], written.parts[1]);
  const auto bits = static_cast<std::uint64_t>(written.size);
  if (written.size == Size::bit) {
    if (bit < 8 && element <= UINT64_MAX / 8 - 1) {
      return at_bits(written.area, Size::bit, kBits, Size::byte, 8 * element + bit);
    }
    return of_parts(written);
  }
  if (bit < bits && element <= kMostElements) {
    return at_bits(written.area, Size::bit, bank_of_elements(written.size), written.size, bits * element + bit);
  }
  Key key;  // %IW5.16 is a bit of a word, not the bit %IX5.16
  key.add(element).add(bit).add(bits);
  return keyed(written.area, Size::bit, key);
}

Address address_of(const IecText& written) {
  if (written.area == Area::memory) return of_memory(written);
  if (written.count == 2) return of_element_and_bit(written);
  if (written.count != 1) return of_parts(written);
  const std::uint64_t number = written.parts[0];
  if (written.size == Size::bit) return at_bits(written.area, Size::bit, kBits, Size::bit, number);
  if (number > kMostElements) return numbered(written.area, written.size, number);
  return at_bits(written.area, written.size, bank_of_elements(written.size), written.size,
                 static_cast<std::uint64_t>(written.size) * number);
}

/// %IX1 and %QX1, as most cells have them.
std::optional<Address> usual_iec(std::string_view text) {
  if (text.size() < 4 || text[0] != '%' || text[2] != 'X' || (text[1] != 'I' && text[1] != 'Q')) return std::nullopt;
  const auto number = usual_number(text.substr(3), 10);
  if (!number) return std::nullopt;
  return at_bits(text[1] == 'I' ? Area::input : Area::output, Size::bit, kBits, Size::bit, *number);
}

}  // namespace

std::optional<Address> parse_iec(std::string_view text) {
  if (const auto usual = usual_iec(text)) return usual;
  return parse_iec_by_grammar(text);
}

std::optional<Address> parse_iec_by_grammar(std::string_view text) {
  IecText written;
  if (!matches(trimmed(text), kIec, written)) return std::nullopt;
  if (!written.channel.empty()) return keyed(written.area, written.size, Key().add(written.channel));
  if (written.assigned) return address_of(written);
  Address address = keyed(written.area, written.size, Key());
  address.assigned = false;
  address.sized = written.has_size;
  return address;
}

std::optional<std::string> iec_text(const Address& address, Radix) {
  if (address.area == Area::memory || address.bank == kNoBank) return std::nullopt;
  const char area = address.area == Area::input ? 'I' : 'Q';
  const auto element = address.element;
  if (address.bank == kBits && address.size == Size::bit) {
    if (element == 1) return fmt::format("%{}X{}", area, address.first_bit);
    return element == 8 ? std::optional(fmt::format("%{}X{}.{}", area, address.first_bit / 8, address.first_bit % 8))
                        : std::nullopt;
  }
  if (address.bank != element) return std::nullopt;
  const char size = element == 8 ? 'B' : element == 16 ? 'W' : element == 32 ? 'D' : 'L';
  if (address.size != Size::bit) return fmt::format("%{}{}{}", area, size, address.first_bit / element);
  return fmt::format("%{}{}{}.{}", area, size, address.first_bit / element, address.first_bit % element);
}

}  // namespace symplant::address
