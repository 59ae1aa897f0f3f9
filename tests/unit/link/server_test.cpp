// The Modbus TCP server over real sockets on the loopback.
#include "symplant/link/modbus/server.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <csignal>

#include "support/catch.hpp"
#include "unit/link/plant_server.hpp"
#include "unit/link/symbol_list.hpp"

using namespace symplant;
using test::Bytes;
using test::CellServer;
using test::open_descriptors;
using test::RawClient;

namespace {

const Bytes kReadInputs = {2, 0, 1, 0, 4};

}  // namespace

TEST_CASE("A client drives the cell over TCP") {
  CellServer server;
  RawClient client(server.port());
  REQUIRE(client.connected());
  CHECK(client.ask(kReadInputs) == Bytes{2, 1, 0b0101});
  CHECK(client.ask({5, 0, 1, 0xFF, 0}) == Bytes{5, 0, 1, 0xFF, 0});
  server.cycle(10 * tables::kMillisecond);
  CHECK(client.ask(kReadInputs) == Bytes{2, 1, 0b0100});
  server.cycle(tables::kSecond);
  CHECK(client.ask(kReadInputs) == Bytes{2, 1, 0b0110});
}

TEST_CASE("The server counts its answers") {
  CellServer server;
  RawClient client(server.port());
  client.ask(kReadInputs);
  client.ask({0x63});
  client.ask({5, 0, 9, 0xFF, 0});
  const auto status = server.link().status();
  CHECK(status.requests == 3);
  CHECK(status.exceptions == 1);
  CHECK(status.writes_to_gaps == 1);
  CHECK(status.connections == 1);
}

TEST_CASE("Single bytes, splits and many frames at once are answered the same over TCP") {
  CellServer server;
  RawClient client(server.port());
  const Bytes one = RawClient::frame(7, kReadInputs);
  const Bytes answer = RawClient::frame(7, {2, 1, 0b0101});
  for (const std::uint8_t byte : one) client.send({byte});
  CHECK(client.receive(answer.size()) == answer);
  for (std::size_t split = 1; split < one.size(); ++split) {
    client.send(Bytes(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(split)));
    client.send(Bytes(one.begin() + static_cast<std::ptrdiff_t>(split), one.end()));
    REQUIRE(client.receive(answer.size()) == answer);
  }
  Bytes many;
  Bytes answers;
  for (int i = 0; i < 64; ++i) {
    many.insert(many.end(), one.begin(), one.end());
    answers.insert(answers.end(), answer.begin(), answer.end());
  }
  client.send(many);
  CHECK(client.receive(answers.size()) == answers);
}

TEST_CASE("An exception does not lose the pipelined request after it") {
  CellServer server;
  RawClient client(server.port());
  Bytes both = RawClient::frame(1, {15, 0, 1, 0, 0, 0});
  const Bytes second = RawClient::frame(2, kReadInputs);
  both.insert(both.end(), second.begin(), second.end());
  client.send(both);
  CHECK(client.receive(9) == RawClient::frame(1, {0x8F, 3}));
  CHECK(client.receive(10) == RawClient::frame(2, {2, 1, 0b0101}));
}

TEST_CASE("A frame of another protocol gets no answer, and a broken one closes only its own connection") {
  CellServer server;
  RawClient good(server.port());
  RawClient bad(server.port());
  bad.send(RawClient::frame(1, kReadInputs, 1));
  CHECK(bad.ask(kReadInputs) == Bytes{2, 1, 0b0101});
  bad.send({0, 1, 0, 0, 0xFF, 0xFF});
  CHECK(bad.is_closed());
  CHECK(good.ask(kReadInputs) == Bytes{2, 1, 0b0101});
}

