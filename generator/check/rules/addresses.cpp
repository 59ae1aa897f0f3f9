// Rules: addresses, how they are counted, and which symbols share them.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <tuple>

#include "address/bits.hpp"
#include "check/rule.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

/// The cell of a symbol's address, also if the symbol lost it.
std::string_view written_cell(const Symbol& symbol) {
  return symbol.address_is_iec ? symbol.row->iec_address : symbol.row->vendor_address;
}

/// Two symbols of one location.
Finding at_shared(const Find& find, const Symbol& symbol, const Symbol& other, std::string text) {
  Finding finding = find.at(symbol, written_cell(symbol));
  finding.also(Kind::symbol, other.name()).see(*other.row, other.address_cell(), std::move(text));
  return finding.follows(Kind::address, symbol.name()).follows(Kind::address, other.name());
}

void address_used_twice(const Find& find, const Symbol& symbol) {
  if (symbol.leader == kNone) return;
  const auto index = static_cast<std::uint32_t>(&symbol - find.symbols.data());
  const auto& twice = find.evidence.driven_twice;  // SP304 reports them
  const auto driven = std::ranges::lower_bound(twice, std::array{index, std::uint32_t{0}});
  if (driven != twice.end() && (*driven)[0] == index) return;
  const Symbol& leader = find.symbols[symbol.leader];
  at_shared(find, symbol, leader, "the symbol that it follows")
      .say("`{}` has the address `{}`, as `{}` has: they are kept equal; correct the address if they are two signals",
           symbol.name(), symbol.address_cell(), leader.name());
}

void event_driven_twice(const Find& find) {
  const auto& twice = find.evidence.driven_twice;
  for (auto pair = twice.begin(); pair != twice.end();) {
    const std::uint32_t first = (*pair)[1];
    const Symbol& a = find.symbols[first];
    const Symbol& b = find.symbols[(*pair)[0]];
    const auto follows = [&](const auto& other) {
      return other[1] == first && b.unit != kNone && find.symbols[other[0]].unit == b.unit;
    };
    const auto end = std::find_if_not(pair + 1, twice.end(), follows);
    Finding finding = at_shared(find, b, a, "the other one");
    std::string names = fmt::format("`{}`", b.name());
    for (const auto& other : std::span(pair + 1, end)) {
      const Symbol& symbol = find.symbols[other[0]];
      finding.also(Kind::symbol, symbol.name()).follows(Kind::address, symbol.name());
      names += fmt::format(" and `{}`", symbol.name());
    }
    const bool one = end - pair == 1;
    finding.say(
        "{} {} the address `{}`, as `{}` has, and the plant drives each of them: the address counts for `{}` alone; "
        "correct {}",
        names, one ? "has" : "have", written_cell(b), a.name(), a.name(), one ? "one of them" : "them");
    pair = end;
  }
}

void address_not_understood(const Find& find) {
  for (const model::BadAddress& bad : find.evidence.bad_addresses) {
    const bool melsec = find.plant.lists[find.plant.list_of(*bad.row)].table->notation == address::Notation::melsec;
    const bool octal = melsec && address::parse_melsec(bad.cell, address::Radix::hexadecimal).has_value();
    find.at(*bad.row, bad.cell)
        .say("`{}` is not a valid address{}: `{}` gets no address from it; correct it", bad.cell,
             octal ? ", since X and Y count in octal here (`--xy hex` changes that)" : "", bad.row->name);
  }
}

void no_address(const Find& find) {
  std::vector<const Symbol*> found;
  for (const Symbol& symbol : find.symbols) {
    if (!symbol.address && symbol.written_address().empty()) found.push_back(&symbol);  // otherwise SP307
  }
  if (found.empty()) return;
  find.at(*found[0]).say("`{}`{} no address, and no link", found[0]->name(),
                         found.size() == 1 ? " has" : fmt::format(" and {} more have", found.size() - 1));
}

