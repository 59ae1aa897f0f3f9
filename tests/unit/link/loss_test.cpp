// A server link whose PLC falls silent and comes back: over a socket, the cycles counted by hand.
#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using exec::LinkState;
using link::LinkSettings;
using link::MapRow;
using link::OnLoss;
using tables::kMillisecond;
using tables::kSecond;
using test::Bytes;

namespace {

/// Two coils, a holding register and a discrete input; a cycle of 10 ms is what a test makes it.
struct LossBench {
  explicit LossBench(const LinkSettings& settings = {}) : tables(made()), plant(tables) {
    auto opened = link::open_link({"modbus-tcp-server://127.0.0.1:0", 0, settings}, tables);
    REQUIRE(std::holds_alternative<std::unique_ptr<link::Link>>(opened));
    link = std::move(std::get<std::unique_ptr<link::Link>>(opened));
    plant->advance_to(0);
    link->write_events(*plant, {});
    client = std::make_unique<test::RawClient>(test::port_of(*link));
  }
  const tables::PlantTables& made() {
    list.add("A", test::SymbolList::kOut, 0);
    list.add("B", test::SymbolList::kOut, 1);
    list.add("N", test::SymbolList::kOut, 2, tables::DataType::int_);
    list.add("E", test::SymbolList::kIn, 0);
    owned = list.tables();
    return owned;
  }

  void cycle(bool frozen = false) {
    now += 10 * kMillisecond;
    link->read_operations(*plant, now);
    plant->advance_to(plant->now() + 10 * kMillisecond);
    link->write_events(*plant,
                       {.cycles = cycles++, .live = link->state() == LinkState::live ? 1U : 0U, .frozen = frozen});
    plant->forget_changed_events();
  }
  void silence(tables::Time time) {
    for (tables::Time t = 0; t < time; t += 10 * kMillisecond) cycle();
  }
  bool a() { return plant->operation(0); }
  bool b() { return plant->operation(1); }
  std::uint64_t n() { return plant->operation_value(0); }

  void write_coil(std::uint8_t place, bool on) {
    REQUIRE(client->ask({5, 0, place, static_cast<std::uint8_t>(on ? 0xFF : 0), 0}).size() == 5);
  }
  void write_register(std::uint8_t place, std::uint8_t value) {
    REQUIRE(client->ask({6, 0, place, 0, value}).size() == 5);
  }
  /// A register of the status block, which stands at 100.
  int status(std::uint8_t place) {
    const Bytes answer = client->ask({4, 0, static_cast<std::uint8_t>(100 + place), 0, 1});
    REQUIRE(answer.size() == 4);
    return answer[2] << 8 | answer[3];
  }

  test::SymbolList list;
  tables::PlantTables owned{};
  tables::PlantTables tables;
  test::OwnedPlant plant;
  std::unique_ptr<link::Link> link;
  std::unique_ptr<test::RawClient> client;
  tables::Time now = 77;
  std::uint64_t cycles = 0;
};

}  // namespace

TEST_CASE("before the first request that touches the map the link waits, and others do not count") {
  LossBench bench;
  bench.silence(5 * kSecond);
  CHECK(bench.link->state() == LinkState::waiting);
  CHECK(bench.status(2) == 0);                            // the status block is not the map
  CHECK(bench.client->ask({1, 0, 2, 0, 5}).size() == 3);  // coils 2 to 6: gaps
  CHECK(bench.client->ask({1, 0, 0, 0, 0}).size() == 2);  // an exception
  bench.cycle();
  CHECK(bench.link->state() == LinkState::waiting);
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.status(2) == 1);
}

TEST_CASE("a write counts from the first, and acts in the next cycle") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.a());
}

TEST_CASE("what a silent PLC wrote is held, and the link is lost after its time") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.write_register(2, 7);
  bench.cycle();
  bench.silence(kSecond - 10 * kMillisecond);
  CHECK(bench.link->state() == LinkState::live);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::lost);
  CHECK(bench.a());
  CHECK(bench.n() == 7);
  CHECK_FALSE(bench.link->freezes_plant());
  CHECK(bench.link->status().losses == 1);
}

TEST_CASE("operations whose policy is zero go to zero when the link is lost, others hold") {
  const std::array<MapRow, 1> places = {MapRow{.symbol = 1, .on_loss = OnLoss::hold}};
  LinkSettings settings;
  settings.rows = places;
  settings.on_loss = OnLoss::zero;
  LossBench bench(settings);
  bench.write_coil(0, true);
  bench.write_coil(1, true);
  bench.write_register(2, 7);
  bench.cycle();
  bench.silence(kSecond);
  REQUIRE(bench.link->state() == LinkState::lost);
  CHECK_FALSE(bench.a());
  CHECK(bench.b());
  CHECK(bench.n() == 0);
  // And so the PLC reads them when it asks again.
  CHECK(bench.client->ask({1, 0, 0, 0, 2}) == Bytes{1, 1, 2});
}