TEST_CASE("Many clients are served at the same time") {
  CellServer server;
  std::vector<std::unique_ptr<RawClient>> clients;
  for (std::size_t i = 0; i < link::modbus::ServerOptions{}.connections; ++i) {
    clients.push_back(std::make_unique<RawClient>(server.port()));
  }
  for (int round = 0; round < 3; ++round) {
    for (const auto& client : clients) REQUIRE(client->ask(kReadInputs) == Bytes{2, 1, 0b0101});
  }
  CHECK(server.link().status().connections == link::modbus::ServerOptions{}.connections);
}

TEST_CASE("The oldest unused connection is closed when all are taken") {
  CellServer server;
  std::vector<std::unique_ptr<RawClient>> clients;
  for (std::size_t i = 0; i < link::modbus::ServerOptions{}.connections; ++i) {
    clients.push_back(std::make_unique<RawClient>(server.port()));
    REQUIRE(clients.back()->ask(kReadInputs).size() == 3);
  }
  // The first is used again; the second sends bytes but no request, which does not count as use.
  REQUIRE(clients[0]->ask(kReadInputs).size() == 3);
  clients[1]->send({0, 1, 0});
  RawClient one_more(server.port());
  CHECK(one_more.ask(kReadInputs) == Bytes{2, 1, 0b0101});
  CHECK(clients[1]->is_closed());
  CHECK(clients[0]->ask(kReadInputs) == Bytes{2, 1, 0b0101});
  CHECK(clients[2]->ask(kReadInputs) == Bytes{2, 1, 0b0101});
}

TEST_CASE("The number of clients and the keep list are settings of the link") {
  const auto tables = test::cell_tables();
  link::LinkChoice choice{"modbus-tcp-server://127.0.0.1:0"};
  const std::string_view here = "127.0.0.1";
  choice.settings.connections = 2;
  choice.settings.keep = std::span(&here, 1);
  auto opened = link::open_link(choice, tables);
  const auto link = std::move(std::get<std::unique_ptr<link::Link>>(opened));
  RawClient first(test::port_of(*link));
  RawClient second(test::port_of(*link));
  REQUIRE(first.ask(kReadInputs).size() == 3);
  REQUIRE(second.ask(kReadInputs).size() == 3);
  const RawClient third(test::port_of(*link));
  CHECK(third.is_closed());
  CHECK(first.ask(kReadInputs).size() == 3);
}

