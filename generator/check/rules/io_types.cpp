// Rules: directions and types of inputs and outputs.
#include <fmt/format.h>

#include <vector>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

void check_direction_against_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  if (!conflicts_are_errors(subject.plant)) report_direction_conflicts(rule, subject, diagnostics);
}

/// The symbol, which its device lacks.
diag::Subjects about_lost(const model::Symbol& symbol) {
  diag::Subjects subjects = about(symbol).explaining(address_of(symbol.name()));
  explain_missing(subjects, std::string(symbol.name()), symbol.reading.device_path(), symbol.direction);
  return subjects;
}

void check_type_against_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address) continue;
    const int bits = model::data_type_bits(symbol.type);
    if (bits == static_cast<int>(symbol.address->size)) continue;
    diagnostics.add(
        rule.info, about_lost(symbol),
        fmt::format("`{}` is {}, {} bit{}, but its address `{}` has {}: it is on no link; correct type or address",
                    symbol.name(), model::data_type_name(symbol.type), bits, bits == 1 ? "" : "s",
                    symbol.address_cell(), static_cast<int>(symbol.address->size)),
        location_of(plant, *symbol.row, symbol.row->type),
        {{location_of(plant, *symbol.row, symbol.address_cell()), "the address"}});
  }
}

/// The row, which its device lacks.
diag::Subjects about_lost(const read::ListRow& row, name::NameParser& parser) {
  diag::Subjects subjects = about(row);
  const name::NameReading reading = parser.parse(row.name);
  if (reading.fault != name::NameFault::none) return subjects;
  const bool operation = reading.direction == name::Direction::operation;
  explain_missing(subjects, std::string(row.name), reading.device_path(),
                  operation ? tables::Direction::operation : tables::Direction::event);
  return subjects;
}

void check_type_of_no_io(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (subject.evidence.typeless_io.empty()) return;
  name::NameParser parser(*plant.rule);
  for (const model::TypelessIo& io : subject.evidence.typeless_io) {
    diagnostics.add(
        rule.info, about_lost(*io.row, parser),
        fmt::format("`{}` is no type of an input or output, so `{}` on `{}` is left out; write BOOL, or the "
                    "number's type",
                    io.row->type, io.row->name, io.address_cell),
        location_of(plant, *io.row, io.row->type));
  }
}

