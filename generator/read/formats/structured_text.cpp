// Reads variables that are declared in Structured Text.
#include "read/formats.hpp"
#include "read/st/declared_rows.hpp"

namespace symplant::read {

namespace {

std::optional<SymbolTable> read_structured_text(const Reading& reading) {
  TableBuilder builder(reading, address::Notation::iec);
  DeclaredRows rows(builder);
  rows.read({0, builder.text().size()}, {});
  return rows.finish();
}

}  // namespace

const ReaderInfo kStructuredText{"st", "Structured Text (VAR_GLOBAL ... END_VAR)", declarations_likelihood,
                                 read_structured_text};

}  // namespace symplant::read
