// The workbook of TIA Portal's tag tables.
#include "convert/workbook.hpp"

#include <string>
#include <vector>

#include "convert_support.hpp"
#include "read/cells/workbook.hpp"
#include "support/strings.hpp"

namespace symplant::convert {
namespace {

using test::contains;
using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("tia-xlsx: The sheets have the tags and the constants") {
  const Made made = convert_to("tia-xlsx", gx_list("VAR_GLOBAL,A,X1F,,BOOL,TRUE,a\n"
                                                   "VAR_GLOBAL,W,,%QW5,INT,0,\n"
                                                   "VAR_GLOBAL,M,M500,,BOOL,,\n"
                                                   "VAR_GLOBAL,F,,,MyBlock,,\n"
                                                   "VAR_GLOBAL_CONSTANT,C,,,INT,K7,the most\n"));
  const auto sheets = read::read_workbook(made.text);
  REQUIRE(bool(sheets));
  REQUIRE(sheets->size() == 2);
  CHECK((*sheets)[0].name == "PLC Tags");
  CHECK((*sheets)[0].text ==
        "Name\tPath\tData Type\tLogical Address\tComment\tHmi Visible\tHmi Accessible\tHmi Writeable\tTypeobject "
        "ID\tVersion ID\n"
        "A\tDefault tag table\tBool\t%I3.7\ta\tTrue\tTrue\tTrue\n"
        "W\tDefault tag table\tInt\t%QW10\t\tTrue\tTrue\tTrue\n"
        "M\tDefault tag table\tBool\t\t\tTrue\tTrue\tTrue\n");
  CHECK((*sheets)[1].name == "Constants");
  CHECK((*sheets)[1].text == "Name\tPath\tData Type\tValue\tComment\nC\tDefault tag table\tInt\t7\tthe most\n");
  CHECK(made.written.symbols == 4);
  CHECK(
      made.report.lines() ==
      Lines{
          "1 symbol is left out: the target has no such type, or there is no type: `F`",
          "1 initial value is not written: a tag has none: `A`",
          "1 tag has no address: the list has no SIMATIC address for it; TIA Portal marks such a tag as faulty: `M`"});
}

TEST_CASE("tia-xlsx: Equal lists give equal bytes, and a sheet of constants only for constants") {
  const std::string rows = "VAR_GLOBAL,A,X1F,,BOOL,,a\n";
  CHECK(convert_to("tia-xlsx", gx_list(rows)).text == convert_to("tia-xlsx", gx_list(rows)).text);
  const auto sheets = read::read_workbook(convert_to("tia-xlsx", gx_list(rows)).text);
  REQUIRE(bool(sheets));
  CHECK(sheets->size() == 1);
}

TEST_CASE("tia-xlsx: Addresses of SIMATIC stay as they are") {
  const auto cell = [](const std::string& address) {
    const auto symbols = symbols_of_text(
        "list.sdf", "\"A\",\"" + address + "\",\"Word\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\n");
    const std::string text = (*read::read_workbook(convert_to("tia-xlsx", symbols).text))[0].text;
    const std::size_t begin = text.find("Word\t") + 5;
    return text.substr(begin, text.find('\t', begin) - begin);
  };
  for (const char* address : {"%I3.7", "%IW64", "%IW65", "%QD7", "%M3.5", "%MW11", "%T5"})
    CHECK(cell(address) == address);
}

TEST_CASE("A workbook holds any text: line ends, quotes, markup, and what looks like an escape") {
  SharedStrings strings;
  SheetTable sheet{"Sheet", 1, {}};
  const Lines texts{"a", "a \"b\"", "<&>", "_x0041_", "_x004", "x_x0041_y_x0042_", "밸브", "=1+1", " b "};
  for (const std::string& text : texts) sheet.cells.push_back(strings.keep(text));
  const auto bytes = workbook_bytes({sheet}, strings);
  REQUIRE(bool(bytes));
  const auto sheets = read::read_workbook(*bytes);
  REQUIRE(bool(sheets));
  const std::string& text = sheets->front().text;
  for (const char* cell : {"a \"b\"\n", "<&>\n", "밸브\n", "=1+1\n", "_x0041_\n", "x_x0041_y_x0042_\n"}) {
    INFO(cell);
    CHECK(contains(text, cell));
  }
}

TEST_CASE("A workbook of many rows is packed piece by piece") {
  SharedStrings strings;
  SheetTable sheet{"Sheet", 2, {}};
  for (int i = 0; i < 5000; ++i) {
    sheet.cells.push_back(strings.keep("name " + std::to_string(i)));
    sheet.cells.push_back(strings.keep("same"));
  }
  const auto sheets = read::read_workbook(*workbook_bytes({sheet}, strings));
  REQUIRE(bool(sheets));
  CHECK(contains(sheets->front().text, "name 999\tsame\nname 1000\tsame\nname 1001\tsame\n"));
  CHECK(contains(sheets->front().text, "name 4999\tsame\n"));
}

}  // namespace symplant::convert
