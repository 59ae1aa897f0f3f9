// Losses that several formats have.
#include "convert/losses.hpp"

#include "convert/symbols.hpp"

namespace symplant::convert {

void report_scope(const Symbol& symbol, Report& report) {
  if (symbol.extra->scope.empty() || symbol.extra->scope == kDefaultTagTable) return;
  report.add(kNoScope, symbol.row->name);
}

}  // namespace symplant::convert
