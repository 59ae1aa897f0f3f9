// A soft PLC for the sorting line: reads inputs, runs the program, writes outputs, over Modbus TCP, for some seconds.
//
//   sorting_controller HOST PORT SECONDS [DELAY]      DELAY: scans that the program waits before it pushes
#include <modbus/modbus.h>
#include <symplant/program.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

/// Of program/sorting.c: how many scans a new program waits before it pushes.
extern "C" int sorting_push_delay;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kScan{20};

/// The program with its memory. Its variables are those of the list: first the inputs from X0000 on, then the outputs
/// from Y0000 on.
class Program {
 public:
  Program() : cells_(of_.count) {
    std::vector<void*> cells;
    for (auto& cell : cells_) cells.push_back(&cell);
    instance_ = of_.create(cells.data());
    while (inputs_ < of_.count && of_.variables[inputs_].writes == 0) ++inputs_;
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { of_.destroy(instance_); }

  bool scan(modbus_t* context, std::int64_t now) {
    std::vector<std::uint8_t> bits(of_.count);
    if (modbus_read_input_bits(context, 0, static_cast<int>(inputs_), bits.data()) != static_cast<int>(inputs_)) {
      return false;
    }
    for (std::size_t i = 0; i < inputs_; ++i) cells_[i][0] = bits[i];
    if (of_.scan(instance_, now) != 0) return false;
    const std::size_t outputs = of_.count - inputs_;
    for (std::size_t i = 0; i < outputs; ++i) bits[i] = cells_[inputs_ + i][0];
    return modbus_write_bits(context, 0, static_cast<int>(outputs), bits.data()) == static_cast<int>(outputs);
  }

 private:
  const symplant_program& of_ = *symplant_program_v1();
  std::vector<std::array<std::uint8_t, 8>> cells_;
  std::size_t inputs_ = 0;
  void* instance_ = nullptr;
};

modbus_t* connected(const char* host, int port) {
  modbus_t* const context = modbus_new_tcp(host, port);
  const auto end = Clock::now() + std::chrono::seconds(10);
  while (context != nullptr && Clock::now() < end) {
    if (modbus_connect(context) == 0) return context;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return nullptr;
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
  if (argc > 4) sorting_push_delay = std::atoi(argv[4]);
  Program program;
  const auto begin = Clock::now();
  const auto end = begin + std::chrono::seconds(std::atoi(argv[3]));
  int code = 0;
  for (auto next = begin; next < end && code == 0; next += kScan) {
    if (!program.scan(context, std::chrono::nanoseconds(next - begin).count())) code = 1;
    std::this_thread::sleep_until(next + kScan);
  }
  modbus_close(context);
  modbus_free(context);
  return code;
}
