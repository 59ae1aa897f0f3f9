// From a written coil to its consequence: the time until a Modbus client reads the resulting input.
//
// The plant is a double solenoid with travel time 0, run by `symplant run` in real time. Each sample starts at
// a random moment of the cycle: the client writes a coil, then reads the input until it has changed.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "conformance/server_process.hpp"
#include "support/raw_client.hpp"

namespace {

using symplant::conformance::ServerProcess;
using symplant::test::Bytes;
using symplant::test::RawClient;
using Clock = std::chrono::steady_clock;

constexpr const char* kUsage = R"(usage: modbus_reaction SYMPLANT FOLDER CYCLE_US SAMPLES [RUN_OPTION...]

Prints p50, p99 and the worst of SAMPLES reactions, in microseconds and in cycles. FOLDER is for the plant's files.
)";

constexpr const char* kList = R"(Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial
VAR_GLOBAL,L_P_CYL_O_ADV,Y0001,%QX1,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_O_RET,Y0002,%QX2,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_I_ADV,X0001,%IX1,BOOL,FALSE
VAR_GLOBAL,L_P_CYL_I_RET,X0002,%IX2,BOOL,FALSE
)";
constexpr const char* kPlant =
    R"({ "symplant": 1, "name": "reaction", "symbols": ["list.csv"], "defaults": { "travel": "0s" } })";

std::uint16_t free_port() {
  const symplant::link::net::Descriptor probe(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* any = reinterpret_cast<sockaddr*>(&address);
  if (::bind(probe.get(), any, size) != 0 || ::getsockname(probe.get(), any, &size) != 0) std::exit(3);
  return ntohs(address.sin_port);
}

double at(const std::vector<double>& sorted, double part) {
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
}

/// Microseconds from sending a command to reading the cylinder's new position.
double sample(RawClient& client, bool advance) {
  const std::uint8_t wanted = advance ? 1 : 2;
  const auto begin = Clock::now();
  if (client.ask({15, 0, 1, 0, 2, 1, wanted}).size() != 5) std::exit(1);
  for (;;) {
    const Bytes seen = client.ask({2, 0, 1, 0, 2});
    if (seen.size() != 3) std::exit(1);
    if (seen[2] == wanted) return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return std::fputs(kUsage, stderr), 2;
  const std::string folder = argv[2];
  const int cycle = std::atoi(argv[3]);
  std::ofstream(folder + "/list.csv") << kList;
  std::ofstream(folder + "/plant.json") << kPlant;
  const std::string port = std::to_string(free_port());
  std::string run = std::string(argv[1]) + " run " + folder + "/plant.json --cycle " + argv[3] +
                    "us --link modbus-tcp-server://127.0.0.1:" + port;
  for (int i = 5; i < argc; ++i) run += std::string(" ") + argv[i];
  const ServerProcess server("sh -c 'echo " + port + " 16 16 0 0 symplant; exec " + run + " >/dev/null 2>&1'");
  for (int i = 0; i < 200 && !RawClient(server.server().port).connected(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  RawClient client(server.server().port);
  std::mt19937 random(1);
  std::vector<double> times;
  sample(client, true);
  for (int i = 0; i < std::atoi(argv[4]); ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(random() % static_cast<unsigned>(2 * cycle)));
    times.push_back(sample(client, i % 2 != 0));
  }
  std::sort(times.begin(), times.end());
  std::printf("| cycle %d us | p50 %.0f us (%.2f cycles) | p99 %.0f us (%.2f) | max %.0f us |\n", cycle, at(times, 0.5),
              at(times, 0.5) / cycle, at(times, 0.99), at(times, 0.99) / cycle, times.back());
}
