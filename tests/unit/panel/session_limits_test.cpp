// What a session keeps in memory of its acts.
#include "support/plant_bench.hpp"
#include "support/strings.hpp"
#include "symplant/panel/operate/session.hpp"

namespace symplant::test {
namespace {

panel::Deed deed_of(std::size_t bytes, tables::Time time) {
  const std::string members = "\"set\":\"" + std::string(bytes, 'x') + "\"";
  return {time, static_cast<std::uint64_t>(time), false, "hand", "{" + members + "}", members};
}

TEST_CASE("The steps of a session are limited by their bytes, and one that is not complete says so") {
  const BenchTables tables({"AGV_I_P1", "AGV_O_P1"});
  const trace::PlantNames names(tables.rows);
  panel::Session session(names, 0);
  for (int i = 0; i < 100; ++i) session.add(deed_of(60'000, i));
  CHECK(session.is_complete());
  CHECK(session.scenario("", 100).size() > 6'000'000);
  for (int i = 100; i < 2000; ++i) session.add(deed_of(60'000, i));  // 240 MB
  CHECK_FALSE(session.is_complete());
  CHECK(session.scenario("", 2000).size() <= panel::Session::kMostStepBytes);
  session.add(deed_of(1, 2000));
  CHECK_FALSE(session.is_complete());
  CHECK(session.count() == 2001);
  std::string json;
  session.put(json, 0, panel::Role::trainer);
  CHECK(json.size() <= (std::size_t{16} << 20));
  CHECK(contains(json, "\"n\":2000,"));
  session.begin_again(nullptr);
  session.add(deed_of(60'000, 1));
  CHECK(session.is_complete());
}

}  // namespace
}  // namespace symplant::test
