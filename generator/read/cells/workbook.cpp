// Reads the sheets of a workbook as text.
#include "read/cells/workbook.hpp"

#include <optional>
#include <utility>

#include "read/archive.hpp"
#include "read/cells/sheet_text.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kSaveAgain = "; open the workbook and save it again, or save the sheet as CSV";
constexpr std::uint64_t kMostText = 128'000'000;  ///< of all sheets, and of the strings that they share

base::Result<std::vector<Sheet>, ArchiveFault> read_sheets(std::string_view bytes) {
  auto archive = Archive::open(bytes, "workbook");
  if (!archive) return archive.error();
  const auto book = archive->whole("xl/workbook.xml");
  if (!book) return book.error();
  const auto relations = archive->whole("xl/_rels/workbook.xml.rels");
  if (!relations) return relations.error();
  const auto parts = sheet_parts(*book, *relations);
  if (!parts) return ArchiveFault{parts.error()};
  if (parts->empty()) return ArchiveFault{"the workbook has no sheet"};
  SharedStrings strings(kMostText);
  if (archive->has("xl/sharedStrings.xml")) {
    const auto fault =
        archive->stream("xl/sharedStrings.xml", [&](std::string& rest) { return strings.take_from(rest); });
    if (fault) return *fault;
  }
  std::vector<Sheet> sheets;
  std::uint64_t written = 0;
  for (const SheetPart& part : *parts) {
    if (!archive->has(part.path)) continue;  // a chart
    SheetText text(strings.texts(), kMostText - written);
    const auto fault = archive->stream(part.path, [&](std::string& rest) { return text.take_from(rest); });
    if (fault) return *fault;
    written += text.size();
    sheets.push_back({part.name, text.take()});
  }
  return sheets;
}

}  // namespace

bool is_workbook(std::string_view bytes) {
  return Archive::is_one(bytes) && bytes.find("xl/workbook.xml") != std::string_view::npos;
}

base::Result<std::vector<Sheet>, std::string> read_workbook(std::string_view bytes) {
  auto sheets = read_sheets(bytes);
  if (!sheets) return sheets.error().what + std::string(kSaveAgain);
  return std::move(*sheets);
}

}  // namespace symplant::read
