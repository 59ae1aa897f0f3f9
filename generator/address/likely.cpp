// Recognizes addresses, and the notation of a column of them.
#include <algorithm>
#include <array>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/notation.hpp"

namespace symplant::address {
namespace {

/// In the order of preference, where several read the same.
constexpr std::array kByPreference{Notation::iec,   Notation::siemens,  Notation::melsec,
                                   Notation::omron, Notation::rockwell, Notation::modbus};

/// An address of a notation; a name without a module is no evidence for Rockwell.
std::optional<Address> evident(std::string_view cell, Notation notation) {
  if (notation == Notation::rockwell && cell.find(':') == cell.npos) return std::nullopt;
  return parse(cell, {notation});
}

/// %I0.0, which IEC 61131-3 and SIMATIC read: without a letter of a size.
bool is_byte_and_bit_of_siemens(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() < 3 || text::upper(cell[1]) == 'M' || !text::is_digit(cell[2])) return false;
  return cell.find('.') != cell.npos && parse_siemens(cell).has_value();
}

bool is_evident_tag(std::string_view text) {
  const auto address = parse_rockwell(text);
  return address && address->area != Area::memory && (text.find('.') != text.npos || text.find('/') != text.npos);
}

/// Devices of memory that lists of symbols often have.
bool is_common_device(char first) {
  return first == 'M' || first == 'D' || first == 'B' || first == 'W' || first == 'L' || first == 'R';
}

/// X1F, Y0001, unlike the name X1.
bool has_two_digits(std::string_view text) { return text.size() > 2 && text::is_digit(text[1]); }

}  // namespace

std::optional<Notation> likely_notation(std::span<const std::string_view> cells) {
  std::array<std::size_t, kByPreference.size()> counts{};
  std::size_t filled = 0;
  bool has_siemens_bits = false;
  for (const std::string_view cell : cells) {
    if (trimmed(cell).empty()) continue;
    ++filled;
    has_siemens_bits = has_siemens_bits || is_byte_and_bit_of_siemens(cell);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += evident(cell, kByPreference[i]).has_value() ? 1U : 0U;
  }
  auto best = static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  if (counts[best] == 0 || 2 * counts[best] < filled) return std::nullopt;
  for (std::size_t other = best + 1; other < counts.size(); ++other) {
    if (counts[other] != counts[best]) continue;
    for (const std::string_view cell : cells) {
      const auto a = evident(cell, kByPreference[best]);
      const auto b = evident(cell, kByPreference[other]);
      if (a.has_value() != b.has_value() || (a && a->area != b->area)) return std::nullopt;
    }
  }
  const bool is_iec = kByPreference[best] == Notation::iec;
  if (is_iec && has_siemens_bits && counts[1] == counts[0]) return Notation::siemens;
  return kByPreference[best];
}

int address_strength(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return 0;
  if (parse_iec(text) || is_evident_tag(text)) return 2;
  const auto siemens = parse_siemens(text);
  if (siemens) {
    const bool has_dot = text.find('.') != text.npos;  // E 2.6, DB1.DBX0.0
    if (has_dot || text.front() == '%' || text.find(':') != text.npos) return 2;
    if (siemens->area != Area::memory) return text::upper(text.front()) == 'P' ? 2 : 1;  // PIW 64; IW64
  }
  if (const auto melsec = parse_melsec(text, Radix::hexadecimal)) {
    if (melsec->area != Area::memory) return has_two_digits(text) ? 2 : 1;
    const bool is_certain = text.find('\\') != text.npos || (text.find('.') != text.npos && text.size() > 4);
    if (is_certain) return 2;
    return is_common_device(text::upper(text.front())) && text::is_digit(text[1]) ? 1 : 0;
  }
  if (parse_modbus(text)) return 1;
  const auto omron = parse_omron(text, nullptr);
  const bool is_word_and_bit = omron && omron->size == Size::bit;
  return is_word_and_bit ? 1 : 0;
}

}  // namespace symplant::address
