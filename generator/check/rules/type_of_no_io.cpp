// SP313 type-of-no-io: an input or output has a type that no I/O symbol has.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTypeOfNoIoPage =
    R"(A row has an address of the PLC's inputs or outputs (X, Y, `%I`, `%Q`), but its type is not one of an I/O symbol: BOOL, SINT to
LINT, USINT to ULINT, BYTE to LWORD, REAL, LREAL. Most often the type is misspelled, or cells of the row are in the wrong
columns.

**What the model loses.** The whole symbol: the row counts as internal. It is in no image and on no link, and its device lacks
an operation or an event.

**How to fix it.** Correct the type, or move the row's cells back into their columns.
)";

/// The row, which its device lacks.
diag::Subjects about_lost(const read::ListRow& row, name::NameParser& parser) {
  diag::Subjects subjects = about(row);
  const name::NameReading reading = parser.parse(row.name);
  if (reading.fault != name::NameFault::none) return subjects;
  const bool operation = reading.direction == name::Direction::operation;
  explain_missing(subjects, std::string(row.name), reading.device_path,
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

}  // namespace

const Rule kTypeOfNoIo{{"SP313", "type-of-no-io", diag::Severity::warning,
                        "an input or output has a type that no I/O symbol has", kTypeOfNoIoPage, diag::Rank::row},
                       check_type_of_no_io};

}  // namespace symplant::check
