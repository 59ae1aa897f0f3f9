// Options of the Modbus server: number of clients, idle time, and which client is closed first.
#include <fcntl.h>
#include <sys/resource.h>

#include "support/catch.hpp"
#include "support/raw_client.hpp"
#include "symplant/link/modbus/server.hpp"
#include "symplant/link/net/descriptors.hpp"
#include "symplant/link/net/listener.hpp"
#include "symplant/link/net/posix/file_limit.hpp"

using namespace symplant;
using namespace symplant::link::modbus;
using namespace symplant::link::net;
using test::Bytes;
using test::open_descriptors;
using test::RawClient;

namespace {

const Bytes kAsked = {3, 1, 2};

/// Answers every request with its own bytes.
class Echo final : public Responder {
 public:
  Answer respond(const ClientId& /*client*/, std::span<const std::uint8_t> request,
                 std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    std::copy(request.begin(), request.end(), reply.begin());
    return {.size = request.size()};
  }
  void refused(std::span<const std::uint8_t> /*request*/) noexcept override {}
};

struct EchoServer {
  Listener listener = std::get<Listener>(listen_on({"127.0.0.1", 0}));
  std::uint16_t port = listener.bound.port;
  Echo echo;
  Server server;

  explicit EchoServer(ServerOptions options) : server(std::move(listener.socket), echo, std::move(options)) {}

