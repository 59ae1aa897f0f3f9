// Random requests to a running panel: none ends it, and each answer is one of the interface.
#include <cstdlib>
#include <random>
#include <set>

#include "fuzz/http_plant.hpp"
#include "unit/panel/panel_bench.hpp"
#include "unit/panel/request_corpus.hpp"

namespace symplant::test {
namespace {

/// SYMPLANT_REQUESTS, or 1,000.
int request_count() {
  const char* const given = std::getenv("SYMPLANT_REQUESTS");
  return given == nullptr ? 1000 : std::atoi(given);
}

/// The seeds as requests to this panel.
std::vector<std::string> requests_to(const PanelBench& bench) {
  std::vector<std::string> requests;
  const std::pair<std::string, std::string> changes[] = {
      {std::string(fuzz::kSeedToken), bench.token},
      {"Run: " + std::string(fuzz::kSeedRun), "Run: " + bench.run},
      {":8137", ":" + std::to_string(bench.port)},
  };
  for (const auto& [name, seed] : request_seeds()) {
    std::string request = fuzz::sent_text(seed);
    for (const auto& [from, to] : changes) {
      for (std::size_t at = 0; (at = request.find(from, at)) != std::string::npos; at += to.size()) {
        request.replace(at, from.size(), to);
      }
    }
    requests.push_back(std::move(request));
  }
  return requests;
}

/// Random changes of requests, of the kinds that fuzzers make.
class Damage {
 public:
  explicit Damage(std::uint32_t seed) : random_(seed) {}

  std::string request(const std::vector<std::string>& seeds) {
    std::string text = seeds[below(seeds.size())];
    const std::string& other = seeds[below(seeds.size())];
    for (std::size_t i = below(4); i > 0; --i) change(text, other);
    return text;
  }

 private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

  /// A location; more often in the first line, where the address is.
  std::size_t location(const std::string& text) {
    const std::size_t line = std::min(text.find('\r'), text.size());
    return below(2) == 0 ? below(line + 1) : below(text.size() + 1);
  }

  void change(std::string& text, const std::string& other) {
    static const std::vector<std::string> kWords = {"?",
                                                    "/",
                                                    "%",
                                                    "%00",
                                                    "&",
                                                    "=",
                                                    " ",
                                                    "\r\n",
                                                    "\r\n\r\n",
                                                    ":",
                                                    ",",
                                                    "{",
                                                    "}",
                                                    "[",
                                                    "]",
                                                    "\"",
                                                    "null",
                                                    "-1",
                                                    "1e999",
                                                    "9223372036854775807",
                                                    "GET ",
                                                    "POST ",
                                                    "HEAD ",
                                                    " HTTP/1.1",
                                                    "Host: x\r\n",
                                                    "Transfer-Encoding: chunked\r\n",
                                                    "Content-Length: 0\r\n",
                                                    "Accept-Encoding: gzip\r\n",
                                                    "/api/v1/"};
    const std::size_t at = location(text);
    const std::size_t count = below(2) == 0 ? 1 : below(40);
    switch (below(6)) {
      case 0:
        text.erase(at, count);
        return;
      case 1:
        text.insert(at, kWords[below(kWords.size())]);
        return;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        return;
      case 3:
        text.insert(at, text.substr(location(text), count));
        return;
      case 4:
        text.insert(at, other.substr(location(other), count));
        return;
      default:
        text = text.substr(0, at) + other.substr(location(other));
    }
  }

  std::minstd_rand random_;
};

/// What the server sends before it closes, up to a limit: a stream goes on.
std::string answer_to(std::uint16_t port, const std::string& request) {
  RawClient client(port);
  REQUIRE(client.connected());
  const linger reset{1, 0};  // leaves no waiting port behind
  ::setsockopt(client.descriptor(), SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
  client.send(Bytes(request.begin(), request.end()));
  ::shutdown(client.descriptor(), SHUT_WR);
  std::string answer;
  while (answer.size() < 4096) {
    const Bytes piece = client.receive(1);
    if (piece.empty()) break;
    answer.append(piece.begin(), piece.end());
    char more[4096];
    const ssize_t count = ::recv(client.descriptor(), more, sizeof more, MSG_DONTWAIT);
    if (count > 0) answer.append(more, static_cast<std::size_t>(count));
  }
  return answer;
}

TEST_CASE("Random requests get an answer of the interface or none, and the panel goes on") {
  PanelPlan plan;
  const PanelBench bench(plan);
  const std::vector<std::string> seeds = requests_to(bench);
  REQUIRE(seeds.size() > 20);
  const std::set<std::string> statuses = {"200", "400", "401", "403", "404", "405", "409",
                                          "413", "422", "429", "431", "501", "503"};
  Damage damage(1);
  std::set<std::string> seen;
  for (int i = 0; i < request_count(); ++i) {
    const std::string request = damage.request(seeds);
    const std::string answer = answer_to(bench.port, request);
    if (answer.empty()) continue;
    INFO(i << ": " << request << "\n" << answer);
    REQUIRE(answer.starts_with("HTTP/1.1 "));
    REQUIRE(statuses.count(answer.substr(9, 3)) == 1);
    seen.insert(answer.substr(9, 3));
  }
  CHECK(seen.size() >= 8);
  CHECK(bench.send(bench.request("GET", "/api/v1/picture")).status == 200);
  CHECK(bench.messages().empty());
}

}  // namespace
}  // namespace symplant::test
