// PLCs for a plant of double solenoids: each exchanges the whole image by Modbus TCP in a fixed period and moves every
// device back and forth. usage: modbus_masters SECONDS PERIOD_MS DEVICES PORT...
//
// Device d of a port has the coils 2d (advance) and 2d+1 (return), and discrete inputs of the same numbers. At the
// end it prints the number of exchanges, the slowest exchange of the whole image, and the number of motions.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostRead = 2000;
constexpr std::size_t kMostWritten = 1968;
constexpr std::size_t kHeader = 7;
constexpr std::size_t kLongest = 260;

struct Result {
  bool failed = false;
  std::uint64_t exchanges = 0;
  std::uint64_t motions = 0;
  double slowest_ms = 0;
};

class Master {
 public:
  Master(int devices, std::uint16_t port) : inputs_(bytes(devices)), coils_(bytes(devices)), devices_(devices) {
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  ~Master() { ::close(socket_); }
  Master(const Master&) = delete;
  Master& operator=(const Master&) = delete;

  /// Every period until `end`.
  Result run(Clock::duration period, Clock::time_point end) {
    Result result;
    for (Clock::time_point next = Clock::now(); next < end; next += period) {
      std::this_thread::sleep_until(next);
      const Clock::time_point begin = Clock::now();
      if (!connected_ || !read_inputs()) result.failed = true;
      result.motions += command();
      if (result.failed || !write_coils()) {
        result.failed = true;
        return result;
      }
      ++result.exchanges;
      const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
      result.slowest_ms = std::max(result.slowest_ms, took.count());
    }
    return result;
  }

 private:
  using Bytes = std::vector<std::uint8_t>;

  static std::size_t bytes(int devices) { return (2 * static_cast<std::size_t>(devices) + 7) / 8; }
  std::size_t bits() const { return 2 * static_cast<std::size_t>(devices_); }

  static bool bit(const Bytes& image, std::size_t at) { return (image[at / 8] >> (at % 8) & 1) != 0; }
  static void set(Bytes& image, std::size_t at, bool on) {
    const auto mask = static_cast<std::uint8_t>(1U << (at % 8));
    image[at / 8] = static_cast<std::uint8_t>(on ? image[at / 8] | mask : image[at / 8] & ~mask);
  }

  /// Sends arrived devices back; returns their number.
  std::uint64_t command() {
    std::uint64_t arrived = 0;
    for (std::size_t ram = 0; ram < bits(); ram += 2) {
      for (const std::size_t end : {ram, ram + 1}) {
        const std::size_t other = end ^ 1;
        if (!bit(inputs_, end) || bit(coils_, other)) continue;
        if (bit(coils_, end)) ++arrived;
        set(coils_, end, false);
        set(coils_, other, true);
      }
    }
    return arrived;
  }

  bool receive(std::span<std::uint8_t> to) const {
    std::size_t have = 0;
    while (have < to.size()) {
      const ssize_t got = ::recv(socket_, to.data() + have, to.size() - have, 0);
      if (got <= 0) return false;
      have += static_cast<std::size_t>(got);
    }
    return true;
  }

  /// A request of `size` bytes after the header, which this function fills in; its answer is in `answer_`.
  bool ask(std::span<std::uint8_t> frame, std::size_t answer) {
    const auto length = static_cast<std::uint8_t>(frame.size() - kHeader + 1);
    const auto id = ++transaction_;
    frame[0] = static_cast<std::uint8_t>(id >> 8);
    frame[1] = static_cast<std::uint8_t>(id);
    frame[2] = frame[3] = frame[4] = 0;
    frame[5] = length;
    frame[6] = 1;
    if (::send(socket_, frame.data(), frame.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(frame.size())) return false;
    const auto whole = std::span(answer_).first(kHeader + answer);
    return receive(whole) && whole[0] == frame[0] && whole[1] == frame[1] && whole[kHeader] == frame[kHeader];
  }

  static void put(std::uint8_t* at, std::size_t value) {
    at[0] = static_cast<std::uint8_t>(value >> 8);
    at[1] = static_cast<std::uint8_t>(value);
  }

  bool read_inputs() {
    std::array<std::uint8_t, kHeader + 5> frame{};
    for (std::size_t first = 0; first < bits(); first += kMostRead) {
      const std::size_t count = std::min(kMostRead, bits() - first);
      frame[kHeader] = 2;
      put(&frame[kHeader + 1], first);
      put(&frame[kHeader + 3], count);
      const std::size_t size = (count + 7) / 8;
      if (!ask(frame, 2 + size)) return false;
      std::copy_n(answer_.begin() + kHeader + 2, size, inputs_.begin() + static_cast<std::ptrdiff_t>(first / 8));
    }
    return true;
  }

  bool write_coils() {
    std::array<std::uint8_t, kLongest> frame{};
    for (std::size_t first = 0; first < bits(); first += kMostWritten) {
      const std::size_t count = std::min(kMostWritten, bits() - first);
      const std::size_t size = (count + 7) / 8;
      frame[kHeader] = 15;
      put(&frame[kHeader + 1], first);
      put(&frame[kHeader + 3], count);
      frame[kHeader + 5] = static_cast<std::uint8_t>(size);
      std::copy_n(coils_.begin() + static_cast<std::ptrdiff_t>(first / 8), size, frame.begin() + kHeader + 6);
      if (!ask(std::span(frame).first(kHeader + 6 + size), 5)) return false;
    }
    return true;
  }

  int socket_ = -1;
  bool connected_ = false;
  std::uint16_t transaction_ = 0;
  Bytes inputs_;
  Bytes coils_;
  std::array<std::uint8_t, kLongest> answer_{};
  int devices_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("usage: modbus_masters SECONDS PERIOD_MS DEVICES PORT...\n", stderr);
    return 2;
  }
  const auto end = Clock::now() + std::chrono::seconds(std::atoi(argv[1]));
  const auto period = std::chrono::milliseconds(std::atoi(argv[2]));
  const int devices = std::atoi(argv[3]);
  std::vector<Result> results(static_cast<std::size_t>(argc - 4));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto port = static_cast<std::uint16_t>(std::atoi(argv[4 + i]));
    threads.emplace_back([&, i, port] { results[i] = Master(devices, port).run(period, end); });
  }
  for (std::thread& thread : threads) thread.join();
  Result all;
  for (const Result& result : results) {
    all.failed = all.failed || result.failed;
    all.exchanges += result.exchanges;
    all.motions += result.motions;
    all.slowest_ms = std::max(all.slowest_ms, result.slowest_ms);
  }
  std::printf("%llu exchanges of the whole image, the slowest %.1f ms, %llu motions, %.0f a second%s\n",
              static_cast<unsigned long long>(all.exchanges), all.slowest_ms,
              static_cast<unsigned long long>(all.motions),
              static_cast<double>(all.motions) / std::max(1, std::atoi(argv[1])), all.failed ? "; BROKEN OFF" : "");
  return all.failed ? 1 : 0;
}
