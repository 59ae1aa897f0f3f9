// A soft PLC for the sorting line: reads inputs, runs the program, writes outputs, over Modbus TCP, for some seconds.
//
//   sorting_controller HOST PORT SECONDS [DELAY]      DELAY: scans that the program waits before it pushes
#include <modbus/modbus.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "program.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kScan{20};
constexpr int kInputs = 9;   // X0000 to X0008
constexpr int kOutputs = 3;  // Y0000 to Y0002

modbus_t* connected(const char* host, int port) {
  modbus_t* const context = modbus_new_tcp(host, port);
  const auto end = Clock::now() + std::chrono::seconds(10);
  while (context != nullptr && Clock::now() < end) {
    if (modbus_connect(context) == 0) return context;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return nullptr;
}

bool scan(modbus_t* context, sorting::Program& program) {
  std::array<std::uint8_t, kInputs> in{};
  if (modbus_read_input_bits(context, 0, kInputs, in.data()) != kInputs) return false;
  const auto on = [&](std::size_t input) { return in.at(input) != 0; };
  const sorting::Outputs out = program.scan({.belt_runs = on(0),
                                             .low = on(1),
                                             .high = on(2),
                                             .stop1 = on(3),
                                             .stop2 = on(4),
                                             .push1_out = on(5),
                                             .push1_back = on(6),
                                             .push2_out = on(7),
                                             .push2_back = on(8)});
  const std::array<std::uint8_t, kOutputs> bits{out.belt, out.push1, out.push2};
  return modbus_write_bits(context, 0, kOutputs, bits.data()) == kOutputs;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: sorting_controller HOST PORT SECONDS [DELAY]\n", stderr);
    return 2;
  }
  modbus_t* const context = connected(argv[1], std::atoi(argv[2]));
  if (context == nullptr) {
    std::fprintf(stderr, "controller: no connection to %s:%s\n", argv[1], argv[2]);
    return 3;
  }
  sorting::Program program(argc > 4 ? std::atoi(argv[4]) : 0);
  const auto begin = Clock::now();
  const auto end = begin + std::chrono::seconds(std::atoi(argv[3]));
  int code = 0;
  for (auto next = begin; next < end && code == 0; next += kScan) {
    if (!scan(context, program)) code = 1;
    std::this_thread::sleep_until(next + kScan);
  }
  modbus_close(context);
  modbus_free(context);
  return code;
}