TEST_CASE("A client that disconnects while answers are being sent affects only itself") {
  CellServer server;
  {
    RawClient rude(server.port());
    for (int i = 0; i < 200; ++i) rude.send(RawClient::frame(i, kReadInputs));
    const linger at_once{1, 0};  // a reset instead of an orderly end
    ::setsockopt(rude.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  }
  RawClient client(server.port());
  CHECK(client.ask(kReadInputs) == Bytes{2, 1, 0b0101});
}

TEST_CASE("A client that never reads does not delay the answers of others") {
  CellServer server;
  RawClient deaf(server.port());
  const int small = 4096;
  ::setsockopt(deaf.descriptor(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  Bytes many;
  for (int i = 0; i < 5000; ++i) {
    const Bytes one = RawClient::frame(i, kReadInputs);
    many.insert(many.end(), one.begin(), one.end());
  }
  // Non-blocking: at some point the socket takes no more, as intended.
  for (int i = 0; i < 200; ++i) ::send(deaf.descriptor(), many.data(), many.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  RawClient client(server.port());
  for (int i = 0; i < 10; ++i) REQUIRE(client.ask(kReadInputs) == Bytes{2, 1, 0b0101});
}

TEST_CASE("A client that reads late gets an answer to every request, in order") {
  constexpr std::size_t kRequests = 60'000;
  test::SymbolList list;
  list.add("LAST", test::SymbolList::kOut, 124, tables::DataType::word);
  const auto tables = list.tables();
  const auto link = test::open_or_throw("modbus-tcp-server://127.0.0.1:0", tables);
  RawClient client(test::port_of(*link));
  // More answers than the sockets hold: the sender blocks until the client reads.
  std::thread sender([&client] {
    for (std::size_t i = 0; i < kRequests; ++i) client.send(RawClient::frame(static_cast<int>(i), {3, 0, 0, 0, 125}));
  });
  while (link->status().exceptions == 0) std::this_thread::yield();

  std::size_t in_order = 0;
  std::size_t served = 0;
  std::size_t busy = 0;
  for (std::size_t i = 0; i < kRequests; ++i) {
    const Bytes header = client.receive(7);
    if (header.size() != 7) break;
    const Bytes pdu = client.receive(static_cast<std::size_t>(header[5]) - 1);
    in_order += header[0] == i >> 8 && header[1] == (i & 0xFF) ? 1U : 0U;
    served += pdu.size() == 252 && pdu[0] == 3 ? 1U : 0U;
    busy += pdu == Bytes{0x83, 6} ? 1U : 0U;
  }
  sender.join();
  CHECK(in_order == kRequests);
  CHECK(busy > 0);
  CHECK(served + busy == kRequests);
}

TEST_CASE("The server works on descriptors above 1024") {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  const rlimit before = limit;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur < 3000) return;
  std::vector<link::net::Descriptor> fill;
  for (int i = 0; i < 2000; ++i) fill.emplace_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  {
    CellServer server;
    RawClient client(server.port());
    CHECK(client.descriptor() > 1024);
    CHECK(client.ask(kReadInputs) == Bytes{2, 1, 0b0101});
  }
  fill.clear();
  ::setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("A server starts and stops a thousand times on one port, with clients, and leaves nothing open") {
  const auto tables = test::cell_tables();
  std::string url = "modbus-tcp-server://127.0.0.1:0";
  const std::size_t descriptors = open_descriptors();
  int taken = 0;
  for (int i = 0; i < 1000; ++i) {
    auto result = link::open_link({url}, tables);
    if (std::holds_alternative<link::LinkError>(result)) {
      ++taken;  // by another program's connection in the meantime
      result = link::open_link({"modbus-tcp-server://127.0.0.1:0"}, tables);
    }
    auto& link = std::get<std::unique_ptr<link::Link>>(result);
    url = link->url();
    RawClient client(test::port_of(*link));
    REQUIRE(client.connected());
    if (i % 10 == 0) REQUIRE(client.ask(kReadInputs).size() == 3);
    link.reset();  // before the client: so the server's end still holds the port at the next start
  }
  CHECK(taken < 5);
  CHECK(open_descriptors() == descriptors);
}

TEST_CASE("Stopping closes the connections of idle clients") {
  auto server = std::make_unique<CellServer>();
  RawClient client(server->port());
  REQUIRE(client.ask(kReadInputs).size() == 3);
  server.reset();
  CHECK(client.is_closed());
}

TEST_CASE("The server's thread leaves signals to its host") {
  CellServer server;
  sigset_t now;
  ::pthread_sigmask(SIG_SETMASK, nullptr, &now);
  CHECK(::sigismember(&now, SIGTERM) == 0);  // starting it did not change the caller's
}

TEST_CASE("A PLC program over TCP completes a cycle of the cell while plant and server run") {
  CellServer server;
  server.start_cycling();
  RawClient plc(server.port());
  const auto wait_for = [&](std::uint8_t inputs) {
    for (int tries = 0; tries < 1'000'000; ++tries) {
      const Bytes answer = plc.ask(kReadInputs);
      if (answer.size() != 3) return false;
      if (answer[2] == inputs) return true;
    }
    return false;
  };
  const auto write = [&](std::uint8_t coils) { plc.ask({15, 0, 1, 0, 4, 1, coils}); };
  write(0b0001);
  CHECK(wait_for(0b0110));
  write(0b1000);
  CHECK(wait_for(0b1010));
  write(0b0100);
  CHECK(wait_for(0b0110));
  write(0b0010);
  CHECK(wait_for(0b0101));
}
