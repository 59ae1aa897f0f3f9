// Tables of real projects that read wrong once: each either is read right, or refused by name.
#include <string>

#include "read/cells/layout.hpp"
#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;

namespace {

std::string table_text(const std::string& text) {
  const test::Reading reading = test::read_text(text);
  for (const diag::Diagnostic& finding : reading.diagnostics.all()) UNSCOPED_INFO(finding.message);
  REQUIRE(reading.table);
  return test::rows_as_text(*reading.table);
}

std::string refusal_of(const std::string& text, const std::string& name = "list.csv") {
  const test::Reading reading = test::read_text(text, name);
  REQUIRE_FALSE(reading.table);
  REQUIRE(reading.diagnostics.all().size() == 1);
  CHECK(reading.diagnostics.all()[0].rule->slug == "recognized-format");
  return reading.diagnostics.all()[0].message;
}

}  // namespace

TEST_CASE("An unknown column whose cells are addresses is the address column") {
  CHECK(table_text("Tag,Terminal,Type\nA,%QX0.0,BOOL\nB,%IX0.0,BOOL\n") == "|A|%QX0.0||BOOL||\n|B|%IX0.0||BOOL||\n");
}

TEST_CASE("A column `Device` of words is not one of addresses") {
  CHECK(table_text("Device,Tag,Terminal\nSOLENOID VALVE,XV_1,%QX0.0\nLIMIT_SWITCH,ZSO_1,%IX0.0\n") ==
        "|XV_1|%QX0.0||||SOLENOID VALVE\n|ZSO_1|%IX0.0||||LIMIT_SWITCH\n");
}

TEST_CASE("A list of devices and comments may have more columns") {
  const std::string rows = "1,INPUT,X1,clamp open,why\n2,OUTPUT,Y5,open clamp,how\n";
  for (const char* comment : {"DeviceComment", "Comment"}) {
    CHECK(table_text("No,Direction,Device," + std::string(comment) + ",LogicNotes\n" + rows) ==
          "|X1|X1||||clamp open\n|Y5|Y5||||open clamp\n");
  }
}

TEST_CASE("Comments are never taken from a column that repeats few words") {
  CHECK(table_text("Tag,Address,Retentive,Notes\nA,%QX0.0,Off,opens the clamp\nB,%QX0.1,Off,closes it\n") ==
        "|A|%QX0.0||||opens the clamp\n|B|%QX0.1||||closes it\n");
  CHECK(table_text("Tag,Address,Kept,Address Comment\nA,%QX0.0,long,a\nB,%QX0.1,short,b\nC,%QX0.2,none,b\n") ==
        "|A|%QX0.0||||a\n|B|%QX0.1||||b\n|C|%QX0.2||||b\n");
}

TEST_CASE("Tables whose addresses no reader has right are refused by name") {
  CHECK(refusal_of("Address,Data Type,Modbus Address,Function Code,Nickname,Initial Value,Retentive,Address Comment\n"
                   "X001,BIT,100001,FC=02,start,,Off,a\n")
            .starts_with("this is the address list of AutomationDirect CLICK; "));
  CHECK(refusal_of("Rack,Slot,Point,Card Type,Device,Tag Name,Description\n1,1,0,1756-IB16,SWITCH,TSL_1,low\n")
            .starts_with("this is a table whose addresses are in several columns (rack, slot and point); "));
  CHECK(refusal_of("\"PRG1\"\n\"PLC Information:\"\t\"R04\"\n\"Step No.\"\t\"Line Statement\"\t\"Instruction\"\t"
                   "\"I/O (Device)\"\n\"0\"\t\"\"\t\"LD\"\t\"X1\"\n")
            .starts_with("this is a program of GX Works (ladder, CSV); "));
  CHECK(refusal_of("x", "line.ap16").starts_with("this is a TIA Portal project or archive; "));
  CHECK(refusal_of(std::string("\xFF\x00\x81", 3), "line.zap19").starts_with("this is a TIA Portal project"));
}

TEST_CASE("The columns that a user names are read, whatever the header is") {
  read::ReadOptions options;
  options.columns = *read::column_map_of("name=Nickname,address=Modbus Address");
  const test::Reading reading =
      test::read_text("Address,Modbus Address,Function Code,Nickname\nX001,100001,FC=02,start\n", "list.csv", options);
  REQUIRE(reading.table);
  CHECK(reading.table->rows[0].name == "start");
  CHECK(reading.table->rows[0].vendor_address == "100001");
}

TEST_CASE("XG5000: what a program uses of the global variables is not a second symbol") {
  const std::string head = "Remark,PLC Name=A\nType,Scope,Variable,Address,DataType,Property,Comment\n";
  const std::string text = head +
                           "Tag,ScanProgram\\010,\"SOL\",%QX1.0,\"BOOL\",,\"\"\n"
                           "Tag,GlobalVariable,\"SOL\",%QX1.0,\"BOOL\",,\"\"\n"
                           "Tag,ScanProgram\\011,\"SOL\",%QX1.0,\"BOOL\",,\"\"\n"
                           "Tag,ScanProgram\\011,\"OWN\",%IX1.0,\"BOOL\",,\"\"\n"
                           "Tag,ScanProgram\\012,\"OWN\",%IX1.0,\"BOOL\",,\"\"\n"
                           "Tag,ScanProgram\\012,\"SOL\",%QX9.0,\"BOOL\",,\"\"\n";
  CHECK(table_text(text) == "|SOL||%QX1.0|BOOL||\n|OWN||%IX1.0|BOOL||\n|SOL||%QX9.0|BOOL||\n");
  const test::Reading two = test::read_text(text + head + "Tag,GlobalVariable,\"SOL\",%QX1.0,\"BOOL\",,\"\"\n");
  REQUIRE(two.table);
  CHECK(two.table->rows.size() == 4);
  CHECK(two.table->parts == std::vector<std::size_t>{3});
}

TEST_CASE("Logix: a list of several controllers has the tags of each") {
  const std::string rows = table_text(
      "CONTROLLER,TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES\n"
      "BLK,ALIAS,,ZSO_1,,,\"Local:1:I.Data.0\",\"\"\nBLK,ALIAS,,XV_1,,,\"Local:2:O.Data.0\",\"\"\n"
      "SIS,ALIAS,,ZSO_1,,,\"Local:3:I.Data.0\",\"\"\n");
  CHECK(rows == "|BLK.ZSO_1|Local:1:I.Data.0||||\n|XV_1|Local:2:O.Data.0||||\n|SIS.ZSO_1|Local:3:I.Data.0||||\n");
}

TEST_CASE("Variables of B&R without addresses: the message names the file that has them") {
  const std::string text = "VAR\n\tdiOpen : BOOL; (*X1.1*)\nEND_VAR\n";
  const auto message = [&](const std::string& name) {
    const test::Reading reading = test::read_text(text, name);
    REQUIRE_FALSE(reading.table);
    return reading.diagnostics.all()[0].message;
  };
  CHECK(message("Global.var").ends_with("; of B&R Automation Studio give the I/O mapping (IoMap.iom)"));
  CHECK(message("global.st").ends_with("export the list of global variables"));
}
