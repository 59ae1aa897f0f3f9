// A server link whose PLC stops sending and returns: over a socket, with cycles run by the test.
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

/// Two coils, a holding register and a discrete input; the test runs each cycle of 10 ms.
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

  void write_coil(std::uint8_t address, bool on) {
    REQUIRE(client->ask({5, 0, address, static_cast<std::uint8_t>(on ? 0xFF : 0), 0}).size() == 5);
  }
  void write_register(std::uint8_t address, std::uint8_t value) {
    REQUIRE(client->ask({6, 0, address, 0, value}).size() == 5);
  }
  /// A register of the status block, which starts at 100.
  int status(std::uint8_t address) {
    const Bytes answer = client->ask({4, 0, static_cast<std::uint8_t>(100 + address), 0, 1});
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

TEST_CASE("Before the first request to the map the link waits, and other requests do not count") {
  LossBench bench;
  bench.silence(5 * kSecond);
  CHECK(bench.link->state() == LinkState::waiting);
  CHECK(bench.status(2) == 0);                            // the status block is not part of the map
  CHECK(bench.client->ask({1, 0, 2, 0, 5}).size() == 3);  // coils 2 to 6: gaps
  CHECK(bench.client->ask({1, 0, 0, 0, 0}).size() == 2);  // an exception
  bench.cycle();
  CHECK(bench.link->state() == LinkState::waiting);
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.status(2) == 1);
}

TEST_CASE("A write counts from the first, and acts in the next cycle") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.a());
}

TEST_CASE("The values of a silent PLC are held, and the link is lost after its time") {
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

TEST_CASE("Operations with policy zero go to zero when the link is lost, others hold") {
  const std::array<MapRow, 1> rows = {MapRow{.symbol = 1, .on_loss = OnLoss::hold}};
  LinkSettings settings;
  settings.rows = rows;
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
  // The PLC reads the same values on its next request.
  CHECK(bench.client->ask({1, 0, 0, 0, 2}) == Bytes{1, 1, 2});
}

TEST_CASE("On return writes are collected, and act together when all earlier addresses are written again") {
  LinkSettings settings;
  settings.on_loss = OnLoss::zero;
  LossBench bench(settings);
  bench.write_coil(0, true);
  bench.write_register(2, 7);
  bench.cycle();
  bench.silence(2 * kSecond);
  REQUIRE(bench.link->state() == LinkState::lost);
  bench.write_register(2, 9);
  bench.write_coil(1, true);  // was never written before
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

TEST_CASE("A PLC that returns and only reads, though it wrote before, is live after the resync time") {
  const std::array<MapRow, 1> rows = {MapRow{.symbol = 1, .on_loss = OnLoss::zero}};
  LinkSettings settings;
  settings.rows = rows;
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
  CHECK_FALSE(bench.b());  // went to zero, and was not written again
}

TEST_CASE("A PLC that never wrote is back with its first read") {
  LossBench bench;
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  bench.silence(kSecond);
  REQUIRE(bench.link->state() == LinkState::lost);
  bench.client->ask({2, 0, 0, 0, 1});
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
}

TEST_CASE("A plant freezes while its link is lost or waits if so set") {
  LinkSettings settings;
  settings.plant_on_loss = link::PlantOnLoss::freeze;
  LossBench bench(settings);
  bench.silence(2 * kSecond);
  CHECK(bench.link->freezes_plant());
  bench.write_coil(0, true);
  bench.cycle();
  CHECK_FALSE(bench.link->freezes_plant());
  bench.silence(kSecond);
  CHECK(bench.link->freezes_plant());
}

TEST_CASE("The watchdog register keeps the link alive, other requests do not") {
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

TEST_CASE("A watchdog that is changed and changed back within a cycle counts as changed") {
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

TEST_CASE("The status block counts cycles, shows the state and losses, and the end of the run") {
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
  CHECK(bench.status(5) == 4);  // cycles since then: the one of the loss, and three more
  bench.cycle(true);
  CHECK(bench.status(2) == 3);
  const Bytes hash = bench.client->ask({4, 0, 108, 0, 4});
  CHECK(hash.size() == 10);
  CHECK(Bytes(hash.begin() + 2, hash.end()) != Bytes(8, 0));
  CHECK_FALSE(bench.link->status().end_unread);
  bench.link->leave();
  CHECK(bench.link->status().end_unread);
  CHECK(bench.client->ask({4, 0, 100, 0, 2}).size() == 6);  // without that register
  CHECK(bench.link->status().end_unread);
  CHECK(bench.status(2) == 4);
  CHECK_FALSE(bench.link->status().end_unread);
  // Leaving writes no other register.
  CHECK(bench.client->ask({1, 0, 0, 0, 1}) == Bytes{1, 1, 1});
}

TEST_CASE("A PLC that never reads the plant's state is not expected to read its end") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  CHECK(bench.status(1) == 1);  // the heartbeat alone
  bench.link->leave();
  CHECK_FALSE(bench.link->status().end_unread);
}

TEST_CASE("A link without a status block has no status registers") {
  LinkSettings settings;
  settings.status_block = link::kNowhere;
  LossBench bench(settings);
  bench.link->leave();
  CHECK_FALSE(bench.link->status().end_unread);
  CHECK(bench.client->ask({4, 0, 100, 0, 1}) == Bytes{0x84, 2});
}

TEST_CASE("A cut link closes its connections and answers nothing; afterwards it works again") {
  LossBench bench;
  bench.write_coil(0, true);
  bench.cycle();
  REQUIRE(bench.link->state() == LinkState::live);
  bench.link->cut(true);
  CHECK(bench.client->is_closed());
  test::RawClient other(test::port_of(*bench.link));
  CHECK(other.ask({1, 0, 0, 0, 1}).empty());
  bench.silence(2 * kSecond);
  CHECK(bench.link->state() == LinkState::lost);
  CHECK(bench.link->status().connections == 0);
  CHECK(bench.a());
  bench.link->cut(false);
  bench.client = std::make_unique<test::RawClient>(test::port_of(*bench.link));
  bench.write_coil(0, false);
  bench.cycle();
  CHECK(bench.link->state() == LinkState::live);
  CHECK_FALSE(bench.a());
}
