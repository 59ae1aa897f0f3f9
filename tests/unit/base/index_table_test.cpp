// Finds indexes by the hash of keys that are stored elsewhere.
#include "base/index_table.hpp"

#include <map>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "text/ascii.hpp"

using namespace symplant::base;
using namespace symplant::text;

TEST_CASE("An index table finds what a map finds, for any hashes") {
  std::mt19937 random(1);
  for (const std::uint64_t mask : {~std::uint64_t{0}, std::uint64_t{0xFF}, std::uint64_t{0}}) {
    std::vector<std::string> keys;
    std::map<std::string, std::uint32_t> indexes;
    IndexTable table;
    CHECK(table.find(1, [](std::uint32_t) { return true; }) == IndexTable::kNothing);
    for (int i = 0; i < 3000; ++i) {
      const std::string key = std::to_string(random() % 1000);
      const std::uint64_t hash = hash_ignoring_case(key) & mask;
      const auto is_at = [&](std::uint32_t index) { return keys[index] == key; };
      const auto known = indexes.find(key);
      REQUIRE(table.find(hash, is_at) == (known == indexes.end() ? IndexTable::kNothing : known->second));
      const auto next = static_cast<std::uint32_t>(keys.size());
      keys.push_back(key);
      REQUIRE(table.find_or_add(hash, next, is_at) == indexes.try_emplace(key, next).first->second);
      if (random() % 8 != 0) continue;
      indexes[key] = next;  // the key is there, too
      table.move(hash, next, is_at);
    }
    CHECK(table.size() == indexes.size());
  }
}

TEST_CASE("Texts that differ only in case have one hash") {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (auto length = random() % 30; length > 0; --length) text += "abcXYZ_09\xC3\xA4 "[random() % 12];
    CAPTURE(text);
    CHECK(hash_ignoring_case(text) == hash_ignoring_case(to_upper(text)));
    CHECK(hash_ignoring_case(text) != hash_ignoring_case(text + "A"));
  }
}
