// systemd's side played by a socket: paths, abstract names, nobody.
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

/// Receives what a service tells.
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

  /// The next datagram; empty where there is none yet.
  std::string next() {
    std::array<char, 256> text{};
    const ssize_t size = ::recv(socket_, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
  }
  /// Waits for a datagram that begins with `what`, ten seconds at the most.
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

TEST_CASE("the service manager hears by a path and by an abstract name") {
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

TEST_CASE("without a service manager nothing is told and nothing goes wrong") {
  for (const std::string& name : {std::string(), std::string("@"), std::string("vsock:2:1"),
                                  std::string("/no/such/socket"), std::string(200, '/')}) {
    const host::ServiceManager manager(name, tables::kSecond);
    CHECK_FALSE(manager.listens());
    CHECK(manager.watchdog() == 0);
    manager.report("READY=1");
  }
}

TEST_CASE("a service manager that does not read is not waited for") {
  FakeManager systemd(abstract_name());
  const host::ServiceManager manager(abstract_name(), 0);
  for (int i = 0; i < 100'000; ++i) manager.report("WATCHDOG=1");
  CHECK(systemd.next() == "WATCHDOG=1");
}

/// Sets variables of the environment while it lives.
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

TEST_CASE("the watchdog's time is taken from the environment where it is meant for this process") {
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

TEST_CASE("ready is told when the cycle goes, the watchdog as long as it goes, the end at the end") {
  FakeManager systemd(abstract_name());
  const Environment environment(abstract_name(), "100000", std::to_string(getpid()));
  exec::CycleMeter meter;
  {
    host::Console console(std::cout, std::cerr);
    const host::Attendant attendant(meter, {}, false, false, console);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    CHECK(systemd.next().empty());  // no cycle yet
    meter.beats.add(1);
    CHECK(systemd.hears("READY=1"));
    CHECK(systemd.hears("WATCHDOG=1"));
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    while (!systemd.next().empty()) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    CHECK(systemd.next().empty());  // the cycle hangs: nobody says that it lives
    meter.beats.add(1);
    CHECK(systemd.hears("WATCHDOG=1"));
  }
  CHECK(systemd.hears("STOPPING=1"));
}

TEST_CASE("a run in real time is ready when its cycle goes, and says when it ends") {
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

TEST_CASE("the status line says cycles, lateness, overruns and how each link stands") {
  exec::CycleMeter meter;
  meter.cycles.add(7);
  meter.overruns.add(2);
  meter.lateness.add(1500);
  meter.note(1, exec::LinkState::lost);
  CHECK(host::status_text(meter, {"loop:", "PLC2"}, false) ==
        "7 cycles, p99 1.5 us late, 2 overruns; loop: waiting, PLC2 lost");
  meter.note_standstill(true);
  CHECK(host::status_text(meter, {"loop:"}, false) ==
        "7 cycles, p99 1.5 us late, 2 overruns; loop: waiting; the plant stands still");
  meter.note_standstill(false);
  CHECK(host::status_text(meter, {}, true) == "7 cycles, p99 1.5 us late, 2 overruns, real time degraded");
}

}  // namespace
}  // namespace symplant::test