void check_byte_on_no_register(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<bool> placed(plant.symbols.size());
  for (const model::ControllerLink& link : plant.links) {
    for (const link::MapRow& row : link.rows) {
      if (row.number != link::MapRow::kDefault) placed[row.symbol] = true;
    }
  }
  for (std::size_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (placed[i]) continue;
    const int bits = model::data_type_bits(symbol.type);
    if (bits != 8 || !symbol.address || bits != static_cast<int>(symbol.address->size)) continue;
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` is {}, {} bits: it is in the images and on no register", symbol.name(),
                                model::data_type_name(symbol.type), bits),
                    location_of(plant, *symbol.row, symbol.row->type));
  }
}

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
      explain_missing(subjects, std::string(row.name), reading.device_path(),
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

bool conflicts_are_errors(const model::PlantModel& plant) {
  return plant.reader != nullptr && plant.reader->naming().naming().direction.conflict_is_error;
}

void report_direction_conflicts(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::set<const model::Symbol*> reported;  // by SP407
  for (const TaskClaim& claim : task_claims(plant)) reported.insert(&plant.symbols[claim.overruled]);
  for (const model::Symbol& symbol : plant.symbols) {
    const name::NameFault fault = symbol.reading.fault;
    if (!symbol.address || (fault != name::NameFault::none && fault != name::NameFault::not_linked)) continue;
    const bool name_says_operation = symbol.reading.direction == name::Direction::operation;
    const bool address_says_operation = symbol.address->area == address::Area::output;
    if (name_says_operation == address_says_operation || reported.count(&symbol) != 0) continue;
    const bool address_counts = (symbol.direction == tables::Direction::operation) == address_says_operation;
    diag::Diagnostic& finding = diagnostics.add(
        rule.info,
        about(symbol)
            .explaining(device(symbol.reading.device_path()))
            .explaining(address_of(symbol.name()))
            .following(address_of(symbol.name())),
        fmt::format("`{}` is an {} by its name and an {} by its address `{}`: the {} counts; correct one of them",
                    symbol.name(), name_says_operation ? "operation" : "event",
                    address_says_operation ? "operation" : "event", symbol.address_cell(),
                    address_counts ? "address" : "name"),
        location_of(plant, symbol), {{location_of(plant, *symbol.row, symbol.address_cell()), "the address"}});
    if (plant.pairing != nullptr) continue;  // a custom rule reads names and does not write them
    diag::Subject renamed = missing(plant, symbol.reading.device_path(), symbol.direction, symbol.reading.task());
    finding.renames.push_back(rename_of(symbol, std::move(renamed.name), false));
  }
}

const Rule kDirectionAgainstAddress{
    {"SP305", "direction-against-address", diag::Severity::warning, "a name gives one direction, its address the other",
     R"(The direction in a symbol's name contradicts its address: `..._I_...` has the address of an output (Y, `%Q`), or `..._O_...`
that of an input (X, `%I`).

**What the model loses.** The address counts, since it is wired: the symbol has the direction of its address. If the address is
wrong, an operation or an event of the device is missing. A naming rule may give the name priority (`"direction"` in
naming.json).

**How to fix it.** Correct the name, or the address.
)",
     diag::Rank::direction},
    check_direction_against_address};

const Rule kTypeAgainstAddress{
    {"SP306", "type-against-address", diag::Severity::warning, "a type needs another size of address",
     R"(A symbol's type and its address have different sizes: a BOOL on `%IW5`, an INT on `X0010`.

**What the model loses.** The symbol is in the model, but on no link: its register or bit is unknown, and might be that of another
symbol.

**How to fix it.** Correct the type or the address: BOOL goes with X, Y, `%IX`, `%QX`; 16-bit types with `%IW`, `%QW`; 32-bit
types with `%ID`, `%QD`.
)",
     diag::Rank::row},
    check_type_against_address};

const Rule kTypeOfNoIo{
    {"SP313", "type-of-no-io", diag::Severity::warning, "an input or output has a type that no I/O symbol has",
     R"(A row has an address of the PLC's inputs or outputs (X, Y, `%I`, `%Q`), but its type is not one of an I/O symbol: BOOL, SINT to
LINT, USINT to ULINT, BYTE to LWORD, REAL, LREAL. Most often the type is misspelled, or cells of the row are in the wrong
columns.

**What the model loses.** The whole symbol: the row counts as internal. It is in no image and on no link, and its device lacks
an operation or an event.

**How to fix it.** Correct the type, or move the row's cells back into their columns.
)",
     diag::Rank::row},
    check_type_of_no_io};

const Rule kByteOnNoRegister{
    {"SP312", "byte-on-no-register", diag::Severity::note, "a numeric symbol has 8 bits and is on no register",
     R"(A numeric symbol has 8 bits. Registers have 16, and two such symbols would share one. PLCs differ in which half is used first,
so the symbol is in the images and on no register.

**What the model loses.** The PLC can neither write nor read the symbol over Modbus.

**How to fix it.** Give the symbol a separate register in the description's `links`, by `symbol` and `number`; it uses the lower
half. Or use a type of 16 bits (INT, UINT, WORD).
)"},
    check_byte_on_no_register};

const Rule kIoNameInMemory{
    {"SP323", "io-name-in-memory", diag::Severity::warning,
     "a name of an input or output has an address in the PLC's memory",
     R"(A name follows the naming rule, direction included, and the address of the symbol is in the memory of the PLC: `M100`, `%MX0.3`.
Names such as `LINE_PROC_DEV_I_TASK` say that the symbol is an input or an output.

**What the model loses.** The row is left out: memory belongs to the program, not to the plant. The device lacks the symbol.

**How to fix it.** Give the symbol the address that is wired. If the program copies its inputs and outputs to memory, and the plant
is to use these addresses, remove the address from the list and place the symbol with `map` in the `links` of plant.json.
)",
     diag::Rank::address},
    check_io_name_in_memory};

}  // namespace symplant::check
