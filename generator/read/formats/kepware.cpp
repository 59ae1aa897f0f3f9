// Reads tags of Kepware (KEPServerEX, ThingWorx) and of tools with the same columns.
#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array<HeaderWords, 1> kKepwareHeaders{{{"tagname", "address", "datatype", "clientaccess"}}};

int kepware_likelihood(std::string_view text) { return layout_in_any(text, kKepwareHeaders) ? kKnownHeader : 0; }

}  // namespace

const ReaderInfo kKepware{"kepware", "Kepware tags", kepware_likelihood, kAnyTable.read};

}  // namespace symplant::read