void radix_assumed(const Find& find) {
  using By = model::RadixChoice::By;
  for (const model::PlantList& list : find.plant.lists) {
    if (list.own.by == By::option && list.own.radix != list.radix.radix) {
      Finding finding = find.at(diag::Location{list.table->source, {}});
      finding.as.severity = kWarning;
      finding.say("this list has another `xy` than another list of its controller: give both the same");
    }
    const read::ListRow* row = list.radix.matters_in;
    if (list.radix.by != By::nothing || row == nullptr) continue;
    if (&find.plant.lists[find.plant.list_of(*row)] != &list) continue;  // once for all lists of a controller
    find.at(*row, row->vendor_address)
        .say("`{}` is read as hexadecimal, and nothing in the list proves it: use `--xy hex` or `--xy octal`",
             row->vendor_address);
  }
}

/// "input 16".
std::string location_text(const address::Address& address) {
  if (address.area == address::Area::memory) return "memory";
  return fmt::format("{} {}", address.area == address::Area::input ? "input" : "output", address.number);
}

void addresses_contradict(const Find& find) {
  std::vector<std::size_t> count(find.plant.lists.size());
  for (const model::AddressContradiction& found : find.evidence.address_contradictions) ++count[found.list];
  for (const model::AddressContradiction& found : find.evidence.address_contradictions) {
    const model::PlantList& list = find.plant.lists[found.list];
    const std::size_t of_list = count[found.list];
    if (of_list == 0) continue;  // they are reported
    const read::ListRow& row = *found.row;
    const bool all = of_list > 8 && 2 * of_list > list.compared;
    if (all) count[found.list] = 0;
    Finding finding = all ? find.at(location_of(find.plant, row, row.iec_address)) : find.at(row, row.iec_address);
    finding.explains(Kind::address, row.name);
    if (list.radix.proof != nullptr && found.vendor.area == found.iec.area) {
      finding.see(*list.radix.proof, list.radix.proof->vendor_address, "this row proves how X and Y are counted");
    }
    finding.say(
        "{}`{}` ({}) and `{}` ({}) differ: the IEC address counts; correct one of them",
        all ? fmt::format("the two addresses differ in {} of {} rows, such as here: ", of_list, list.compared) : "",
        row.vendor_address, location_text(found.vendor), row.iec_address, location_text(found.iec));
  }
}

/// The bits of a symbol, by the numbering that it shares.
struct Covered {
  std::tuple<std::uint32_t, address::Area, address::Bank> numbering;
  address::BitRange bits;
  const Symbol* symbol;
};

void addresses_overlap(const Find& find) {
  std::vector<Covered> covered;
  const auto is_bool = [](const Symbol& symbol) { return symbol.type == tables::DataType::boolean; };
  if (std::ranges::all_of(find.symbols, is_bool)) return;
  for (const Symbol& symbol : find.symbols) {
    if (!symbol.address || symbol.address->bank == address::kNoBank || symbol.leader != kNone) continue;
    if (static_cast<int>(symbol.address->size) != model::data_type_bits(symbol.type)) continue;
    covered.push_back({{find.plant.controller_of(symbol), symbol.address->area, symbol.address->bank},
                       *address::bits_of(*symbol.address),
                       &symbol});
  }
  std::ranges::sort(covered, [](const Covered& a, const Covered& b) {  // of two the larger one is first
    return std::tuple(a.numbering, a.bits.first, b.bits.last) < std::tuple(b.numbering, b.bits.first, a.bits.last);
  });
  const Covered* next = nullptr;  // the one that reaches farthest
  bool has_bits = false;
  for (const Covered& part : covered) {
    const Covered* whole = next;
    const bool apart = whole == nullptr || part.numbering != whole->numbering || part.bits.first > whole->bits.last;
    if (apart || part.bits.last > whole->bits.last) next = &part;
    if (apart) has_bits = false;
    const bool bit = part.symbol->address->size == address::Size::bit;
    if (apart || (bit && std::exchange(has_bits, true))) continue;
    Finding finding = at_shared(find, *whole->symbol, *part.symbol, "has bits of it");
    if (bit) finding.as.severity = kNote;
    finding.say("`{}` on `{}` has bits of `{}` on `{}`, and they are not kept equal: {}", whole->symbol->name(),
                whole->symbol->address_cell(), part.symbol->name(), part.symbol->address_cell(),
                bit ? "let the PLC program use either the number or its bits" : "correct one of the addresses");
  }
}

