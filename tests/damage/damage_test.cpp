// Damage to a list is reported at its row, with few other findings.
#include <cstdlib>
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

const Shop& shop() {
  static const Shop shop(read_list(test::read_bytes(SYMPLANT_SOURCE_DIR "/examples/body-shop/body-shop.csv")));
  return shop;
}

const std::vector<Figures>& figures() {
  static const std::vector<Figures> all = measure(shop(), kCopies, kSeed);
  return all;
}

TEST_CASE("The damaged line is a large one") { CHECK(shop().list.rows.size() >= 3'000); }

TEST_CASE("There are more than 30 kinds of damage, each with a unique name") {
  std::set<std::string_view> names;
  for (const Kind& kind : kinds()) names.insert(kind.name);
  CHECK(names.size() == kinds().size());
  CHECK(names.size() >= 30);
}

TEST_CASE("The catalogue has every rule that damage must trigger") {
  for (const Kind& kind : kinds()) {
    INFO(kind.name);
    CHECK(check::find_rule(kind.rule) != nullptr);
  }
}

TEST_CASE("The same kind and seed give the same damage, another seed gives other damage") {
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

/// The part of the manual between its markers.
struct Page {
  std::string before;
  std::string table;
  std::string after;
};

Page page_with_table(const std::string& text) {
  const std::string begin = "<!-- damage: written by test_damage -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find("<!-- end of damage -->");
  REQUIRE(from != text.npos);
  REQUIRE(to != text.npos);
  const std::size_t first = from + begin.size();
  return {text.substr(0, first), text.substr(first, to - first), text.substr(to)};
}

TEST_CASE("Each kind of damage is reported at its row by its rule with few other findings, as the manual states") {
  const std::string figures_now = table(figures());
  std::size_t findings = 0;
  std::size_t others = 0;
  for (const Figures& of : figures()) {
    INFO(of.kind->name << ": " << of.missed);
    CHECK(of.found == of.copies);
    findings += of.findings;
    others += of.others;
  }
  INFO(figures_now);
  CHECK(20 * others <= findings);
  const std::string path = SYMPLANT_SOURCE_DIR "/docs/checking.md";
  const Page page = page_with_table(test::read_bytes(path));
  if (std::getenv("SYMPLANT_UPDATE_GOLDENS") != nullptr) {
    test::check_golden(path, page.before + figures_now + page.after);
  } else {
    CHECK(page.table == figures_now);
  }
}

}  // namespace
}  // namespace symplant::damage
