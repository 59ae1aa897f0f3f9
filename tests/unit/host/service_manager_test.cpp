// Simulates systemd with a socket: paths, abstract names, no listener.
#include "symplant/host/service_manager.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

#include "support/bare_tables.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/host/attendant.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run.hpp"

namespace symplant::test {
namespace {

/// Receives the messages of a service.
class FakeManager {
 public:
  /// `name` as in NOTIFY_SOCKET.
  explicit FakeManager(const std::string& name) : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.data(), name.size());
    if (name[0] == '@') address.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    REQUIRE(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) == 0);
  }
  ~FakeManager() { ::close(socket_); }
  FakeManager(const FakeManager&) = delete;
  FakeManager& operator=(const FakeManager&) = delete;

  /// The next datagram; empty if no datagram has arrived yet.
  std::string next() {
    std::array<char, 256> text{};
    const ssize_t size = ::recv(socket_, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
  }
  /// Waits for a datagram that begins with `what`, at most ten seconds.
  bool hears(const std::string& what) {
    for (int i = 0; i < 1000; ++i) {
      for (std::string text = next(); !text.empty(); text = next()) {
        if (text.rfind(what, 0) == 0) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

 private:
  int socket_;
};

std::string abstract_name() { return "@symplant-test-" + std::to_string(getpid()); }

TEST_CASE("The service manager is reached by a path and by an abstract name") {
  const TemporaryFolder folder;
  for (const std::string& name : {folder / "notify", abstract_name()}) {
    FakeManager systemd(name);
    const host::ServiceManager manager(name, 5 * tables::kSecond);
    CHECK(manager.listens());
    CHECK(manager.watchdog() == 5 * tables::kSecond);
    manager.report("READY=1");
    CHECK(systemd.next() == "READY=1");
  }
}

TEST_CASE("Without a service manager no message is sent and there is no error") {
  for (const std::string& name : {std::string(), std::string("@"), std::string("vsock:2:1"),
                                  std::string("/no/such/socket"), std::string(200, '/')}) {
    const host::ServiceManager manager(name, tables::kSecond);
    CHECK_FALSE(manager.listens());
    CHECK(manager.watchdog() == 0);
    manager.report("READY=1");
  }
}

TEST_CASE("A service manager that does not read is not waited for") {
  FakeManager systemd(abstract_name());
  const host::ServiceManager manager(abstract_name(), 0);
  for (int i = 0; i < 100'000; ++i) manager.report("WATCHDOG=1");
  CHECK(systemd.next() == "WATCHDOG=1");
}

/// Sets environment variables while it lives.
class Environment {
 public:
  Environment(const std::string& socket, const std::string& watchdog, const std::string& pid) {
    setenv("NOTIFY_SOCKET", socket.c_str(), 1);
    setenv("WATCHDOG_USEC", watchdog.c_str(), 1);
    setenv("WATCHDOG_PID", pid.c_str(), 1);
  }
  ~Environment() {
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) unsetenv(name);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
};

TEST_CASE("The watchdog's time is read from the environment if it is meant for this process") {
  FakeManager systemd(abstract_name());
  const std::string own = std::to_string(getpid());
  const auto watchdog = [&](const std::string& time, const std::string& pid) {
    const Environment environment(abstract_name(), time, pid);
    return host::ServiceManager::of_environment().watchdog();
  };
  CHECK(watchdog("2000000", own) == 2 * tables::kSecond);
  CHECK(watchdog("2000000", "1") == 0);
  CHECK(watchdog("", own) == 0);
  CHECK(watchdog("2s", own) == 0);
  CHECK(watchdog("99999999999999999999", own) == 0);
}

TEST_CASE("Ready is sent when the cycle runs, the watchdog while it runs, the end at the end") {
  FakeManager systemd(abstract_name());
  const Environment environment(abstract_name(), "100000", std::to_string(getpid()));
  exec::CycleMeter meter;
  {
    host::Console console(std::cout, std::cerr);
    const host::Attendant attendant(meter, {}, {{}, ""}, false, false, console);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    CHECK(systemd.next().empty());  // no cycle yet
    meter.beats.add(1);
    CHECK(systemd.hears("READY=1"));
    CHECK(systemd.hears("WATCHDOG=1"));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    while (!systemd.next().empty()) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(systemd.next().empty());  // the cycle hangs: no sign of life
    meter.beats.add(1);
    CHECK(systemd.hears("WATCHDOG=1"));
  }
  CHECK(systemd.hears("STOPPING=1"));
}

TEST_CASE("A run in real time is ready when its cycle runs, and reports its end") {
  FakeManager systemd(abstract_name());
  const Environment environment(abstract_name(), "", "");
  tables::PlantTables tables = bare_tables("bare", 0, 0);
  tables.list_names = {"none", 5};
  host::RunOptions options;
  options.clock = host::RunOptions::Clock::real_time;
  options.until = GENERATE(50, 300) * tables::kMillisecond;
  std::ostringstream out;
  CHECK(host::run({.tables = tables}, options, out, out) == host::kGood);
  CHECK(systemd.next().rfind("READY=1\n", 0) == 0);
  CHECK(systemd.next() == "STOPPING=1");
}

TEST_CASE("The status line shows cycles, lateness, overruns and the state of each link") {
  exec::CycleMeter meter;
  meter.cycles.add(7);
  meter.overruns.add(2);
  meter.lateness.add(1500);
  meter.note(1, exec::LinkState::lost);
  CHECK(host::status_text(meter, {"loop:", "PLC2"}, false) ==
        "7 cycles, late by 1.5 us (p99), 2 overruns; loop: waiting, PLC2 lost");
  meter.note_standstill(true);
  CHECK(host::status_text(meter, {"loop:"}, false) ==
        "7 cycles, late by 1.5 us (p99), 2 overruns; loop: waiting; the plant is frozen");
  meter.note_standstill(false);
  CHECK(host::status_text(meter, {}, true) == "7 cycles, late by 1.5 us (p99), 2 overruns, real time degraded");
}

TEST_CASE("The status line shows how far plant time is from the PLC's clock") {
  exec::CycleMeter meter;
  const auto shown = [&] {
    const std::string text = host::status_text(meter, {}, false);
    return text.substr(text.find("overruns") + 8);
  };
  CHECK(shown().empty());
  meter.note(exec::PlcClockReading{});
  CHECK(shown() == "; plant time waits for the PLC's clock");
  meter.note(exec::PlcClockReading{5, -3'200'000, 4'000'000, 1, 2});
  CHECK(shown() == "; plant time 3.2 ms behind the PLC, 1 wait, 2 restarts");
  meter.note(exec::PlcClockReading{6, 400'000, 4'000'000, 12, 1});
  CHECK(shown() == "; plant time 0.4 ms ahead of the PLC, 12 waits, 1 restart");
}

}  // namespace
}  // namespace symplant::test
