// Aliases of Logix tags: chains, scopes, cycles, and what hostile lists cost.
#include "read/rockwell/aliases.hpp"
#include "support/catch.hpp"

using symplant::read::AliasResolver;
using Outcome = AliasResolver::Outcome;

namespace {

struct Fixture {
  std::deque<std::string> arena;
  AliasResolver aliases{arena};

  std::string of(std::string_view operand, std::string_view scope = {}) {
    return std::string(aliases.resolve(scope, operand).text);
  }
  Outcome outcome(std::string_view operand, std::string_view scope = {}) {
    return aliases.resolve(scope, operand).outcome;
  }
};

}  // namespace

TEST_CASE("An alias is resolved over other aliases to the tag of a module") {
  Fixture tags;
  tags.aliases.add("", "Box:I");
  tags.aliases.add("", "Box:3:I", "Box:I.Data[3]");
  tags.aliases.add("", "Part_Present", "BOX:3:i.7");
  tags.aliases.add("", "Part", "Part_Present");
  CHECK(tags.of("Part") == "Box:I.Data[3].7");
  CHECK(tags.outcome("part") == Outcome::tag);
  CHECK(tags.of("Box:3:I") == "Box:I.Data[3]");
  CHECK(tags.of("box:3:i.2") == "Box:I.Data[3].2");
  CHECK(tags.of("Box:I.Data[3].7") == "Box:I.Data[3].7");
}

TEST_CASE("An operand on a tag that no row declares is resolved as it is written") {
  Fixture tags;
  tags.aliases.add("", "Door_Open", "Local:4:I.Data.2");
  CHECK(tags.of("Door_Open") == "Local:4:I.Data.2");
  CHECK(tags.outcome("Door_Open") == Outcome::unknown_tag);
  CHECK(tags.of("Local:4:I.Data.9") == "Local:4:I.Data.9");
  CHECK(tags.outcome("") == Outcome::unknown_tag);
  CHECK(tags.outcome("[3].x") == Outcome::unknown_tag);
}

TEST_CASE("A tag of a program has priority over the controller's in that program only") {
  Fixture tags;
  tags.aliases.add("", "Step", "Local:1:O.Data.0");
  tags.aliases.add("Press", "Step");
  tags.aliases.add("Press", "Valve", "Step.4");
  tags.aliases.add("Wash", "Valve", "Step");
  CHECK(tags.of("Valve", "press") == "\\Press.Step.4");
  CHECK(tags.of("Valve", "Wash") == "Local:1:O.Data.0");
  CHECK(tags.of("Step", "Wash") == "Local:1:O.Data.0");
  CHECK(tags.outcome("Valve") == Outcome::unknown_tag);
}

TEST_CASE("The first of two tags of one name in one scope counts") {
  Fixture tags;
  CHECK(tags.aliases.add("", "A", "Local:1:I.Data.0"));
  CHECK_FALSE(tags.aliases.add("", "a", "Local:1:I.Data.1"));
  CHECK(tags.aliases.add("Press", "A", "Local:1:I.Data.2"));
  CHECK(tags.of("A") == "Local:1:I.Data.0");
}

TEST_CASE("An alias in a cycle, or leading to one, is returned as it is written") {
  Fixture tags;
  tags.aliases.add("", "Self", "Self.1");
  tags.aliases.add("", "A", "B");
  tags.aliases.add("", "B", "A.x");
  tags.aliases.add("", "To_It", "A");
  for (const std::string_view name : {"Self", "A", "B", "To_It", "To_It.3"}) {
    INFO(name);
    CHECK(tags.outcome(name) == Outcome::cycle);
    CHECK(tags.of(name) == name);
  }
}

TEST_CASE("A cycle of 100,000 aliases, and a chain of as many, take one step an alias") {
  constexpr int kAliases = 100'000;
  std::deque<std::string> names;
  for (int i = 0; i < kAliases; ++i) names.push_back("T" + std::to_string(i));
  Fixture cycle;
  Fixture chain;
  chain.aliases.add("", "End");
  for (std::size_t i = 0; i < kAliases; ++i) {
    cycle.aliases.add("", names[i], names[(i + 1) % kAliases]);
    chain.aliases.add("", names[i], i + 1 == kAliases ? std::string_view("End") : names[i + 1]);
  }
  for (const std::string& name : names) {
    REQUIRE(cycle.outcome(name) == Outcome::cycle);
    REQUIRE(chain.of(name) == "End");
  }
  CHECK(chain.arena.empty());
}

TEST_CASE("A chain whose operand grows with each alias ends at the longest operand") {
  std::deque<std::string> texts{"T0"};
  Fixture tags;
  tags.aliases.add("", texts.front());
  for (int i = 1; i < 100'000; ++i) {
    const std::string_view target = texts.emplace_back("T" + std::to_string(i - 1) + ".1");
    tags.aliases.add("", texts.emplace_back("T" + std::to_string(i)), target);
  }
  CHECK(tags.of("T3") == "T0.1.1.1");
  CHECK(tags.outcome("T126") == Outcome::tag);
  CHECK(tags.outcome("T127") == Outcome::too_long);
  CHECK(tags.outcome("T99999") == Outcome::too_long);
  CHECK(tags.arena.size() < 1000);
}