TEST_CASE("on return writes are collected, and act together when all that was written before is written again") {
  LinkSettings settings;
  settings.on_loss = OnLoss::zero;
  LossBench bench(settings);
  bench.write_coil(0, true);
  bench.write_register(2, 7);
  bench.cycle();
  bench.silence(2 * kSecond);
  REQUIRE(bench.link->state() == LinkState::lost);
  bench.write_register(2, 9);
  bench.write_coil(1, true);  // was not written before
  bench.cycle();
  CHECK(bench.link->state() == LinkState::lost);
  CHECK(bench.n() == 0);
  CHECK_FALSE(bench.b());
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.a());
  CHECK(bench.b());
  CHECK(bench.n() == 9);
}

TEST_CASE("a PLC that comes back and only reads, though it wrote before, is live after the resync time") {
  const std::array<MapRow, 1> places = {MapRow{.symbol = 1, .on_loss = OnLoss::zero}};
  LinkSettings settings;
  settings.rows = places;
  settings.resync = 500 * kMillisecond;
  LossBench bench(settings);
  bench.write_coil(0, true);
  bench.write_coil(1, true);
  bench.cycle();
  bench.silence(2 * kSecond);
  tables::Time waited = 0;
  while (bench.link->state() == LinkState::lost && waited < 5 * kSecond) {
    bench.client->ask({2, 0, 0, 0, 1});
    bench.cycle();
    waited += 10 * kMillisecond;
  }
  CHECK(bench.link->state() == LinkState::live);
  CHECK(waited == 510 * kMillisecond);  // counted from the cycle that heard it first
  CHECK(bench.a());
  CHECK_FALSE(bench.b());  // went to zero, and nobody wrote it again
}

TEST_CASE("a PLC that never wrote is back with its first read") {
  LossBench bench;
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  bench.silence(kSecond);
  REQUIRE(bench.link->state() == LinkState::lost);
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
}

TEST_CASE("a plant whose link says so stands still while the link is lost, not while it waits") {
  LinkSettings settings;
  settings.plant_on_loss = link::PlantOnLoss::freeze;
  LossBench bench(settings);
  bench.silence(2 * kSecond);
  CHECK_FALSE(bench.link->freezes_plant());
  bench.write_coil(0, true);
  bench.cycle();
  CHECK_FALSE(bench.link->freezes_plant());
  bench.silence(kSecond);
  CHECK(bench.link->freezes_plant());
}

TEST_CASE("the watchdog's register keeps the link alive, requests alone do not") {
  LinkSettings settings;
  settings.watchdog = 5;
  settings.watchdog_within = 200 * kMillisecond;
  LossBench bench(settings);
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::waiting);
  bench.write_register(5, 1);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.a());
  for (int i = 0; i < 19; ++i) {
    bench.write_register(5, 1);
    bench.cycle();
  }
  CHECK(bench.link->state() == LinkState::live);
  bench.write_register(5, 1);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::lost);
  CHECK(bench.link->status().writes_to_gaps == 0);
}

TEST_CASE("a watchdog that is changed and changed back within a cycle has changed") {
  LinkSettings settings;
  settings.watchdog = 5;
  LossBench bench(settings);
  for (int i = 0; i < 200; ++i) {
    bench.write_register(5, 1);
    bench.write_register(5, 0);
    bench.cycle();
  }
  CHECK(bench.link->state() == LinkState::live);
}

TEST_CASE("the status block counts cycles, tells the state and what was lost, and at the end that it is over") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.status(0) == 1);
  CHECK(bench.status(1) == 1);
  CHECK(bench.status(2) == 1);
  CHECK(bench.status(3) == 1);
  bench.cycle();
  CHECK(bench.status(1) == 2);
  bench.silence(kSecond + 20 * kMillisecond);
  CHECK(bench.status(2) == 2);
  CHECK(bench.status(3) == 0);
  CHECK(bench.status(4) == 0);  // high word first
  CHECK(bench.status(5) == 4);  // cycles since then: the one in which it was lost, and three more
  bench.cycle(true);
  CHECK(bench.status(2) == 3);
  const Bytes hash = bench.client->ask({4, 0, 108, 0, 4});
  CHECK(hash.size() == 10);
  CHECK(Bytes(hash.begin() + 2, hash.end()) != Bytes(8, 0));
  CHECK_FALSE(bench.link->status().end_unread);
  bench.link->leave();
  CHECK(bench.link->status().end_unread);
  CHECK(bench.client->ask({4, 0, 100, 0, 2}).size() == 6);  // not that register
  CHECK(bench.link->status().end_unread);
  CHECK(bench.status(2) == 4);
  CHECK_FALSE(bench.link->status().end_unread);
  // Leaving writes nothing else.
  CHECK(bench.client->ask({1, 0, 0, 0, 1}) == Bytes{1, 1, 1});
}

TEST_CASE("a PLC that never reads the plant's state is not expected to read its end") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.status(1) == 1);  // the heartbeat alone
  bench.link->leave();
  CHECK_FALSE(bench.link->status().end_unread);
}

TEST_CASE("a link without a status block has none") {
  LinkSettings settings;
  settings.status_block = link::kNowhere;
  LossBench bench(settings);
  bench.link->leave();
  CHECK_FALSE(bench.link->status().end_unread);
  CHECK(bench.client->ask({4, 0, 100, 0, 1}) == Bytes{0x84, 2});
}
