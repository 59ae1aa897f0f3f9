// Checks that need more than one frame and its answer, by their names in the table.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "player.hpp"

namespace symplant::conformance {

namespace {

using test::RawClient;

constexpr auto kFrameApart = std::chrono::microseconds(300);  ///< so that parts arrive in separate segments

const Bytes kRead = {1, 0, 0, 0, 8};
const Bytes kReadAnswer = {1, 1, 0x49};  // coils 0, 3 and 6

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The next frames must be these answers; their transaction numbers count from `first`.
std::string expect(const RawClient& client, const std::vector<Bytes>& answers, int first = 1) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Seen seen = next_frame(client);
    if (seen.kind != Seen::Kind::frame) return seen.text() + " after " + std::to_string(i) + " frames";
    if (seen.transaction != first + static_cast<int>(i)) return "another transaction's answer";
    if (seen.pdu != answers[i]) return seen.text();
  }
  return {};
}

std::string served(RawClient& client) {
  const Bytes seen = client.ask(kRead);
  if (seen == kReadAnswer) return {};
  return seen.empty() ? "no answer" : hex(seen);
}

/// Four requests of different lengths, which leave memory unchanged, and their answers.
struct Mixed {
  std::vector<Bytes> frames;
  std::vector<Bytes> answers;

  explicit Mixed(int count) {
    const std::vector<Bytes> requests = {
        kRead, {6, 0, 0, 0, 1}, {16, 0, 1, 0, 2, 4, 0, 8, 0, 15}, {3, 0, 0, 0, 3}, {3, 0, 0, 0, 0}};
    const std::vector<Bytes> replies = {
        kReadAnswer, {6, 0, 0, 0, 1}, {16, 0, 1, 0, 2}, {3, 6, 0, 1, 0, 8, 0, 15}, {0x83, 3}};
    for (int i = 0; i < count; ++i) {
      const auto which = static_cast<std::size_t>(i) % requests.size();
      frames.push_back(RawClient::frame(i + 1, requests[which]));
      answers.push_back(replies[which]);
    }
  }
};

std::string codes_unserved(const Server& server, Memory&) {
  const std::vector<int> others = {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 15, 16, 17, 22, 23, 43};
  RawClient client = connect_to(server);
  for (int code = 1; code < 128; ++code) {
    if (std::count(others.begin(), others.end(), code) != 0) continue;
    // A server may support files (20, 21) and the queue (24): from other servers any answer is valid.
    if (!server.strict && (code == 20 || code == 21 || code == 24)) continue;
    Bytes request(code % 16 == 9 ? 1 : 5, 0);  // some requests have no data
    request[0] = static_cast<std::uint8_t>(code);
    const Bytes seen = client.ask(request);
    if (seen == Bytes{static_cast<std::uint8_t>(code | 0x80), 1}) continue;
    return "code " + std::to_string(code) + ": " + (seen.empty() ? "no answer" : hex(seen));
  }
  return {};
}

std::string codes_reserved(const Server& server, Memory&) {
  RawClient client = connect_to(server);
  for (int code = 128; code < 256; ++code) {
    client.send(
        joined({RawClient::frame(code, {static_cast<std::uint8_t>(code), 0, 0, 0, 1}), RawClient::frame(1, kRead)}));
    Seen seen = next_frame(client);
    if (seen.transaction == code && seen.pdu == Bytes{static_cast<std::uint8_t>(code), 1}) seen = next_frame(client);
    if (seen.transaction != 1 || seen.pdu != kReadAnswer) return "code " + std::to_string(code) + ": " + seen.text();
  }
  return {};
}

std::string one_byte(const Server& server, Memory&) {
  const RawClient client = connect_to(server);
  const Mixed mixed(5);
  for (const std::uint8_t byte : joined(mixed.frames)) {
    client.send({byte});
    std::this_thread::sleep_for(kFrameApart);
  }
  return expect(client, mixed.answers);
}

std::string split_everywhere(const Server& server, Memory&) {
  const RawClient client = connect_to(server);
  const Mixed mixed(3);
  const Bytes all = joined(mixed.frames);
  for (std::size_t at = 1; at < all.size(); ++at) {
    client.send(Bytes(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at)));
    std::this_thread::sleep_for(kFrameApart);
    client.send(Bytes(all.begin() + static_cast<std::ptrdiff_t>(at), all.end()));
    const std::string fault = expect(client, mixed.answers);
    if (!fault.empty()) return fault;
  }
  return {};
}

std::string in_one_segment(const Server& server, int count) {
  const RawClient client = connect_to(server);
  const Mixed mixed(count);
  client.send(joined(mixed.frames));
  return expect(client, mixed.answers);
}

std::string pipeline(const Server& server, Memory&) {
  constexpr int kOutstanding = 16;
  constexpr int kAll = 400;
  const RawClient client = connect_to(server);
  const Mixed mixed(kAll);
  client.send(joined({mixed.frames.begin(), mixed.frames.begin() + kOutstanding}));
  for (int i = 0; i < kAll; ++i) {
    const std::string fault = expect(client, {mixed.answers[static_cast<std::size_t>(i)]}, i + 1);
    if (!fault.empty()) return fault;
    if (i + kOutstanding < kAll) client.send(mixed.frames[static_cast<std::size_t>(i + kOutstanding)]);
  }
  return {};
}

