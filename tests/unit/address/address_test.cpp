// Addresses as one value.
#include "address/address.hpp"

#include <random>
#include <set>
#include <string>
#include <vector>

#include "address/bits.hpp"
#include "address/grammars.hpp"
#include "support/catch.hpp"

using namespace symplant::address;

namespace {

Address plain(Area area, Size size, std::uint64_t number) {
  Address address;
  address.area = area;
  address.size = size;
  address.number = number;
  return address;
}

Address bit(Area area, std::uint64_t number) { return plain(area, Size::bit, number); }

std::optional<Address> hex(std::string_view text) { return parse_melsec(text, Radix::hexadecimal); }
std::optional<Address> oct(std::string_view text) { return parse_melsec(text, Radix::octal); }

}  // namespace

TEST_CASE("An IEC bit is a number, or a byte and a bit") {
  CHECK(parse_iec("%IX1") == bit(Area::input, 1));
  CHECK(parse_iec("%I1") == bit(Area::input, 1));
  CHECK(parse_iec("%QX0002") == bit(Area::output, 2));
  CHECK(parse_iec("%IX3.5") == bit(Area::input, 29));
  CHECK(parse_iec("  %qx0.5\t") == bit(Area::output, 5));
}

TEST_CASE("IEC words, bytes and doubles keep their size") {
  CHECK(parse_iec("%IW5") == plain(Area::input, Size::word, 5));
  CHECK(parse_iec("%QD2") == plain(Area::output, Size::dword, 2));
  CHECK(parse_iec("%IB3") == plain(Area::input, Size::byte, 3));
  CHECK(parse_iec("%QL7") == plain(Area::output, Size::lword, 7));
}

TEST_CASE("%M is memory") {
  REQUIRE(parse_iec("%MX0.500"));
  CHECK(parse_iec("%MX0.500")->area == Area::memory);
  CHECK(parse_iec("%MW5.1234")->size == Size::word);
  CHECK(parse_iec("%MX0.500") != parse_iec("%MX0.501"));
}

TEST_CASE("The memories of XG5000 and Unity Pro are memory, each with a separate area") {
  std::set<std::uint64_t> numbers;
  const auto texts = {"%MW48029", "%WW48029", "%RW48029", "%KW48029", "%FX48029", "%LX48029", "%S48029", "%UX0.0.1"};
  for (const char* text : texts) {
    INFO(text);
    REQUIRE(parse_iec(text));
    CHECK(parse_iec(text)->area == Area::memory);
    numbers.insert(parse_iec(text)->number);
  }
  CHECK(numbers.size() == texts.size());
}

TEST_CASE("A bit of a word has no link number, and differs from the bit of a byte") {
  const auto word_bit = parse_iec("%IW5.12");
  REQUIRE(word_bit.has_value());
  CHECK(word_bit->size == Size::bit);
  CHECK(word_bit->area == Area::input);
  CHECK_FALSE(word_bit->plain);
  CHECK(*word_bit == *parse_iec("%IW5.12"));
  CHECK_FALSE(*word_bit == *parse_iec("%IX5.12"));
  CHECK_FALSE(*word_bit == *parse_iec("%IW5.13"));
  CHECK(parse_iec("%MW0.500")->size == Size::word);  // in memory: area and number
}

TEST_CASE("An address with too many parts for a link is not plain, but stays distinct") {
  for (const char* text : {"%IX1.2.3", "%IX3.12", "%IW5.3", "%IX0.0.0", "%QX1.8"}) {
    INFO(text);
    const auto address = parse_iec(text);
    REQUIRE(address);
    CHECK_FALSE(address->plain);
    CHECK(parse_iec(text) == address);
  }
  CHECK(parse_iec("%IX3.12") != parse_iec("%IX4.4"));
  CHECK(parse_iec("%IX1.2.3") != parse_iec("%IX1.23"));
  CHECK(parse_iec("%ix.\"IF3.ST1\".DigitalInput01") == parse_iec("%IX.\"if3.st1\".digitalinput01"));
  CHECK(parse_iec("%IX.\"IF3.ST1\".DigitalInput01") != parse_iec("%IX.\"IF3.ST1\".DigitalInput02"));
  CHECK(parse_iec("%IX.\"IF3.ST1\".DigitalInput01") != parse_iec("%QX.\"IF3.ST1\".DigitalInput01"));
  CHECK(parse_iec("%QW.\"IF3.ST1\".AnalogOutput01")->size == Size::word);
  CHECK(parse_iec("%IX.IF3.ST1.DigitalInput01")->area == Area::input);
  CHECK_FALSE(parse_iec("%IX.1.2"));
  CHECK_FALSE(parse_iec("%QW.\"IF3.ST1\".AnalogOutput01")->plain);
  for (const char* text : {"%IX.\"IF3.ST1\"", "%IX.\"\".A", "%IX.\"A", "%IX\"A\".B", "%IX.\"A\".B C", "%IX.\"A\".B."}) {
    INFO(text);
    CHECK_FALSE(parse_iec(text));
  }
  CHECK(parse_iec("%IX1.2.3") != parse_iec("%QX1.2.3"));
}

