// What is in a file after SIGKILL: everything older than 100 ms, in whole lines.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "recording/read.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/temporary_folder.hpp"

using namespace symplant;

namespace {

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;
using std::chrono::milliseconds;

constexpr milliseconds kLost{100};  ///< what a killed process may lose

constexpr const char* kList =
    "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
    "VAR_GLOBAL,LINE_S1_TANK_O_LEVEL,,%QD0,UDINT,0,\n"
    "VAR_GLOBAL,LINE_S1_CYL_O_OUT,Y0020,%QX32,BOOL,FALSE,\n"
    "VAR_GLOBAL,LINE_S1_CYL_I_OUT,X0010,%IX16,BOOL,FALSE,\n";

/// Numbers that were given out, and when.
class Stamps {
 public:
  void add(std::uint32_t number) {
    const std::scoped_lock lock(mutex_);
    times_[number] = Clock::now();
  }
  std::uint32_t count() const {
    const std::scoped_lock lock(mutex_);
    return static_cast<std::uint32_t>(times_.size());
  }
  /// The last number before a time; 0: none.
  std::uint32_t last_before(Clock::time_point time) const {
    const std::scoped_lock lock(mutex_);
    std::uint32_t last = 0;
    for (const auto& [number, at] : times_) {
      if (at <= time) last = std::max(last, number);
    }
    return last;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::uint32_t, Clock::time_point> times_;
};

/// A PLC that serves Modbus to one client. Each reading of holding registers gets the next number, which it stamps.
class StampingPlc {
 public:
  StampingPlc() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);  // NOLINT: as the interface has it
    if (::bind(listener_, any, size) != 0 || ::listen(listener_, 4) != 0 || ::getsockname(listener_, any, &size) != 0) {
      throw std::runtime_error("no port");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  StampingPlc(const StampingPlc&) = delete;
  StampingPlc& operator=(const StampingPlc&) = delete;
  ~StampingPlc() {
    stop_ = true;
    thread_.join();
    ::close(listener_);
  }

  std::uint16_t port() const { return port_; }
  const Stamps& stamps() const { return stamps_; }
  int writes() const { return writes_; }

 private:
  void serve() {
    while (!stop_) {
      pollfd waiting{listener_, POLLIN, 0};
      if (::poll(&waiting, 1, 5) <= 0) continue;
      const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      const int on = 1;
      ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      while (!stop_ && answer(client)) continue;
      ::close(client);
    }
  }

  bool answer(int client) {
    pollfd waiting{client, POLLIN, 0};
    if (::poll(&waiting, 1, 5) <= 0) return true;
    std::array<std::uint8_t, 260> request{};
    const ssize_t size = ::recv(client, request.data(), request.size(), 0);  // a request is one segment
    if (size < 8) return false;
    const std::uint8_t function = request[7];
    Bytes pdu;
    if (function == 1 || function == 2) {
      const std::size_t bits = std::size_t{request[10]} << 8 | request[11];
      pdu = {function, static_cast<std::uint8_t>((bits + 7) / 8)};
      pdu.resize(2 + (bits + 7) / 8);
    } else if (function == 3) {
      const std::uint32_t number = stamps_.count() + 1;
      const auto byte = [number](int bits) { return static_cast<std::uint8_t>(number >> bits); };
      pdu = {function, 4, byte(8), byte(0), byte(24), byte(16)};  // low word first
      stamps_.add(number);
    } else {
      if (function != 43) ++writes_;
      pdu = {static_cast<std::uint8_t>(function | 0x80), 1};
    }
    Bytes reply(request.begin(), request.begin() + 4);
    reply.push_back(0);
    reply.push_back(static_cast<std::uint8_t>(pdu.size() + 1));
    reply.push_back(request[6]);
    reply.insert(reply.end(), pdu.begin(), pdu.end());
    return ::send(client, reply.data(), reply.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(reply.size());
  }

  int listener_;
  std::uint16_t port_ = 0;
  Stamps stamps_;
  std::atomic<int> writes_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// The tool as a process, which is killed at the latest by the destructor. Its output goes to a file.
class ToolProcess {
 public:
  ToolProcess(std::vector<std::string> arguments, const std::string& log) {
    arguments.insert(arguments.begin(), SYMPLANT_TOOL);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    if (::posix_spawn(&pid_, SYMPLANT_TOOL, &actions, nullptr, argv.data(), environ) != 0) pid_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    if (pid_ < 0) throw std::runtime_error("cannot start the tool");
  }
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;
  ~ToolProcess() { end(SIGKILL); }

  /// The status of waitpid().
  int end(int signal) {
    if (pid_ < 0) return status_;
    ::kill(pid_, signal);
    ::waitpid(pid_, &status_, 0);
    pid_ = -1;
    return status_;
  }

 private:
  pid_t pid_ = -1;
  int status_ = 0;
};

int kills() {
  const char* const text = std::getenv("SYMPLANT_KILLS");  // NOLINT(concurrency-mt-unsafe): no thread sets variables
  return text == nullptr ? 10 : std::atoi(text);
}

template <class Holds>
bool wait_for(Holds holds) {
  for (int i = 0; i < 4'000 && !holds(); ++i) std::this_thread::sleep_for(milliseconds(5));
  return holds();
}

/// The numbers of LEVEL in the whole lines of a file, in their order.
std::vector<std::uint32_t> numbers_in(const std::string& path) {
  std::vector<std::uint32_t> numbers;
  std::istringstream file(test::read_bytes(path));
  for (std::string line; std::getline(file, line) && !file.eof();) {
    const auto json = nlohmann::json::parse(line);
    if (json.value("symbol", "") == "LINE_S1_TANK_O_LEVEL") numbers.push_back(json["value"].get<std::uint32_t>());
  }
  return numbers;
}

std::string reading_fault(const std::string& path) {
  std::ifstream file(path);
  return recording::read_recording(file, "r").error;
}

/// Writes the numbers from 1 on to the holding registers of a plant, and stamps those that it has taken.
class Writing {
 public:
  explicit Writing(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    const auto* const any = reinterpret_cast<const sockaddr*>(&address);  // NOLINT: as the interface has it
    if (::connect(socket_, any, sizeof address) != 0) throw std::runtime_error("no connection");
    thread_ = std::thread([this] { write(); });
  }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
  ~Writing() {
    stop_ = true;
    thread_.join();
    ::close(socket_);
  }
  const Stamps& stamps() const { return stamps_; }

 private:
  void write() {
    for (std::uint32_t number = 1; !stop_; ++number) {
      const auto byte = [number](int bits) { return static_cast<std::uint8_t>(number >> bits); };
      const Bytes request{0, 1, 0, 0, 0, 11, 1, 16, 0, 0, 0, 2, 4, byte(8), byte(0), byte(24), byte(16)};
      if (::send(socket_, request.data(), request.size(), MSG_NOSIGNAL) < 0) return;
      std::array<std::uint8_t, 64> reply{};
      if (::recv(socket_, reply.data(), reply.size(), 0) <= 0) return;
      stamps_.add(number);
      std::this_thread::sleep_for(milliseconds(3));
    }
  }

  int socket_;
  Stamps stamps_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace

TEST_CASE("A recording that is killed has everything older than 100 ms") {
  std::mt19937 random(20);
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  for (int kill = 0; kill < kills(); ++kill) {
    const StampingPlc plc;
    const std::string path = folder / "r.jsonl";
    ToolProcess tool({"record", list, "--link", "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()), "--every",
                      "10ms", "-o", path},
                     folder / "log");
    REQUIRE(wait_for([&] { return plc.stamps().count() > 5; }));
    std::this_thread::sleep_for(milliseconds(100 + random() % 500));
    const Clock::time_point killed = Clock::now();
    tool.end(SIGKILL);
    const std::uint32_t least = plc.stamps().last_before(killed - kLost);
    const std::vector<std::uint32_t> numbers = numbers_in(path);
    CAPTURE(kill, test::read_bytes(folder / "log"));
    REQUIRE_FALSE(numbers.empty());
    for (std::size_t i = 1; i < numbers.size(); ++i) REQUIRE(numbers[i] == numbers[i - 1] + 1);
    CHECK(numbers.back() >= least);
    CHECK(numbers.back() <= plc.stamps().count());
    CHECK(reading_fault(path).empty());
    CHECK(plc.writes() == 0);
  }
}

TEST_CASE("The trace of a real-time run that is killed has everything older than 100 ms") {
  constexpr milliseconds kCycle{10};  // until the plant takes what was written
  std::mt19937 random(21);
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  for (int kill = 0; kill < std::max(kills() / 4, 1); ++kill) {
    const std::string path = folder / "t.jsonl";
    const std::string log = folder / "log";
    ToolProcess tool({"run", list, "--link", "modbus-tcp-server://127.0.0.1:0", "--trace", path}, log);
    std::uint16_t port = 0;
    REQUIRE(wait_for([&] {
      const std::string text = test::read_bytes(log);
      const std::string before = "link modbus-tcp-server://127.0.0.1:";
      const std::size_t at = text.find(before);
      if (at != text.npos) port = static_cast<std::uint16_t>(std::atoi(text.c_str() + at + before.size()));
      return text.find("running in real time") != text.npos;
    }));
    const Writing writing(port);
    REQUIRE(wait_for([&] { return writing.stamps().count() > 5; }));
    std::this_thread::sleep_for(milliseconds(150 + random() % 500));
    const Clock::time_point killed = Clock::now();
    tool.end(SIGKILL);
    const std::vector<std::uint32_t> numbers = numbers_in(path);
    CAPTURE(kill, test::read_bytes(log));
    REQUIRE_FALSE(numbers.empty());
    CHECK(numbers.back() >= writing.stamps().last_before(killed - kLost - kCycle));
    CHECK(reading_fault(path).empty());
  }
}

TEST_CASE("The trace of a run with a panel is in the file while it runs") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  const std::string path = folder / "t.jsonl";
  ToolProcess tool({"run", list, "--panel", "127.0.0.1:0", "--trace", path}, folder / "log");
  // Nothing changes: the header is far below what a buffer holds.
  CHECK(wait_for([&] { return std::filesystem::exists(path) && test::read_bytes(path).ends_with("}\n"); }));
  tool.end(SIGKILL);
  CHECK(reading_fault(path).empty());
}

TEST_CASE("A recording ends cleanly with SIGTERM and SIGINT") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  for (const int signal : {SIGTERM, SIGINT}) {
    const StampingPlc plc;
    const std::string path = folder / "r.jsonl";
    ToolProcess tool({"record", list, "--link", "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()), "-o", path},
                     folder / "log");
    REQUIRE(wait_for([&] { return plc.stamps().count() > 5; }));
    const int status = tool.end(signal);
    CAPTURE(test::read_bytes(folder / "log"));
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    const std::string text = test::read_bytes(path);
    CHECK(text.ends_with(",\"end\":true}\n"));
    CHECK(reading_fault(path).empty());
    CHECK(test::read_bytes(folder / "log").find("resolution: 50.0 ms") != std::string::npos);
  }
}

TEST_CASE("A start condition that never held gives exit code 1 and an empty file") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  const StampingPlc plc;
  const std::string path = folder / "r.jsonl";
  ToolProcess tool({"record", list, "--link", "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()), "-o", path,
                    "--start-when", "LINE_S1_CYL_I_OUT", "--before", "1s"},
                   folder / "log");
  REQUIRE(wait_for([&] { return plc.stamps().count() > 5; }));
  const int status = tool.end(SIGTERM);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  CHECK(test::read_bytes(path).empty());
  CHECK(test::read_bytes(folder / "log").find("`--start-when LINE_S1_CYL_I_OUT` did not hold") != std::string::npos);
}

TEST_CASE("A full disk ends the recording with exit code 3") {
  const test::TemporaryFolder folder;
  const std::string list = folder.write("list.csv", kList);
  const StampingPlc plc;
  ToolProcess tool(
      {"record", list, "--link", "modbus-tcp://127.0.0.1:" + std::to_string(plc.port()), "-o", "/dev/full"},
      folder / "log");
  REQUIRE(wait_for([&] { return test::read_bytes(folder / "log").find("error: ") != std::string::npos; }));
  const int status = tool.end(0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 3);
  const std::string log = test::read_bytes(folder / "log");
  CAPTURE(log);
  CHECK(log.find("error: cannot write the recording `/dev/full`: No space left on device; the recording ends at ") !=
        std::string::npos);
  CHECK(log.find(" s, what was written before is valid\n") != std::string::npos);
}
