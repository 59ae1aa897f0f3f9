// The grammar of Modbus reference numbers.
#include <fmt/format.h>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

struct ModbusText {
  std::uint64_t reference = 0;
  std::size_t digits = 0;
  std::optional<std::uint64_t> bit;
};

const auto kReference = [](auto& context) {
  const auto& digits = x3::_attr(context);
  auto& written = x3::get<ModbusText>(context);
  written.digits = digits.size();
  const char* at = digits.begin();
  x3::parse(at, digits.end(), kDecimal, written.reference);
  x3::_pass(context) = written.digits == 5 || written.digits == 6;
};
const auto kModbusBit = [](auto& context) {
  x3::get<ModbusText>(context).bit = x3::_attr(context);
  x3::_pass(context) = x3::_attr(context) < 16;
};
const auto kModbus = x3::raw[+x3::ascii::digit][kReference] >> -('.' >> kDecimal[kModbusBit]);

}  // namespace

std::optional<Address> parse_modbus(std::string_view text) {
  ModbusText written;
  if (!matches(trimmed(text), kModbus, written)) return std::nullopt;
  const bool is_long = written.digits == 6;
  const std::uint64_t table = written.reference / (is_long ? 100'000 : 10'000);
  const std::uint64_t number = written.reference % (is_long ? 100'000 : 10'000);
  const bool is_register = table == 3 || table == 4;
  if (number == 0 || number > 65'536 || (table != 0 && table != 1 && !is_register)) return std::nullopt;
  if (written.bit && !is_register) return std::nullopt;
  const Area area = table == 0 ? Area::output : table == 4 ? Area::memory : Area::input;
  if (!is_register) return at_bits(area, Size::bit, kBits, Size::bit, number - 1);
  const Bank bank = area == Area::memory ? kHoldingRegisters : bank_of_elements(Size::word);
  return at_bits(area, written.bit ? Size::bit : Size::word, bank, Size::word,
                 16 * (number - 1) + written.bit.value_or(0));
}

std::optional<std::string> modbus_text(const Address& address, Radix) {
  const bool is_register = address.element == 16;
  if (address.bank == kNoBank || (!is_register && (address.size != Size::bit || address.element != 1))) {
    return std::nullopt;
  }
  const std::uint64_t number = address.first_bit / address.element;
  if (number >= 65'536) return std::nullopt;
  const int table = address.area == Area::output ? 0 : !is_register ? 1 : address.area == Area::input ? 3 : 4;
  const std::string reference = fmt::format("{}{:05}", table, number + 1);
  if (!is_register || address.size == Size::word) return reference;
  return fmt::format("{}.{}", reference, address.first_bit % 16);
}

Address as_output_register(const Address& holding) {
  return at_bits(Area::output, holding.size, bank_of_elements(Size::word), Size::word, holding.first_bit);
}

}  // namespace symplant::address
