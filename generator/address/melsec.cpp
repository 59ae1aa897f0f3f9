// The grammar of MELSEC devices.
#include <fmt/format.h>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

/// In which number system a device counts.
enum class Counts : std::uint8_t { decimal, hexadecimal, as_list };

struct Device {
  std::string_view name;
  Size size;
  Counts counts = Counts::decimal;
  Area area = Area::memory;
};

constexpr std::array kDevices{
    Device{"BL", Size::bit},
    Device{"B", Size::bit, Counts::hexadecimal},
    Device{"CS", Size::bit},
    Device{"CC", Size::bit},
    Device{"CN", Size::word},
    Device{"C", Size::word},
    Device{"DX", Size::bit, Counts::as_list, Area::input},
    Device{"DY", Size::bit, Counts::as_list, Area::output},
    Device{"D", Size::word},
    Device{"ER", Size::word},
    Device{"FX", Size::bit},
    Device{"FY", Size::bit},
    Device{"FD", Size::word},
    Device{"F", Size::bit},
    Device{"I", Size::bit},
    Device{"LSTS", Size::bit},
    Device{"LSTC", Size::bit},
    Device{"LSTN", Size::dword},
    Device{"LST", Size::dword},
    Device{"LTS", Size::bit},
    Device{"LTC", Size::bit},
    Device{"LTN", Size::dword},
    Device{"LCS", Size::bit},
    Device{"LCC", Size::bit},
    Device{"LCN", Size::dword},
    Device{"LT", Size::dword},
    Device{"LC", Size::dword},
    Device{"LZ", Size::dword},
    Device{"L", Size::bit},
    Device{"M", Size::bit},
    Device{"N", Size::bit},
    Device{"P", Size::bit},
    Device{"RD", Size::word},
    Device{"R", Size::word},
    Device{"STS", Size::bit},
    Device{"STC", Size::bit},
    Device{"STN", Size::word},
    Device{"SM", Size::bit},
    Device{"SD", Size::word},
    Device{"SB", Size::bit, Counts::hexadecimal},
    Device{"SW", Size::word, Counts::hexadecimal},
    Device{"ST", Size::word},
    Device{"SS", Size::bit},
    Device{"SC", Size::bit},
    Device{"SN", Size::word},
    Device{"S", Size::bit},
    Device{"TS", Size::bit},
    Device{"TC", Size::bit},
    Device{"TN", Size::word},
    Device{"T", Size::word},
    Device{"V", Size::bit},
    Device{"W", Size::word, Counts::hexadecimal},
    Device{"X", Size::bit, Counts::as_list, Area::input},
    Device{"Y", Size::bit, Counts::as_list, Area::output},
    Device{"ZR", Size::word},
    Device{"Z", Size::word},
};

constexpr Bank bank_of(const Device& device) {
  if (device.area != Area::memory) return kBits;
  return static_cast<Bank>(kMemoryBanks + (&device - kDevices.data()));
}

/// A device as it is written, with what is in front of it.
struct MelsecText {
  enum class Form : std::uint8_t { device, digits, indirect, buffer, shared_buffer, steps, network };

  Radix radix = Radix::hexadecimal;  ///< of X and Y
  Form form = Form::device;
  const Device* device = nullptr;
  std::uint64_t number = 0;
  std::optional<std::uint8_t> bit = {};  ///< of a word
  std::uint64_t in = 0;                  ///< digits of K4X0, module of U6\G100, network of J1\X10, block of BL0\S1
};

template <Counts kHow>
constexpr auto kCounts = only_if<MelsecText>([](const MelsecText& written) { return written.device->counts == kHow; });
const auto kInOctal = only_if<MelsecText>([](const MelsecText& written) { return written.radix == Radix::octal; });
const auto kBitOfWord = [](auto& context) {
  auto& written = x3::get<MelsecText>(context);
  const std::uint64_t bit = x3::_attr(context);
  x3::_pass(context) = bit < 16 && written.device->area == Area::memory && written.device->size == Size::word;
  written.bit = static_cast<std::uint8_t>(bit);
};

/// A device and its number.
const auto kMelsecDevice = OneOf<kDevices>()[kSet<&MelsecText::device>] >>
                           (kCounts<Counts::decimal> >> kDecimal[kSet<&MelsecText::number>] |
                            kCounts<Counts::as_list> >> kInOctal >> kOctal[kSet<&MelsecText::number>] |
                            !kCounts<Counts::decimal> >> !(kCounts<Counts::as_list> >> kInOctal) >>
                                kHexadecimal[kSet<&MelsecText::number>]) >>
                           -('.' >> kHexadecimal[kBitOfWord]);

template <MelsecText::Form kForm>
constexpr auto kIs = only_if<MelsecText>([](MelsecText& written) {
  written.form = kForm;
  return true;
});
/// X and Y of another network are those of its master, which counts in hexadecimal.
const auto kOfNetwork = only_if<MelsecText>([](MelsecText& written) {
  written.radix = Radix::hexadecimal;
  return true;
});
const auto kDigits = [](auto& context) {
  x3::get<MelsecText>(context).in = x3::_attr(context);
  x3::_pass(context) = x3::_attr(context) >= 1 && x3::_attr(context) <= 8;
};

