// Conditions written and read back.
#include "model/condition_text.hpp"

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "model/plant_names.hpp"
#include "model_support.hpp"

namespace symplant::test {
namespace {

using condition::Atom;
using condition::Tree;

bool same(const Tree& a, const Tree& b) {
  if (a.kind != b.kind || a.children.size() != b.children.size()) return false;
  if (a.kind == Tree::Kind::atom && !(a.atom == b.atom)) return false;
  if (a.kind == Tree::Kind::constant && (a.value != b.value || a.atom.of != b.atom.of)) return false;
  for (std::size_t i = 0; i < a.children.size(); ++i) {
    if (!same(a.children[i], b.children[i])) return false;
  }
  return true;
}

/// Devices, states and symbols whose names are keywords, have letters of other scripts, or are no valid names.
Analysed hostile() {
  return analyse_rows({{"L_P_D_O_A1", "Y1"},
                       {"L_P_D_I_B2", "X2"},
                       {"\xEA\xB3\xB5_\xEC\xA0\x95_D_I_\xC3\x84", "X3"},
                       {"1_2_3_I_AND", "X4"},
                       {"not", "X5"},
                       {"OR", "X6"},
                       {"don't'", "X7"},
                       {"a.b c", "X8"},
                       {"\xE2\x82\xAC", "X9"},
                       {"LEVEL", "", "INT", "0", "%IW1"},
                       {"BIG", "", "ULINT", "0", "%IL2"},
                       {"LONG", "", "LINT", "0", "%IL3"},
                       {"SPEED", "", "REAL", "0", "%ID8"}});
}

struct Reader {
  const model::PlantModel& plant;
  std::vector<description::DescriptionFault> found{};
  std::vector<description::DescriptionFault> warned{};
  description::Faults faults{found, warned};
  model::PlantNames names{plant, faults};

  Tree read(const std::string& text) const {
    INFO(text);
    const auto result = condition::parse_and_resolve(text, names);
    if (const auto* fault = std::get_if<condition::Fault>(&result)) FAIL(fault->message);
    return std::get<Tree>(result);
  }
  std::string again(const std::string& text) const { return model::condition_text(read(text), plant); }
};

TEST_CASE("A condition is written with quotes and parentheses only where needed") {
  const Analysed analysed = hostile();
  const Reader reader{analysed.model()};
  for (const char* text : {
           "L_P_D.A1",
           "L_P_D.A1 and not L_P_D.B2 or 'OR' and L_P_D.moving",
           "(L_P_D.A1 or L_P_D.B2) and not (L_P_D.A1 and L_P_D.B2)",
           "not (not L_P_D.A1)",
           "(L_P_D.A1 and L_P_D.B2) and L_P_D.A1",
           "\xEA\xB3\xB5_\xEC\xA0\x95_D.\xC3\x84",
           "1_2_3.AND and 'not' and 'OR' and 'don''t''' and 'a.b c' and '\xE2\x82\xAC'",
           "LEVEL < -5 or BIG >= 18446744073709551615 or LONG = -9223372036854775808",
           "SPEED > 0.1 or SPEED <= 1e+300 or SPEED = -3",
           "LEVEL >= -32768 and not BIG < 0",
           "LEVEL < SPEED or SPEED = 80 +- 1.5 or not BIG >= LONG",
       }) {
    CHECK(reader.again(text) == text);
  }
  CHECK(reader.again("((L_P_D.A1)) AND ('L_P_D'.'B2')") == "L_P_D.A1 and L_P_D.B2");
  CHECK(reader.again("l_p_d.a1") == "L_P_D.A1");
  CHECK(reader.again("LEVEL < 3.5") == "LEVEL <= 3");
  CHECK(reader.again("LEVEL < 1e9") == "LEVEL >= -32768");
  CHECK(reader.again("BIG = 0.5") == "BIG < 0");
}

TEST_CASE("A name that reads as a number, or is on the right and begins with a digit, is in quotes") {
  const Analysed analysed = analyse_rows({{"12", "", "INT", "0", "%IW1"}, {"3D", "", "INT", "0", "%IW2"}});
  const Reader reader{analysed.model()};
  for (const char* text : {"'12' < 5", "3D < 5", "3D < '12'", "'12' = '3D'"}) CHECK(reader.again(text) == text);
  CHECK(reader.again("5 > '12'") == "'12' < 5");
}

TEST_CASE("Conditions about parts are written as they are read, with quotes where needed") {
  description::Description description;
  description.material.kinds = {{"raw", 1000, 0}, {"don't", 1000, 0}};
  description.material.places = {{"CV1", "", 1, {}}, {"not", "", 1, {}}, {"lift 2.a", "", 1, {}}};
  const Analysed analysed = analyse_described(bits({"L_P_D_O_A1"}), std::move(description));
  const Reader reader{analysed.model()};
  for (const char* text : {
           "CV1.part and not 'not'.raw or 'lift 2.a'.'don''t'",
           "CV1.parts < 3 or 'not'.parts = 0 or 'lift 2.a'.parts >= 18446744073709551615",
           "CV1.parts < 0 or CV1.parts >= 0",
       }) {
    CHECK(reader.again(text) == text);
  }
  CHECK(reader.again("cv1.PARTS >= 1 or CV1.Part or cv1.RAW") == "CV1.part or CV1.part or CV1.raw");
  CHECK(reader.again("CV1.parts > 1e30") == "CV1.parts < 0");
}

TEST_CASE("A condition without source text says so, a long text is cut between characters") {
  const Analysed analysed = hostile();
  Tree always;
  always.value = true;
  CHECK(model::condition_text(always, analysed.model()) == "always");
  CHECK(model::condition_text(Tree{}, analysed.model()) == "never");
  const Reader reader{analysed.model()};
  const Tree korean = reader.read("\xEA\xB3\xB5_\xEC\xA0\x95_D.\xC3\x84");
  CHECK(model::condition_text(korean, analysed.model(), 5) == "\xEA\xB3\xB5_ ...");
  CHECK(model::condition_text(korean, analysed.model(), 2) == " ...");
  CHECK(model::condition_text(korean, analysed.model(), 12) == "\xEA\xB3\xB5_\xEC\xA0\x95_D.\xC3\x84");
}

class RandomTree {
 public:
  explicit RandomTree(const model::PlantModel& plant) : plant_(plant) {}

