// The notation of a column, and whether a text is an address at all.
#include <string>
#include <vector>

#include "address/notation.hpp"
#include "support/catch.hpp"

using namespace symplant::address;

namespace {

std::string likely(const std::vector<std::string_view>& cells) {
  const auto notation = likely_notation(cells);
  if (!notation) return "none";
  constexpr const char* kNames[] = {"iec", "melsec", "siemens", "rockwell", "omron", "modbus"};
  return kNames[static_cast<std::size_t>(*notation)];
}

}  // namespace

TEST_CASE("The notation that reads most cells is the likely one") {
  CHECK(likely({"%IX0.5", "%QW3", "%MX0.1"}) == "iec");
  CHECK(likely({"X0", "Y1F", "M500", "", "D10.5"}) == "melsec");
  CHECK(likely({"I 0.0", "PIW 64", "DB 5", "M 1.0"}) == "siemens");
  CHECK(likely({"E 0.0", "A 4.1", "PEW 64"}) == "siemens");
  CHECK(likely({"Local:1:I.Data.0", "Local:2:O.Data.5", "Flags[3].1"}) == "rockwell");
  CHECK(likely({"I:1/0", "O:2/3", "N7:0"}) == "rockwell");
  CHECK(likely({"1052.02", "0.00", "W10.00", "D100"}) == "omron");
  CHECK(likely({"10001", "00001", "400001"}) == "modbus");
}

TEST_CASE("SIMATIC and IEC 61131-3 differ by their bits and words") {
  CHECK(likely({"%I0.0", "%Q0.1", "%IW64"}) == "siemens");
  CHECK(likely({"%I0.0", "%IW64:P"}) == "siemens");
  CHECK(likely({"%IX0.0", "%IW64"}) == "iec");
  CHECK(likely({"%IW64", "%QW2"}) == "iec");
  CHECK(likely({"%E0.0", "%A0.1"}) == "siemens");
  CHECK(likely({"%I0.0", "%I*"}) == "iec");
}

TEST_CASE("A column of other texts has no notation") {
  CHECK(likely({}) == "none");
  CHECK(likely({"", " "}) == "none");
  CHECK(likely({"cylinder", "pump", "X1"}) == "none");
  CHECK(likely({"BOOL", "INT", "REAL"}) == "none");
  CHECK(likely({"A0.1", "A 4.0"}) == "none");  // an output of SIMATIC, or memory of Omron
}

TEST_CASE("Addresses are recognized, and names are not taken for them") {
  for (const char* text : {"%IX0.5", "%I*", "%MW2037.8", "X1F", "Y0001", "X10", "K4X0", "I 0.0", "E2.6", "%IW64",
                           "PIW 64", "DB1.DBX0.0", "Local:1:I.Data.0", "I:1/0", "U6\\G100", "D100.5", "W10.00"}) {
    INFO(text);
    CHECK(address_strength(text) == 2);
    CHECK(looks_like_address(text));
  }
  for (const char* text : {"M1", "M500", "D10", "W1F", "X1", "Y2", "40001", "1052.02", "IW64"}) {
    INFO(text);
    CHECK(address_strength(text) == 1);
  }
  for (const char* text :
       {"",   "P1",   "S301",      "LIMIT1",    "T1",   "C1", "START", "DB1",      "FB10", "Local", "Pump:Start",
        "10", "BOOL", "L_P_D_I_A", "Motor.Run", "N7:0", "V1", "Z0",    "12345678", "F1",   "I1",    "TC1"}) {
    INFO(text);
    CHECK(address_strength(text) == 0);
  }
}
