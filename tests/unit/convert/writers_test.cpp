// What each writer writes for a small list, and what it reports.
#include "convert/writers.hpp"

#include <string>
#include <vector>

#include "convert_support.hpp"
#include "support/strings.hpp"

namespace symplant::convert {
namespace {

using test::contains;
using Lines = std::vector<std::string>;

std::shared_ptr<const Symbols> small_list() {
  return gx_list(
      "VAR_GLOBAL,A_B_C_I_X,X1F,%IX31,BOOL,FALSE,a comment\n"
      "VAR_GLOBAL,A_B_C_O_X,Y10,%QX16,BOOL,1,\"two\nlines *) end\"\n"
      "VAR_GLOBAL,SPEED,,%IW5,INT,K-5,\n"
      "VAR_GLOBAL,M 1,M500,%MX0.500,BOOL,,memory\n"
      "VAR_GLOBAL,T1,,,TIMER,,\n"
      "VAR_GLOBAL_CONSTANT,LIMIT_1,,,REAL,5,the most\n");
}

}  // namespace

TEST_CASE("gx-iec: A list has both addresses, a class and the words of the source") {
  const Made made = convert_to("gx-iec", small_list());
  CHECK(made.text ==
        "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
        "VAR_GLOBAL,A_B_C_I_X,X1F,%IX31,BOOL,FALSE,a comment\n"
        "VAR_GLOBAL,A_B_C_O_X,Y10,%QX16,BOOL,1,\"two\nlines *) end\"\n"
        "VAR_GLOBAL,SPEED,,%IW5,INT,K-5,\n"
        "VAR_GLOBAL,M 1,M500,%MX0.500,BOOL,,memory\n"
        "VAR_GLOBAL,T1,,,TIMER,,\n"
        "VAR_GLOBAL_CONSTANT,LIMIT_1,,,REAL,5,the most\n");
  CHECK(made.written.symbols == 6);
  CHECK(made.written.inputs == 2);
  CHECK(made.written.outputs == 1);
  CHECK(made.report.lines() ==
        Lines{"1 name is not an identifier: GX IEC Developer may reject it, it is written unchanged: `M 1`"});
}

TEST_CASE("gx-iec: Addresses of other tools get a MELSEC device only if the user says how X and Y count") {
  const auto symbols = symbols_of_text("a.st", "VAR_GLOBAL\n  a AT %IX3.7 : BOOL;\n  w AT %MW5 : WORD;\nEND_VAR\n");
  const Made plain = convert_to("gx-iec", symbols);
  CHECK(contains(plain.text, "VAR_GLOBAL,a,,%IX31,BOOL,,\n"));
  CHECK(contains(plain.text, "VAR_GLOBAL,w,,,WORD,,\n"));
  CHECK(plain.report.lines() == Lines{"1 address is not written: the target has no such address: `w`"});
  CHECK(contains(convert_to("gx-iec", symbols, "codesys", address::Radix::hexadecimal).text, "a,X1F,%IX31"));
  CHECK(contains(convert_to("gx-iec", symbols, "codesys", address::Radix::octal).text, "a,X37,%IX31"));
}

TEST_CASE("csv: A table has the addresses of the source, and further columns only where rows need them") {
  CHECK(convert_to("csv", gx_list("VAR_GLOBAL,A,X1F,%IX31,BOOL,FALSE,=1+1\n")).text ==
        "Name,Address,Type,Initial,Comment\nA,X1F,BOOL,FALSE,'=1+1\n");
  CHECK(convert_to("csv", gx_list("VAR_GLOBAL,A_B_C_O_X,,,BOOL,-5,\nVAR_GLOBAL_CONSTANT,C,,,INT,5,\n")).text ==
        "Name,Address,Type,Initial,Comment,Direction,Class\nA_B_C_O_X,,BOOL,-5,,output,VAR_GLOBAL\n"
        "C,,INT,5,,,VAR_GLOBAL_CONSTANT\n");
}

TEST_CASE(
    "csv: X and Y that count in octal are written as IEC addresses, because a table does not say how they count") {
  const auto octal = gx_list("VAR_GLOBAL,A,X10,%IX8,BOOL,,\nVAR_GLOBAL,B,M500,,BOOL,,\nVAR_GLOBAL,C,X7,,BOOL,,\n");
  CHECK(convert_to("csv", octal).text ==
        "Name,Address,Type,Initial,Comment,Notation\nA,%IX8,BOOL,,,melsec\n"
        "B,M500,BOOL,,,melsec\nC,%IX7,BOOL,,,melsec\n");
}

TEST_CASE("csv: The notation is named where the addresses do not show it") {
  const auto words =
      symbols_of_text("PLCTags.sdf", "\"W\",\"%IW64\",\"Word\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\n");
  CHECK(words->all.front().address->number == 32);
  const Made made = convert_to("csv", words);
  CHECK(contains(made.text, "Name,Address,Type,Initial,Comment,Notation\nW,%IW64,Word,,,siemens\n"));
  CHECK(symbols_of_text("a.csv", made.text)->all.front().address->number == 32);
}

TEST_CASE("st: Declarations are grouped, located, and have initial values and comments") {
  const Made made = convert_to("st", small_list());
  CHECK(made.text ==
        "(* Variables for CODESYS, written by symplant. *)\n\n"
        "(* inputs *)\nVAR_GLOBAL\n"
        "  A_B_C_I_X AT %IX3.7 : BOOL := FALSE; // a comment\n"
        "  SPEED AT %IW5 : INT := -5;\nEND_VAR\n\n"
        "(* outputs *)\nVAR_GLOBAL\n"
        "  A_B_C_O_X AT %QX2.0 : BOOL := TRUE; (* two\nlines * ) end *)\nEND_VAR\n\n"
        "(* other variables *)\nVAR_GLOBAL\n  M_1 : BOOL; // memory\nEND_VAR\n\n"
        "(* constants *)\nVAR_GLOBAL CONSTANT\n  LIMIT_1 : REAL := 5.0; // the most\nEND_VAR\n");
  CHECK(made.written.symbols == 5);
  CHECK(made.report.lines() ==
        Lines{"1 address is not written: the target has no such address: `M 1`",
              "1 symbol is left out: the target has no such type, or there is no type: `T1`",
              "1 name is changed: a variable has a unique identifier of letters, digits and `_`: `M 1` is `M_1`",
              "1 comment is changed: the target cannot hold some of its characters: `A_B_C_O_X`"});
}

TEST_CASE("st: TwinCAT finds the addresses of inputs and outputs that it cannot express") {
  const Made made = convert_to("st",
                               gx_list("VAR_GLOBAL,A_B_C_I_X,,,BOOL,,\nVAR_GLOBAL,B,,%QX1.2.3,BOOL,,\n"
                                       "VAR_GLOBAL,W,,%IW5,WORD,,\n"),
                               "twincat");
  CHECK(contains(made.text, "  A_B_C_I_X AT %I* : BOOL;\n"));
  CHECK(contains(made.text, "  B AT %Q* : BOOL;\n"));
  CHECK(contains(made.text, "  W AT %IW10 : WORD;\n"));
  CHECK(made.report.lines() == Lines{"2 addresses are left to the target: declared as `AT %I*` or `AT %Q*`; link each "
                                     "to a terminal: `A_B_C_I_X`, `B`"});
}

TEST_CASE("st: OpenPLC gets a program, with what its compiler accepts") {
  const Made made = convert_to("st",
                               gx_list("VAR_GLOBAL,A,X0,,BOOL,,a // comment\nVAR_GLOBAL,B,,%IW5,REAL,,\n"
                                       "VAR_GLOBAL,C,,,STRING[20],'x',\nVAR_GLOBAL,D,,,LTIME,,\n"),
                               "openplc");
  CHECK(contains(made.text,
                 "PROGRAM symplant_io\n\n(* inputs *)\nVAR\n  A AT %IX0.0 : BOOL; (* a // comment *)\nEND_VAR\n\n"
                 "(* inputs *)\nVAR\n  B : REAL;\nEND_VAR\n"));
  CHECK(contains(made.text, "  C : STRING := 'x';\n"));
  CHECK(contains(made.text, "CONFIGURATION Config0"));
  CHECK(made.report.lines() ==
        Lines{"1 address is not written: OpenPLC locates only a type of the same size as the address: `B`",
              "1 length of a string is not written: OpenPLC has strings of one length only: `C`",
              "1 symbol is left out: the target has no such type, or there is no type: `D`"});
}

TEST_CASE("st: Nothing in a comment ends it, or begins another") {
  for (const char* comment : {"*)", "(*", "(*)", "**)", "*))", "(*(*", "a *) END_VAR", "*\n)"}) {
    INFO(comment);
    const Made made = convert_to("st", gx_list("VAR_GLOBAL,A,X0,,BOOL,,\"\n" + std::string(comment) + "\"\n"));
    const std::size_t begin = made.text.find("BOOL; (* ");
    REQUIRE(begin != made.text.npos);
    const std::string rest = made.text.substr(begin + 9);
    CHECK(rest.find("(*") == rest.npos);
    CHECK(rest.find("*)") == rest.find(" *)\nEND_VAR") + 1);
  }
}

TEST_CASE("plcopen: Global variable lists, as CODESYS and TwinCAT import them") {
  const Made made = convert_to("plcopen", small_list());
  CHECK(contains(made.text, "<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\">"));
  CHECK(contains(made.text,
                 "<globalVars name=\"IO_Outputs\">\n"
                 "        <variable name=\"A_B_C_O_X\" address=\"%QX2.0\">\n"
                 "          <type><BOOL/></type>\n"
                 "          <initialValue><simpleValue value=\"TRUE\"/></initialValue>\n"
                 "          <documentation><xhtml xmlns=\"http://www.w3.org/1999/xhtml\">two&#10;lines *) end</xhtml>"
                 "</documentation>\n"));
  CHECK(contains(made.text, "<globalVars name=\"IO_Constants\" constant=\"true\">"));
}

TEST_CASE("plcopen: Variables of a program for OpenPLC, and types with their elements") {
  const Made made =
      convert_to("plcopen",
                 gx_list("VAR_GLOBAL,A,X0,,BOOL,,<&\"\nVAR_GLOBAL,B,,,\"ARRAY [0..7, -1 .. 1] OF INT\",,\n"
                         "VAR_GLOBAL,S,,,STRING,,\n"),
                 "openplc");
  CHECK(contains(made.text, "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\">"));
  CHECK(contains(made.text, "<localVars>\n        <variable name=\"A\" address=\"%IX0.0\">"));
  CHECK(contains(made.text, ">&lt;&amp;&quot;</p>"));
  CHECK(contains(made.text,
                 "<array><dimension lower=\"0\" upper=\"7\"/><dimension lower=\"-1\" upper=\"1\"/>"
                 "<baseType><INT/></baseType></array>"));
  CHECK(contains(made.text, "<string/>"));
  CHECK(contains(convert_to("plcopen", gx_list("VAR_GLOBAL,S,,,STRING[20],,\n")).text, "<string length=\"20\"/>"));
}

TEST_CASE("A writer is found by its name, and by the extension of a file") {
  CHECK(find_writer("st")->name == "st");
  CHECK(find_writer("nothing") == nullptr);
  CHECK(writer_of_extension(".XLSX")->name == "tia-xlsx");
  CHECK(writer_of_extension(".csv")->name == "csv");
  CHECK(writer_of_extension(".txt")->name == "gx-iec");
  CHECK(writer_of_extension("") == nullptr);
}

TEST_CASE("Lists of several controllers are joined, which is reported") {
  const auto table = [](const std::string& path) {
    return std::make_shared<const read::SymbolTable>([&] {
      diag::Diagnostics diagnostics;
      return std::move(*read::read_symbol_list(path, "Name,Address,Type\nA,X0,BOOL\n", {}, diagnostics));
    }());
  };
  const std::vector<List> lists{{table("a.csv"), "PLC1", {}}, {table("b.csv"), "PLC2", {}}};
  const auto symbols = std::make_shared<const Symbols>(symbols_of(lists));
  const Made made = convert_to("st", symbols);
  CHECK(contains(made.text, "A_2 AT %IX0.0"));
  CHECK(made.report.lines().front() ==
        "2 lists of different controllers are joined: a target declares one controller; convert each list to get a "
        "file for each: `a.csv`, `b.csv`");
}

}  // namespace symplant::convert