  Tree draw(int depth) {
    Tree tree;
    const std::uint32_t choice = depth == 0 ? 0 : below(4);
    if (choice == 0) return leaf();
    tree.kind = choice == 1 ? Tree::Kind::negation : choice == 2 ? Tree::Kind::all : Tree::Kind::any;
    const std::uint32_t children = choice == 1 ? 1 : 2 + below(3);
    for (std::uint32_t i = 0; i < children; ++i) tree.children.push_back(draw(depth - 1));
    return tree;
  }

 private:
  std::uint32_t below(std::size_t bound) { return static_cast<std::uint32_t>(random_() % bound); }

  Tree leaf() {
    Tree tree;
    tree.kind = Tree::Kind::atom;
    if (below(2) == 0) {
      tree.atom.of = below(plant_.units.size());
      tree.atom.kind = below(3) == 0 ? Atom::Kind::moving : Atom::Kind::settled;
      if (tree.atom.kind == Atom::Kind::settled) {
        tree.atom.state = static_cast<std::uint8_t>(below(plant_.units[tree.atom.of].states.size()));
      }
      return tree;
    }
    tree.atom.of = below(plant_.symbols.size());
    const tables::DataType type = plant_.symbols[tree.atom.of].type;
    tree.atom.kind = type == tables::DataType::boolean ? Atom::Kind::bit : Atom::Kind::number;
    if (tree.atom.kind == Atom::Kind::bit) return tree;
    tree.atom.comparison = static_cast<tables::Comparison>(below(5));
    if (type == tables::DataType::real) {
      tree.atom.number = tables::NumberKind::real;
      tree.atom.operand = std::bit_cast<std::uint64_t>(1.0 / (1.0 + below(1000)) * (below(2) == 0 ? 1e30 : -1e-30));
    } else if (type == tables::DataType::int_) {
      tree.atom.operand = static_cast<std::uint64_t>(std::int64_t{below(60'000)} - 30'000);
    } else if (type == tables::DataType::lint) {
      tree.atom.operand = random_() | 1;  // neither end of the range
    } else {
      tree.atom.number = tables::NumberKind::unsigned_integer;
      tree.atom.operand = 1 + random_() / 2;  // neither end of the range
    }
    return tree;
  }

  const model::PlantModel& plant_;
  std::mt19937_64 random_{1};
};

TEST_CASE("2,000 random trees, written and read back, are the same") {
  const Analysed analysed = hostile();
  const Reader reader{analysed.model()};
  RandomTree random(analysed.model());
  for (int i = 0; i < 2'000; ++i) {
    const Tree tree = random.draw(1 + i % 5);
    const std::string text = model::condition_text(tree, analysed.model());
    INFO(text);
    REQUIRE(same(tree, reader.read(text)));
  }
}

}  // namespace
}  // namespace symplant::test
