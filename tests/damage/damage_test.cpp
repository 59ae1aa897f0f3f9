// Whatever a careless hand does to a list is found at its row, and little else is told.
#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <string>

#include "check/catalogue.hpp"
#include "damage/measure.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"

namespace symplant::damage {
namespace {

constexpr std::size_t kCopies = 8;
constexpr std::uint64_t kSeed = 20'261;

/// Kinds whose rules are still to be written, or to be made better. A kind leaves this list as soon as it is found.
const std::set<std::string_view> kStillToCome{"line-misspelt",  "process-misspelt", "device-misspelt", "task-misspelt",
                                              "columns-number", "columns-radix",    "columns-side",    "operation-lost",
                                              "event-lost",     "memory-address",   "task-lost",       "number-skipped",
                                              "step-lost",      "number-repeated",  "word-bent"};

bool is_to_come(const Kind& kind) { return kStillToCome.count(kind.name) != 0; }

const Shop& shop() {
  static const Shop shop(read_list(test::read_bytes(SYMPLANT_SOURCE_DIR "/examples/body-shop/body-shop.csv")));
  return shop;
}

const std::vector<Figures>& figures() {
  static const std::vector<Figures> all = measure(shop(), kCopies, kSeed);
  return all;
}

TEST_CASE("The line that is damaged is a large one") { CHECK(shop().list.rows.size() >= 3'000); }

TEST_CASE("There are more than 30 kinds of damage, each of its own name") {
  std::set<std::string_view> names;
  for (const Kind& kind : kinds()) names.insert(kind.name);
  CHECK(names.size() == kinds().size());
  CHECK(names.size() >= 30);
}

TEST_CASE("Every rule that damage must bring is in the catalogue, but those still to come") {
  for (const Kind& kind : kinds()) {
    INFO(kind.name);
    CHECK((is_to_come(kind) || check::find_rule(kind.rule) != nullptr));
  }
}

TEST_CASE("Damage of one kind and seed is always the same, of another seed another") {
  for (const Kind& kind : kinds()) {
    INFO(kind.name);
    Dice first(1);
    Dice again(1);
    const std::string text = kind.apply(shop(), first).list.text();
    CHECK(text == kind.apply(shop(), again).list.text());
    CHECK(text != shop().list.text());
    bool differs = false;
    for (std::uint64_t seed = 2; seed < 5; ++seed) {
      Dice other(seed);
      differs = differs || kind.apply(shop(), other).list.text() != text;
    }
    CHECK(differs);
  }
}

TEST_CASE("Every kind of damage is found at its row by its rule") {
  std::fputs(table(figures()).c_str(), stdout);
  for (const Figures& of : figures()) {
    INFO(of.kind->name << ": `damage_list LIST " << of.kind->name << " SEED` shows what was told");
    CHECK((of.found == of.copies) == !is_to_come(*of.kind));
  }
}

}  // namespace
}  // namespace symplant::damage
