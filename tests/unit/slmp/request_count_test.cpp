// How many requests an image takes: the counts in the table of docs/performance.md.
#include "support/catch.hpp"
#include "support/slmp_clients.hpp"

using namespace symplant::test;

namespace {

/// Requests of the link and of clients with one request for each run of devices and for each point.
struct Counts {
  std::size_t planned;
  std::size_t runs;
  std::size_t points;
};

Counts counts(const SlmpFamily& family, std::uint32_t points, Spread spread) {
  const BitMap map(points, spread);
  BitPlc plc(family);
  PlannedClient client(map, family, plc.plc().port());
  CHECK(client.exchange());
  CHECK(plc.plc().log().violations().empty());
  for (const std::uint32_t number : map.events) {
    if (!plc.plc().memory().bit("B", number)) FAIL("an event is not written");
  }
  return {plc.plc().log().count(), run_spans(map, family).requests(), point_spans(map).requests()};
}

}  // namespace

TEST_CASE("The numbers of requests are those of the documentation") {
  struct Row {
    std::uint32_t points;
    Spread spread;
    Counts counts;
  };
  for (const SlmpFamily& family : kSlmpFamilies) {
    const bool fx5 = family.name == "fx5";
    for (const Row& row : {Row{64, Spread::dense, {2, 2, 64}}, Row{64, Spread::scattered, {2, 63, 64}},
                           Row{1'000, Spread::dense, {2, 2, 1'000}}, Row{1'000, Spread::scattered, {5, 986, 1'000}},
                           Row{10'000, Spread::dense, {fx5 ? 3U : 2U, fx5 ? 4U : 2U, 10'000}},
                           Row{10'000, Spread::scattered, {30, 8'475, 10'000}}}) {
      CAPTURE(family.name, row.points, row.spread == Spread::dense);
      const Counts seen = counts(family, row.points, row.spread);
      CHECK(seen.planned == row.counts.planned);
      CHECK(seen.runs == row.counts.runs);
      CHECK(seen.points == row.counts.points);
    }
  }
}
