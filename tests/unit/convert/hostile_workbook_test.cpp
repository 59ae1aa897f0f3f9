// Workbooks that unpack to far more than they hold, or are no workbooks, are refused.
#include <string>
#include <utility>
#include <vector>

#include "convert/zip_package.hpp"
#include "convert_support.hpp"
#include "read/cells/workbook.hpp"
#include "support/strings.hpp"

namespace symplant::convert {
namespace {

/// `piece` `count` times over, between `head` and `tail`.
PackagePart part(std::string name, std::string head, std::string piece, std::size_t count, std::string tail) {
  return {std::move(name), [=](std::size_t number) {
            if (number == 0) return head;
            if (number <= count) return piece;
            return number == count + 1 ? tail : std::string();
          }};
}

std::string book_with(std::vector<PackagePart> parts) {
  parts.push_back(part("xl/workbook.xml",
                       "<workbook xmlns:r='r'><sheets><sheet name='IO' r:id='a'/></sheets></workbook>", "", 0, ""));
  parts.push_back(
      part("xl/_rels/workbook.xml.rels", "<R><Relationship Id='a' Target='worksheets/sheet1.xml'/></R>", "", 0, ""));
  const auto packed = zip_package(parts);
  REQUIRE(bool(packed));
  return *packed;
}

std::string fault_of(const std::string& book) {
  const auto sheets = read::read_workbook(book);
  return sheets ? "" : sheets.error();
}

const std::string kSheet = "xl/worksheets/sheet1.xml";

}  // namespace

TEST_CASE("A part that unpacks to more than a hundred times its size is refused") {
  const std::string row = "<row><c t='inlineStr'><is><t>" + std::string(100'000, ' ') + "</t></is></c></row>";
  CHECK(test::contains(
      fault_of(book_with({part(kSheet, "<worksheet><sheetData>", row, 1000, "</sheetData></worksheet>")})),
      "more than 100 times its size"));
}

TEST_CASE("A row without an end is refused before it fills the memory") {
  std::string noise;
  for (std::size_t i = 0; i < 400'000; ++i) noise += std::to_string(i * 2'654'435'761U % 1'000'000'007U);
  CHECK(test::contains(fault_of(book_with({part(kSheet, "<worksheet><sheetData><row>", noise, 6, "")})),
                       "has an element `row` of more than 16 MiB"));
}

TEST_CASE("A sheet that is no XML, or has a document type, is refused") {
  const auto sheet = [&](const std::string& xml) { return fault_of(book_with({part(kSheet, xml, "", 0, "")})); };
  CHECK(test::contains(sheet("<sheetData><row><c></row></sheetData>"), "is no valid XML"));
  CHECK(test::contains(sheet("<!DOCTYPE a [<!ENTITY b 'c'>]><row><c><v>&b;</v></c></row>"), "is no valid XML"));
  CHECK(sheet("<sheetData/>").empty());
}

TEST_CASE("A string that cells refer to without end is refused") {
  std::string text;
  for (std::size_t i = 0; i < 200'000; ++i) text += std::to_string(i * 2'654'435'761U % 1'000'000'007U);
  const std::string row = "<row><c t='s'><v>0</v></c></row>";
  const std::string fault =
      fault_of(book_with({part("xl/sharedStrings.xml", "<sst><si><t>" + text + "</t></si></sst>", "", 0, ""),
                          part(kSheet, "<sheetData>", row, 1000, "</sheetData>")}));
  CHECK(test::contains(fault, "has more than 128 MB of text"));
}

}  // namespace symplant::convert
