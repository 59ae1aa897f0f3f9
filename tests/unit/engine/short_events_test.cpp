// The record of rises within a cycle.
#include "symplant/engine/short_events.hpp"

#include <vector>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

struct Record {
  explicit Record(std::size_t words) : memory(8192) {
    engine::Arena arena(reinterpret_cast<std::byte*>(memory.data()));
    events.take(arena, words);
    REQUIRE(arena.used() <= memory.size() * sizeof(std::max_align_t));
  }
  std::vector<std::max_align_t> memory;
  engine::ShortEvents events;
};

TEST_CASE("An event shorter than a cycle is short, one of a whole cycle is not") {
  Record record(2);
  record.events.rose(1, 0b11, 100);
  CHECK(record.events.fell(1, 0b01, 109, 10) == 0b01);
  CHECK(record.events.fell(1, 0b10, 110, 10) == 0);
}

TEST_CASE("A forgotten rise is not short, one after it is") {
  Record record(1);
  record.events.rose(0, 0b01, 100);
  record.events.forget();
  record.events.rose(0, 0b10, 101);
  CHECK(record.events.fell(0, 0b11, 102, 10) == 0b10);
}

TEST_CASE("Events of other words, and events that never rose, are not short") {
  Record record(2);
  record.events.rose(0, 0b11, 100);
  CHECK(record.events.fell(1, 0b11, 101, 10) == 0);
  CHECK(record.events.fell(0, 0b100, 101, 10) == 0);
}

TEST_CASE("Several rises of one word are all remembered, of one event the last counts") {
  Record record(1);
  record.events.rose(0, 0b001, 100);
  record.events.rose(0, 0b010, 105);
  record.events.rose(0, 0b100, 108);
  CHECK(record.events.fell(0, 0b111, 112, 10) == 0b110);
  record.events.rose(0, 0b001, 115);
  CHECK(record.events.fell(0, 0b001, 116, 10) == 0b001);
}

TEST_CASE("The oldest rises are forgotten if too many fall into one cycle") {
  Record record(2);
  record.events.rose(0, 1, 100);
  for (int i = 0; i < 63; ++i) record.events.rose(1, 1, 101);
  CHECK(record.events.fell(0, 1, 102, 10) == 1);
  record.events.rose(1, 1, 102);
  CHECK(record.events.fell(0, 1, 103, 10) == 0);
  CHECK(record.events.fell(1, 1, 103, 10) == 1);
}

TEST_CASE("A plant of more than 64 words has room for a rise in each") {
  Record record(100);
  for (std::uint32_t word = 0; word < 100; ++word) record.events.rose(word, 1, 100);
  for (std::uint32_t word = 0; word < 100; ++word) REQUIRE(record.events.fell(word, 1, 101, 10) == 1);
}

}  // namespace
}  // namespace symplant::test
