// The grammar of addresses of Omron's CS, CJ and CP, as CX-Programmer writes them.
#include <fmt/format.h>

#include "address/grammars.hpp"
#include "address/make.hpp"
#include "address/terminals.hpp"

namespace symplant::address {
namespace {

constexpr std::uint64_t kLastCioWord = 6143;

struct Region {
  std::string_view name;
  bool has_bits = true;  ///< false: timers, counters, registers
};
constexpr std::array kRegions{Region{"AR"},         Region{"A"},          Region{"CF", false}, Region{"CIO"},
                              Region{"CNT", false}, Region{"C", false},   Region{"DM"},        Region{"DR", false},
                              Region{"D"},          Region{"HR"},         Region{"H"},         Region{"IR", false},
                              Region{"LR"},         Region{"TIM", false}, Region{"TK", false}, Region{"T", false},
                              Region{"WR"},         Region{"W"}};
constexpr const Region* kCio = &kRegions[3];
static_assert(kCio->name == "CIO");
constexpr Bank kFirstBank = kMemoryBanks + 192;

struct OmronText {
  const Region* region = kCio;
  std::optional<std::uint64_t> extended_bank;  ///< of E0_100
  std::uint64_t word = 0;
  std::optional<std::uint64_t> bit;
};

const auto kOmronBit = [](auto& context) {
  auto& written = x3::get<OmronText>(context);
  written.bit = x3::_attr(context);
  x3::_pass(context) = *written.bit < 16 && written.region->has_bits;
};
const auto kExtendedBank = letter('E') >> -letter('M') >> kHexadecimal[kSet<&OmronText::extended_bank>] >> '_';
const auto kOmron = -(kExtendedBank | OneOf<kRegions>()[kSet<&OmronText::region>] >> kBlanks) >>
                    kDecimal[kSet<&OmronText::word>] >> -('.' >> kDecimal[kOmronBit]);

Area area_of(std::uint64_t word, const IoRanges* ranges) {
  if (ranges != nullptr) {
    for (const IoRanges::Range& range : ranges->ranges) {
      if (word >= range.first && word <= range.last) return range.area;
    }
  }
  return Area::memory;
}

}  // namespace

std::optional<Address> parse_omron(std::string_view text, const IoRanges* ranges) {
  OmronText written;
  if (!matches(trimmed(text), kOmron, written) || written.word > kMostElements) return std::nullopt;
  const bool is_cio = written.region == kCio && !written.extended_bank;
  if (is_cio && written.word > kLastCioWord) return std::nullopt;
  const Size size = written.bit ? Size::bit : Size::word;
  const std::uint64_t first = 16 * written.word + written.bit.value_or(0);
  if (written.extended_bank) return keyed(Area::memory, size, Key().add(*written.extended_bank).add(first));
  const Area area = is_cio ? area_of(written.word, ranges) : Area::memory;
  const auto bank = area != Area::memory ? kBits : static_cast<Bank>(kFirstBank + (written.region - kRegions.data()));
  return at_bits(area, size, bank, Size::word, first);
}

std::optional<std::string> omron_text(const Address& address, Radix) {
  if (address.element != 16 || (address.size != Size::bit && address.size != Size::word)) return std::nullopt;
  const bool is_io = address.area != Area::memory;
  const std::size_t index = address.bank - kFirstBank;
  if (is_io ? address.bank != kBits : index >= kRegions.size()) return std::nullopt;
  const Region& region = is_io ? *kCio : kRegions[index];
  const std::string word = fmt::format("{}{}", &region == kCio ? "" : region.name, address.first_bit / 16);
  return address.size == Size::word ? word : fmt::format("{}.{:02}", word, address.first_bit % 16);
}

}  // namespace symplant::address
