// Addresses of a program's variables.
#include "symplant/program/address.hpp"

#include "support/catch.hpp"

namespace symplant::program {
namespace {

using tables::Direction;

TEST_CASE("An address of IEC 61131-3 has a direction, a size and a number") {
  struct Case {
    const char* text;
    Direction direction;
    int bits;
    std::uint32_t number;
  };
  for (const Case& one : {Case{"%IX3.2", Direction::event, 1, 26}, Case{"%IX26", Direction::event, 1, 26},
                          Case{"%qx0.7", Direction::operation, 1, 7}, Case{"%I5", Direction::event, 1, 5},
                          Case{"%QB4", Direction::operation, 8, 4}, Case{"%QW4", Direction::operation, 16, 4},
                          Case{"%ID2", Direction::event, 32, 2}, Case{"%QL1", Direction::operation, 64, 1}}) {
    INFO(one.text);
    const auto address = parse_address(one.text);
    REQUIRE(address);
    CHECK(address->direction == one.direction);
    CHECK(address->bits == one.bits);
    CHECK(address->number == one.number);
  }
}

TEST_CASE("Other texts are no addresses") {
  for (const char* text : {"", "%", "%I", "%IX", "%MX1", "IX1", "%IX1.8", "%IX1.", "%IW1.2", "%IX1 ", "%IX-1",
                           "%IX99999999999", "%IX536870912.0", "%IX1.2.3"}) {
    INFO(text);
    CHECK_FALSE(parse_address(text));
  }
}

}  // namespace
}  // namespace symplant::program
