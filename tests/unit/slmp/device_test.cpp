// Devices and their texts.
#include "symplant/link/slmp/device.hpp"

#include "support/catch.hpp"

using namespace symplant::link::slmp;

namespace {

/// The device as text of the same family, or "-".
std::string read(const char* text, Family family = Family::q) {
  const auto device = parse_device(text, family);
  return device ? device_text(*device, family) : "-";
}

std::uint32_t number(const char* text, Family family = Family::q) { return parse_device(text, family)->number; }

}  // namespace

TEST_CASE("X and Y are hexadecimal, on FX5 octal") {
  CHECK(number("X10") == 0x10);
  CHECK(number("X10", Family::fx5) == 010);
  CHECK(number("Y0001") == 1);
  CHECK(read("X18", Family::fx5) == "-");
  CHECK(read("x1f") == "X1F");
  CHECK(read("X100", Family::fx5) == "X100");
  CHECK(number("XA0") == 0xA0);
}

TEST_CASE("The longest name that leaves a number is the device") {
  CHECK(read("DX10") == "DX10");
  CHECK(read("SB1") == "SB1");
  CHECK(read("BFF") == "BFF");
  CHECK(read("CC5") == "CC5");
  CHECK(read("FF") == "-");
  CHECK(read("D0") == "D0");
  CHECK(read("ZR81499") == "ZR81499");
  CHECK(read("W1F") == "W1F");
  CHECK(number("W10") == 0x10);
  CHECK(number("D10") == 10);
  CHECK(read("DX10", Family::fx5) == "-");
}

TEST_CASE("A bit of a word has one hexadecimal digit") {
  CHECK(read("D100.F") == "D100.F");
  CHECK(parse_device("D100.F", Family::q)->bit == 15);
  CHECK(read("D100.10") == "-");
  CHECK(read("M5.1") == "-");
  CHECK(read("D100.") == "-");
}

TEST_CASE("K4X0 is a number of 16 bits") {
  const auto device = parse_device("K4X10", Family::q);
  REQUIRE(device);
  CHECK(device->digits == 4);
  CHECK_FALSE(device->is_bit());
  CHECK(read("K4X10") == "K4X10");
  CHECK(read("K4D0") == "-");
  CHECK(read("K9X0") == "-");
}

TEST_CASE("The IEC form of GX IEC Developer counts in decimal") {
  CHECK(read("%IX16") == "X10");
  CHECK(read("%IX8", Family::fx5) == "X10");
  CHECK(read("%Q31") == "Y1F");
  CHECK(read("%MX0.100") == "M100");
  CHECK(read("%MX1.863") == "B35F");
  CHECK(read("%MW0.100") == "D100");
  CHECK(read("%MD0.100") == "D100");
  CHECK(read("%MW1.863") == "W35F");
  CHECK(read("%MX99.1") == "-");
  CHECK(read("%MX1863") == "-");
  CHECK(read("%IX0.1") == "-");
}

TEST_CASE("What is not a device is rejected") {
  for (const char* text : {"", "X", "10", "I0.0", "Q", "%", "%I", "%IX", "D-1", "D 1", "X16777216", "M16777216"}) {
    CAPTURE(text);
    CHECK(read(text) == "-");
  }
  CHECK(read("M16777215") == "M16777215");
}
