// Rules: addresses and how they are counted.
#include <fmt/format.h>

#include <vector>

#include "address/address.hpp"
#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

std::string_view examples_of(address::Notation notation) {
  switch (notation) {
    case address::Notation::siemens:
      return "`%I0.0`, `%QW64` or `E 2.6`";
    case address::Notation::rockwell:
      return "`Local:1:I.Data.0`";
    case address::Notation::omron:
      return "`1052.02`, `W10.00` or `D100`";
    case address::Notation::modbus:
      return "`10001` or `400001`";
    default:
      return "`%IX1`, `%QW5`, `X1F` or `Y0001`";
  }
}

/// An address of X or Y whose digits are hexadecimal, in a list that is read in octal.
bool is_hexadecimal(address::Notation notation, std::string_view cell) {
  if (notation != address::Notation::melsec) return false;
  const char first = cell.empty() ? ' ' : text::upper(cell.front());
  return (first == 'X' || first == 'Y') && address::parse_melsec(cell, address::Radix::hexadecimal).has_value();
}

void check_address_not_understood(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::BadAddress& bad : subject.evidence.bad_addresses) {
    const address::Notation notation = plant.lists[plant.list_of(*bad.row)].table->notation;
    const bool in_octal = is_hexadecimal(notation, bad.cell);
    diagnostics.add(rule.info, about(*bad.row),
                    fmt::format("`{}` is not a valid address{}: `{}` gets no address from it; {}", bad.cell,
                                in_octal ? ", since X and Y count in octal here" : "", bad.row->name,
                                in_octal ? "correct its digits, or use `--xy hex` if the list counts in hexadecimal"
                                         : fmt::format("write it like {}", examples_of(notation))),
                    location_of(plant, *bad.row, bad.cell));
  }
}

void check_no_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<const model::Symbol*> found;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address && symbol.written_address().empty()) found.push_back(&symbol);  // otherwise SP307
  }
  if (found.empty()) return;
  std::vector<diag::Related> others;
  for (std::size_t i = 1; i < found.size() && i <= 5; ++i)
    others.push_back({location_of(plant, *found[i]), "no address either"});
  diagnostics.add(rule.info, about(*found[0]),
                  found.size() == 1 ? fmt::format("`{}` has no address: it is on no link", found[0]->name())
                                    : fmt::format("`{}` and {} more have no address: they are on no link",
                                                  found[0]->name(), found.size() - 1),
                  location_of(plant, *found[0]), std::move(others));
}

void check_radix_assumed(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (std::uint32_t list = 0; list < plant.lists.size(); ++list) {
    const model::RadixChoice& radix = plant.lists[list].radix;
    if (radix.by != model::RadixChoice::By::nothing || radix.matters_in == nullptr) continue;
    const read::ListRow& row = *radix.matters_in;
    if (plant.list_of(row) != list) continue;  // reported once for all lists of a controller
    diagnostics.add(rule.info, about(row),
                    fmt::format("`{}` is read as hexadecimal, and nothing in the list proves it: use `--xy hex` or "
                                "`--xy octal`",
                                row.vendor_address),
                    location_of(plant, row, row.vendor_address));
  }
}

std::string_view radix_name(address::Radix radix) {
  return radix == address::Radix::hexadecimal ? "hexadecimal" : "octal";
}

void check_radix_disagrees(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::PlantList& list : plant.lists) {
    if (list.own.by == model::RadixChoice::By::nothing || list.own.radix == list.radix.radix) continue;
    diag::Location location{list.table->source, {}};
    if (list.own.proof != nullptr) location = location_of(plant, *list.own.proof, list.own.proof->vendor_address);
    std::vector<diag::Related> related;
    if (list.radix.proof != nullptr) {
      const read::ListRow& proof = *list.radix.proof;
      related.push_back({location_of(plant, proof, proof.vendor_address), "this row proves the other radix"});
    }
    diagnostics.add(rule.info,
                    fmt::format("this list counts X and Y in {}, but all lists of its controller are read in {}: "
                                "correct one of them, or give the lists different controllers",
                                radix_name(list.own.radix), radix_name(list.radix.radix)),
                    std::move(location), std::move(related));
  }
}

