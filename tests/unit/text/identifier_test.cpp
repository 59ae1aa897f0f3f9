// Turns names into identifiers.
#include "text/identifier.hpp"

#include <array>
#include <random>
#include <set>

#include "support/catch.hpp"

using namespace symplant::text;

namespace {

bool is_legal(const std::string& text) {
  if (text.empty() || text.find("__") != std::string::npos || text[0] == '_') return false;
  if (text[0] >= '0' && text[0] <= '9') return false;
  for (const char c : text) {
    const bool word = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
    if (!word) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("A plain name is unchanged after a prefix, and no other name is") {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string name;
    for (auto length = random() % 6; length > 0; --length) name += "aZ09__-\xC3\xA4."[random() % 10];
    if (random() % 50 == 0) name += std::string(99, 'x');
    CAPTURE(name);
    REQUIRE(symplant::text::is_plain_identifier(name) == (symplant::text::identifier(name, "k") == "k" + name));
  }
}

TEST_CASE("A name is an identifier if it is its own") {
  std::mt19937 random(2);
  const std::array<std::string, 8> words{"class", "EDOM", "I", "_MAX", "SIG", "x", "_", "9"};
  for (int i = 0; i < 20'000; ++i) {
    std::string name;
    for (auto count = random() % 4; count > 0; --count) name += words[random() % words.size()];
    CAPTURE(name);
    REQUIRE(symplant::text::is_identifier(name) == (identifier(name) == name));
  }
}

TEST_CASE("A plain name is its own identifier") {
  CHECK(identifier("EXLINE_MB_AGV_I_P1") == "EXLINE_MB_AGV_I_P1");
  CHECK(identifier("run2") == "run2");
}

TEST_CASE("Other characters are written as code points") {
  CHECK(identifier("Spare(5)") == "Spare_u0028_5_u0029");
  CHECK(identifier("\xEC\x9A\xB4\xEC\xA0\x84") == "uC6B4_uC804");
  CHECK(identifier("a\xF0\x9F\x98\x80"
                   "b") == "a_u1F600_b");
  CHECK(identifier("a-b") != identifier("a/b"));
  CHECK(identifier("a\xFF") == "a_uFFFD");
}

TEST_CASE("Underscores are single, and neither lead nor end") {
  CHECK(identifier("_A") == "u005F_A");
  CHECK(identifier("A__B") == "A_u005F_B");
  CHECK(identifier("A_") == "A_u005F");
  CHECK(identifier("__") == "u005F_u005F");
}

TEST_CASE("An identifier does not start with a digit and is not empty") {
  CHECK(identifier("21010") == "n21010");
  CHECK(identifier("") == "unnamed");
}

TEST_CASE("Keywords, alternative tokens and macros get an underscore") {
  for (const char* word : {"class", "xor_eq", "not", "co_await", "errno", "EOF", "NULL", "I", "linux", "unix"}) {
    CHECK(identifier(word) == std::string(word) + "_");
  }
  CHECK(identifier("CLASS") == "CLASS");
}

TEST_CASE("A prefix leaves nothing else to fix") {
  CHECK(enumerator("P1") == "kP1");
  CHECK(enumerator("RUN2") == "kRUN2");
  CHECK(enumerator("class") == "kclass");
  CHECK(enumerator("2A") == "k2A");
  CHECK(enumerator("_A") == "ku005F_A");
  CHECK(enumerator("") == "kunnamed");
}

TEST_CASE("A long name is cut, and its hash distinguishes it from others") {
  const std::string name(500, 'a');
  const std::string first = identifier(name + "x");
  CHECK(first.size() == 109);
  CHECK(first != identifier(name + "y"));
  CHECK(first.substr(0, 101) == std::string(100, 'a') + "_");
  CHECK(identifier(std::string(100, 'a')) == std::string(100, 'a'));
}

TEST_CASE("Any bytes give a legal identifier") {
  std::mt19937 random(1);
  const std::string alphabet = "_aA09 \t\n\\\"*/\xC3\x84\xEC\x9A\xB4\xFF\x80?";
  for (int i = 0; i < 20000; ++i) {
    std::string name;
    for (std::size_t n = random() % 12; n > 0; --n) name += alphabet[random() % alphabet.size()];
    INFO(name);
    REQUIRE(is_legal(identifier(name)));
    REQUIRE(is_legal(enumerator(name)));
    REQUIRE(identifier(name).back() != '_');
  }
}

TEST_CASE("Identifiers of a scope differ, ignoring case") {
  IdentifierScope scope;
  CHECK(scope.unique("RUN") == "RUN");
  CHECK(scope.unique("run") == "run_2");
  CHECK(scope.unique("Run") == "Run_3");
  CHECK(scope.unique("RUN_2") == "RUN_2_2");
  CHECK(scope.unique("class") == "class_");
  CHECK(scope.unique("class") == "class_2");
  CHECK(scope.unique("P1", "k") == "kP1");
  CHECK(scope.unique("p1", "k") == "kp1_2");
}

TEST_CASE("Reserved words are taken from the start") {
  constexpr std::array<std::string_view, 2> kReserved{"State", "plant"};
  IdentifierScope scope(kReserved);
  CHECK(scope.unique("STATE") == "STATE_2");
  CHECK(scope.unique("Plant") == "Plant_2");
}

TEST_CASE("A scope takes a hundred thousand equal names without time passing") {
  IdentifierScope scope;
  std::set<std::string> all;
  for (int i = 0; i < 100000; ++i) all.insert(scope.unique("SPARE"));
  CHECK(all.size() == 100000);
}
