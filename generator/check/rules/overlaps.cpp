// Rules: addresses that share bits.
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

constexpr std::size_t kFewOverlapped = 5;

/// The numbering of bits that an address is in.
struct BankOfBits {
  std::uint32_t controller = 0;
  address::Area area{};
  address::Bank bank = 0;

  bool operator==(const BankOfBits&) const = default;
  bool operator<(const BankOfBits& other) const {
    return std::tie(controller, area, bank) < std::tie(other.controller, other.area, other.bank);
  }
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

/// One finding for the overlaps of a symbol with numbers, or with bits.
class OverlapReport {
 public:
  OverlapReport(const model::PlantModel& plant, const model::Symbol& symbol) : plant_(plant), symbol_(symbol) {}

  void take(const model::Symbol& other) {
    ++count_;
    if (first_ == nullptr) first_ = &other;
    if (related_.size() == kFewOverlapped) return;
    related_.push_back({location_of(plant_, *other.row, other.address_cell()), "has bits of it"});
  }

  void report(const diag::RuleInfo& rule, std::string_view advice, diag::Diagnostics& diagnostics) {
    if (first_ == nullptr) return;
    const std::string more =
        count_ == 1 ? "" : fmt::format(" and of {} more symbol{}", count_ - 1, count_ == 2 ? "" : "s");
    diagnostics.add(
        rule, about(symbol_, *first_).following(address_of(symbol_.name())).following(address_of(first_->name())),
        fmt::format("`{}` on `{}` has bits of `{}` on `{}`{}, and they are not kept equal: {}", symbol_.name(),
                    symbol_.address_cell(), first_->name(), first_->address_cell(), more, advice),
        location_of(plant_, *symbol_.row, symbol_.address_cell()), std::move(related_));
  }

 private:
  const model::PlantModel& plant_;
  const model::Symbol& symbol_;
  const model::Symbol* first_ = nullptr;
  std::size_t count_ = 0;
  std::vector<diag::Related> related_;
};

void check_addresses_overlap(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const auto pairs = Overlaps(plant).find();
  for (std::size_t at = 0; at < pairs.size();) {
    const std::uint32_t larger = pairs[at].first;
    OverlapReport numbers(plant, plant.symbols[larger]);
    OverlapReport bits(plant, plant.symbols[larger]);
    for (; at < pairs.size() && pairs[at].first == larger; ++at) {
      const model::Symbol& other = plant.symbols[pairs[at].second];
      (other.address->size == address::Size::bit ? bits : numbers).take(other);
    }
    numbers.report(rule.info, "correct one of the addresses", diagnostics);
    bits.report(kWordAndBits.info, "let the PLC program use either the number or its bits", diagnostics);
  }
}

}  // namespace

const Rule kAddressesOverlap{
    {"SP319", "addresses-overlap", diag::Severity::warning, "two numbers have common bits",
     R"(The addresses of two numbers have common bits: `%ID100` of SIMATIC and `%IW102`, `%IW100` and `%IW101`. SIMATIC numbers bytes, so
the double word `%ID100` ends with byte 103. Most often one of the addresses is wrong. A number and its bits are SP320.

**What the model loses.** The symbols are separate: what a device or the PLC writes to one of them does not change the other.

**How to fix it.** Correct the address. If both are wanted, let the PLC program use one of them, and ignore the finding with the
reason (section `check` of plant.json).
)"},
    check_addresses_overlap};

/// Fired by what makes the map of a link (app/map_findings.cpp).
const Rule kSymbolsOverlap{
    {"SP316", "symbols-overlap", diag::Severity::error, "two symbols have one coil, input or register of a link",
     R"(Two symbols of different addresses, or of different sizes, have the same coil, input or register of their PLC's link. By default
a symbol's number is that of its address, counted in registers: `%QD5` has holding registers 10 and 11, and meets `%QW10` and
`%QW11`. Numbers from the description's `links` can meet others, too.

**What the model loses.** What the PLC writes for one of them would reach the other.

**How to fix it.** Correct the addresses, or give one of the two another `number` in `links`. `symplant map` shows the index of
each symbol.
)"}};

/// Fired by the search for overlaps (addresses_overlap.cpp).
const Rule kWordAndBits{
    {"SP320", "word-and-bits", diag::Severity::note, "a number and its bits are symbols",
     R"(A number and some of its bits are symbols: `%IW64` of SIMATIC and `%I64.3`, `%IW5` and its bit `%IW5.3`, `K4X0` of MELSEC and `X3`.
Usually both are wanted: the word to copy it, its bits by name. There is one finding for each number, with all of its bits.

**What the model loses.** The symbols are separate: if a device sets the bit, the word does not change, and the PLC may read a
word that its bits contradict.

**How to fix it.** Let the PLC program read either the word or its bits, or correct the address.
)"}};

}  // namespace symplant::check
