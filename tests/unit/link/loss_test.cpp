// A server link whose PLC stops sending and returns: over a socket, with cycles run by the test.
#include "unit/link/loss_bench.hpp"

using namespace symplant;
using exec::LinkState;
using link::LinkSettings;
using link::MapRow;
using link::OnLoss;
using tables::kMillisecond;
using tables::kSecond;
using test::Bytes;
using test::LossBench;

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
