// Truth tables give the same result as a walk of the tree.
#include "symplant/condition/truth_table.hpp"

#include <algorithm>
#include <random>

#include "condition_support.hpp"

namespace symplant::test {
namespace {

using condition::Atom;
using condition::Tree;
using condition::TruthTable;

Tree atom(std::uint32_t of) {
  Tree tree;
  tree.kind = Tree::Kind::atom;
  tree.atom.kind = Atom::Kind::bit;
  tree.atom.of = of;
  return tree;
}

Tree constant(bool value) {
  Tree tree;
  tree.value = value;
  return tree;
}

Tree node(Tree::Kind kind, std::vector<Tree> children) {
  Tree tree;
  tree.kind = kind;
  tree.children = std::move(children);
  return tree;
}

/// The truth of a tree in which atom i is bit i of `bits`.
bool walked(const Tree& tree, std::uint64_t bits) {
  const auto child = [&](const Tree& t) { return walked(t, bits); };
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value;
    case Tree::Kind::atom:
      return (bits >> tree.atom.of & 1) != 0;
    case Tree::Kind::negation:
      return !child(tree.children.front());
    case Tree::Kind::all:
      return std::all_of(tree.children.begin(), tree.children.end(), child);
    case Tree::Kind::any:
      return std::any_of(tree.children.begin(), tree.children.end(), child);
  }
  return false;
}

bool looked_up(const std::vector<TruthTable>& tables, std::uint64_t bits) {
  std::vector<bool> truth;
  for (const TruthTable& table : tables) {
    std::uint64_t row = 0;
    for (std::size_t k = 0; k < table.inputs.size(); ++k) {
      const condition::Input& input = table.inputs[k];
      const bool on = input.is_table ? truth.at(input.table) : (bits >> input.atom.of & 1) != 0;
      row |= std::uint64_t{on ? 1U : 0U} << k;
    }
    truth.push_back((table.truth >> row & 1) != 0);
  }
  return truth.back();
}

/// No table has more than six inputs or the same input twice, inner ones precede their one reader, unused bits are 0.
void check_shape(const std::vector<TruthTable>& tables) {
  std::vector<int> readers(tables.size());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const auto& inputs = tables[t].inputs;
    REQUIRE(inputs.size() <= condition::kMostInputs);
    for (std::size_t a = 0; a < inputs.size(); ++a) {
      if (inputs[a].is_table) {
        REQUIRE(inputs[a].table < t);
        ++readers[inputs[a].table];
        continue;
      }
      for (std::size_t b = 0; b < a; ++b) REQUIRE((inputs[b].is_table || !(inputs[a].atom == inputs[b].atom)));
    }
    if (inputs.size() < condition::kMostInputs) REQUIRE(tables[t].truth >> (std::size_t{1} << inputs.size()) == 0);
    if (t + 1 < tables.size()) REQUIRE_FALSE(inputs.empty());
  }
  for (std::size_t t = 0; t + 1 < tables.size(); ++t) REQUIRE(readers[t] == 1);
}

class RandomTree {
 public:
  explicit RandomTree(unsigned seed, std::uint32_t atoms) : random_(seed), atoms_(atoms) {}

  Tree make(int depth) {
    const auto choice = random_() % 10;
    if (depth == 0 || choice < 2) return choice == 0 && random_() % 4 == 0 ? constant(random_() % 2 == 0) : leaf();
    if (choice < 4) return node(Tree::Kind::negation, {make(depth - 1)});
    std::vector<Tree> children;
    const auto count = 2 + random_() % 5;
    for (std::uint_fast32_t i = 0; i < count; ++i) children.push_back(make(depth - 1));
    return node(choice < 7 ? Tree::Kind::all : Tree::Kind::any, std::move(children));
  }

 private:
  Tree leaf() { return atom(static_cast<std::uint32_t>(random_()) % atoms_); }

  std::mt19937 random_;
  std::uint32_t atoms_;
};

TEST_CASE("Truth tables of random trees up to 12 atoms evaluate like a walk of the tree") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const std::uint32_t atoms = 1 + seed % 12;
    const Tree tree = RandomTree(seed, atoms).make(static_cast<int>(seed % 4));
    const auto tables = condition::truth_tables(tree);
    check_shape(tables);
    if (atoms <= condition::kMostInputs) REQUIRE(tables.size() == 1);
    for (std::uint64_t bits = 0; bits < std::uint64_t{1} << atoms; ++bits) {
      if (walked(tree, bits) != looked_up(tables, bits)) FAIL("seed " << seed << ", bits " << bits);
    }
  }
}

TEST_CASE("A condition of one atom is a table of one input") {
  const auto tables = condition::truth_tables(atom(3));
  REQUIRE(tables.size() == 1);
  CHECK(tables[0].truth == 0b10);
  CHECK(tables[0].inputs.size() == 1);
  CHECK(tables[0].inputs[0].atom.of == 3);
  CHECK(condition::truth_tables(node(Tree::Kind::negation, {atom(3)}))[0].truth == 0b01);
}

TEST_CASE("A constant is a table without inputs") {
  CHECK(condition::truth_tables(constant(true))[0].truth == 1);
  CHECK(condition::truth_tables(constant(false))[0].truth == 0);
  CHECK(condition::truth_tables(constant(true))[0].inputs.empty());
}

TEST_CASE("An atom without influence on the truth is not watched") {
  const Tree tree = node(Tree::Kind::any, {atom(1), node(Tree::Kind::negation, {atom(1)}), atom(2)});
  const auto tables = condition::truth_tables(tree);
  CHECK(tables.size() == 1);
  CHECK(tables[0].inputs.empty());
  CHECK(tables[0].truth == 1);
  const Tree with_constant = node(Tree::Kind::all, {atom(1), constant(true), atom(2)});
  CHECK(condition::truth_tables(with_constant)[0].inputs.size() == 2);
}

TEST_CASE("Seven atoms are a network of two tables") {
  std::vector<Tree> atoms;
  for (std::uint32_t i = 0; i < 7; ++i) atoms.push_back(atom(i));
  const auto tables = condition::truth_tables(node(Tree::Kind::all, std::move(atoms)));
  REQUIRE(tables.size() == 2);
  CHECK(tables[0].truth == std::uint64_t{1} << 63);
  CHECK(tables[1].truth == 0b1000);
}

TEST_CASE("A wide condition is a flat network") {
  std::vector<Tree> atoms;
  for (std::uint32_t i = 0; i < 1000; ++i) atoms.push_back(atom(i));
  const auto tables = condition::truth_tables(node(Tree::Kind::any, std::move(atoms)));
  std::vector<int> depth;
  for (const TruthTable& table : tables) {
    int deepest = 0;
    for (const condition::Input& input : table.inputs) {
      if (input.is_table) deepest = std::max(deepest, depth[input.table]);
    }
    depth.push_back(deepest + 1);
  }
  CHECK(depth.back() == 4);
  CHECK(tables.size() < 210);
}

}  // namespace
}  // namespace symplant::test
