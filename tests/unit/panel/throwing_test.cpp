// Whatever a request makes the program throw, the client gets an answer and the server goes on.
#include <stdexcept>

#include "support/strings.hpp"
#include "unit/panel/panel_bench.hpp"
#include "unit/panel/served_source.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A request whose address does not begin with a slash is an error, and the next one is answered") {
  const PanelBench bench;
  for (const std::string target : {"?", "?x", "??", "x", "*", "http://127.0.0.1/", "%3f", "%2f%", "//", "/?", "/%00"}) {
    INFO(target);
    const int status = bench.send(bench.request("GET", target)).status;
    CHECK((status == 400 || status == 404 || (status == 200 && target == "/?")));
    const int posted = bench.send(bench.request("POST", target, "{}")).status;
    CHECK(posted == 404);
    CHECK(bench.send(bench.request("GET", "/api/v1/picture")).status == 200);
  }
}

TEST_CASE("What a source throws is an answer 500 and a message, and the next request is answered") {
  ServedSource served;
  served.source.answer_get = [](const panel::Answered&) -> std::optional<panel::Reply> {
    throw std::out_of_range("a planted error");
  };
  served.begin();
  HttpClient client(served.port);
  client.send(served.request("GET", "/api/v1/chart?symbols=1"));
  const HttpAnswer failed = client.answer();
  CHECK(failed.status == 500);
  CHECK(contains(failed.head, "Content-Type: application/json\r\n"));
  CHECK(contains(failed.body, "{\"error\":\""));
  client.send(served.request("GET", "/api/v1/picture"));
  CHECK(client.answer().status == 200);
  const std::vector<std::string> messages = served.messages();
  REQUIRE(messages.size() == 1);
  CHECK(contains(messages[0], "`GET /api/v1/chart?symbols=1` failed by an error of symplant: a planted error"));
}

TEST_CASE("Errors one after the other are logged once, and counted in the next message") {
  std::vector<std::string> messages;
  panel::Guard guard([&](const std::string& message) { messages.push_back(message); });
  for (int i = 0; i < 100; ++i) CHECK_FALSE(guard.run("GET /", [] { throw 5; }));
  CHECK(messages.size() == 1);
  CHECK(guard.run("GET /", [] {}));
  panel::Guard mute(nullptr);
  CHECK_FALSE(mute.run("GET /", [] { throw std::bad_alloc(); }));
  panel::Guard failing([](const std::string&) { throw std::runtime_error("no terminal"); });
  CHECK_FALSE(failing.run("GET /", [] { throw 5; }));
}

TEST_CASE("A message about a request has no control characters, and not all of a long address") {
  std::string message;
  panel::Guard guard([&](const std::string& text) { message = text; });
  guard.run("GET /\x1b[31m\xe2\x80\xae" + std::string(5000, 'x'), [] { throw std::runtime_error("line\nline"); });
  CHECK(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  CHECK(message.size() < 400);
}

TEST_CASE("An act whose answer is lost is an answer 500") {
  ServedSource served;
  served.source.answer_post = [](const panel::Answered&) {};  // `later` is destroyed without a call
  served.begin();
  CHECK(served.send(served.request("POST", "/api/v1/acts", "", "{}")).status == 500);
  CHECK(served.get("/api/v1/picture").status == 200);
}

TEST_CASE("An act that throws after its answer has one answer") {
  ServedSource served;
  served.source.answer_post = [](const panel::Answered& later) {
    later({200, "{}"});
    throw std::runtime_error("late");
  };
  served.begin();
  HttpClient client(served.port);
  for (int i = 0; i < 3; ++i) {
    client.send(served.request("POST", "/api/v1/check", "", "{}"));
    CHECK(client.answer().body == "{}");
  }
}

TEST_CASE("A stream whose picture or changes throw ends or waits, and the server goes on") {
  ServedSource served;
  std::atomic<bool> throws{true};
  served.source.make_picture = [&]() -> std::string {
    if (throws) throw std::runtime_error("no picture");
    return "{}";
  };
  served.source.make_changes = [&]() -> std::string {
    if (throws) throw std::runtime_error("no changes");
    return "{\"x\":1}";
  };
  served.begin();
  CHECK(served.get("/api/v1/stream").status == 500);
  CHECK(served.get("/api/v1/picture").status == 500);
  throws = false;
  HttpClient stream(served.port);
  stream.send(served.request("GET", "/api/v1/stream"));
  CHECK(contains(stream.read_until("event: picture"), "200 OK"));
  throws = true;
  CHECK(served.get("/api/v1/picture").status == 500);
  throws = false;
  CHECK(contains(stream.read_until("event: changes"), "event: changes"));
}

}  // namespace
}  // namespace symplant::test