TEST_CASE("An invalid IEC address is rejected") {
  for (const char* text : {"", "%", "%I", "%IX", "%IX.", "%IX1.", "%IX.1", "%IX1..2", "%IXA", "%ZX1", "IX1", "%IX-1",
                           "%IX 1", "%I**", "%I*1", "%*", "X1", "%IX1 x", "%IX1.2.3.4.5.6.7.8.9"}) {
    INFO(text);
    CHECK_FALSE(parse_iec(text));
  }
}

TEST_CASE("Numbers up to 64 bits are read, larger ones are rejected") {
  CHECK(parse_iec("%IX18446744073709551615") == bit(Area::input, 18446744073709551615U));
  CHECK_FALSE(parse_iec("%IX18446744073709551616"));
  REQUIRE(parse_iec("%IX18446744073709551615.1"));
  CHECK_FALSE(parse_iec("%IX18446744073709551615.1")->plain);
  CHECK_FALSE(hex("X1FFFFFFFFFFFFFFFF"));
}

TEST_CASE("X and Y count in the radix of the list") {
  CHECK(hex("X1F") == bit(Area::input, 31));
  CHECK(hex("Y0001") == bit(Area::output, 1));
  CHECK(hex("X0A0") == bit(Area::input, 160));
  CHECK(hex("x10") == bit(Area::input, 16));
  CHECK(oct("X10") == bit(Area::input, 8));
  CHECK(oct("Y007") == bit(Area::output, 7));
  CHECK(hex("DX10") == hex("X10"));
  CHECK(hex("DY1F") == bit(Area::output, 31));
}

TEST_CASE("A digit outside the radix makes the address invalid") {
  CHECK_FALSE(oct("X8"));
  CHECK_FALSE(oct("X19"));
  CHECK_FALSE(oct("Y1F"));
  CHECK_FALSE(hex("X1G"));
}

TEST_CASE("Equal addresses are equal in any notation") {
  CHECK(hex("X1F") == parse_iec("%IX31"));
  CHECK(parse_iec("%IX31") == parse_iec("%IX3.7"));
  CHECK(oct("Y10") == parse_iec("%QX8"));
}

TEST_CASE("Internal devices are memory, each with a separate area") {
  std::set<std::uint64_t> numbers;
  const auto texts = {"M500",     "L1",      "F1",      "V1",      "S1",   "B1F", "SB1F",    "SM400",
                      "D10",      "D10.5",   "D10.F",   "W0.F",    "W1F",  "R5",  "ZR81499", "SD1",
                      "SW1",      "Z0",      "T0",      "ST1",     "C0",   "TN0", "TS0",     "CC1",
                      "U6\\G100", "U0A\\G0", "J1\\B1F", "J1\\X10", "P532", "N0",  "I0"};
  for (const char* text : texts) {
    INFO(text);
    const auto address = hex(text);
    REQUIRE(address);
    CHECK(address->area == Area::memory);
    numbers.insert(address->number);
  }
  CHECK(numbers.size() == texts.size());
  CHECK(hex("D10")->size == Size::word);
  CHECK(hex("D10.5")->size == Size::bit);
  CHECK(hex("d010") == hex("D10"));
}

TEST_CASE("An unknown device is rejected") {
  for (const char* text :
       {"",     "X",   "Y",   "K0X0", "K9M0",   "XYZ1",       "BOOL", "D",     "D10.", "D10.1F", "M1.1", "X1.5",
        "%IX1", "X-1", "X 1", "MA",   "U6\\D1", "J1\\J1\\B0", "\\G1", "U\\G1", "H1F",  "E3.14",  "1X"}) {
    INFO(text);
    CHECK_FALSE(hex(text));
  }
}