constexpr std::size_t kFew = 8;

std::string_view side(address::Area area) {
  switch (area) {
    case address::Area::input:
      return "input";
    case address::Area::output:
      return "output";
    default:
      return "memory of the PLC";
  }
}

std::string location_words(const address::Address& address, bool with_number) {
  if (address.area == address::Area::memory) return "in the memory of the PLC";
  const std::string_view article = with_number ? "" : "an ";
  return fmt::format("{}{}{}", article, side(address.area), with_number ? fmt::format(" {}", address.number) : "");
}

address::Radix other_radix(address::Radix radix) {
  return radix == address::Radix::hexadecimal ? address::Radix::octal : address::Radix::hexadecimal;
}

std::string_view radix_word(address::Radix radix) {
  return radix == address::Radix::hexadecimal ? "hexadecimal" : "octal";
}

/// Whether the two agree if X and Y are counted in the other radix.
bool agree_otherwise(const model::PlantModel& plant, const model::AddressContradiction& found) {
  const auto other = address::parse_melsec(found.row->vendor_address, other_radix(plant.lists[found.list].radix.radix));
  return other && *other == found.iec;
}

/// What is there, as far as "the IEC address counts".
std::string difference(const model::PlantModel& plant, const model::AddressContradiction& found) {
  const read::ListRow& row = *found.row;
  const address::Radix radix = plant.lists[found.list].radix.radix;
  if (found.vendor.area == found.iec.area && agree_otherwise(plant, found)) {
    return fmt::format("`{}` and `{}` agree only where X and Y are counted in {}, and here they are counted in {}",
                       row.vendor_address, row.iec_address, radix_word(other_radix(radix)), radix_word(radix));
  }
  const bool numbers = found.vendor.area == found.iec.area;
  return fmt::format("`{}` is {} and `{}` {}", row.vendor_address, location_words(found.vendor, numbers),
                     row.iec_address, location_words(found.iec, numbers));
}

/// SP314 reports a list that counts in another radix than its controller.
bool reported_of_list(const model::PlantModel& plant, const model::AddressContradiction& found) {
  const model::PlantList& list = plant.lists[found.list];
  return list.own.by != model::RadixChoice::By::nothing && list.own.radix != list.radix.radix &&
         agree_otherwise(plant, found);
}

/// The symbol and its device, or the row if it is left out.
diag::Subjects about_row(const model::PlantModel& plant, const read::ListRow& row) {
  const model::Symbol* symbol = symbol_of(plant, row);
  diag::Subjects subjects = symbol != nullptr ? about(*symbol) : about(row);
  subjects.explains.push_back(address_of(row.name));
  return subjects;
}

void check_addresses_contradict(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<std::size_t> count(plant.lists.size());
  for (const model::AddressContradiction& found : subject.evidence.address_contradictions) ++count[found.list];
  std::vector<bool> reported(plant.lists.size());
  for (const model::AddressContradiction& found : subject.evidence.address_contradictions) {
    if (reported_of_list(plant, found)) continue;
    const model::PlantList& list = plant.lists[found.list];
    const read::ListRow& row = *found.row;
    diag::Location location = location_of(plant, row, row.iec_address);
    if (count[found.list] > kFew && 2 * count[found.list] > list.compared) {
      if (reported[found.list]) continue;
      reported[found.list] = true;
      diagnostics.add(rule.info,
                      fmt::format("the two addresses of {} of {} rows differ, first of this one: {}; "
                                  "the IEC addresses count; export the list again, or empty the column that is wrong",
                                  count[found.list], list.compared, difference(plant, found)),
                      std::move(location));
      continue;
    }
    std::vector<diag::Related> related;
    if (list.radix.proof != nullptr && found.vendor.area == found.iec.area) {
      related.push_back({location_of(plant, *list.radix.proof, list.radix.proof->vendor_address),
                         "this row proves how X and Y are counted"});
    }
    diagnostics.add(rule.info, about_row(plant, row),
                    fmt::format("{}: the IEC address counts; correct one of them", difference(plant, found)),
                    std::move(location), std::move(related));
  }
}

}  // namespace

