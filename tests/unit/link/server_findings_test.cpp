// What a server link finds in the requests of its clients, over sockets.
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "symplant/tables/missed_pulse.hpp"
#include "symplant/tables/refusal.hpp"
#include "unit/link/loss_bench.hpp"

namespace symplant::test {
namespace {

using tables::FindingKind;
using tables::MissedPulse;
using tables::Refusal;
using Found = std::vector<link::LinkFinding>;

constexpr std::uint32_t kA = 0;  ///< of LossBench: coil 0, coil 1, holding register 2, discrete input 0
constexpr std::uint32_t kB = 1;
constexpr std::uint32_t kN = 2;
constexpr std::uint32_t kE = 3;
constexpr std::uint32_t kLocal = 0x7F00'0001;
const Bytes kReadE = {2, 0, 0, 0, 1};

/// Takes findings as the cycle does: after the link has read the operations.
struct FindingBench : LossBench {
  FindingBench() {
    plant->reset(0, 10 * kMillisecond);
    plant->advance_to(0);
    cycle();
  }
  void cycle() {
    now += 10 * kMillisecond;
    link->read_operations(*plant, now);
    while (const auto one = link->take_finding()) found.push_back(*one);
    plant->advance_to(plant->now() + 10 * kMillisecond);
    link->write_events(*plant, {});
    plant->forget_changed_events();
  }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) cycle();
  }
  void set_event(bool on) { plant->set_input(kE, on ? 1 : 0); }
  /// A PLC that reads E every 200 ms, and has read it now.
  void read_every_200_ms() {
    for (int i = 0; i < 3; ++i) {
      cycles(i == 0 ? 0 : 20);
      REQUIRE(client->ask(kReadE).size() == 3);
    }
    cycle();
  }
  /// E gets another value for this many cycles.
  void pulse(bool on, int length) {
    set_event(on);
    cycles(length);
    set_event(!on);
    cycles(2);
  }

  Found found;
};

MissedPulse pulse_of(const link::LinkFinding& finding) { return tables::unpack_missed_pulse(finding.value); }

TEST_CASE("An event that is on only between two reads is not read") {
  FindingBench bench;
  bench.read_every_200_ms();
  bench.pulse(true, 5);
  REQUIRE(bench.found.size() == 1);
  CHECK(bench.found[0].kind == FindingKind::not_read);
  CHECK(bench.found[0].symbol == kE);
  CHECK(pulse_of(bench.found[0]) == MissedPulse{true, 50 * kMillisecond, 200 * kMillisecond});
  bench.pulse(true, 5);
  CHECK(bench.found.size() == 2);
}

TEST_CASE("An event that is off only between two reads is not read") {
  FindingBench bench;
  bench.set_event(true);
  bench.cycle();
  bench.read_every_200_ms();
  bench.pulse(false, 3);
  REQUIRE(bench.found.size() == 1);
  CHECK(pulse_of(bench.found[0]) == MissedPulse{false, 30 * kMillisecond, 200 * kMillisecond});
}

TEST_CASE("Of two pulses between two reads each is missed, but not the pause between them") {
  FindingBench bench;
  bench.read_every_200_ms();
  bench.pulse(true, 1);
  bench.pulse(true, 1);
  REQUIRE(bench.client->ask(kReadE).size() == 3);
  bench.cycles(2);
  REQUIRE(bench.found.size() == 2);
  CHECK(pulse_of(bench.found[0]).on);
  CHECK(pulse_of(bench.found[1]).on);
}

TEST_CASE("An event that any client reads while it is on is read") {
  FindingBench bench;
  bench.read_every_200_ms();
  RawClient other(port_of(*bench.link));
  bench.set_event(true);
  bench.cycles(2);
  REQUIRE(other.ask({2, 0, 0, 0, 8}).size() == 3);
  bench.cycles(2);
  bench.set_event(false);
  bench.cycles(2);
  CHECK(bench.found.empty());
}

TEST_CASE("A read of other inputs, and one that is refused, read nothing of an event") {
  FindingBench bench;
  bench.read_every_200_ms();
  bench.set_event(true);
  bench.cycle();
  bench.client->ask({2, 0, 1, 0, 8});
  bench.client->ask({2, 0, 0, 0xFF, 0xFF});
  bench.client->ask({1, 0, 0, 0, 1});
  bench.cycle();
  bench.set_event(false);
  bench.cycles(2);
  REQUIRE(!bench.found.empty());
  CHECK(bench.found.back().kind == FindingKind::not_read);
}

TEST_CASE("An event that no client reads again and again is not missed") {
  FindingBench bench;
  bench.write_coil(0, false);
  bench.pulse(true, 2);
  REQUIRE(bench.client->ask(kReadE).size() == 3);
  bench.pulse(true, 2);
  CHECK(bench.link->state() == LinkState::live);
  CHECK(bench.found.empty());
}

TEST_CASE("An event that comes and goes within a cycle is not read") {
  FindingBench bench;
  bench.read_every_200_ms();
  bench.set_event(true);
  bench.plant->advance_to(bench.plant->now() + kMillisecond);
  bench.set_event(false);
  bench.cycles(2);
  REQUIRE(bench.found.size() == 1);
  CHECK(bench.found[0].kind == FindingKind::not_read);
  CHECK(pulse_of(bench.found[0]) == MissedPulse{true, 0, 200 * kMillisecond});
}

