// The two notations of Mitsubishi's tools.
#include "address/mitsubishi.hpp"

#include "support/catch.hpp"

using namespace symplant::address;

namespace {

struct Pair {
  const char* melsec;
  const char* iec;
};

}  // namespace

TEST_CASE("MELSEC and IEC addresses of Mitsubishi convert in both directions") {
  const Pair pairs[] = {{"X0", "%IX0"},       {"X10", "%IX16"},     {"X1F", "%IX31"},     {"Y1F", "%QX31"},
                        {"X0A0", "%IX160"},   {"M100", "%MX0.100"}, {"D100", "%MW0.100"}, {"B35F", "%MX1.863"},
                        {"W35F", "%MW1.863"}, {"M0", "%MX0.0"},     {"W0FF", "%MW1.255"}};
  for (const Pair& pair : pairs) {
    INFO(pair.melsec);
    CHECK(iec_of_melsec(pair.melsec, Radix::hexadecimal) == pair.iec);
    CHECK(melsec_of_iec(pair.iec, Radix::hexadecimal) == pair.melsec);
  }
}

TEST_CASE("X and Y convert in the radix of the list, the others do not depend on it") {
  CHECK(iec_of_melsec("X0010", Radix::octal) == "%IX8");
  CHECK(melsec_of_iec("%IX8", Radix::octal) == "X10");
  CHECK(iec_of_melsec("B1F", Radix::octal) == "%MX1.31");
  CHECK(melsec_of_iec("%MX1.31", Radix::octal) == "B1F");
}

TEST_CASE("The size letter of a bit may be missing, and a double word begins at its first device") {
  CHECK(melsec_of_iec("%I16", Radix::hexadecimal) == "X10");
  CHECK(melsec_of_iec(" %q31 ", Radix::hexadecimal) == "Y1F");
  CHECK(melsec_of_iec("%M0.100", Radix::hexadecimal) == "M100");
  CHECK(melsec_of_iec("%MD0.100", Radix::hexadecimal) == "D100");
}

TEST_CASE("Nothing else is converted") {
  for (const char* text : {"", "S5", "TS0", "R5", "ZR5", "L1", "DX10", "K4X0", "D10.5", "U6\\G100", "J1\\B0", "X1G",
                           "D99999999999999999999"}) {
    INFO(text);
    CHECK_FALSE(iec_of_melsec(text, Radix::hexadecimal));
  }
  for (const char* text : {"", "%IX0.1", "%IW5", "%MX1863", "%MX2.5", "%MW3.5", "%MX0.1.2", "%I*", "%IX1.2.3", "X10",
                           "%MW0.18446744073709551615"}) {
    INFO(text);
    CHECK_FALSE(melsec_of_iec(text, Radix::hexadecimal));
  }
}
