// A PLC that serves Modbus TCP on the loopback and runs a program; it lies on request. It has none of the project's
// code.
//
//   ModbusPlc plc({.program = [](PlcMemory& memory) { memory.coils[1] = memory.discrete_inputs[3]; }});
//   plc.with([](PlcMemory& memory) { memory.holding_registers[7] = 5; });
//   plc.lie({.seed = 7, .per_thousand = 300});
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "support/modbus/plc_answers.hpp"
#include "support/modbus/plc_lies.hpp"

namespace symplant::test::modbus {

struct PlcSetup {
  std::uint8_t unit = 1;  ///< requests to other units get no answer
  PlcMemory memory = {};
  PlcAbilities abilities = {};
  std::function<void(PlcMemory&)> program = {};  ///< runs after each request and each ms
};

struct Lies {
  std::uint32_t seed = 1;
  unsigned per_thousand = 0;
  std::vector<Lie> kinds = {};            ///< empty: all
  std::chrono::milliseconds late_by{40};  ///< more than the client's timeout
};

class ModbusPlc {
 public:
  explicit ModbusPlc(PlcSetup setup = {});
  ~ModbusPlc();
  ModbusPlc(const ModbusPlc&) = delete;
  ModbusPlc& operator=(const ModbusPlc&) = delete;

  std::uint16_t port() const { return port_; }

  /// Runs between two requests.
  void with(const std::function<void(PlcMemory&)>& use);
  void with_abilities(const std::function<void(PlcAbilities&)>& use);
  void lie(const Lies& lies);
  std::uint64_t lies() const { return lies_sent_; }
  std::uint64_t lies(Lie lie) const { return count_[static_cast<std::size_t>(lie)]; }
  void close_connections();
  /// Connections so far.
  std::uint64_t accepted() const { return accepted_; }

  /// All requests so far, as PDUs.
  std::vector<Bytes> requests();
  std::vector<Written> written();
  void forget_log();

  /// Looks at the condition after each request and each ms, with the memory locked against requests. False after 20 s.
  bool wait_until(const std::function<bool(PlcMemory&)>& holds);

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection {
    int socket = -1;
    Bytes received = {};
    Bytes before = {};  ///< the latest reply
    Bytes late = {};    ///< to be sent at `due`
    std::size_t answers = 0;
    Clock::time_point due = {};  ///< of `late`
  };

  void run();
  bool serve(Connection& connection);
  bool answer(Connection& connection, const Bytes& frame);
  bool send_now(const Connection& connection, const Bytes& bytes) const;
  Lie next_lie();

  PlcSetup setup_;
  int listener_ = -1;
  int wake_ = -1;
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Connection> connections_;
  Lies lies_;
  std::mt19937 random_;
  std::vector<Bytes> requests_;
  std::vector<Written> written_;
  std::atomic<std::uint64_t> lies_sent_{0};
  std::atomic<std::uint64_t> accepted_{0};
  std::array<std::atomic<std::uint64_t>, kLies> count_{};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace symplant::test::modbus