TEST_CASE("Without a live PLC no event is missed") {
  FindingBench bench;
  bench.read_every_200_ms();
  bench.cycles(120);
  REQUIRE(bench.link->state() == LinkState::lost);
  bench.pulse(true, 2);
  CHECK(bench.found.empty());
}

TEST_CASE("An operation that is on only between two cycles is not sampled") {
  FindingBench bench;
  bench.write_coil(1, true);
  bench.cycle();
  for (int pulse = 0; pulse < 20; ++pulse) {
    bench.write_coil(0, true);
    bench.write_coil(0, false);
    bench.cycle();
  }
  REQUIRE(bench.found.size() == 20);
  CHECK(bench.found[0].kind == FindingKind::not_sampled);
  CHECK(bench.found[0].symbol == kA);
  CHECK(pulse_of(bench.found[0]).on);
}

TEST_CASE("Of two pulses within a cycle each is missed, but not the pause between them") {
  FindingBench bench;
  bench.write_coil(1, true);
  bench.cycle();
  for (int i = 0; i < 4; ++i) bench.write_coil(0, i % 2 == 0);
  bench.cycle();
  REQUIRE(bench.found.size() == 2);
  CHECK(pulse_of(bench.found[0]).on);
  CHECK(pulse_of(bench.found[1]).on);
}

TEST_CASE("Each value of an operation that no cycle samples is found, also one that is off") {
  FindingBench bench;
  bench.write_coil(1, true);
  bench.cycle();
  REQUIRE(bench.client->ask({15, 0, 0, 0, 2, 1, 0}).size() == 5);
  REQUIRE(bench.client->ask({15, 0, 0, 0, 2, 1, 2}).size() == 5);
  bench.cycle();
  REQUIRE(bench.found.size() == 1);
  CHECK(bench.found[0].symbol == kB);
  CHECK_FALSE(pulse_of(bench.found[0]).on);
}

TEST_CASE("An operation that a cycle has seen on and off is sampled, and a number may change twice in a cycle") {
  FindingBench bench;
  for (int i = 0; i < 6; ++i) {
    bench.write_coil(0, i % 2 == 0);
    bench.cycle();
  }
  bench.write_register(2, 7);
  bench.write_register(2, 8);
  bench.write_register(2, 7);
  bench.cycle();
  CHECK(bench.found.empty());
}

TEST_CASE("Two clients that write different values within a cycle are found, once for each symbol") {
  FindingBench bench;
  RawClient other(port_of(*bench.link));
  for (int i = 0; i < 3; ++i) {
    bench.write_coil(0, false);
    REQUIRE(other.ask({15, 0, 0, 0, 2, 1, 1}).size() == 5);
    bench.write_register(2, 1);
    REQUIRE(other.ask({6, 0, 2, 0, 2}).size() == 5);
    bench.cycle();
  }
  Found several;
  for (const auto& one : bench.found) {
    if (one.kind == FindingKind::several_writers) several.push_back(one);
  }
  REQUIRE(several.size() == 2);
  CHECK(several[0].symbol == kA);
  CHECK(several[0].value == (std::uint64_t{kLocal} << 32 | kLocal));
  CHECK(several[1].symbol == kN);
}

TEST_CASE("Clients that write the same value, other numbers, or in other cycles are no several writers") {
  FindingBench bench;
  RawClient other(port_of(*bench.link));
  bench.write_coil(0, true);
  REQUIRE(other.ask({5, 0, 0, 0xFF, 0}).size() == 5);
  REQUIRE(other.ask({5, 0, 1, 0xFF, 0}).size() == 5);
  bench.cycle();
  REQUIRE(other.ask({5, 0, 0, 0, 0}).size() == 5);
  bench.cycle();
  CHECK(bench.found.empty());
}

TEST_CASE("A client that connects again for each request is one writer") {
  FindingBench bench;
  bench.write_coil(0, true);
  bench.client = nullptr;
  while (bench.link->status().connections != 0) std::this_thread::yield();
  bench.client = std::make_unique<RawClient>(port_of(*bench.link));
  bench.write_coil(0, false);
  bench.cycle();
  for (const auto& one : bench.found) CHECK(one.kind != FindingKind::several_writers);
}

TEST_CASE("A request that is answered with an exception is found, once for each function, exception and address") {
  FindingBench bench;
  for (int i = 0; i < 3; ++i) {
    bench.client->ask({0x63});
    bench.client->ask({15, 0x0B, 0xB8, 0, 1, 1, 1});
    bench.client->ask({3, 0, 2, 0, 0});
  }
  bench.client->ask({43, 14, 1, 0});
  bench.cycle();
  std::vector<Refusal> refused;
  for (const auto& one : bench.found) {
    CHECK(one.kind == FindingKind::request_refused);
    CHECK(one.symbol == tables::kNone);
    refused.push_back(tables::unpack_refusal(one.value));
  }
  const auto server = Refusal::Side::modbus_server;
  CHECK(refused == std::vector<Refusal>{{server, 0x63, 1, 0}, {server, 15, 2, 3000}, {server, 3, 3, 2}});
  CHECK(bench.link->status().exceptions == 9);
}

TEST_CASE("At most 16 kinds of refused requests are found") {
  FindingBench bench;
  for (std::uint8_t function = 100; function < 127; ++function) bench.client->ask({function});
  bench.cycle();
  CHECK(bench.found.size() == 16);
}

}  // namespace
}  // namespace symplant::test
