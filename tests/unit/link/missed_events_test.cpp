// Reads that are in progress while an image is published, and how often ranges are read.
#include "symplant/link/image/missed_events.hpp"

#include <vector>

#include "support/catch.hpp"
#include "unit/link/symbol_list.hpp"

namespace symplant::test {
namespace {

using link::image::EventReads;
using link::image::MissedEvents;
using link::image::ReadRanges;
using tables::kMillisecond;
using tables::kSecond;

struct ReadBench {
  static SymbolList made() {
    SymbolList list;
    list.add("E", SymbolList::kIn, 70);
    return list;
  }

  /// The image in which the event has this value.
  void image(bool on) {
    now += 10 * kMillisecond;
    missed.begin_image(now);
    if (on != value) missed.changed(70, on);
    value = on;
    words[1] = on ? std::uint64_t{1} << 6 : 0;
  }
  void publish() { missed.end_image(); }
  void read(const std::vector<std::uint64_t>& from) { reads.read(from, 0, 80); }

  SymbolList list = made();
  tables::PlantTables tables = list.tables();
  link::image::Map map = image_of(tables, link::modbus::make_io_map(tables, 0, {}));
  EventReads reads{map.size(link::Plane::event_bits)};
  MissedEvents missed{map, reads};
  std::vector<std::uint64_t> words = {0, 0};
  bool value = false;
  tables::Time now = 0;
};

TEST_CASE("A read that is still in progress when its image has ended may have read every value") {
  ReadBench bench;
  bench.image(false);
  bench.publish();
  for (int i = 0; i < 2; ++i) {
    bench.reads.begin();
    bench.read(bench.words);
    bench.reads.end();
  }
  bench.image(true);
  bench.publish();
  const auto shown = bench.words;
  bench.reads.begin();  // takes the image in which the event is on
  bench.image(false);
  bench.publish();
  SECTION("and notes it later") {
    CHECK_FALSE(bench.missed.take());
    bench.read(shown);
    bench.reads.end();
  }
  SECTION("and notes it before the next image") {
    bench.read(shown);
    bench.reads.end();
    CHECK_FALSE(bench.missed.take());
  }
  SECTION("but not if it ends without a read") {
    bench.reads.end();
    CHECK(bench.missed.take());
    CHECK_FALSE(bench.missed.take());
  }
}

TEST_CASE("A range is read again and again from its second read on, and forgotten after a minute") {
  ReadRanges ranges;
  ranges.read(10, 5, 0);
  CHECK(ranges.every(10, 0) == -1);
  ranges.read(10, 5, kSecond);
  CHECK(ranges.every(10, kSecond) == kSecond);
  CHECK(ranges.every(14, kSecond) == kSecond);
  CHECK(ranges.every(9, kSecond) == -1);
  CHECK(ranges.every(15, kSecond) == -1);
  CHECK(ranges.every(10, 62 * kSecond) == -1);
  ranges.read(10, 5, 62 * kSecond);
  CHECK(ranges.every(10, 62 * kSecond) == -1);
}

TEST_CASE("Of several ranges with an address the one that is read most often counts") {
  ReadRanges ranges;
  for (tables::Time time = 0; time <= kSecond; time += 100 * kMillisecond) {
    ranges.read(0, 100, time);
    if (time % (500 * kMillisecond) == 0) ranges.read(50, 1, time);
  }
  CHECK(ranges.every(50, kSecond) == 100 * kMillisecond);
}

TEST_CASE("Reads of many other ranges replace those that were read the longest time ago") {
  ReadRanges ranges;
  ranges.read(0, 1, 0);
  ranges.read(0, 1, kMillisecond);
  for (std::uint32_t i = 1; i <= 40; ++i) {
    ranges.read(i, 1, i * kSecond);
    ranges.read(i, 1, i * kSecond);
  }
  CHECK(ranges.every(0, 40 * kSecond) == -1);
  CHECK(ranges.every(40, 40 * kSecond) == 0);
}

}  // namespace
}  // namespace symplant::test
