// What the rules about names share.
#include "check/rules.hpp"

namespace symplant::check {

void narrow(diag::Place& place, const model::Symbol& symbol) {
  const base::Span part = symbol.reading.where;
  if (place.span.end - place.span.begin != symbol.name().size()) return;  // the whole row, or an unescaped cell
  place.span = {place.span.begin + part.begin, place.span.begin + part.end};
}

std::string_view faulty_part(const model::Symbol& symbol) {
  const base::Span part = symbol.reading.where;
  return symbol.name().substr(part.begin, part.end - part.begin);
}

}  // namespace symplant::check
