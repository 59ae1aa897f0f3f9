// What names that differ only in digits have in common.
#include "text/shape.hpp"

#include <string>

#include "support/catch.hpp"

namespace symplant::text {
namespace {

TEST_CASE("A shape has # for digits, one blank for blanks and one form for ordinals") {
  CHECK(shape_of("S201_I_RB12_HOME") == "S#_I_RB#_HOME");
  CHECK(shape_of("12") == "#");
  CHECK(shape_of("A  1\t \n2") == "A # #");
  CHECK(shape_of("A##1") == "A##");
  CHECK(shape_of("1ST_2nd_3RD 4th") == "#TH_#TH_#TH #TH");
  CHECK(shape_of("1STOP #ND ST 2S") == "#STOP #ND ST #S");
  CHECK(shape_of("") == "");
  CHECK(shape_of("\t 1 ") == " # ");
  CHECK(shape_of(" #1#2") == " ##");
  CHECK(shape_of("21ST") == "#TH");
  CHECK(shape_of("1S") == "#S");
  CHECK(shape_of("1STA 2ND_") == "#STA #TH_");
  CHECK(shape_of(std::string(40, '7') + "A") == "#A");
}

}  // namespace
}  // namespace symplant::text