TEST_CASE("An IEC address without a number is an area, and a location apart") {
  for (const char* text : {"%I*", "%ix*", "%IW*", "%Q*", "%M*"}) {
    INFO(text);
    const auto address = parse_iec(text);
    REQUIRE(address);
    CHECK_FALSE(address->assigned);
    CHECK_FALSE(address->plain);
    CHECK_FALSE(same_location(*address, *address));
    CHECK_FALSE(overlap(*address, *address));
  }
  CHECK(parse_iec("%I*")->area == Area::input);
  CHECK(parse_iec("%Q*")->area == Area::output);
  CHECK_FALSE(parse_iec("%I*")->sized);
  CHECK(parse_iec("%IW*")->sized);
  CHECK(parse_iec("%IW*")->size == Size::word);
  CHECK(same_location(*parse_iec("%IX1"), *parse_iec("%IX0.1")));
}

TEST_CASE("A digit designation is a group of bits") {
  const auto group = hex("K4X0");
  REQUIRE(group);
  CHECK(group->area == Area::input);
  CHECK(group->size == Size::word);
  CHECK_FALSE(group->plain);
  CHECK(overlap(*group, *hex("XF")));
  CHECK_FALSE(overlap(*group, *hex("X10")));
  CHECK(hex("K8Y20")->size == Size::dword);
  CHECK(hex("K2M0")->size == Size::byte);
  CHECK(hex("K4M0")->area == Area::memory);
  REQUIRE(hex("K3X0"));
  CHECK_FALSE(bits_of(*hex("K3X0")));
  CHECK(hex("K3X0") != hex("K3X4"));
  CHECK_FALSE(hex("K4D0"));
  CHECK(overlap(*oct("K4X0"), *oct("X17")));
}

TEST_CASE("Devices of other modules and networks are memory") {
  std::set<std::uint64_t> numbers;
  const auto texts = {"U6\\G100", "U6\\HG100", "U3E0\\HG0", "J1\\X10", "J1\\Y10", "J2\\X10", "J1\\SW5", "J1\\W0.F",
                      "BL0\\S1",  "@D0",       "@D1",       "LSTN5",   "LTS5",    "STS5",    "STN5",    "LCN3",
                      "LCS3",     "LZ1",       "RD7",       "ER7",     "K1X0",    "D10.F"};
  for (const char* text : texts) {
    INFO(text);
    const auto address = hex(text);
    REQUIRE(address);
    if (text[0] != 'K') CHECK(address->area == Area::memory);
    numbers.insert(address->number);
  }
  CHECK(numbers.size() == texts.size());
  CHECK(hex("J1\\X10") == hex("J1\\DX10"));
  CHECK(oct("J1\\X1F") == hex("J1\\X1F"));
}

TEST_CASE("Addresses overlap where their bits are known to be common") {
  CHECK(overlap(*parse_iec("%IX3.5"), *parse_iec("%IX29")));
  CHECK(overlap(*parse_iec("%IW5.3"), *parse_iec("%IW5")));
  CHECK_FALSE(overlap(*parse_iec("%IW5.3"), *parse_iec("%IW5.4")));
  CHECK_FALSE(overlap(*parse_iec("%IW5.3"), *parse_iec("%QW5")));
  CHECK_FALSE(overlap(*parse_iec("%IW0"), *parse_iec("%IX0.0")));  // not defined by IEC 61131-3
  CHECK_FALSE(overlap(*parse_iec("%ID0"), *parse_iec("%IW0")));
  CHECK(overlap(*hex("D10"), *hex("D10.F")));
  CHECK_FALSE(overlap(*hex("D10"), *hex("D11.0")));
  CHECK_FALSE(overlap(*hex("D10"), *hex("R10.0")));
  CHECK_FALSE(overlap(*hex("M10"), *hex("L10")));
  CHECK(overlap(*parse_iec("%IX1.2.3"), *parse_iec("%IX1.2.3")));
  CHECK_FALSE(overlap(*parse_iec("%IX1.2.3"), *parse_iec("%IX1.2.4")));
}

