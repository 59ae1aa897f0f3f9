// The grammars of vendors, and the texts that they write.
#include <set>
#include <string>

#include "address/bits.hpp"
#include "address/notation.hpp"
#include "support/catch.hpp"

using namespace symplant::address;

namespace {

std::optional<Address> read(Notation notation, std::string_view text) { return parse(text, {notation}); }
std::optional<Address> siemens(std::string_view text) { return read(Notation::siemens, text); }
std::optional<Address> rockwell(std::string_view text) { return read(Notation::rockwell, text); }
std::optional<Address> omron(std::string_view text) { return read(Notation::omron, text); }
std::optional<Address> modbus(std::string_view text) { return read(Notation::modbus, text); }

/// "input word 32", "memory bit", "output bit -" (without a number).
std::string shape(const std::optional<Address>& address) {
  if (!address) return "nothing";
  const std::string area = address->area == Area::input ? "input" : address->area == Area::output ? "output" : "memory";
  const std::string size = std::to_string(static_cast<int>(address->size));
  if (address->area == Area::memory) return area + " " + size;
  return area + " " + size + " " + (address->plain ? std::to_string(address->number) : "-");
}

}  // namespace

TEST_CASE("SIMATIC numbers bytes, in English and German") {
  CHECK(shape(siemens("%I0.0")) == "input 1 0");
  CHECK(shape(siemens("I      11.6 ")) == "input 1 94");
  CHECK(siemens("E 2.6") == siemens("%i2.6"));
  CHECK(siemens("A 4.0") == siemens("%Q4.0"));
  CHECK(siemens("%I0.3") == parse_iec("%IX0.3"));
  CHECK(shape(siemens("%IB4")) == "input 8 4");
  CHECK(shape(siemens("%IW64")) == "input 16 32");
  CHECK(shape(siemens("%IW65")) == "input 16 -");
  CHECK(shape(siemens("%QD100")) == "output 32 25");
  CHECK(shape(siemens("%QD102")) == "output 32 -");
  CHECK(siemens("PIW 64") == siemens("%IW64:P"));
  CHECK(siemens("PEW64") == siemens("ew64"));
  CHECK(siemens("PAW   256") == siemens("%QW256:p"));
  CHECK(siemens("PQB 2") == siemens("AB2"));
  CHECK(siemens("PID 4") == siemens("ED 4"));
}

TEST_CASE("SIMATIC words and their bits overlap") {
  CHECK(overlap(*siemens("%IW64"), *siemens("%I64.3")));
  CHECK(overlap(*siemens("%IW64"), *siemens("%I65.7")));
  CHECK_FALSE(overlap(*siemens("%IW64"), *siemens("%I66.0")));
  CHECK(overlap(*siemens("%ID100"), *siemens("%IW102")));
  CHECK(overlap(*siemens("%IW100"), *siemens("%IW101")));
  CHECK_FALSE(overlap(*siemens("%IW64"), *siemens("%Q64.3")));
  CHECK(overlap(*siemens("MW10"), *siemens("M 11.0")));
  CHECK_FALSE(overlap(*siemens("MW10"), *siemens("L 11.0")));
}

TEST_CASE("SIMATIC blocks, timers, counters and data are memory") {
  std::set<std::uint64_t> numbers;
  const auto texts = {"M 0.1", "MB4",  "MW4",    "MD4",    "L 0.0",  "LW2",   "T      5",  "C 5",        "DB     54",
                      "FB 1",  "FC 1", "SFB  5", "SFC 20", "OB   1", "UDT 3", "VAT     4", "DB1.DBX0.0", "DB1.DBX0.1",
                      "DI 1",  "SDB1", "%T1",    "%C1",    "%M5.7",  "%MW6",  "DB1.DBW 4", "DB2.DBW4",   "%DB3.DBD8"};
  for (const char* text : texts) {
    INFO(text);
    const auto address = siemens(text);
    REQUIRE(address);
    CHECK(address->area == Area::memory);
    numbers.insert(address->number * 100 + static_cast<std::uint64_t>(address->size));
  }
  CHECK(numbers.size() == texts.size());
  CHECK(siemens("Z 5") == siemens("C5"));
}