constexpr Rule kAddressRules[] = {
    {"SP303", "address-used-twice", kWarning, address_used_twice, "several symbols have one address",
     "This may be intended (two names for one signal). Most often a row was copied and its address not changed.",
     "The symbols are kept equal: writing one writes all.",
     "Give the symbol the address that it has in the wiring, or remove the second name."},
    {"SP304", "event-driven-twice", kWarning, event_driven_twice, "two devices drive events on one address",
     "Devices, conditions (`follow`) or sensors of parts drive two events of one address.",
     "The PLC reads one bit there. It gets the event of the first row; the later one runs, but has no address: without "
     "`map` in `links` it is on no link.",
     "Correct the address of one of them."},
    {"SP307", "address-not-understood", kWarning, address_not_understood, "an address cell has no valid address",
     "It is no IEC 61131-3 address (`%IX1`, `%QX0.5`, `%IW5`) and none of the list's tool: `X1F`, `%I0.0`, `E2.6`, "
     "`PIW64`, `Local:1:I.Data.0`, `1052.02`, `10001`.",
     "Without another address the symbol is on no link, and its name gives its direction.",
     "Correct the cell. Digits 8, 9 and A to F in X and Y need `--xy hex`."},
    {"SP308", "radix-assumed", kNote, radix_assumed, "whether X and Y count in hexadecimal is assumed",
     "MELSEC Q, L and iQ-R count X and Y in hexadecimal, FX and iQ-F in octal: `X0010` has index 16 or 8 on a link. "
     "Rows with a MELSEC and an IEC address prove it for all lists of a controller. Else use `--xy hex` or "
     "`--xy octal`."},
    {"SP309", "no-address", kNote, no_address, "I/O symbols have no address",
     "They are in the model and in traces, and their names give their directions. A PLC does not see them."},
    {"SP315", "addresses-contradict", kWarning, addresses_contradict, "the MELSEC and the IEC address of a row differ",
     "Most often one column was changed and the other was not. If more than half of a list's rows differ, there is one "
     "finding for the list: it counts X and Y in octal, and other lists of its controller do not.",
     "The IEC address counts. If it is wrong, the symbol has the address of another signal.",
     "Correct the wrong column, or leave it empty; or give each list a `controller`.", Rank::address},
    {"SP316", "symbols-overlap", kError, nullptr, "two symbols have one coil, input or register of a link",
     "By default a symbol has the number of its address in registers: `%QD5` has 10 and 11, and overlaps `%QW10`.",
     "What the PLC writes for one of them would reach the other.",
     "Correct an address, or give one a `number` in `links`. `symplant map` shows each index."},
    {"SP317", "address-without-number", kWarning, nullptr,
     "an address without a number changes the numbers of other symbols",
     "In a table, most addresses have a number (`%IX1.5` is discrete input 13), and a few have none: a bit of 8 or "
     "more "
     "(`%IX1.8`), three parts, 65536 or more. Then all symbols of the table are packed in list order.",
     "Every coil, input or register of that table has another number on the link than its address.",
     "Correct the address, or give the symbol a `number` in the `links` of plant.json: then the others keep their "
     "numbers."},
    {"SP319", "addresses-overlap", kWarning, addresses_overlap, "two numbers, or a number and a bit, overlap",
     "SIMATIC numbers bytes: `%ID100` has bits of `%IW102`. A word and its bits (`%IW64`, `%I64.3`) are usually "
     "wanted.",
     "They are separate symbols: what is written to one does not change the other.",
     "Correct the address, or let the PLC program use one of them."},
};

}  // namespace

std::span<const Rule> address_rules() { return kAddressRules; }

}  // namespace symplant::check
