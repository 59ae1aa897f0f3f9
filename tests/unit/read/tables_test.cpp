// Reads tables of unknown tools: columns by header, by content, as the user says; sheets; several lists in one text.
#include <string>

#include "read/cells/layout.hpp"
#include "read/parts.hpp"
#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;
using read::Field;

namespace {

std::string columns_of(const std::string& text) {
  const auto search = read::find_any_layout(text);
  return search.layout ? read::describe(search.layout->columns) : "none";
}

test::Reading read_with(const std::string& text, const std::string& columns) {
  read::ReadOptions options;
  auto map = read::column_map_of(columns);
  REQUIRE(map);
  options.columns = *map;
  return test::read_text(text, "list.csv", options);
}

std::string first_message(const test::Reading& reading) {
  return reading.diagnostics.all().empty() ? "" : reading.diagnostics.all()[0].message;
}

const std::string kUnknown = "A;B;C;D\nP1_RUN;%IX0.0;0;1\nP2_RUN;%IX0.1;0;2\nP3_RUN;%QX0.0;1;3\n";

}  // namespace

TEST_CASE("Headers in the languages of the tools name the columns") {
  CHECK(columns_of("Symbol,Adresse,Datentyp,Kommentar\nA,E0.0,BOOL,x\n") ==
        "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("Имя;Адрес;Тип данных;Комментарий\nA;%I0.0;Bool;x\n") ==
        "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("変数名,アドレス,データ型,コメント\nA,%IX0.0,BOOL,x\n") ==
        "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("名称,地址,数据类型,注释\nA,%I0.0,Bool,x\n") == "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("Название,Адрес,Примечание\nA,%IX0.0,x\nB,%IX0.1,y\n") == "identifier 1, IEC address 2, comment 3");
  CHECK(columns_of("Nome,Endereço,Tipo,Comentário\nA,%I0.0,Bool,x\n") ==
        "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("Nazwa;Adres;Typ;Komentarz\nA;%I0.0;Bool;x\n") == "identifier 1, IEC address 2, type 3, comment 4");
  CHECK(columns_of("信号名称,IO地址,注释\n启动,X0,x\n") == "identifier 1, IEC address 2, comment 3");
  CHECK(columns_of("이름,주소,타입,설명\nA,%IX0.0,BOOL,x\n") == "identifier 1, IEC address 2, type 3, comment 4");
}

TEST_CASE("One known word of a header counts") {
  CHECK(columns_of("Part;Our mark;Bemerkung\nbelt runs;E 0.0;contact\nbelt on;A 4.0;relay\n") ==
        "identifier 1, vendor address 2, comment 3");
  CHECK(columns_of("No;Symbol;Where;Why\n1;RUN;%I0.0;ready\n2;LAMP;%Q0.0;light\n") ==
        "identifier 2, IEC address 3, comment 4");
}

TEST_CASE("A column `Type` without a type is not the column of types") {
  CHECK(columns_of("Tag,Address,Type,Format\nDOOR,%I0.0,DI,Bool\nLAMP,%Q0.0,DO,Bool\n") ==
        "identifier 1, IEC address 2, type 4, comment 3");
  CHECK(columns_of("Tag,Address,Type\nDOOR,%I0.0,PART_DOOR\nLAMP,%Q0.0,Bool\n") ==
        "identifier 1, IEC address 2, type 3");
}

TEST_CASE("A language or a unit in brackets behind the word of a header does not count") {
  CHECK(columns_of("Name,Connection,Address,Comment [en-US]\nA,Link_1,%I0.0,the door\nB,Link_1,%I0.1,the lid\n") ==
        "identifier 1, IEC address 3, comment 4");
}

TEST_CASE("A cell such as `<No Value>` is empty, except where it is a name") {
  const test::Reading reading = test::read_text(
      "Name,Address,Type,Start value,Comment\nA,%I0.0,Bool,<No Value>,<No Value>\n"
      "B,<No Value>,Bool,1,<to the left>\n<C>,%Q0.0,Bool,0,lamp\n");
  REQUIRE(reading.table);
  CHECK(test::rows_as_text(*reading.table) == "|A|%I0.0||Bool||\n|B|||Bool|1|<to the left>\n|<C>|%Q0.0||Bool|0|lamp\n");
  CHECK(reading.diagnostics.all().empty());
}

TEST_CASE("Without words of a header the cells decide: addresses, unique names, types, text") {
  CHECK(columns_of(kUnknown) == "identifier 1, IEC address 2");
  CHECK(columns_of("X1F,BOOL,start,the button\nY2,BOOL,lamp,the lamp of it\nX3,BOOL,stop,a button\n") ==
        "identifier 3, vendor address 1, type 2, comment 4");
}

TEST_CASE("A column of numbers or of TRUE and FALSE is never a comment") {
  CHECK(columns_of("Tag,Operand,a,b\nA,X1,1,TRUE\nB,X2,0,FALSE\nC,Y1,1,TRUE\n") == "identifier 1, vendor address 2");
}

TEST_CASE("A letter, a program and a table of numbers are no table of symbols") {
  CHECK(columns_of("Dear Sir,\nplease find the list, as agreed, below.\n") == "none");
  CHECK(columns_of("PROGRAM main\nVAR\n a : BOOL;\nEND_VAR\nIF a THEN b := 1; END_IF\n") == "none");
  CHECK(columns_of("1,2,3\n4,5,6\n7,8,9\n") == "none");
  CHECK(columns_of("") == "none");
}

TEST_CASE("Two columns of equal evidence are a question that shows both") {
  const test::Reading names = test::read_text("X,Y,Z\nP1_RUN,AB_1,%IX0.0\nP2_RUN,AB_2,%IX0.1\nP3_RUN,AB_3,%QX0.1\n");
  CHECK_FALSE(names.table);
  CHECK(first_message(names) ==
        "two columns serve as identifiers equally well: column 1 `X` (`P1_RUN`, `P2_RUN`) and column 2 `Y` (`AB_1`, "
        "`AB_2`); use `--columns name=1` or `--columns name=2`");
  const test::Reading addresses =
      test::read_text("Name,Address,Addr\nA_RUN,%IX0.0,%IX1.0\nB_RUN,%IX0.1,%IX1.1\nC_RUN,%QX0.1,%QX1.1\n");
  CHECK_FALSE(addresses.table);
  CHECK(test::contains(first_message(addresses), "two columns serve as addresses equally well: column 2 `Address`"));
}

TEST_CASE("Of two columns with words of a header the one whose cells serve counts") {
  CHECK(columns_of("Tag,Symbol,Operand\nMOTOR,,X1\nMOTOR2,,X2\nVALVE,,Y1\n") == "identifier 1, vendor address 3");
}

TEST_CASE("The user's columns count, by header or by number") {
  const test::Reading by_number = read_with(kUnknown, "name=1,address=2,comment=4");
  REQUIRE(by_number.table);
  CHECK(test::rows_as_text(*by_number.table) ==
        "|A|B||||D\n|P1_RUN|%IX0.0||||1\n|P2_RUN|%IX0.1||||2\n|P3_RUN|%QX0.0||||3\n");
  const test::Reading by_header = read_with(kUnknown, "name=A, address=b");
  REQUIRE(by_header.table);
  CHECK(test::rows_as_text(*by_header.table) == "|P1_RUN|%IX0.0||||\n|P2_RUN|%IX0.1||||\n|P3_RUN|%QX0.0||||\n");
  const test::Reading wrong = read_with(kUnknown, "name=Tag");
  CHECK_FALSE(wrong.table);
  CHECK(test::contains(first_message(wrong), "no row of the first 64 has the header `Tag`"));
}

TEST_CASE("A map of columns that cannot be read is explained") {
  const auto fault = [](std::string_view text) {
    const auto map = read::column_map_of(text);
    return map ? std::string() : map.error();
  };
  CHECK(fault("name") == "`name` is not a column; write it as name=Tag or address=3");
  CHECK(test::contains(fault("nmae=1"), "unknown column `nmae`; choose one of `name`, `address`"));
  CHECK(fault("name=1,name=2") == "`name` is given twice; give it once");
  CHECK(fault("name=0") == "columns count from 1, but `name` is column 0");
  CHECK(test::contains(fault("name="), "names no column"));
  CHECK(fault("name=Tag no. 1,sheet=IO,type=4").empty());
}

TEST_CASE("The notation of the addresses of a table is that of its cells") {
  const auto notation = [](const std::string& cells) {
    const test::Reading reading = test::read_text("Name,Address\n" + cells);
    REQUIRE(reading.table);
    return reading.table->notation;
  };
  CHECK(notation("A,X1F\nB,Y20\n") == address::Notation::melsec);
  CHECK(notation("A,E0.0\nB,A4.1\n") == address::Notation::siemens);
  CHECK(notation("A,%IX0.0\nB,%QW3\n") == address::Notation::iec);
  CHECK(notation("A,Local:1:I.Data.0\nB,Local:2:O.Data.1\n") == address::Notation::rockwell);
}

TEST_CASE("A sheet is chosen by its list, or as the user says") {
  const std::string book = test::read_bytes(test::kGoldens + "formats/io_list.xlsx");
  read::ReadOptions options;
  options.columns.sheet = "Cover";
  const test::Reading cover = test::read_text(book, "io_list.xlsx", options);
  CHECK_FALSE(cover.table);
  options.columns.sheet = "Inputs";
  CHECK(first_message(test::read_text(book, "io_list.xlsx", options)) ==
        "the workbook has no sheet `Inputs`; choose one of `Cover`, `IO`");
}

TEST_CASE("A location in a workbook is its row and its column") {
  const test::Reading reading = test::read_golden(test::kGoldens + "formats/PLCTags.xlsx");
  REQUIRE(reading.table);
  const read::ListRow& row = reading.table->rows[2];
  const text::Position position = reading.table->source->position(reading.table->source->span_of(row.type).begin);
  CHECK(row.name == "21010");
  CHECK(position.line == 4);
  CHECK(position.column == 3);
}

TEST_CASE("A workbook cut at any byte is read or refused") {
  const std::string book = test::read_bytes(test::kGoldens + "formats/io_list.xlsx");
  for (std::size_t size = 0; size < book.size(); ++size) {
    const test::Reading reading = test::read_text(book.substr(0, size), "io_list.xlsx");
    CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
  }
}

TEST_CASE("A package cut at any byte is read or refused") {
  const std::string package = test::read_bytes(test::kGoldens + "formats/two_plcs.amlx");
  for (std::size_t size = 0; size < package.size(); ++size) {
    const test::Reading reading = test::read_text(package.substr(0, size), "two_plcs.amlx");
    CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
  }
}

TEST_CASE("A package whose document is damaged is refused by what is wrong") {
  std::string package = test::read_bytes(test::kGoldens + "formats/two_plcs.amlx");
  const std::size_t name = package.find("two.aml");
  REQUIRE(name != std::string::npos);
  for (std::size_t i = 40; i < 80; ++i) package[name + i] = '\x55';
  const std::string message = first_message(test::read_text(package, "two_plcs.amlx"));
  CHECK(
      message ==
      "the part `two.aml` of the package is damaged; export the project again, or as a plain AutomationML file (.aml)");
}

TEST_CASE("A list of variables with channels of modules is a table, whatever the scope") {
  std::string text = "\"Scope\";\"Variable\";\"Type\";\"I/O channel\";\"Task\"\n";
  for (const std::string n : {"01", "02", "03", "04"}) {
    text += "\"GLOBAL\";\"gDi" + n + "\";\"BOOL\";\"%IX.IF3.ST1.DigitalInput" + n + "\";\"Main\"\n";
  }
  const test::Reading reading = test::read_text(text);
  REQUIRE(reading.table);
  CHECK(reading.table->title == "table of symbols");
  REQUIRE(reading.table->rows.size() == 4);
  CHECK(reading.table->rows[1].name == "gDi02");
  CHECK(reading.table->rows[1].vendor_address == "%IX.IF3.ST1.DigitalInput02");
  CHECK(reading.table->rows[1].comment == "");
}

TEST_CASE("A repeated header, or addresses that start over, begin another list") {
  std::string one;
  for (int i = 0; i < 12; ++i) one += "A" + std::to_string(i) + ",%IX" + std::to_string(i) + ",BOOL\n";
  std::string two = one;
  for (char& c : two) c = c == 'A' ? 'B' : c;
  const std::string header = "Name,Address,Type\n";
  const auto begins = [](const std::string& text) {
    const test::Reading reading = test::read_text(text);
    REQUIRE(reading.table);
    return read::find_parts(*reading.table, address::Radix::hexadecimal);
  };
  CHECK(begins(header + one) == std::vector<std::size_t>{});
  CHECK(begins(header + one + header + two) == std::vector<std::size_t>{12});
  CHECK(begins(header + one + two) == std::vector<std::size_t>{12});
  CHECK(begins(header + one + two + one) == std::vector<std::size_t>{12, 24});
  CHECK(begins(header + one + "C1,%IX0,BOOL\nC2,%IX1,BOOL\n") == std::vector<std::size_t>{});  // a few doubles

  read::ReadOptions second;
  second.part = 2;
  const test::Reading part = test::read_text(header + one + two, "list.csv", second);
  REQUIRE(part.table);
  CHECK(part.table->rows.size() == 12);
  CHECK(part.table->rows[0].name == "B0");
}

TEST_CASE("Files that are known and not read are named, with the export that is read") {
  const auto message = [](const std::string& bytes, const std::string& name = "file") {
    const test::Reading reading = test::read_text(bytes, name);
    CHECK_FALSE(reading.table);
    REQUIRE(reading.diagnostics.all().size() == 1);
    CHECK(reading.diagnostics.all()[0].rule->slug == "recognized-format");
    return first_message(reading);
  };
  using namespace std::string_literals;
  CHECK(message("Version 33\r\n\0\x1F\x8B\x08QuickInfo.XML\0"s, "line.ACD") ==
        "this is a Rockwell project (ACD, binary); export the tags: in Logix Designer, Tools > Export > Tags and Logic "
        "Comments (CSV), or save the project as L5K or L5X");
  CHECK(message("Q\0u\0i\0c\0k\0I\0n\0f\0o\0.\0X\0M\0L\0\0\0\1\2\3"s).starts_with("this is a Rockwell project"));
  constexpr const char* kOldWorkbook =
      "this is a workbook in the old Excel format (.xls); open it and save it as .xlsx or as CSV";
  CHECK(message("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1\0\0"s, "list.XLS") == kOldWorkbook);
  CHECK(message("\x09\x08\x08\0\0\x05\x05\0\x12\x0E\0\0"s, "list.xls") ==
        kOldWorkbook);  // Excel 5, without a container
  CHECK(test::contains(message("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1\0\0"s, "list.csv"), "old Excel format"));
  CHECK(message("%PDF-1.7\n%\xE2\xE3\n").starts_with("this is a PDF document"));
  CHECK(message("<?xml version='1.0'?><Symbolconfiguration xmlns='x'/>").starts_with("this is a symbol configuration"));
  CHECK(message("TABLE\n0,1\n\"EXCEL\"\nVECTORS\n0,4\n\"\"\n").starts_with("this is a table in data interchange"));
  CHECK(message("#LimitAlarmDefinitions;\n\"Name\";\n").starts_with("this is a configuration of MX OPC"));
  CHECK(
      message("<?xml version='1.0'?>\n<LogFile titleName='PLCTags.xml'/>").starts_with("this is a log of TIA Portal"));
  CHECK(message("<!DOCTYPE html>\n<html><body/></html>").starts_with("this is a web page"));
  const test::Reading indented = test::read_text("\t\t\tCONNECTION Out (Rate := 5)\n", "part.L5K");
  CHECK(first_message(indented).starts_with("this is no known symbol list"));
}

TEST_CASE("A code page is used where the words show it, and a warning says so where they are few") {
  const test::Reading many = test::read_golden(test::kGoldens + "formats/ls_globals.csv");
  REQUIRE(many.table);
  CHECK(many.diagnostics.all().empty());
  const test::Reading declared = test::read_text(
      "<?xml version='1.0' encoding='windows-1251'?>\n<Tagtable name='a'><Tag type='Bool' remark='\xEA\xED' "
      "addr='%I0.0'>A</Tag></Tagtable>");
  REQUIRE(declared.table);
  CHECK(declared.table->rows[0].comment == "кн");
  const test::Reading damaged = test::read_text("Name,Address,Comment\nA,X1,Förderer für Gehäuse größer\nB,X2,\xFC\n");
  CHECK_FALSE(damaged.table);
}