  void wait_for_connections(std::uint32_t count) const {
    for (int i = 0; i < 30'000 && server.connections() != count; ++i) ::poll(nullptr, 0, 1);
    REQUIRE(server.connections() == count);
  }
};

/// The server's end of a client's connection, which is in this process.
int server_end(const RawClient& client) {
  sockaddr_in ours{};
  socklen_t size = sizeof ours;
  ::getsockname(client.descriptor(), reinterpret_cast<sockaddr*>(&ours), &size);
  for (int fd = 0; fd < 1024; ++fd) {
    sockaddr_in peer{};
    size = sizeof peer;
    if (::getpeername(fd, reinterpret_cast<sockaddr*>(&peer), &size) == 0 && peer.sin_port == ours.sin_port) return fd;
  }
  return -1;
}

/// No descriptor is available while it lives.
class NoDescriptors {
 public:
  NoDescriptors() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit none{1, before_.rlim_max};  // poll() of one takes a limit of one
    ::setrlimit(RLIMIT_NOFILE, &none);
  }
  NoDescriptors(const NoDescriptors&) = delete;
  NoDescriptors& operator=(const NoDescriptors&) = delete;
  ~NoDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

int option(int socket, int level, int name) {
  int value = -1;
  socklen_t size = sizeof value;
  ::getsockopt(socket, level, name, &value, &size);
  return value;
}

}  // namespace

TEST_CASE("A client without requests for the idle time is closed, an active one is kept") {
  const EchoServer bench({.idle = 3 * tables::kSecond});
  RawClient idle(bench.port);
  RawClient busy(bench.port);
  for (int i = 0; i < 70; ++i) {
    REQUIRE(busy.ask(kAsked) == kAsked);
    ::poll(nullptr, 0, 50);
  }
  CHECK(idle.is_closed());
  CHECK(busy.ask(kAsked) == kAsked);
}

TEST_CASE("An idle time of 0 keeps a silent client") {
  const EchoServer bench({.idle = 0, .frame = 20 * tables::kMillisecond});
  RawClient client(bench.port);
  REQUIRE(client.ask(kAsked) == kAsked);
  ::poll(nullptr, 0, 300);
  CHECK(client.ask(kAsked) == kAsked);
}

TEST_CASE("A client that sends a frame byte by byte forever is closed, as a byte does not restart the time") {
  const EchoServer bench({.frame = 300 * tables::kMillisecond});
  const RawClient slow(bench.port);
  const Bytes frame = RawClient::frame(1, Bytes(200, 3));
  pollfd waiting{slow.descriptor(), POLLIN, 0};
  std::size_t sent = 0;
  for (; sent < frame.size() && ::poll(&waiting, 1, 20) == 0; ++sent) slow.send({frame[sent]});
  CHECK(sent < frame.size());
  CHECK(slow.is_closed());
}

TEST_CASE("A slow frame within the time is answered, and so are many in sequence") {
  const EchoServer bench({.frame = 3 * tables::kSecond});
  const RawClient slow(bench.port);
  const Bytes frame = RawClient::frame(1, kAsked);
  // Each segment ends one frame and begins the next: bytes are always left over, for longer than the time of one.
  slow.send({frame[0]});
  for (int i = 0; i < 60; ++i) {
    Bytes part(frame.begin() + 1, frame.end());
    part.push_back(frame[0]);
    slow.send(part);
    REQUIRE(slow.receive(frame.size()) == frame);
    ::poll(nullptr, 0, 60);
  }
}

TEST_CASE("A client without any request is closed before one with an old request") {
  const EchoServer bench({.connections = 3});
  RawClient steady(bench.port);
  REQUIRE(steady.ask(kAsked) == kAsked);
  for (int i = 0; i < 50; ++i) {
    const RawClient passing(bench.port);
    passing.send({0, 1, 0});
  }
  CHECK(steady.ask(kAsked) == kAsked);
}

TEST_CASE("Clients closed for lack of room are counted, those that disconnect are not") {
  const EchoServer bench({.connections = 2});
  RawClient first(bench.port);
  REQUIRE(first.ask(kAsked) == kAsked);
  {
    RawClient passing(bench.port);
    REQUIRE(passing.ask(kAsked) == kAsked);
  }
  bench.wait_for_connections(1);
  CHECK(bench.server.crowded_out() == 0);
  RawClient second(bench.port);
  REQUIRE(second.ask(kAsked) == kAsked);
  RawClient third(bench.port);
  REQUIRE(third.ask(kAsked) == kAsked);
  CHECK(first.is_closed());
  CHECK(bench.server.crowded_out() == 1);
}

TEST_CASE("A client on the keep list is never closed for another, if all are kept the new one is closed") {
  const EchoServer bench({.connections = 2, .keep = {"10.1.2.3", "127.0.0.1"}});
  RawClient first(bench.port);
  RawClient second(bench.port);
  REQUIRE(first.ask(kAsked) == kAsked);
  REQUIRE(second.ask(kAsked) == kAsked);
  RawClient third(bench.port);
  CHECK(third.is_closed());
  CHECK(bench.server.crowded_out() == 1);
  CHECK(first.ask(kAsked) == kAsked);
  CHECK(second.ask(kAsked) == kAsked);
  CHECK(bench.server.connections() == 2);
}

TEST_CASE("A failed accept never closes an active client, and at most one silent client") {
  const EchoServer bench({});
  std::vector<RawClient> asking;
  for (int i = 0; i < 8; ++i) {
    asking.emplace_back(bench.port);
    REQUIRE(asking.back().ask(kAsked) == kAsked);
  }
  const RawClient silent(bench.port);
  const RawClient also_silent(bench.port);
  bench.wait_for_connections(10);
  const Descriptor late(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(bench.port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  {
    const NoDescriptors none;
    REQUIRE(::connect(late.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    // The server's thread runs between two of these, and again after each pause.
    for (int i = 0; i < 30; ++i) {
      for (RawClient& client : asking) REQUIRE(client.ask(kAsked) == kAsked);
      ::poll(nullptr, 0, 10);
    }
    CHECK(bench.server.connections() == 9);
  }
  bench.wait_for_connections(10);
  for (RawClient& client : asking) CHECK(client.ask(kAsked) == kAsked);
}

TEST_CASE("A server closes a client only if its own descriptors run out, and no fault ends its listening") {
  CHECK(after_accept(EMFILE) == AfterAccept::give_way);
  CHECK(after_accept(EAGAIN) == AfterAccept::serve);
  for (const int error : {ENFILE, ENOMEM, ENOBUFS, EBADF}) CHECK(after_accept(error) == AfterAccept::pause);
  for (const int error : {EINTR, ECONNABORTED, EPERM, EPROTO, ENETDOWN, EHOSTUNREACH, ENETUNREACH}) {
    CHECK(after_accept(error) == AfterAccept::again);
  }
}

TEST_CASE("Keepalive probes silent clients, and unacknowledged data time out") {
  const EchoServer bench({});
  RawClient client(bench.port);
  REQUIRE(client.ask(kAsked) == kAsked);
  const int socket = server_end(client);
  REQUIRE(socket >= 0);
  CHECK(option(socket, SOL_SOCKET, SO_KEEPALIVE) == 1);
  CHECK(option(socket, IPPROTO_TCP, TCP_KEEPIDLE) == 10);
  CHECK(option(socket, IPPROTO_TCP, TCP_KEEPINTVL) == 5);
  CHECK(option(socket, IPPROTO_TCP, TCP_KEEPCNT) == 3);
  CHECK(option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT) == 25'000);
  CHECK(option(socket, IPPROTO_TCP, TCP_NODELAY) == 1);
}

TEST_CASE("The descriptor limit is raised for the allowed clients, up to the hard limit") {
  CHECK(limit_for({1024, 4096}, 2000) == 3024);
  CHECK(limit_for({1024, RLIM_INFINITY}, 10'000) == 11'024);
  CHECK(limit_for({1024, 4096}, 4000) == 4096);
  CHECK(limit_for({1024, 1024}, 32) == 1024);
  CHECK_FALSE(limit_for({1024, 4096}, 4090));
  CHECK_FALSE(limit_for({1024, 4096}, 10'000));
}

TEST_CASE("A server has room for all its clients if the soft limit does not") {
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  if (before.rlim_max < 1000) return;
  const rlimit low{100, before.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &low);
  {
    const EchoServer bench({.connections = 300});
    std::vector<RawClient> clients;
    for (int i = 0; i < 150; ++i) {
      clients.emplace_back(bench.port);
      REQUIRE(clients.back().ask(kAsked) == kAsked);
    }
    CHECK(bench.server.connections() == 150);
  }
  ::setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("A server whose clients exceed the limit reports it at its start") {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_max > 100'000'000) return;
  CHECK_THROWS_WITH(EchoServer({.connections = limit.rlim_max}),
                    Catch::Matchers::ContainsSubstring("give fewer `connections`"));
}

TEST_CASE("Two thousand clients at once are served, on descriptors above 1024, and leave none open") {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  const rlimit before = limit;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur < 5000) return;
  const std::size_t descriptors = open_descriptors();
  {
    const EchoServer bench({.connections = 2000});
    std::vector<RawClient> clients;
    for (int i = 0; i < 2000; ++i) {
      clients.emplace_back(bench.port);
      REQUIRE(clients.back().ask(kAsked) == kAsked);
    }
    for (RawClient& client : clients) REQUIRE(client.ask(kAsked) == kAsked);
    CHECK(bench.server.connections() == 2000);
    clients.clear();
    bench.wait_for_connections(0);
  }
  CHECK(open_descriptors() == descriptors);
  ::setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("Five thousand short connections leave no descriptor open, and a steady one is served") {
  const EchoServer bench({.connections = 8});
  RawClient steady(bench.port);
  REQUIRE(steady.ask(kAsked) == kAsked);
  const std::size_t descriptors = open_descriptors();
  for (int i = 0; i < 5000; ++i) {
    const RawClient passing(bench.port);
    passing.send(RawClient::frame(1, kAsked));
    const linger at_once{1, 0};
    if (i % 2 == 0) ::setsockopt(passing.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    if (i % 4 == 0) REQUIRE(steady.ask(kAsked) == kAsked);
  }
  // Connections are accepted in order: once the last one has its answer, their number only falls.
  REQUIRE(RawClient(bench.port).ask(kAsked) == kAsked);
  bench.wait_for_connections(1);
  CHECK(open_descriptors() == descriptors);
}

TEST_CASE("A client that has closed its sending side still gets all its answers, also if it reads late") {
  const EchoServer bench({});
  RawClient client(bench.port);
  REQUIRE(client.ask(kAsked) == kAsked);
  // The client takes so little that answers still wait when the end of the requests is read.
  const int small = 4608;
  ::setsockopt(server_end(client), SOL_SOCKET, SO_SNDBUF, &small, sizeof small);
  const Bytes frame = RawClient::frame(1, Bytes(250, 3));
  constexpr std::size_t kRequests = 5'000;
  std::thread sender([&] {
    for (std::size_t i = 0; i < kRequests; ++i) client.send(frame);
    ::shutdown(client.descriptor(), SHUT_WR);
  });
  ::poll(nullptr, 0, 300);
  std::size_t answers = 0;
  for (; answers < kRequests; ++answers) {
    const Bytes header = client.receive(7);
    if (header.size() != 7) break;
    client.receive(static_cast<std::size_t>(header[5]) - 1);
  }
  sender.join();
  CHECK(answers == kRequests);
  CHECK(client.is_closed());
}