TEST_CASE("An address written as element and bit has both") {
  const auto parts = [](const std::optional<Address>& address) {
    const auto both = element_and_bit(address.value());
    return both ? std::to_string(both->element) + "/" + std::to_string(both->bit) : "";
  };
  CHECK(parts(parse_iec("%IW1410.1")) == "1410/1");
  CHECK(parts(parse_iec("%IX3.5")) == "3/5");
  CHECK(parts(hex("D10.F")) == "10/15");
  CHECK(parts(parse_iec("%IX29")).empty());
  CHECK(parts(parse_iec("%IW3")).empty());
  CHECK(parts(hex("X1F")).empty());
}

TEST_CASE("The addresses after one are elements of its size further") {
  CHECK(advanced(*parse_iec("%IX3.7"), 1) == parse_iec("%IX4.0"));
  CHECK(advanced(*parse_iec("%IX7"), 3) == parse_iec("%IX10"));
  CHECK(advanced(*parse_iec("%IW7"), 3) == parse_iec("%IW10"));
  CHECK(advanced(*parse_iec("%IW7.15"), 1) == parse_iec("%IW8.0"));
  CHECK(advanced(*hex("XF"), 1) == hex("X10"));
  CHECK(advanced(*oct("X7"), 1) == oct("X10"));
  CHECK(advanced(*hex("K4X0"), 1) == hex("K4X10"));
  CHECK(advanced(*hex("D10"), 2) == hex("D12"));
  CHECK(advanced(*hex("D10.F"), 1) == hex("D11.0"));
  CHECK_FALSE(advanced(*parse_iec("%IX1.2.3"), 1));
  CHECK_FALSE(advanced(*parse_iec("%I*"), 1));
  CHECK_FALSE(advanced(*parse_iec("%IX18446744073709551615"), 1));
  CHECK(advanced(*parse_iec("%IX18446744073709551614"), 1) == parse_iec("%IX18446744073709551615"));
  CHECK_FALSE(advanced(*parse_iec("%IX18446744073709551614"), 2));
  CHECK(advanced(*parse_iec("%IW0"), (std::uint64_t{1} << 60U) - 1));
  CHECK_FALSE(advanced(*parse_iec("%IW0"), std::uint64_t{1} << 60U));
  CHECK(advanced(*parse_iec("%IX0"), 0) == parse_iec("%IX0"));
}

namespace {

/// All members: equal addresses may cover bits of different banks.
std::string all_of(const std::optional<Address>& address) {
  if (!address) return "none";
  std::string text;
  for (const std::uint64_t member :
       {static_cast<std::uint64_t>(address->area), static_cast<std::uint64_t>(address->size),
        std::uint64_t{address->plain}, std::uint64_t{address->assigned}, std::uint64_t{address->sized},
        std::uint64_t{address->element}, std::uint64_t{address->bank}, address->number, address->first_bit}) {
    text += std::to_string(member) + " ";
  }
  return text;
}

}  // namespace

TEST_CASE("The fast path reads usual addresses as the grammar does") {
  std::mt19937 random(1);
  const std::vector<std::string> pieces{"%",
                                        "I",
                                        "Q",
                                        "X",
                                        "Y",
                                        "M",
                                        "i",
                                        "x",
                                        "y",
                                        "0",
                                        "1",
                                        "7",
                                        "8",
                                        "9",
                                        "A",
                                        "F",
                                        "f",
                                        "G",
                                        ".",
                                        " ",
                                        "*",
                                        "W",
                                        "D",
                                        "%IX",
                                        "%QX",
                                        "X",
                                        "Y",
                                        "000000000000001",
                                        "FFFFFFFFFFFFFFF",
                                        "99999999999999999999"};
  std::size_t read = 0;
  for (int i = 0; i < 100'000; ++i) {
    std::string text;
    for (std::size_t size = random() % 6; size > 0; --size) text += pieces[random() % pieces.size()];
    CAPTURE(text);
    REQUIRE(all_of(parse_iec(text)) == all_of(parse_iec_by_grammar(text)));
    for (const Radix radix : {Radix::octal, Radix::hexadecimal}) {
      REQUIRE(all_of(parse_melsec(text, radix)) == all_of(parse_melsec_by_grammar(text, radix)));
    }
    read += parse_iec(text) || parse_melsec(text, Radix::hexadecimal) ? 1U : 0U;
  }
  CHECK(read > 1000);
}
