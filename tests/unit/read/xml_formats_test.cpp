// XML exports: findings point to the very cell, and hostile files are refused or read in time.
#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;
using test::kGoldens;
using test::kMany;
using test::repeated;

namespace {

test::Reading read_xml(const std::string& text) { return test::read_soon(text, "list.xml"); }

std::string slug_of_only_finding(const test::Reading& reading) {
  REQUIRE(reading.diagnostics.all().size() == 1);
  return std::string(reading.diagnostics.all()[0].rule->slug);
}

std::string table_of(const std::string& tags) { return "<Tagtable name='T'>" + tags + "</Tagtable>"; }

/// The text of a file that a cell points to; empty if the cell is a copy.
std::string in_file(const read::SymbolTable& table, std::string_view cell) {
  const text::Span span = table.source->span_of(cell);
  return std::string(table.source->text().substr(span.begin, span.end - span.begin));
}

}  // namespace

TEST_CASE("Each row of an XML export knows its line, its tag and the location of its cells") {
  const std::string folder = kGoldens + "formats/";
  std::size_t rows = 0;
  for (const std::string file : {"PLCTags.xml", "two_tables.xml", "openness.xml", "openplc.xml", "codesys.xml",
                                 "project.L5X", "variables.xsy", "GVL_IO.TcGVL", "program.st"}) {
    INFO(file);
    const test::Reading reading = test::read_golden(folder + file);
    REQUIRE(reading.table);
    const read::SymbolTable& table = *reading.table;
    for (const read::ListRow& row : table.rows) {
      INFO(row.name);
      CHECK(table.source->position(row.whole.begin).line == row.line);
      const std::string whole = in_file(table, table.source->text().substr(row.whole.begin, 1));
      CHECK((whole == "<" || file == std::string("GVL_IO.TcGVL") || file == std::string("program.st")));
      const bool composed = row.name.find_first_of(".:\"[") != std::string_view::npos;
      CHECK((composed || in_file(table, row.name) == row.name));
      CHECK((composed || row.vendor_address.find(':') != std::string_view::npos ||
             in_file(table, row.vendor_address) == row.vendor_address));
      ++rows;
    }
  }
  CHECK(rows > 40);
}

TEST_CASE("Every begin of an export gives a table or an error") {
  for (const std::string folder : {"formats/", "layouts/", "bad/"}) {
    for (const std::string& file : test::lists_in(kGoldens + folder)) {
      INFO(folder << file);
      const std::string bytes = test::read_bytes(kGoldens + folder + file);
      for (std::size_t size = 0; size < bytes.size(); ++size) {
        const test::Reading reading = test::read_text(bytes.substr(0, size), file);
        if (reading.table.has_value() == reading.diagnostics.has_errors()) FAIL("the first " << size << " bytes");
      }
    }
  }
}

TEST_CASE("Elements nested 100,000 deep are read without a deep stack") {
  const std::string tag = "<Tag type='Bool' addr='%I0.0'>A</Tag>";
  const test::Reading tags = read_xml(table_of(repeated("<a>", kMany) + tag + repeated("</a>", kMany) + tag));
  REQUIRE(tags.table);
  CHECK(tags.table->rows.size() == 2);
  CHECK(slug_of_only_finding(read_xml(table_of(repeated("<a>", kMany) + tag))) == "invalid-xml");
  const std::string project = "<project xmlns='http://www.plcopen.org/xml/tc6_0200'>";
  const std::string variable = "<variable name='A' address='%IX0.0'><type><BOOL/></type></variable>";
  const test::Reading lists =
      read_xml(project + repeated("<globalVars>", kMany) + variable + repeated("</globalVars>", kMany) + "</project>");
  REQUIRE(lists.table);
  CHECK(lists.table->rows.size() == 1);
  const test::Reading types =
      read_xml(project + "<globalVars><variable name='A'><type>" + repeated("<array><baseType>", kMany) +
               repeated("</baseType></array>", kMany) + "</type></variable></globalVars></project>");
  REQUIRE(types.table);
  CHECK(types.table->rows[0].type.size() < 2000);
  read_xml("<RSLogix5000Content><Controller><Tags><Tag Name='A'><Description>" + repeated("<a>b", kMany) +
           repeated("</a>", kMany) + "</Description></Tag></Tags></Controller></RSLogix5000Content>");
}

