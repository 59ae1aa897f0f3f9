// Types and initial values as the targets write them.
#include "convert/types.hpp"

#include <string>

#include "convert_support.hpp"

namespace symplant::convert {
namespace {

std::string iec_type_of(const std::string& type, const std::string& address = "") {
  return iec_type(gx_list("VAR_GLOBAL,A,\"" + address + "\",,\"" + type + "\",,\n")->all.front()).value_or("-");
}

std::string tia_type_of(const std::string& type) {
  return tia_type(gx_list("VAR_GLOBAL,A,,,\"" + type + "\",,\n")->all.front()).value_or("-");
}

std::string literal(const std::string& initial, const std::string& type) {
  return iec_literal(initial, type).value_or("-");
}

}  // namespace

TEST_CASE("Types are written as IEC 61131-3 spells them") {
  CHECK(iec_type_of("bool") == "BOOL");
  CHECK(iec_type_of("BIT") == "BOOL");
  CHECK(iec_type_of("Date_And_Time") == "DT");
  CHECK(iec_type_of("STRING(20)") == "STRING[20]");
  CHECK(iec_type_of("array [0..7, -1..1] of bit") == "ARRAY [0..7, -1..1] OF BOOL");
}

TEST_CASE("A row without a type has that of its address") {
  CHECK(iec_type_of("", "X0") == "BOOL");
  CHECK(iec_type_of("", "D10") == "WORD");
  CHECK(iec_type_of("") == "-");
}

TEST_CASE("Other types cannot be declared") {
  for (const char* type : {"TIMER", "MyBlock", "ARRAY [0..7] OF MyBlock", "ARRAY [a;b] OF BOOL", "BOOL; END_VAR",
                           "STRING[x]", "ARRAY [0..1] OF ARRAY [0..1] OF BOOL"}) {
    INFO(type);
    CHECK(iec_type_of(type) == "-");
  }
}

TEST_CASE("TIA Portal spells types in its style") {
  CHECK(tia_type_of("BOOL") == "Bool");
  CHECK(tia_type_of("udint") == "UDInt");
  CHECK(tia_type_of("TOD") == "Time_Of_Day");
  CHECK(tia_type_of("STRING") == "-");
  CHECK(tia_type_of("ARRAY [0..7] OF BOOL") == "-");
}

TEST_CASE("Initial values become literals of their type") {
  CHECK(literal("", "BOOL").empty());
  CHECK(literal("1", "BOOL") == "TRUE");
  CHECK(literal("false", "BOOL") == "FALSE");
  CHECK(literal("K5", "INT") == "5");
  CHECK(literal("H1F", "WORD") == "16#1F");
  CHECK(literal("16#1F", "WORD") == "16#1F");
  CHECK(literal("INT#-5", "INT") == "INT#-5");
  CHECK(literal("E3.14", "REAL") == "3.14");
  CHECK(literal("5", "REAL") == "5.0");
  CHECK(literal("1e20", "LREAL") == "1.0e+20");
  CHECK(literal("T#5s", "TIME") == "T#5s");
  CHECK(literal("'abc'", "STRING[20]") == "'abc'");
  CHECK(literal("[8(TRUE)]", "ARRAY [0..7] OF BOOL") == "[8(TRUE)]");
}

TEST_CASE("Text that is no value of the type is never written") {
  CHECK(literal("FALSE; END_VAR", "BOOL") == "-");
  CHECK(literal("70000", "INT") == "-");
  CHECK(literal("T#5s; x", "TIME") == "-");
  CHECK(literal("'a'; x := 'b'", "STRING") == "-");
  CHECK(literal("'a$'", "STRING") == "-");
  CHECK(literal("[1]; x := [2]", "ARRAY [0..7] OF INT") == "-");
  CHECK(literal("5", "TIME") == "-");
}

}  // namespace symplant::convert
