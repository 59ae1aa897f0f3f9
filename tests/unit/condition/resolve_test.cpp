// From names to a tree over a plant, and names that do not fit it.
#include <map>
#include <vector>

#include "condition_support.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::test {
namespace {

using condition::Atom;
using condition::Tree;
using tables::DataType;

/// Devices AGV (0), DOOR (1) with a state `moving`, and a facet DOOR.LOCK (2); some symbols; a track CV1 (0) and a
/// place BOX (1) with parts of the kinds raw (0) and done (1).
class SmallPlant final : public condition::Names {
 public:
  std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const override {
    if (device == "AGV" && facet.empty()) return 0;
    if (device == "DOOR" && facet.empty()) return 1;
    if (device == "DOOR" && facet == "LOCK") return 2;
    return std::nullopt;
  }
  std::vector<std::uint32_t> facets(std::string_view device) const override {
    if (device == "DOOR") return {2};
    if (device == "LIFT") return {3, 4};
    return {};
  }
  std::string path(std::uint32_t unit) const override { return unit == 3 ? "LIFT.A" : unit == 4 ? "LIFT.B" : "?"; }
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override {
    for (std::size_t s = 0; s < states_[unit].size(); ++s) {
      if (states_[unit][s] == name) return static_cast<std::uint8_t>(s);
    }
    return std::nullopt;
  }
  std::optional<Symbol> symbol(std::string_view name) const override {
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<std::uint32_t> location(std::string_view name) const override {
    return name == "CV1" ? std::optional(0U) : name == "BOX" ? std::optional(1U) : std::nullopt;
  }
  std::optional<std::uint32_t> part_kind(std::string_view name) const override {
    return name == "raw" ? std::optional(0U) : name == "done" ? std::optional(1U) : std::nullopt;
  }
  std::string nearest_part_kind(std::string_view name) const override { return near(name, {"raw", "done"}); }
  std::string nearest_device(std::string_view device, std::string_view) const override {
    return near(device, {"AGV", "DOOR", "CV1"});
  }
  std::string nearest_state(std::uint32_t unit, std::string_view name) const override {
    return near(name, states_[unit]);
  }
  std::string nearest_symbol(std::string_view name) const override { return near(name, {"START", "LEVEL"}); }
  std::string why_no_state(std::uint32_t, std::string_view name) const override {
    return name == "BUSY" ? "`BUSY` is only an event" : "";
  }

 private:
  static std::string near(std::string_view wanted, const std::vector<std::string_view>& names) {
    tables::NearestName nearest(wanted);
    for (const std::string_view name : names) nearest.offer(name);
    return std::string(nearest.name());
  }

  std::vector<std::vector<std::string_view>> states_{
      {"P1", "P2"}, {"OPEN", "moving"}, {"SHUT"}, {"UP"}, {"UP", "DOWN"}};
  std::map<std::string_view, Symbol> symbols_{
      {"START", {7, DataType::boolean}}, {"LEVEL", {8, DataType::int_}}, {"SPEED", {9, DataType::real}}};
};

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
  if (const auto* fault = std::get_if<condition::Fault>(&result)) {
    return std::to_string(fault->index.offset) + "+" + std::to_string(fault->index.length) + " " + fault->message;
  }
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

}  // namespace
}  // namespace symplant::test