TEST_CASE("What is no SIMATIC operand is rejected") {
  for (const char* text :
       {"",           "%",          "I",       "I0",     "I 0.8",    "%IX0.0", "%IW",
        "%IW1.0",     "IW64.3",     "X1F",     "P1",     "DB1.DBX0", "T1.0",   "M0",
        "DB1.DBW4.0", "FB1.DBX0.0", "%I0.0:Q", "M0.0:P", "%I0.0 x",  "I0 .0",  "I99999999999999999999.0"}) {
    INFO(text);
    CHECK_FALSE(siemens(text));
  }
}

TEST_CASE("Tags of Logix modules have the direction of their connection") {
  CHECK(shape(rockwell("Local:1:I.Data.0")) == "input 1 -");
  CHECK(shape(rockwell("Local:9:I.Data[12].8")) == "input 1 -");
  CHECK(shape(rockwell("EN2TR_A:1:O.Data.31")) == "output 1 -");
  CHECK(shape(rockwell("BOX_1:I.Data[10].3")) == "input 1 -");
  CHECK(shape(rockwell("Rack:O[3].5")) == "output 1 -");
  CHECK(shape(rockwell("Safe:2:SI.Pt00Data")) == "input 1 -");
  CHECK(shape(rockwell("Local:3:I.Pt03.Data")) == "input 1 -");
  CHECK(shape(rockwell("Net:I1.Data[2].0")) == "input 1 -");
  CHECK(shape(rockwell("Local:1:C.Data")) == "memory 32");
  CHECK(shape(rockwell("Local:1:S.Fault")) == "memory 32");
  CHECK(shape(rockwell("Flags[72].5")) == "memory 1");
  CHECK(shape(rockwell("Program:Main.Step")) == "memory 32");
  CHECK(rockwell("Local:8:I.DATA[2].28") == rockwell("local:8:i.Data[2].28"));
  CHECK(rockwell("Local:8:I.Data[2].28") != rockwell("Local:8:I.Data[2].27"));
}

TEST_CASE("The size of a member of a Logix module is not known from its tag") {
  for (const char* text : {"Local:4:I.Ch0Data", "Local:5:O.Ch[2].Data", "Local:1:I.Data", "Local:4:I.Ch00.Data"}) {
    INFO(text);
    const auto address = rockwell(text);
    REQUIRE(address);
    CHECK_FALSE(address->sized);
    CHECK(address->area != Area::memory);
  }
  CHECK(rockwell("Local:1:I.Data.0")->sized);
}

TEST_CASE("Files of PLC-5 and SLC have an area by their letter") {
  CHECK(shape(rockwell("I:1/0")) == "input 1 -");
  CHECK(shape(rockwell("O:2/3")) == "output 1 -");
  CHECK(shape(rockwell("I:1")) == "input 16 -");
  CHECK(shape(rockwell("O0:2.1/3")) == "output 1 -");
  CHECK(rockwell("I:001/00") == rockwell("i:1/0"));
  CHECK(rockwell("I:1.0/3") == rockwell("I:1/3"));
  CHECK(rockwell("I:1.1/3") != rockwell("I:1/3"));
  for (const char* text : {"N7:0", "B3:0/1", "B3/17", "T4:0.DN", "F8:3", "S:1/15"}) {
    INFO(text);
    REQUIRE(rockwell(text));
    CHECK(rockwell(text)->area == Area::memory);
  }
  for (const char* text :
       {"", ":", "Local:", "Local:1:I.", "1:I", "a b", "Local:1:I.Data.", "Local:1:I[", "I:1/99", "%IX1"}) {
    INFO(text);
    CHECK_FALSE(rockwell(text));
  }
}

TEST_CASE("Words and bits of Omron are memory, unless CIO has ranges of inputs and outputs") {
  std::set<std::uint64_t> numbers;
  const auto texts = {"1052.02", "0.00",  "W10.00", "H13.02", "CF113",   "A400.11", "D20042", "D5.01",
                      "T0723",   "C0001", "E0_0",   "E1_0",   "EA_5.03", "10",      "TK1"};
  for (const char* text : texts) {
    INFO(text);
    const auto address = omron(text);
    REQUIRE(address);
    CHECK(address->area == Area::memory);
    numbers.insert(address->number);
  }
  CHECK(numbers.size() == texts.size());
  CHECK(omron("CIO 10.5") == omron("10.05"));
  CHECK(overlap(*omron("W10"), *omron("W10.15")));

  const IoRanges ranges{{{0, 9, Area::input}, {100, 109, Area::output}}};
  const auto with = [&](std::string_view text) { return parse(text, {Notation::omron, Radix::hexadecimal, &ranges}); };
  CHECK(shape(with("0.00")) == "input 1 0");
  CHECK(shape(with("9.15")) == "input 1 159");
  CHECK(shape(with("CIO 100.02")) == "output 1 1602");
  CHECK(shape(with("101")) == "output 16 101");
  CHECK(shape(with("10.00")) == "memory 1");
  CHECK(shape(with("W5.00")) == "memory 1");
  CHECK(overlap(*with("101"), *with("101.15")));
  for (const char* text : {"", ".", "1.16", "T5.0", "6144", "10001", "X1", "E_0", "W", "1.2.3", "CIO", "P1"}) {
    INFO(text);
    CHECK_FALSE(omron(text));
  }
}

