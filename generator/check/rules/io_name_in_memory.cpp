// SP323 io-name-in-memory: a name says that it is an input or output, and its address is in the PLC's memory.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIoNameInMemoryPage =
    R"(A name follows the naming rule, direction included, and the address of the symbol is in the memory of the PLC: `M100`, `%MX0.3`.
Names such as `LINE_PROC_DEV_I_TASK` say that the symbol is an input or an output.

**What the model loses.** The row is left out: memory belongs to the program, not to the plant. The device lacks the symbol.

**How to fix it.** Give the symbol the address that is wired. If the program copies its inputs and outputs to memory, and the plant
is to use these addresses, remove the address from the list and place the symbol with `map` in the `links` of plant.json.
)";

void check_io_name_in_memory(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.units.empty()) return;  // the names have the form by accident
  if (plant.internal[static_cast<std::size_t>(model::InternalReason::memory)] == 0) return;
  name::NameParser parser(*plant.rule);
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      if (symbol_of(plant, row) != nullptr || row.klass.find("CONSTANT") != std::string_view::npos) continue;
      const name::NameReading reading = parser.parse(row.name);
      if (reading.fault != name::NameFault::none) continue;
      const model::RowAddress address = model::row_address(row, list.dialect());
      if (!address.address || address.address->area != address::Area::memory || address.contradicts) continue;
      diag::Subjects subjects = about(row);
      const bool operation = reading.direction == name::Direction::operation;
      explain_missing(subjects, std::string(row.name), reading.device_path,
                      operation ? tables::Direction::operation : tables::Direction::event);
      diagnostics.add(
          rule.info, std::move(subjects),
          fmt::format("`{}` is an {} by its name, and its address `{}` is in the memory of the PLC: the row "
                      "is left out; correct the address",
                      row.name, operation ? "operation" : "event", address.cell),
          location_of(plant, row, address.cell));
    }
  }
}

}  // namespace

const Rule kIoNameInMemory{
    {"SP323", "io-name-in-memory", diag::Severity::warning,
     "a name of an input or output has an address in the PLC's memory", kIoNameInMemoryPage, diag::Rank::address},
    check_io_name_in_memory};

}  // namespace symplant::check