const Rule kAddressNotUnderstood{
    {"SP307", "address-not-understood", diag::Severity::warning, "an address cell has no valid address",
     R"(A cell of an address column has something that is neither an IEC 61131-3 address (`%IX1`, `%QX0.5`, `%IW5`) nor an address in the
notation of the list's tool: a MELSEC device (X1F, Y0001, M500, D10), a SIMATIC operand (`%I0.0`, `E 2.6`, `PIW 64`), a tag of a
Logix module (`Local:1:I.Data.0`), a word and bit of CX-Programmer (`1052.02`, `W10.00`), a Modbus reference (10001).

**What the model loses.** The symbol has no address from this cell. If the other column has none either, its direction is that
of its name, and it is on no link.

**How to fix it.** Correct the cell. Digits 8, 9 and A to F in X and Y need `--xy hex`.
)"},
    check_address_not_understood};

const Rule kNoAddress{
    {"SP309", "no-address", diag::Severity::note, "I/O symbols have no address",
     R"(Some symbols have neither a vendor's nor an IEC address; their direction comes from their names.

**What the model loses.** Nothing within the plant: they are in the model and in traces. But they are on no link, so no PLC
writes or reads them.

**How to fix it.** Give them addresses if a PLC should see them.
)"},
    check_no_address};

const Rule kRadixAssumed{
    {"SP308", "radix-assumed", diag::Severity::note, "whether X and Y count in hexadecimal is assumed",
     R"(MELSEC Q, L and iQ-R count X and Y in hexadecimal, FX and iQ-F in octal. This list proves neither: no row has both a MELSEC and
an IEC address, and it has numbers for which it makes a difference.

**What the model loses.** Nothing within the plant. On a link, `X0010` has index 16 in hexadecimal and index 8 in octal.

**How to fix it.** Use `--xy hex` or `--xy octal` (in plant.json `"xy"` next to the list's file), or export the IEC addresses as
well.
)"},
    check_radix_assumed};

const Rule kRadixDisagrees{
    {"SP314", "radix-disagrees", diag::Severity::warning, "two lists of one controller count X and Y differently",
     R"(A controller counts its X and Y either in hexadecimal or in octal. Here the lists of one controller disagree, by rows with both
a MELSEC and an IEC address or by their `"xy"`. What most rows of all its lists prove counts for all of them.

**What the model loses.** MELSEC addresses of this list in rows without an IEC address are read in the other radix: `X0010` has
index 16 in hexadecimal and index 8 in octal.

**How to fix it.** If the lists belong to two controllers, give each its `"controller"`. If they belong to one, correct the
wrong addresses, or the `"xy"`.
)"},
    check_radix_disagrees};

const Rule kAddressesContradict{
    {"SP315", "addresses-contradict", diag::Severity::warning, "the MELSEC and the IEC address of a row differ",
     R"(A row has a MELSEC and an IEC address, and they differ: another number (`X0010` is input 16, `%IX17` input 17), another side
(`X`, `%Q`), or a number counted in octal in a list that counts in hexadecimal (`X0020` and `%IX16`). Most often one column was
changed and the other was not.

If more than half of a list's rows differ, there is one finding for the list: the columns do not belong together.

**What the model loses.** The IEC address counts. If it is wrong, the symbol has the address of another signal, or is on the
other side: the PLC reads and writes what belongs to another device.

**How to fix it.** Correct the wrong column, or leave it empty.
)",
     diag::Rank::address},
    check_addresses_contradict};

}  // namespace symplant::check