TEST_CASE("Modbus references have their table as first digit") {
  CHECK(shape(modbus("00001")) == "output 1 0");
  CHECK(shape(modbus("10001")) == "input 1 0");
  CHECK(shape(modbus("30010")) == "input 16 9");
  CHECK(shape(modbus("40001")) == "memory 16");
  CHECK(shape(modbus("065536")) == "output 1 65535");
  CHECK(shape(modbus("100017")) == "input 1 16");
  CHECK(shape(modbus("30001.3")) == "input 1 -");
  CHECK(modbus("400001") == modbus("40001"));
  CHECK(overlap(*modbus("30001.3"), *modbus("30001")));
  for (const char* text :
       {"", "1", "0001", "10000", "20001", "50001", "165537", "10001.3", "40001.16", "1000001", "X10001"}) {
    INFO(text);
    CHECK_FALSE(modbus(text));
  }
}

TEST_CASE("An address is written as its notation reads it") {
  struct Case {
    Notation notation;
    const char* text;
  };
  const Case cases[] = {{Notation::iec, "%IX3.5"},     {Notation::iec, "%QX29"},     {Notation::iec, "%IW1410.1"},
                        {Notation::iec, "%IB3"},       {Notation::iec, "%QL7"},      {Notation::melsec, "X1F"},
                        {Notation::melsec, "Y0A"},     {Notation::melsec, "K4X10"},  {Notation::melsec, "M500"},
                        {Notation::melsec, "D10.F"},   {Notation::melsec, "W0FF"},   {Notation::siemens, "%I0.7"},
                        {Notation::siemens, "%QD102"}, {Notation::siemens, "%MB4"},  {Notation::siemens, "%M0.0"},
                        {Notation::omron, "1052.02"},  {Notation::omron, "W10.00"},  {Notation::omron, "D20042"},
                        {Notation::modbus, "000001"},  {Notation::modbus, "100017"}, {Notation::modbus, "300001.3"},
                        {Notation::modbus, "400001"}};
  for (const Case& given : cases) {
    INFO(given.text);
    const auto address = read(given.notation, given.text);
    REQUIRE(address);
    CHECK(to_text(*address, {given.notation}) == given.text);
  }
  CHECK(to_text(*parse_melsec("X10", Radix::octal), {Notation::melsec, Radix::octal}) == "X10");
  CHECK_FALSE(to_text(*rockwell("Local:1:I.Data.0"), {Notation::rockwell}));
  CHECK_FALSE(to_text(*parse_iec("%IX1.2.3"), {Notation::iec}));
  CHECK_FALSE(to_text(*parse_iec("%IW5"), {Notation::melsec}));
  CHECK_FALSE(to_text(*parse_iec("%IW5"), {Notation::siemens}));
  CHECK_FALSE(to_text(*siemens("%IW64"), {Notation::iec}));
}

TEST_CASE("Elements of arrays are bytes of SIMATIC, words of others") {
  const auto after = [](Notation notation, std::string_view text, std::uint64_t count) {
    return to_text(advanced(read(notation, text).value(), count).value(), {notation}).value();
  };
  CHECK(after(Notation::siemens, "%IW64", 1) == "%IW66");
  CHECK(after(Notation::siemens, "%QD102", 2) == "%QD110");
  CHECK(after(Notation::siemens, "E 0.7", 1) == "%I1.0");
  CHECK(after(Notation::iec, "%IW64", 1) == "%IW65");
  CHECK(after(Notation::omron, "W10.15", 1) == "W11.00");
  CHECK(after(Notation::modbus, "30001", 1) == "300002");
}
