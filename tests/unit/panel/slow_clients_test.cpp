// Clients that read slowly or never: what they cost, when they are closed, and that others are served.
#include <unistd.h>

#include <fstream>
#include <list>

#include "support/strings.hpp"
#include "unit/panel/served_source.hpp"

namespace symplant::test {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

/// The memory that this process has now.
std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  file >> pages >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Whether the server has reset the connection, whatever is still to be read.
bool is_reset(HttpClient& client) {
  pollfd state{client.raw().descriptor(), 0, 0};
  return ::poll(&state, 1, 0) == 1 && (state.revents & (POLLHUP | POLLERR)) != 0;
}

TEST_CASE("The description is made once and shared, however many clients do not read it") {
  ServedSource served;
  served.source.description_size = 16 * kMiB;
  served.begin();
  CHECK(served.get("/api/v1/plant").body.size() > 16 * kMiB);
  const std::size_t before = resident_bytes();
  std::list<HttpClient> crowd;
  for (int i = 0; i < 60; ++i) {
    crowd.emplace_back(served.port);
    crowd.back().send(served.request("GET", "/api/v1/plant", i % 2 == 0 ? "" : "Accept-Encoding: gzip\r\n"));
    CHECK(contains(crowd.back().read_until("\r\n\r\n"), "200 OK"));
  }
  CHECK(served.source.described == 1);
  CHECK(resident_bytes() < before + 100 * kMiB);  // 60 copies are 960 MiB
}

TEST_CASE("A slow client gets all of an answer that takes longer than the patience") {
  ServedSource served(2);
  served.source.description_size = 4 * kMiB;
  served.begin();
  HttpClient slow(served.port, 4096);
  slow.send(served.request("GET", "/api/v1/plant"));
  CHECK(contains(slow.read_until("\r\n\r\n"), "200 OK"));
  std::size_t received = 0;
  for (;;) {
    const std::size_t count = slow.raw().receive(64 * 1024).size();
    if (count == 0) break;
    received += count;
    if (received >= 4 * kMiB) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  CHECK(received >= 4 * kMiB - 64 * 1024);  // what came with the head was received before
}

TEST_CASE("A client that never reads its answer is closed after the patience") {
  ServedSource served(1);
  served.source.description_size = 8 * kMiB;
  served.begin();
  HttpClient silent(served.port);
  silent.send(served.request("GET", "/api/v1/plant"));
  served.wait_for([&] { return is_reset(silent); });
}

TEST_CASE("The bytes that wait for all clients together are limited, and the slowest clients are closed") {
  ServedSource served;
  served.source.make_picture = [] { return std::string(4 * kMiB, ' '); };
  served.begin();
  std::list<HttpClient> crowd;
  for (int i = 0; i < 50; ++i) {
    crowd.emplace_back(served.port);
    crowd.back().send(served.request("GET", "/api/v1/picture"));
  }
  served.wait_for([&] {
    const HttpAnswer answer = served.get("/api/v1/picture");
    return answer.status == 200 && answer.body.size() == 4 * kMiB;
  });
  std::size_t complete = 0;
  for (HttpClient& client : crowd) complete += client.answer().body.size() == 4 * kMiB ? 1U : 0U;
  CHECK(complete <= 17);  // 64 MiB and one answer; of 50
}

TEST_CASE("Clients that never read do not keep others out") {
  ServedSource served(30);
  served.source.description_size = 8 * kMiB;
  served.begin();
  std::list<HttpClient> crowd;
  for (int i = 0; i < 64; ++i) {
    crowd.emplace_back(served.port);
    crowd.back().send(served.request("GET", "/api/v1/plant"));
    CHECK(contains(crowd.back().read_until("\r\n\r\n"), "200 OK"));
  }
  served.wait_for([&] { return served.get("/api/v1/openapi.json").status == 200; });
  std::size_t closed = 0;
  for (HttpClient& client : crowd) closed += is_reset(client) ? 1U : 0U;
  CHECK(closed >= 1);
}

/// Opens a stream and reads its head and first event.
std::string open_stream(HttpClient& client, const std::string& request) {
  client.send(request);
  return client.read_until("event: picture");
}

TEST_CASE("Silent streams are closed though all that they are sent fits into their buffers, and a reader stays") {
  ServedSource served(1);
  served.begin();
  const std::string request = served.request("GET", "/api/v1/stream");
  HttpClient reader(served.port);
  CHECK(contains(open_stream(reader, request), "200 OK"));
  std::list<HttpClient> silent;
  for (int i = 0; i < 7; ++i) {
    silent.emplace_back(served.port);
    CHECK(contains(open_stream(silent.back(), request), "200 OK"));
  }
  CHECK(served.send(request).status == 503);
  std::list<HttpClient> more;
  served.wait_for([&] {
    char bytes[65536];
    while (::recv(reader.raw().descriptor(), bytes, sizeof bytes, MSG_DONTWAIT) > 0) {
    }
    more.emplace_back(served.port);
    return contains(open_stream(more.back(), request), "200 OK");
  });
  CHECK(!is_reset(reader));
  CHECK(contains(reader.read_until(":\n"), ":\n"));  // a comment, though nothing changes
}

TEST_CASE("Four of eight streams are for clients with the token") {
  ServedSource served;
  served.begin();
  const std::string with = served.request("GET", "/api/v1/stream");
  std::string without = with;
  const std::size_t begin = without.find("Authorization");
  without.erase(begin, without.find("\r\n", begin) + 2 - begin);
  std::list<HttpClient> streams;
  const auto opens = [&](const std::string& request) {
    streams.emplace_back(served.port);
    return contains(open_stream(streams.back(), request), "200 OK");
  };
  for (int i = 0; i < 4; ++i) CHECK(opens(without));
  const HttpAnswer refused = served.send(without);
  CHECK(refused.status == 503);
  CHECK(contains(refused.body, "4 clients without a token look already"));
  for (int i = 0; i < 4; ++i) CHECK(opens(with));
  CHECK(served.send(with).status == 503);
  streams.pop_back();
  served.wait_for([&] { return opens(with); });
  streams.clear();
  served.wait_for([&] { return opens(with); });  // without others, the token may have all eight
  for (int i = 0; i < 7; ++i) served.wait_for([&] { return opens(with); });
}

}  // namespace
}  // namespace symplant::test