/// Devices that are not alone: K4X0, @D0, U6\G100, U3E0\HG0, BL0\S1, J1\X10.
const auto kOtherDevice = letter('K') >> kIs<MelsecText::Form::digits> >> kDecimal[kDigits] >> kMelsecDevice |
                          '@' >> kIs<MelsecText::Form::indirect> >> kMelsecDevice |
                          letter('U') >> kHexadecimal[kSet<&MelsecText::in>] >> '\\' >>
                              (letter('G') >> kIs<MelsecText::Form::buffer> |
                               letter('H') >> letter('G') >> kIs<MelsecText::Form::shared_buffer>) >>
                              kDecimal[kSet<&MelsecText::number>] |
                          letter('B') >>
                              letter('L') >> kIs<MelsecText::Form::steps> >> kDecimal[kSet<&MelsecText::in>] >>
                              '\\' >> kMelsecDevice
                          |
                          letter('J') >> kIs<MelsecText::Form::network> >> kOfNetwork
                              >> kDecimal[kSet<&MelsecText::in>] >> '\\' >> kBlanks >> kMelsecDevice;

std::string_view name_of(Area area) { return area == Area::input ? "X" : "Y"; }

Address of_memory(const MelsecText& written, Size size) {
  Key key;
  key.add(static_cast<std::uint64_t>(written.form)).add(written.in).add(written.number);
  if (written.device != nullptr)
    key.add(written.device->area == Area::memory ? written.device->name : name_of(written.device->area));
  if (written.bit) key.add(*written.bit);
  Address address = keyed(Area::memory, size, key);
  address.plain = true;
  return address;
}

Address of_device(const MelsecText& written) {
  const Device& device = *written.device;
  if (device.area != Area::memory) return at_bits(device.area, Size::bit, kBits, Size::bit, written.number);
  const Size size = written.bit ? Size::bit : device.size;
  if (written.number > kMostElements) return of_memory(written, size);
  const std::uint64_t first = static_cast<std::uint64_t>(device.size) * written.number + written.bit.value_or(0);
  return at_bits(Area::memory, size, bank_of(device), device.size, first);
}

/// K4X0: 4 bits a digit, from X0 on. A whole number of bytes, words or doubles has known bits.
std::optional<Address> of_digits(const MelsecText& written) {
  const Device& device = *written.device;
  if (device.size != Size::bit || written.bit) return std::nullopt;
  const Size size = written.in <= 2 ? Size::byte : written.in <= 4 ? Size::word : Size::dword;
  const bool is_whole = 4 * written.in == static_cast<std::uint64_t>(size);
  if (is_whole && written.number <= kMostElements) {
    return at_bits(device.area, size, bank_of(device), Size::bit, written.number);
  }
  Address address = of_memory(written, size);
  address.area = device.area;
  address.plain = device.area == Area::memory;
  return address;
}

/// X1F and Y0001, as most cells have them.
std::optional<Address> usual_melsec(std::string_view text, Radix radix) {
  if (text.empty() || (text[0] != 'X' && text[0] != 'Y')) return std::nullopt;
  const auto number = usual_number(text.substr(1), static_cast<std::uint64_t>(radix));
  if (!number) return std::nullopt;
  return at_bits(text[0] == 'X' ? Area::input : Area::output, Size::bit, kBits, Size::bit, *number);
}

}  // namespace

std::optional<Address> parse_melsec(std::string_view text, Radix radix) {
  if (const auto usual = usual_melsec(text, radix)) return usual;
  return parse_melsec_by_grammar(text, radix);
}

std::optional<Address> parse_melsec_by_grammar(std::string_view text, Radix radix) {
  text = trimmed(text);
  MelsecText written{radix};
  if (matches(text, kMelsecDevice, written)) return of_device(written);
  written = {radix};
  if (!matches(text, kOtherDevice, written)) return std::nullopt;
  switch (written.form) {
    case MelsecText::Form::digits:
      return of_digits(written);
    case MelsecText::Form::steps:
    case MelsecText::Form::network:
      return of_memory(written, written.bit ? Size::bit : written.device->size);
    default:
      return of_memory(written, Size::word);
  }
}

std::optional<std::string> melsec_text(const Address& address, Radix radix) {
  if (address.bank == kNoBank) return std::nullopt;
  const bool is_memory = address.area == Area::memory;
  const std::size_t index = address.bank - kMemoryBanks;
  if (is_memory ? index >= kDevices.size() : address.bank != kBits) return std::nullopt;
  const bool is_word_of_bits = address.size != Size::bit && address.element == 1;
  if (!is_word_of_bits && !is_memory && address.size != Size::bit) return std::nullopt;
  const std::string_view name = is_memory ? kDevices[index].name : name_of(address.area);
  const Counts counts = is_memory ? kDevices[index].counts : Counts::as_list;
  const std::uint64_t number = address.first_bit / address.element;
  std::string digits = counts == Counts::decimal                            ? fmt::format("{}", number)
                       : counts == Counts::as_list && radix == Radix::octal ? fmt::format("{:o}", number)
                                                                            : fmt::format("{:X}", number);
  if (digits.front() > '9') digits.insert(0, "0");  // X0A, as the tools write it
  const std::string front =
      is_word_of_bits ? fmt::format("K{}", static_cast<unsigned>(address.size) / 4) : std::string();
  const bool is_bit_of_word = address.size == Size::bit && address.element != 1;
  const std::string bit = is_bit_of_word && is_memory ? fmt::format(".{:X}", address.first_bit % address.element) : "";
  return fmt::format("{}{}{}{}", front, name, digits, bit);
}

}  // namespace symplant::address
