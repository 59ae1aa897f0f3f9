// SP307 address-not-understood: an address cell has no valid address.
#include <fmt/format.h>

#include "address/address.hpp"
#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressNotUnderstoodPage =
    R"(A cell of an address column has something that is neither an IEC 61131-3 address (`%IX1`, `%QX0.5`, `%IW5`) nor an address in the
notation of the list's tool: a MELSEC device (X1F, Y0001, M500, D10), a SIMATIC operand (`%I0.0`, `E 2.6`, `PIW 64`), a tag of a
Logix module (`Local:1:I.Data.0`), a word and bit of CX-Programmer (`1052.02`, `W10.00`), a Modbus reference (10001).

**What the model loses.** The symbol has no address from this cell. If the other column has none either, its direction is that
of its name, and it is on no link.

**How to fix it.** Correct the cell. Digits 8, 9 and A to F in X and Y need `--xy hex`.
)";

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

}  // namespace

const Rule kAddressNotUnderstood{{"SP307", "address-not-understood", diag::Severity::warning,
                                  "an address cell has no valid address", kAddressNotUnderstoodPage},
                                 check_address_not_understood};

}  // namespace symplant::check
