// Reads global variables of LS Electric XG5000.
#include <algorithm>

#include "read/formats.hpp"
#include "read/formats/table_formats.hpp"

namespace symplant::read {

namespace {

constexpr std::array kLsGlobalsHeaders{HeaderWords{"변수종류", "변수", "타입", "메모리할당"},
                                       HeaderWords{"variablekind", "variable", "type", "memoryallocation"},
                                       HeaderWords{"variablekind", "variable", "type", "address"}};

std::optional<Layout> ls_globals_layout(std::string_view text) {
  auto layout = layout_in_any(text, kLsGlobalsHeaders);
  if (!layout || layout->columns.has_address()) return layout;
  const auto cell = std::find_if(layout->header.begin(), layout->header.end(),
                                 [](const std::string& word) { return header_word(word) == "memoryallocation"; });
  layout->columns.set(Field::iec_address, static_cast<std::size_t>(cell - layout->header.begin()));
  return layout;
}

int ls_globals_likelihood(std::string_view text) { return ls_globals_layout(text) ? kKnownHeader : 0; }

std::optional<SymbolTable> read_ls_globals(const Reading& reading) {
  const auto layout = ls_globals_layout(reading.source->text());
  if (!layout) return kAnyTable.read(reading);
  return read_table(reading, *layout, {.notation = address::Notation::iec});
}

}  // namespace

const ReaderInfo kLsGlobals{"ls-globals", "LS XG5000 global variables", ls_globals_likelihood, read_ls_globals};

}  // namespace symplant::read
