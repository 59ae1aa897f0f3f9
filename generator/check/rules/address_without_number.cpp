// SP317 address-without-number: one address without a number makes the others lose theirs on the link.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressWithoutNumberPage =
    R"(A symbol on a link has the number of its address: `%IX1.5` is discrete input 13, `%QX7` is coil 7. Some addresses have no number:
a bit of 8 or more (`%IX1.8`), three parts, a number of 65536 or more. Then all symbols of the table are packed in list order,
since they could overlap otherwise. Here most addresses of a table have a number, and a few have none.

**What the model loses.** Every coil, input or register of that table has another number on the link than its address. Wiring the
PLC by addresses fails without a message.

**How to fix it.** Correct the address. Or give the symbol a `number` in the description's `links`: then the others keep theirs.
A list in which all addresses consist of word and bit (`%IX1.15`) is packed as a whole and has no finding.
)";

constexpr std::uint64_t kLocations = 65'536;
constexpr std::size_t kMostRelated = 10;

bool is_on_link(const model::Symbol& symbol) {
  const int bits = model::data_type_bits(symbol.type);
  return symbol.address && bits != 8 && bits == static_cast<int>(symbol.address->size);
}

bool has_location(const model::Symbol& symbol) {
  const std::uint64_t locations = static_cast<std::uint64_t>(std::max(1, model::data_type_bits(symbol.type) / 16));
  return symbol.address->plain && symbol.address->number <= (kLocations - locations) / locations;
}

/// Of one table of one controller.
struct PackedTable {
  std::size_t placed = 0;
  std::vector<std::uint32_t> others;
};

class AddressesOfLink {
 public:
  explicit AddressesOfLink(const model::PlantModel& plant) : plant_(plant), tables_(4 * plant.controllers.size()) {}

  std::vector<PackedTable> run() {
    std::vector<bool> given(plant_.symbols.size());
    for (const model::ControllerLink& link : plant_.links) {
      for (const link::MapRow& row : link.rows) given[row.symbol] = row.number != link::MapRow::kDefault;
    }
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      if (given[i] || !is_on_link(symbol)) continue;
      const std::size_t kind = (symbol.direction == tables::Direction::operation ? 2U : 0U) +
                               (symbol.type == tables::DataType::boolean ? 1U : 0U);
      PackedTable& table = tables_[4 * plant_.controller_of(symbol) + kind];
      if (has_location(symbol)) {
        ++table.placed;
      } else {
        table.others.push_back(i);
      }
    }
    return std::move(tables_);
  }

 private:
  const model::PlantModel& plant_;
  std::vector<PackedTable> tables_;
};

void check_address_without_number(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  constexpr std::array<std::string_view, 4> kTables{"input registers", "discrete inputs", "holding registers", "coils"};
  const std::vector<PackedTable> tables = AddressesOfLink(plant).run();
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const PackedTable& table = tables[t];
    if (table.others.empty() || table.placed <= table.others.size()) continue;
    const model::Symbol& symbol = plant.symbols[table.others.front()];
    std::vector<diag::Related> related;
    for (std::size_t i = 1; i < std::min(table.others.size(), kMostRelated); ++i) {
      const model::Symbol& other = plant.symbols[table.others[i]];
      related.push_back({location_of(plant, *other.row, other.address_cell), "this one has no number either"});
    }
    diagnostics.add(
        rule.info, about(symbol),
        fmt::format("`{}` has no number on a link, so {} other {} are in list order and do not have their own "
                    "numbers: correct it, or give `{}` a `number` in `links`",
                    symbol.address_cell, table.placed + table.others.size() - 1, kTables[t % 4], symbol.name()),
        location_of(plant, *symbol.row, symbol.address_cell), std::move(related));
  }
}

}  // namespace

const Rule kAddressWithoutNumber{
    {"SP317", "address-without-number", diag::Severity::warning,
     "one address without a number makes the others lose theirs on the link", kAddressWithoutNumberPage},
    check_address_without_number};

}  // namespace symplant::check
