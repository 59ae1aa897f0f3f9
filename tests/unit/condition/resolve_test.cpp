// From names to a tree over a plant, and names that do not fit it.
#include <sstream>

#include "condition_support.hpp"
#include "small_plant.hpp"
#include "symplant/condition/compare.hpp"

namespace symplant::test {
namespace {

using condition::Atom;
using condition::Tree;

std::string number_text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string text_of(const condition::Quantity& quantity) {
  const std::string of = std::to_string(quantity.of);
  switch (quantity.kind) {
    case condition::Quantity::Kind::number:
      return number_text(quantity.number);
    case condition::Quantity::Kind::output:
      return "output" + of;
    case condition::Quantity::Kind::symbol:
      return "slot" + of + ":" + std::string(condition::type_name(quantity.type));
    case condition::Quantity::Kind::parts:
      return "parts" + of;
    case condition::Quantity::Kind::weight:
      return "weight" + of;
  }
  return "";
}

std::string text_of(const Tree& tree) {
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value ? "always" : "never";
    case Tree::Kind::atom:
      break;
    case Tree::Kind::negation:
    case Tree::Kind::all:
    case Tree::Kind::any: {
      std::string text = tree.kind == Tree::Kind::negation ? "(not" : tree.kind == Tree::Kind::all ? "(and" : "(or";
      for (const Tree& child : tree.children) text += " " + text_of(child);
      return text + ")";
    }
  }
  const std::string of = std::to_string(tree.atom.of);
  switch (tree.atom.kind) {
    case Atom::Kind::compare:
      return text_of(tree.atom.left) + comparison_text(tree.atom.comparison) + text_of(tree.atom.right) +
             (tree.atom.tolerance == 0 ? "" : "+-" + number_text(tree.atom.tolerance));
    case Atom::Kind::settled:
      return "unit" + of + "@" + std::to_string(tree.atom.state);
    case Atom::Kind::moving:
      return "unit" + of + "~";
    case Atom::Kind::bit:
      return "bit" + of;
    case Atom::Kind::number:
      return "slot" + of + comparison_text(tree.atom.comparison) + std::to_string(tree.atom.operand);
    case Atom::Kind::parts:
      return "parts" + of + (tree.atom.part == 0xFFFF'FFFF ? "" : ":" + std::to_string(tree.atom.part)) +
             comparison_text(tree.atom.comparison) + std::to_string(tree.atom.operand);
  }
  return "";
}

std::string resolved(std::string_view text) {
  const auto result = condition::parse_and_resolve(text, SmallPlant());
  if (const auto* fault = std::get_if<condition::Fault>(&result)) return test::text_of(*fault);
  return text_of(std::get<Tree>(result));
}

TEST_CASE("Names resolve to what they name") {
  CHECK(resolved("AGV.P2 and not START or LEVEL >= 5") == "(or (and unit0@1 (not bit7)) slot8>=5)");
  CHECK(resolved("DOOR.LOCK.SHUT") == "unit2@0");
  CHECK(resolved("SPEED < 1.0") == "slot9<4607182418800017408");
}

TEST_CASE("`moving` is true while a unit moves, unless the unit has a state of that name") {
  CHECK(resolved("AGV.moving") == "unit0~");
  CHECK(resolved("AGV.MOVING") == "unit0~");
  CHECK(resolved("DOOR.moving") == "unit1@1");
  CHECK(resolved("DOOR.LOCK.moving") == "unit2~");
}

TEST_CASE("A condition may name the parts at a location") {
  CHECK(resolved("CV1.part") == "parts0>=1");
  CHECK(resolved("not BOX.PART or BOX.raw") == "(or (not parts1>=1) parts1:0>=1)");
  CHECK(resolved("CV1.done and 'CV1'.'raw'") == "(and parts0:1>=1 parts0:0>=1)");
  CHECK(resolved("CV1.parts < 3") == "parts0<3");
  CHECK(resolved("BOX.Parts = 0 or BOX.parts >= 2.5") == "(or parts1=0 parts1>2)");
}

TEST_CASE("A number of parts is an integer of at least 0") {
  CHECK(resolved("CV1.parts >= 0") == "always");
  CHECK(resolved("CV1.parts = -1") == "never");
  CHECK(resolved("CV1.parts = 0.5") == "never");
}

TEST_CASE("What is no condition about parts has a message") {
  CHECK(resolved("CV1") == "0+3 `CV1` is a track or place of parts; write `CV1.part`");
  CHECK(resolved("CV1 > 2") == "0+3 `CV1` is a track or place of parts; write `CV1.part`");
  CHECK(resolved("CV1.parts") == "4+5 `CV1.parts` is a number; compare it, as in `CV1.parts > 0`, or write `CV1.part`");
  CHECK(resolved("CV1.part > 2") == "0+8 only the number of parts is compared, as in `CV1.parts > 0`");
  CHECK(resolved("CV1.raw = 2") == "0+7 only the number of parts is compared, as in `CV1.parts > 0`");
  CHECK(resolved("BOX.rew") == "4+3 kind of part `rew` not found; did you mean `raw`?");
  CHECK(resolved("BOX.moving") == "4+6 kind of part `moving` not found");
  CHECK(resolved("BOX.a.part") == "0+10 `BOX` is a track or place of parts; write `BOX.part`");
  CHECK(resolved("BOX.a.parts > 1") == "0+11 `BOX` is a track or place of parts; write `BOX.part`");
  CHECK(resolved("CV2.parts > 1") == "0+3 track or place `CV2` not found; did you mean `CV1`?");
  CHECK(resolved("CV2.part") == "0+3 device `CV2` not found; did you mean `CV1`?");
}

TEST_CASE("The state of a device is looked up in its facets") {
  CHECK(resolved("DOOR.SHUT") == "unit2@0");
  CHECK(resolved("LIFT.DOWN") == "unit4@1");
  CHECK(resolved("not LIFT.UP") == "4+7 `LIFT.UP` is in several facets of the device; write `LIFT.A.UP`, `LIFT.B.UP`");
  CHECK(resolved("LIFT.moving") ==
        "0+11 `LIFT.moving` is in several facets of the device; write `LIFT.A.moving`, `LIFT.B.moving`");
  CHECK(resolved("LIFT") == "0+4 `LIFT` is a device; name one of its states, as in `LIFT.STATE`");
}

TEST_CASE("A comparison that is always or never true is a constant") {
  CHECK(resolved("LEVEL < 40000") == "always");
  CHECK(resolved("LEVEL = 2.5 or START") == "(or never bit7)");
}

TEST_CASE("An unknown name is reported at its location, with the nearest known name") {
  CHECK(resolved("AGW.P1") == "0+3 device `AGW` not found; did you mean `AGV`?");
  CHECK(resolved("AGV.P9") == "4+2 state `P9` of `AGV` not found; did you mean `P1`?");
  CHECK(resolved("START and STRAT") == "10+5 symbol `STRAT` not found; did you mean `START`?");
  CHECK(resolved("XYZZY") == "0+5 symbol `XYZZY` not found");
  CHECK(resolved("DOOR.LOK.SHUT") == "5+3 facet `LOK` of `DOOR` not found; did you mean `DOOR`?");
  CHECK(resolved("AGV.BUSY") == "4+4 `BUSY` is only an event");
}

TEST_CASE("A device needs a state, a symbol does not") {
  CHECK(resolved("AGV") == "0+3 `AGV` is a device; name one of its states, as in `AGV.STATE`");
  CHECK(resolved("START.ON") == "0+5 `START` is a symbol and has no states; use its name only");
}

TEST_CASE("A BOOL symbol has no comparison, a numeric one needs one") {
  CHECK(resolved("START > 0") == "0+5 `START` is of type BOOL and compared with a number; remove the comparison");
  CHECK(resolved("not LEVEL") == "4+5 `LEVEL` is of type INT and has no comparison; compare it, as in `LEVEL > 0`");
  CHECK(resolved("AGV.P1 < 3") == "0+6 a state is compared with a number; only numeric symbols can be compared");
  CHECK(resolved("SPEED > 1e999") == "8+5 the number is out of range for REAL");
}

TEST_CASE("Two operands compare as doubles") {
  CHECK(resolved("TANK.level >= 99") == "output0>=99");
  CHECK(resolved("flow > LEVEL or flow <= TANK.level") == "(or output1>slot8:INT output1<=output0)");
  CHECK(resolved("LEVEL < SPEED") == "slot8:INT<slot9:REAL");
  CHECK(resolved("CV1.parts = BOX.parts") == "parts0=parts1");
  CHECK(resolved("BOX.weight > 12.5 and BOX.Weight < CV1.weight") == "(and weight1>12.5 weight1<weight0)");
  CHECK(resolved("BOOM[1] > BOOM[3]") == "output2>output4");
  CHECK(resolved("TANK.level = -80 +- 1") == "output0=-80+-1");
  CHECK(resolved("LEVEL = 80 +- 1.5") == "slot8:INT=80+-1.5");
  CHECK(resolved("BOX.parts = 2 +- 0") == "parts1=2");
}

TEST_CASE("A number on the left is the comparison from the other side") {
  CHECK(resolved("80 < TANK.level") == "output0>80");
  CHECK(resolved("80 >= TANK.level") == "output0<=80");
  CHECK(resolved("80 = TANK.level +- 1") == "output0=80+-1");
  CHECK(resolved("5 <= LEVEL and 5 > LEVEL and 5.5 < LEVEL") == "(and slot8>=5 slot8<5 slot8>5)");
  CHECK(resolved("40000 > LEVEL") == "always");
  CHECK(resolved("3 > CV1.parts") == "parts0<3");
  CHECK(resolved("1e999 > SPEED") == "0+5 the number is out of range for REAL");
}

TEST_CASE("What cannot be compared has a message") {
  CHECK(resolved("TANK.level") ==
        "0+10 `TANK.level` is a value and has no comparison; compare it, as in `TANK.level = 1`");
  CHECK(resolved("not flow") == "4+4 `flow` is a value and has no comparison; compare it, as in `flow = 1`");
  CHECK(resolved("1 < 2") ==
        "0+5 both sides are numbers; compare a name, which is in single quotes if it reads as a number");
  CHECK(resolved("flow < 5 +- 1") == "12+1 a tolerance is only for `=`; write `=`, or remove the `+-`");
  CHECK(resolved("flow = 5 +- -1") == "12+2 a tolerance is at least 0; remove the `-`");
  CHECK(resolved("flow = 5 +- 1e999") == "12+5 the number is out of range");
  CHECK(resolved("flow = -1e999") == "7+6 the number is out of range");
  CHECK(resolved("BOOM > 1") == "0+4 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(resolved("BOOM[4] > 1") == "5+1 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(resolved("BOOM[0] > 1") == "5+1 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(resolved("BOOM[x] > 1") == "5+1 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(resolved("BOOM") == "0+4 `BOOM` is a value and has no comparison; compare it, as in `BOOM[1] = 1`");
  CHECK(resolved("flow[1] > 1") == "5+1 `flow` has one output; write it without `[1]`");
  CHECK(resolved("LEVEL[1] > 1") == "6+1 only a value of kind `linear` has several outputs; remove `[1]`");
  CHECK(resolved("flow < START") == "7+5 `START` is of type BOOL and compared with a number; remove the comparison");
  CHECK(resolved("flow < AGV.P1") == "7+6 a state is compared with a number; only numeric symbols can be compared");
  CHECK(resolved("BOX.weight") == "4+6 `BOX.weight` is a number; compare it, as in `BOX.weight > 0`");
  CHECK(resolved("CV2.weight > 1") == "0+3 track or place `CV2` not found; did you mean `CV1`?");
}

TEST_CASE("The nearest name may be that of a value") {
  CHECK(resolved("TANK.levl > 3") == "0+9 value `TANK.levl` not found; did you mean `TANK.level`?");
  CHECK(resolved("TANK.levl") == "0+9 value `TANK.levl` not found; did you mean `TANK.level`?");
  CHECK(resolved("flw > 3") == "0+3 symbol `flw` not found; did you mean `flow`?");
  CHECK(resolved("START2 = 3") == "0+6 symbol `START2` not found; did you mean `START`?");
  CHECK(resolved("A.B.C.D > 3") == "0+7 value `A.B.C.D` not found");
}

}  // namespace
}  // namespace symplant::test
