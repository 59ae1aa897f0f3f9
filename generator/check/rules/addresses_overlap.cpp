// SP319 addresses-overlap: a symbol has bits of other symbols.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <tuple>
#include <vector>

#include "address/bits.hpp"
#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressesOverlapPage =
    R"(The address of a symbol covers bits of other symbols: `%IW64` of SIMATIC and `%I64.3`, `%ID100` and `%IW102`, `K4X0` of MELSEC
and `X3`, `%IW5` and its bit `%IW5.3`. Either both are wanted, a word and names for its bits, or one of the addresses is wrong.

**What the model loses.** The symbols are separate: if a device sets the bit, the word does not change, and the PLC may read a
word that its bits contradict.

**How to fix it.** Correct the address. If both are wanted, let the PLC program read either the word or its bits, and ignore the
finding with the reason (section `check` of plant.json).
)";

constexpr std::size_t kFewOverlapped = 5;

/// The numbering of bits that an address is in.
struct BankOfBits {
  std::uint32_t controller = 0;
  address::Area area{};
  address::Bank bank = 0;

  auto operator<=>(const BankOfBits&) const = default;
};

/// A symbol that has an address apart, by its bits.
struct Covered {
  BankOfBits where;
  address::BitRange bits;
  std::uint32_t symbol = 0;
};

class Overlaps {
 public:
  explicit Overlaps(const model::PlantModel& plant) : plant_(plant) {}

  /// Pairs of a symbol and one of at most its size that has common bits, by symbol, then by bits. Addresses are at most
  /// 64 bits long, and only one symbol of each is looked at. O(n log n), O(n) if no bank can have an
  /// overlap.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> find() {
    collect();
    std::sort(covered_.begin(), covered_.end(), [](const Covered& a, const Covered& b) {
      return std::tie(a.where, a.bits.first, b.bits.last, a.symbol) <
             std::tie(b.where, b.bits.first, a.bits.last, b.symbol);
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < covered_.size(); ++i) {
      const Covered& first = covered_[i];
      for (std::size_t j = i + 1; j < covered_.size(); ++j) {
        const Covered& next = covered_[j];
        if (next.where != first.where || next.bits.first > first.bits.last) break;
        const bool is_smaller = next.bits.last - next.bits.first <= first.bits.last - first.bits.first;
        pairs.emplace_back(is_smaller ? first.symbol : next.symbol, is_smaller ? next.symbol : first.symbol);
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return pairs;
  }

 private:
  /// Banks in which sizes differ, or in which an address of several bits can begin at any bit.
  bool can_overlap(const model::Symbol& symbol) const {
    const unsigned sizes = sizes_[index_of(symbol)];
    return symbol.address->bank == address::kBits ? sizes > 1 : std::popcount(sizes) > 1;
  }

  /// Of the bank: by controller, area and the width of its elements, 1 to 64.
  std::size_t index_of(const model::Symbol& symbol) const {
    const std::size_t area = symbol.address->area == address::Area::output ? 1 : 0;
    const auto width = static_cast<std::size_t>(std::countr_zero(symbol.address->bank));
    return (2 * plant_.controller_of(symbol) + area) * 8 + width;
  }

  static bool is_apart(const model::Symbol& symbol) {
    return symbol.address && symbol.address->bank != address::kNoBank && symbol.leader == model::kNone &&
           static_cast<int>(symbol.address->size) == model::data_type_bits(symbol.type);
  }

  /// %IW64 of SIMATIC and K4X0, or %IW5.3: without one of these all bits are apart. Most plants have none.
  static bool is_unusual(const model::Symbol& symbol) {
    if (!symbol.address || symbol.address->bank == address::kNoBank) return false;
    return (symbol.address->bank == address::kBits) != (symbol.address->size == address::Size::bit);
  }

  void collect() {
    if (std::none_of(plant_.symbols.begin(), plant_.symbols.end(), is_unusual)) return;
    sizes_.resize(16 * plant_.controllers.size());
    for (const model::Symbol& symbol : plant_.symbols) {
      if (is_apart(symbol)) sizes_[index_of(symbol)] |= static_cast<unsigned>(symbol.address->size);
    }
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      if (!is_apart(symbol) || !can_overlap(symbol)) continue;
      const address::Address& address = *symbol.address;
      covered_.push_back({{plant_.controller_of(symbol), address.area, address.bank}, *address::bits_of(address), i});
    }
  }

  const model::PlantModel& plant_;
  std::vector<unsigned> sizes_;  ///< the sizes of a bank's addresses, a bit for each
  std::vector<Covered> covered_;
};

void check_addresses_overlap(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const auto pairs = Overlaps(plant).find();
  for (std::size_t begin = 0; begin < pairs.size();) {
    const model::Symbol& symbol = plant.symbols[pairs[begin].first];
    const model::Symbol& first = plant.symbols[pairs[begin].second];
    std::vector<diag::Related> related;
    std::size_t end = begin;
    for (; end < pairs.size() && pairs[end].first == pairs[begin].first; ++end) {
      const model::Symbol& other = plant.symbols[pairs[end].second];
      if (related.size() == kFewOverlapped) continue;
      related.push_back({location_of(plant, *other.row, other.address_cell), "has bits of it"});
    }
    const std::size_t more = end - begin - 1;
    diagnostics.add(
        rule.info, about(symbol, first).following(address_of(symbol.name())).following(address_of(first.name())),
        fmt::format("`{}` on `{}` has bits of `{}` on `{}`{}, and they are not kept equal: correct the address, or use "
                    "either of them",
                    symbol.name(), symbol.address_cell, first.name(), first.address_cell,
                    more == 0 ? "" : fmt::format(" and of {} more symbol{}", more, more == 1 ? "" : "s")),
        location_of(plant, *symbol.row, symbol.address_cell), std::move(related));
    begin = end;
  }
}

}  // namespace

const Rule kAddressesOverlap{{"SP319", "addresses-overlap", diag::Severity::warning,
                              "a symbol has bits of other symbols", kAddressesOverlapPage},
                             check_addresses_overlap};

}  // namespace symplant::check