TEST_CASE("A comment of a megabyte is kept, a name of a megabyte is an error") {
  const std::string megabyte(1 << 20, 'x');
  const test::Reading comment = read_xml(table_of("<Tag remark='" + megabyte + "'>A</Tag>"));
  REQUIRE(comment.table);
  CHECK(comment.table->rows[0].comment.size() == megabyte.size());
  CHECK(slug_of_only_finding(read_xml(table_of("<Tag remark=''>" + megabyte + "</Tag>"))) == "cell-too-long");
  CHECK(slug_of_only_finding(read_xml(table_of("<Tag type='" + megabyte + "'>A</Tag>"))) == "cell-too-long");
}

TEST_CASE("A long name of a program is not copied for each of its variables") {
  const std::string megabyte(1 << 20, 'x');
  const std::string variable = "<variable name='A' address='%IX0.0'><type><BOOL/></type></variable>";
  read_xml("<project xmlns='http://www.plcopen.org/xml/tc6_0200'><pou name='&amp;" + megabyte + "'>" +
           repeated("<localVars>" + variable + "</localVars>", 20'000) + "</pou></project>");
  read_xml("<RSLogix5000Content><Controller><Programs><Program Name='" + megabyte + "'><Tags><Tag Name='" + megabyte +
           "'><Comments>" + repeated("<Comment Operand='.1'>c</Comment>", 20'000) +
           "</Comments></Tag></Tags></Program></Programs></Controller></RSLogix5000Content>");
}

TEST_CASE("A document type is refused wherever it is, so that no entity grows or reads another file") {
  for (const std::string& doctype :
       {std::string("<!DOCTYPE T SYSTEM 'file:///etc/hostname'>"), std::string("<!DOCTYPE T [<!ENTITY a 'b'>]>"),
        "<!--" + std::string(100'000, ' ') + "--><!DOCTYPE T>"}) {
    INFO(doctype.substr(0, 40));
    read::ReadOptions options;
    options.input_format = "tia-tag-table";
    const test::Reading reading = test::read_text(doctype + table_of("<Tag>A</Tag>"), "list.xml", options);
    CHECK_FALSE(reading.table);
    CHECK(slug_of_only_finding(reading) == "document-type");
  }
}

TEST_CASE("Unknown entities stay as written, and references to what is no character do no harm") {
  const test::Reading reading =
      read_xml(table_of("<Tag remark='&a;&lt;&#xD800;&#x110000;&#7;&#x85;'>A&#10;&#0;B</Tag><Tag>C&amp;amp;</Tag>"));
  REQUIRE(reading.table);
  REQUIRE(reading.table->rows.size() == 2);
  CHECK(reading.table->rows[0].comment.substr(0, 4) == "&a;<");
  CHECK(reading.table->rows[0].comment.find('\x07') == std::string_view::npos);
  CHECK(reading.table->rows[0].name.find('\n') == std::string_view::npos);
  CHECK(reading.table->rows[1].name == "C&amp;");
}

TEST_CASE("CDATA sections that are split around their end mark are one text") {
  const test::Reading comment = read_xml(
      "<VariablesExchangeFile><dataBlock><variables name='A' typeName='BOOL'><comment>a<![CDATA[ ]]]]><![CDATA[> b]]>"
      "</comment></variables></dataBlock></VariablesExchangeFile>");
  REQUIRE(comment.table);
  CHECK(comment.table->rows[0].comment == "a ]]> b");
  const test::Reading list = read_xml(
      "<TcPlcObject>\n<GVL Name='G'>\n<Declaration><![CDATA[VAR_GLOBAL\n A : INT := x[y[1]]]]><![CDATA[> 2;\n B : "
      "BOOL\n"
      "END_VAR]]></Declaration></GVL></TcPlcObject>");
  REQUIRE(list.table);
  CHECK(list.table->rows[0].initial == "x[y[1]]> 2");
  CHECK(list.table->rows[0].line == 3);
  REQUIRE(list.diagnostics.all().size() == 1);
  CHECK(list.table->source->position(list.diagnostics.all()[0].location.span.begin).line == 3);
}

TEST_CASE("A file that would need too much memory is refused before it is parsed") {
  CHECK(slug_of_only_finding(read_xml(table_of(repeated("<a/>", 5'000'000)))) == "invalid-xml");
  CHECK(slug_of_only_finding(read_xml(table_of("<a" + repeated(" b=''", 8'000'000) + "/>"))) == "invalid-xml");
  CHECK(slug_of_only_finding(read_xml(table_of(repeated("<a/>b ", 2'500'000)))) == "invalid-xml");
}

TEST_CASE("One line with 20,000 tags is read in time, with the column of each") {
  const test::Reading reading = read_xml(table_of(repeated("<Tag remark='r' addr='%I0.0'>A</Tag>", 20'000)));
  REQUIRE(reading.table);
  CHECK(reading.table->rows.size() == 20'000);
  CHECK(reading.table->rows.back().line == 1);
}

TEST_CASE("No reader takes a symbol configuration of CODESYS, because it has no addresses") {
  const std::string text =
      "<?xml version=\"1.0\"?><Symbolconfiguration "
      "xmlns=\"http://www.3s-software.com/schemas/Symbolconfiguration.xsd\">"
      "<Header/><NodeList><Node name=\"Application\"/></NodeList></Symbolconfiguration>";
  for (const read::ReaderInfo* reader : read::readers()) CHECK(reader->likelihood(text) == 0);
}

TEST_CASE("An AutomationML project has the rows of the workbook of the same project") {
  const test::Reading project = test::read_golden(kGoldens + "formats/PLCTags.aml");
  const test::Reading book = test::read_golden(kGoldens + "formats/PLCTags.xlsx");
  REQUIRE(project.table);
  REQUIRE(book.table);
  for (std::size_t i = 0; i < 3; ++i) {
    const read::ListRow& row = project.table->rows.at(i);
    const read::ListRow& same = book.table->rows.at(i);
    CHECK(row.name == same.name);
    CHECK(row.vendor_address == same.vendor_address);
    CHECK(row.type == same.type);
    CHECK(row.comment == same.comment);
    CHECK(project.table->extra_of(row).scope == book.table->extra_of(same).scope);
  }
}

TEST_CASE("Tags of several PLCs in one AutomationML project are several lists, whatever folders their tables are in") {
  const test::Reading reading = test::read_golden(kGoldens + "formats/two_plcs.amlx");
  REQUIRE(reading.table);
  CHECK(reading.table->parts == std::vector<std::size_t>{2});
  read::ReadOptions second;
  second.part = 2;
  const test::Reading part = test::read_text(test::read_bytes(kGoldens + "formats/two_plcs.amlx"), "a.amlx", second);
  REQUIRE(part.table);
  CHECK(part.table->rows.size() == 2);
  CHECK(part.table->rows[0].name == "L_P_E_I_OPEN");
}

TEST_CASE("An AutomationML project without tags is refused by what it has") {
  const auto refusal = [](const std::string& element) {
    return test::read_soon("<CAEXFile><InstanceHierarchy>" + element + "</InstanceHierarchy></CAEXFile>", "a.aml")
        .diagnostics.all()
        .front()
        .message;
  };
  CHECK(refusal("<InternalElement/>") == "the file has no PLC tags; export the project with its PLC tag tables");
  CHECK(refusal("<InternalElement><ExternalInterface RefBaseClassPath='A/Channel'/></InternalElement>") ==
        "the file has channels of modules, but no PLC tags; export the PLC tags, too");
}
