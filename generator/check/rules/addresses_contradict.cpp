// SP315 addresses-contradict: the MELSEC and the IEC address of a row differ.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressesContradictPage =
    R"(A row has a MELSEC and an IEC address, and they differ: another number (`X0010` is input 16, `%IX17` input 17), another side
(`X`, `%Q`), or a number counted in octal in a list that counts in hexadecimal (`X0020` and `%IX16`). Most often one column was
changed and the other was not.

If more than half of a list's rows differ, there is one finding for the list: the columns do not belong together.

**What the model loses.** The IEC address counts. If it is wrong, the symbol has the address of another signal, or is on the
other side: the PLC reads and writes what belongs to another device.

**How to fix it.** Correct the wrong column, or leave it empty.
)";

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

const Rule kAddressesContradict{
    {"SP315", "addresses-contradict", diag::Severity::warning, "the MELSEC and the IEC address of a row differ",
     kAddressesContradictPage, diag::Rank::address},
    check_addresses_contradict};

}  // namespace symplant::check
