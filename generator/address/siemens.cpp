// The grammar of SIMATIC operands, English and German mnemonics.
#include <fmt/format.h>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

/// What follows an operand's name: byte and bit, a byte, or the number of a block, timer or counter.
enum class Kind : std::uint8_t { bit, bytes, object };

struct Operand {
  std::string_view name;
  Kind kind;
  Area area = Area::memory;
  Size size = Size::bit;
  std::string_view same_as = {};  ///< the English mnemonic; empty: `name`
};

constexpr Operand bit(std::string_view name, Area area) { return {name, Kind::bit, area}; }
constexpr Operand bytes(std::string_view name, Area area, Size size) { return {name, Kind::bytes, area, size}; }
constexpr Operand object(std::string_view name, std::string_view same_as = {}) {
  return {name, Kind::object, Area::memory, Size::word, same_as};
}

constexpr std::array kOperands{
    bytes("AB", Area::output, Size::byte),
    bytes("AW", Area::output, Size::word),
    bytes("AD", Area::output, Size::dword),
    bit("A", Area::output),
    object("C"),
    object("DB"),
    object("DI"),
    bytes("EB", Area::input, Size::byte),
    bytes("EW", Area::input, Size::word),
    bytes("ED", Area::input, Size::dword),
    bit("E", Area::input),
    object("FB"),
    object("FC"),
    bytes("IB", Area::input, Size::byte),
    bytes("IW", Area::input, Size::word),
    bytes("ID", Area::input, Size::dword),
    bit("I", Area::input),
    bytes("LB", Area::memory, Size::byte),
    bytes("LW", Area::memory, Size::word),
    bytes("LD", Area::memory, Size::dword),
    bit("L", Area::memory),
    bytes("MB", Area::memory, Size::byte),
    bytes("MW", Area::memory, Size::word),
    bytes("MD", Area::memory, Size::dword),
    bit("M", Area::memory),
    object("OB"),
    bytes("PIB", Area::input, Size::byte),
    bytes("PIW", Area::input, Size::word),
    bytes("PID", Area::input, Size::dword),
    bytes("PEB", Area::input, Size::byte),
    bytes("PEW", Area::input, Size::word),
    bytes("PED", Area::input, Size::dword),
    bytes("PQB", Area::output, Size::byte),
    bytes("PQW", Area::output, Size::word),
    bytes("PQD", Area::output, Size::dword),
    bytes("PAB", Area::output, Size::byte),
    bytes("PAW", Area::output, Size::word),
    bytes("PAD", Area::output, Size::dword),
    bytes("QB", Area::output, Size::byte),
    bytes("QW", Area::output, Size::word),
    bytes("QD", Area::output, Size::dword),
    bit("Q", Area::output),
    object("SDB"),
    object("SFB"),
    object("SFC"),
    object("T"),
    object("UDT"),
    object("VAT"),
    object("Z", "C"),
};

/// What is in a data block: DB1.DBX0.0, DB1.DBW4.
constexpr std::array kFields{
    bytes("DBB", Area::memory, Size::byte),
    bytes("DBW", Area::memory, Size::word),
    bytes("DBD", Area::memory, Size::dword),
    bit("DBX", Area::memory),
};

constexpr Bank kMarkers = kMemoryBanks + 128;
constexpr Bank kLocal = kMarkers + 1;

struct SiemensText {
  const Operand* operand = nullptr;
  std::uint64_t number = 0;
  std::uint64_t bit = 0;
  const Operand* field = nullptr;  ///< of a data block
  std::uint64_t field_number = 0;
};

const auto kSiemensBit = [](auto& context) {
  x3::get<SiemensText>(context).bit = x3::_attr(context);
  x3::_pass(context) = x3::_attr(context) < 8;
};
const auto kIsBit = only_if<SiemensText>([](const SiemensText& written) { return written.operand->kind == Kind::bit; });
const auto kIsBlock = only_if<SiemensText>(
    [](const SiemensText& written) { return written.operand->name == "DB" || written.operand->name == "DI"; });
const auto kIsIo =
    only_if<SiemensText>([](const SiemensText& written) { return written.operand->area != Area::memory; });
const auto kIsBitField =
    only_if<SiemensText>([](const SiemensText& written) { return written.field->kind == Kind::bit; });

const auto kInBlock = kIsBlock >> '.' >> OneOf<kFields>()[kSet<&SiemensText::field>] >> kBlanks
                      >> kDecimal[kSet<&SiemensText::field_number>] >>
                      (kIsBitField >> '.' >> kDecimal[kSiemensBit] | !kIsBitField);
const auto kSiemens = -x3::lit('%') >> OneOf<kOperands>()[kSet<&SiemensText::operand>] >> kBlanks >>
                      (kIsBit >> kDecimal[kSet<&SiemensText::number>] >> '.' >> kDecimal[kSiemensBit] |
                       !kIsBit >> kDecimal[kSet<&SiemensText::number>] >> -kInBlock) >>
                      -(kIsIo >> ':' >> letter('P'));

Address of_object(const SiemensText& written) {
  const Operand& operand = *written.operand;
  Key key;
  key.add(operand.same_as.empty() ? operand.name : operand.same_as).add(written.number);
  const Operand* const field = written.field;
  if (field != nullptr) key.add(field->name).add(written.field_number).add(written.bit);
  return keyed(Area::memory, field != nullptr ? field->size : operand.size, key);
}

}  // namespace

std::optional<Address> parse_siemens(std::string_view text) {
  SiemensText written;
  if (!matches(trimmed(text), kSiemens, written) || written.number > kMostElements) return std::nullopt;
  const Operand& operand = *written.operand;
  if (operand.kind == Kind::object) return of_object(written);
  const Bank bank = operand.area != Area::memory ? kBits : operand.name.front() == 'M' ? kMarkers : kLocal;
  return at_bits(operand.area, operand.size, bank, Size::byte, 8 * written.number + written.bit);
}

std::optional<std::string> siemens_text(const Address& address, Radix) {
  const bool is_io = address.area != Area::memory;
  if (address.bank != (is_io ? kBits : kMarkers) || address.element != 8) return std::nullopt;
  const char area = !is_io ? 'M' : address.area == Area::input ? 'I' : 'Q';
  if (address.size == Size::bit) return fmt::format("%{}{}.{}", area, address.first_bit / 8, address.first_bit % 8);
  if (address.size == Size::lword) return std::nullopt;
  const char size = address.size == Size::byte ? 'B' : address.size == Size::word ? 'W' : 'D';
  return fmt::format("%{}{}{}", area, size, address.first_bit / 8);
}

}  // namespace symplant::address