std::string deaf(const Server& server, Memory& memory) {
  constexpr int kRequests = 30'000;  // 7.8 MB of answers: more than socket buffers hold
  const RawClient client = connect_to(server);
  std::atomic<int> sent{0};
  std::thread sender([&] {
    for (int i = 0; i < kRequests; ++i, ++sent) client.send(RawClient::frame(i & 0xFFFF, {3, 0, 0, 0, 125}));
  });
  // Until all is sent, or the server has accepted no data for two seconds.
  for (int before = -1, still = 0; sent < kRequests && still < 4; still = sent == before ? still + 1 : 0) {
    before = sent;
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
  int busy = 0;
  std::string fault;
  for (int i = 0; i < kRequests && fault.empty(); ++i) {
    const Seen seen = next_frame(client);
    if (seen.kind != Seen::Kind::frame) fault = seen.text();
    const bool whole = seen.pdu.size() == 252 && seen.pdu[0] == 3 && seen.pdu[3] == memory.registers[0];
    const bool refused = seen.pdu == Bytes{0x83, 6};
    if (fault.empty() && (seen.transaction != i || !(whole || refused))) fault = "answers lost";
    if (refused) ++busy;
  }
  if (!fault.empty()) ::shutdown(client.descriptor(), SHUT_RDWR);
  sender.join();
  if (fault.empty() && server.strict && busy == 0) return "never 06";
  return fault;
}

std::string half_close(const Server& server, Memory&) {
  const RawClient client = connect_to(server);
  const Mixed mixed(10);
  client.send(joined(mixed.frames));
  ::shutdown(client.descriptor(), SHUT_WR);
  const std::string fault = expect(client, mixed.answers);
  if (!fault.empty()) return fault;
  return client.is_closed() ? "" : "not closed";
}

std::string kept(const Server& server, Memory&) {
  RawClient client = connect_to(server);
  for (int i = 0; i < 3; ++i) {
    const std::string fault = served(client);
    if (!fault.empty()) return fault;
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
  }
  return {};
}

std::string many(const Server& server, Memory&) {
  std::vector<RawClient> clients;
  for (int i = 0; i < 16; ++i) clients.push_back(connect_to(server));
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = 0; i < clients.size(); ++i) {
      clients[i].send(RawClient::frame(static_cast<int>(i), {3, 0, static_cast<std::uint8_t>(i), 0, 1}));
    }
    for (std::size_t i = 0; i < clients.size(); ++i) {
      const std::string fault =
          expect(clients[i], {{3, 2, 0, static_cast<std::uint8_t>(7 * i + 1)}}, static_cast<int>(i));
      if (!fault.empty()) return fault;
    }
  }
  return {};
}

std::string full(const Server& server, Memory&) {
  RawClient used = connect_to(server);
  std::vector<RawClient> others;
  for (int i = 0; i < 60; ++i) {
    others.push_back(connect_to(server));
    std::string fault = served(others.back());
    if (!fault.empty()) return "the newest: " + fault;
    fault = served(used);
    if (!fault.empty()) return "the used one: " + fault;
  }
  return {};
}

std::string storm(const Server& server, Memory&) {
  RawClient steady = connect_to(server);
  for (int i = 0; i < 2000; ++i) {
    const RawClient passing = connect_to(server);
    if (!passing.connected()) return "refused";
    passing.send(RawClient::frame(1, kRead));
    const linger at_once{1, 0};
    if (i % 2 == 0) ::setsockopt(passing.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    const std::string fault = i % 10 == 0 ? served(steady) : "";
    if (!fault.empty()) return fault;
  }
  return served(steady);
}

std::string partial(const Server& server, Memory&) {
  std::vector<RawClient> stuck;
  for (const std::size_t size : {1U, 6U, 7U, 9U, 11U}) {
    stuck.push_back(connect_to(server));
    const Bytes frame = RawClient::frame(1, kRead);
    stuck.back().send(Bytes(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  RawClient client = connect_to(server);
  return served(client);
}

}  // namespace

std::string play_procedure(const std::string& name, const Server& server, Memory& memory) {
  if (name == "codes-unserved") return codes_unserved(server, memory);
  if (name == "codes-reserved") return codes_reserved(server, memory);
  if (name == "one-byte") return one_byte(server, memory);
  if (name == "split") return split_everywhere(server, memory);
  if (name == "segment") return in_one_segment(server, 16);
  if (name == "64") return in_one_segment(server, 64);
  if (name == "pipeline") return pipeline(server, memory);
  if (name == "deaf") return deaf(server, memory);
  if (name == "half-close") return half_close(server, memory);
  if (name == "kept") return kept(server, memory);
  if (name == "many") return many(server, memory);
  if (name == "full") return full(server, memory);
  if (name == "storm") return storm(server, memory);
  if (name == "partial") return partial(server, memory);
  throw std::runtime_error("there is no procedure `" + name + "`");
}

}  // namespace symplant::conformance
