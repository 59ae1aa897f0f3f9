// Full-image exchanges with several Modbus TCP servers in one run: pairs per second, and the time of one pair.
//
// A pair is a read of 2000 discrete inputs and a write of 1968 coils, each a request and its answer, in sequence.
// Each round queries every server in turn, on the same processors, so that other load on the machine affects all
// servers equally.
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "conformance/server_process.hpp"
#include "support/raw_client.hpp"

namespace {

using symplant::conformance::ServerProcess;
using symplant::test::Bytes;
using symplant::test::RawClient;
using Clock = std::chrono::steady_clock;

constexpr const char* kUsage = R"(usage: modbus_pairs CLIENT_CPU SERVER_CPU ROUNDS PAIRS NAME=COMMAND...

Plays ROUNDS rounds of PAIRS pairs against each server, which COMMAND starts (as tests/conformance has them), and prints
for each the median of the rounds' pairs a second, and p50 and p99 of a pair in microseconds over all rounds.
)";

bool pin(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<unsigned>(cpu), &set);
  return ::sched_setaffinity(0, sizeof set, &set) == 0;
}

struct Side {
  std::string name;
  std::string command;
  std::vector<double> pairs_a_second;
  std::vector<double> microseconds;
};

double at(std::vector<double>& values, double part) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

void play(Side& side, std::uint16_t port, int pairs) {
  const RawClient client(port);
  const Bytes read = RawClient::frame(1, {2, 0, 0, 2000 >> 8, 2000 & 0xFF});
  Bytes pdu = {15, 0, 0, 1968 >> 8, 1968 & 0xFF, 246};
  pdu.resize(6 + 246, 0x5A);
  Bytes write = RawClient::frame(2, pdu);
  const auto start = Clock::now();
  for (int i = 0; i < pairs; ++i) {
    write[20] = static_cast<std::uint8_t>(i);  // at least one coil changes each time
    const auto begin = Clock::now();
    client.send(read);
    const std::size_t got = client.receive(9 + 250).size();
    client.send(write);
    if (got + client.receive(12).size() != 9 + 250 + 12) {
      std::fprintf(stderr, "%s does not answer\n", side.name.c_str());
      std::exit(1);
    }
    side.microseconds.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  side.pairs_a_second.push_back(pairs / std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) return std::fputs(kUsage, stderr), 2;
  const int client_cpu = std::atoi(argv[1]);
  const int server_cpu = std::atoi(argv[2]);
  const int rounds = std::max(std::atoi(argv[3]), 1);
  const int pairs = std::max(std::atoi(argv[4]), 1);
  std::vector<Side> sides;
  for (int i = 5; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t equals = text.find('=');
    if (equals == text.npos) return std::fputs(kUsage, stderr), 2;
    sides.push_back({text.substr(0, equals), text.substr(equals + 1), {}, {}});
  }
  for (int round = 0; round < rounds; ++round) {
    for (Side& side : sides) {
      if (!pin(server_cpu)) return std::fputs("no such processor\n", stderr), 2;  // child processes inherit it
      const ServerProcess server(side.command);
      if (!pin(client_cpu)) return std::fputs("no such processor\n", stderr), 2;
      play(side, server.server().port, pairs);
    }
  }
  std::printf("| client on %d, server on %d | pairs/s | p50 us | p99 us |\n|---|---|---|---|\n", client_cpu,
              server_cpu);
  for (Side& side : sides) {
    std::printf("| %s | %.0f | %.1f | %.1f |\n", side.name.c_str(), at(side.pairs_a_second, 0.5),
                at(side.microseconds, 0.5), at(side.microseconds, 0.99));
  }
}
