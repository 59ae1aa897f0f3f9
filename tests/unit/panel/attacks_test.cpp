// Attacks on the panel. Each test fails if its defense is removed.
#include <filesystem>
#include <list>

#include "symplant/panel/web/page_files.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

const std::string kForce = R"({"force":{"L_P_AGV_I_P2":true}})";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

/// A POST of the page that forces a symbol.
std::string forcing(const PanelBench& bench) {
  return bench.request("POST", "/api/v1/acts", "{\"acts\":[" + kForce + "]}");
}

TEST_CASE("The page itself may act") {
  const PanelBench bench;
  CHECK(bench.send(forcing(bench)).status == 200);
  CHECK(bench.value("AGV_I_P2") == true);
}

TEST_CASE("A page of another origin cannot act or look") {
  const PanelBench bench;
  for (const std::string origin : {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1"}) {
    const std::string header = "\r\nOrigin: " + origin + "\r\n";
    CHECK(bench.send(replaced(forcing(bench), "\r\n", header)).status == 403);
    CHECK(bench.send(replaced(bench.request("GET", "/api/v1/picture"), "\r\n", header)).status == 403);
  }
  const std::string own = "\r\nOrigin: http://127.0.0.1:" + std::to_string(bench.port) + "\r\n";
  CHECK(bench.value("AGV_I_P2") == false);
  CHECK(bench.send(replaced(forcing(bench), "\r\n", own)).status == 200);
}

TEST_CASE("A name that was pointed at this machine (DNS rebinding) is not the panel's") {
  const PanelBench bench;
  const std::string port = std::to_string(bench.port);
  const std::string host = "Host: 127.0.0.1:" + port;
  for (const std::string& name : {"evil.example:" + port, std::string("127.0.0.1:1"), std::string("127.0.0.1"),
                                  "localhost.evil.example:" + port, std::string("")}) {
    INFO(name);
    CHECK(bench.send(replaced(forcing(bench), host, "Host: " + name)).status == 403);
    CHECK(bench.send(replaced(bench.request("GET", "/api/v1/plant"), host, "Host: " + name)).status == 403);
    CHECK(bench.send(replaced(bench.request("GET", "/"), host, "Host: " + name)).status == 403);
  }
  CHECK(bench.value("AGV_I_P2") == false);
  CHECK(bench.send(replaced(forcing(bench), host, "Host: localhost:" + port)).status == 200);
}

TEST_CASE("An act needs the token") {
  const PanelBench bench;
  const std::string header = "Authorization: Bearer " + bench.token + "\r\n";
  std::string other = bench.token;
  other.back() = other.back() == '0' ? '1' : '0';
  for (const std::string& sent :
       {std::string(), "Authorization: Bearer " + other + "\r\n",
        "Authorization: Bearer " + bench.token.substr(1) + "\r\n", "Authorization: Bearer " + bench.token + "0\r\n",
        "Authorization: Basic " + bench.token + "\r\n", "Authorization: Digest " + bench.token + "\r\n",
        std::string("Authorization: Bearer \r\n")}) {
    CHECK(bench.send(replaced(forcing(bench), header, sent)).status == 401);
  }
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("Beyond the loopback, looking needs the token too") {
  PanelPlan plan;
  plan.options.address = "0.0.0.0:0";
  const PanelBench bench(plan);
  const std::string header = "Authorization: Bearer " + bench.token + "\r\n";
  for (const std::string path : {"/api/v1/plant", "/api/v1/picture", "/api/v1/stream", "/api/v1/session/session"}) {
    CHECK(bench.send(replaced(bench.request("GET", path), header, "")).status == 401);
  }
  CHECK(bench.send(bench.request("GET", "/api/v1/picture")).status == 200);
}

TEST_CASE("A body over 64 KiB, and a header over 8 KiB, are refused") {
  const PanelBench bench;
  const std::string large(65 * 1024, ' ');
  CHECK(bench.send(bench.request("POST", "/api/v1/acts", large)).status == 413);
  const std::string long_header = "\r\nX-More: " + std::string(9 * 1024, 'x') + "\r\n";
  CHECK(bench.send(replaced(bench.request("GET", "/"), "\r\n", long_header)).status == 431);
  // Without a length in advance, too.
  HttpClient chunks(bench.port);
  chunks.send(
      replaced(replaced(bench.request("POST", "/api/v1/acts", ""), "Content-Length: 0", "Transfer-Encoding: chunked"),
               "\r\n\r\n", "\r\n\r\n11000\r\n"));
  chunks.send(std::string(0x11000, ' ') + "\r\n0\r\n\r\n");
  CHECK(chunks.answer().status == 413);
}

TEST_CASE("A client that sends its header, or its body, slowly is closed") {
  PanelPlan plan;
  plan.options.patience = 1;
  const PanelBench bench(plan);
  for (const std::string& text : {bench.request("GET", "/"), forcing(bench)}) {
    HttpClient slow(bench.port);
    slow.raw().wait_at_most(20);
    const auto begin = std::chrono::steady_clock::now();
    bool closed = false;
    for (std::size_t i = 0; i + 1 < text.size() && !closed; ++i) {  // a byte each 20 ms: each comes in time
      slow.send(text.substr(i, 1));
      closed = slow.raw().is_closed();
    }
    CHECK(closed);
    CHECK(std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(500));
  }
}

TEST_CASE("A thousand connections leave room for the page, and the descriptors stay bounded") {
  const PanelBench bench;
  const std::size_t before = open_descriptors();
  std::list<HttpClient> crowd;
  for (int i = 0; i < 1000; ++i) {
    crowd.emplace_back(bench.port);
    if (i % 2 == 0) crowd.back().send("GET / HTTP/1.1\r\n");
    while (crowd.size() > 300) crowd.pop_front();
  }
  CHECK(bench.send(bench.request("GET", "/api/v1/picture")).status == 200);
  CHECK(bench.send(forcing(bench)).status == 200);
  // Of both ends of the connections in this process, the server has 64 at most.
  CHECK(open_descriptors() <= before + crowd.size() + 70);
}

TEST_CASE("No more than eight clients get a stream") {
  const PanelBench bench;
  std::list<HttpClient> streams;
  for (int i = 0; i < 8; ++i) {
    streams.emplace_back(bench.port);
    streams.back().send(bench.request("GET", "/api/v1/stream"));
    CHECK(contains(streams.back().read_until("\n\n"), "200 OK"));
  }
  CHECK(bench.send(bench.request("GET", "/api/v1/stream")).status == 503);
  streams.pop_front();
  bench.wait_for([&] {
    HttpClient client(bench.port);
    client.send(bench.request("GET", "/api/v1/stream"));
    return contains(client.read_until("\r\n\r\n"), "200 OK");
  });
}

TEST_CASE("A name cannot climb out of the folder of files") {
  PanelPlan plan;
  const TemporaryFolder outer;
  plan.options.files = outer / "files";
  const PanelBench bench(plan);
  outer.write("secret.snapshot", "x");
  for (const std::string name :
       {"../secret", "..", "/etc/passwd", "a/b", "a\\\\b", ".hidden", "", "a\\u0000b", "C:x"}) {
    INFO(name);
    for (const std::string act : {"snapshot", "save", "restore", "session"}) {
      const int status = bench.post("{\"" + act + "\":\"" + name + "\"}").status;
      CHECK((status == 422 || (name == "a\\u0000b" && status == 400)));
    }
  }
  CHECK(bench.post("{\"save\":\"" + std::string(65, 'a') + "\"}").status == 422);
  CHECK(bench.act(R"({"save":"shift 1"})") >= 0);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(outer.path()))
    files += entry.is_regular_file();
  CHECK(files == 2);
  CHECK(std::filesystem::exists(outer / "files/shift 1.snapshot"));
}

TEST_CASE("A script in a symbol's name stays a text") {
  PanelPlan plan;
  plan.names = {"AGV_I_<script>alert(1)</script>", "AGV_I_\"><img src=x onerror=alert(1)>", "AGV_O_P1", "AGV_I_P1"};
  const PanelBench bench(plan);
  const HttpAnswer answer = bench.send(bench.request("GET", "/api/v1/plant"));
  CHECK(contains(answer.head, "Content-Type: application/json\r\n"));
  CHECK(contains(answer.head, "X-Content-Type-Options: nosniff\r\n"));
  CHECK(contains(answer.head, "Cache-Control: no-store\r\n"));
  CHECK(contains(answer.head, "Referrer-Policy: no-referrer\r\n"));
  CHECK(contains(answer.head, "Cross-Origin-Resource-Policy: same-origin\r\n"));
  CHECK(contains(answer.head, "Cross-Origin-Opener-Policy: same-origin\r\n"));
  CHECK(Json::parse(answer.body).at("symbols").at(0).at("name") == "L_P_AGV_I_<script>alert(1)</script>");
  const HttpAnswer page = bench.send(bench.request("GET", "/"));
  CHECK(page.status == 200);
  CHECK(contains(page.head, "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self';"));
  CHECK(!contains(page.head, "unsafe"));
  for (const panel::PageFile& file : panel::page_files()) {
    INFO(file.name);
    for (const char* way : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "new Function",
                            "srcdoc", "javascript:"}) {
      CHECK(!contains(file.text, way));
    }
  }
}

TEST_CASE("JSON that is nested too deep is refused") {
  const PanelBench bench;
  const std::string deep = std::string(20'000, '[') + std::string(20'000, ']');
  const HttpAnswer answer = bench.send(bench.request("POST", "/api/v1/acts", deep));
  CHECK(answer.status == 400);
  CHECK(contains(answer.body, "level"));
  CHECK(bench.post("{\"force\":" + deep + "}").status == 400);
}

TEST_CASE("An act on an unknown device does nothing, and names the nearest one") {
  const PanelBench bench;
  const HttpAnswer answer = bench.post(kForce + R"(,{"state":{"L_P_DOR":"OPEN2"}})");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "did you mean `L_P_DOOR`?"));
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("A panel that only shows does no act") {
  PanelPlan plan;
  plan.options.view_only = true;
  const PanelBench bench(plan);
  CHECK(bench.send(forcing(bench)).status == 403);
  CHECK(bench.value("AGV_I_P2") == false);
  CHECK(bench.get("/api/v1/plant").at("acts") == false);
}

TEST_CASE("A page of an earlier start cannot act on another plant") {
  PanelPlan plan;
  const TemporaryFolder folder;
  plan.options.token_file = folder.write("token", std::string(32, 'a'));
  std::string earlier;
  {
    const PanelBench bench(plan);
    earlier = bench.run;
  }
  plan.names.emplace_back("LAMP_O_ON");
  const PanelBench bench(plan);
  CHECK(bench.token == std::string(32, 'a'));
  CHECK(bench.send(replaced(forcing(bench), bench.run, earlier)).status == 409);
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("More than a hundred acts in a second are refused") {
  const PanelBench bench;
  std::size_t refused = 0;
  for (int i = 0; i < 250; ++i) refused += bench.post(kForce).status == 429 ? 1U : 0U;
  CHECK(refused > 0);
}

TEST_CASE("Clients of the stream that never read are closed, and others get their place") {
  PanelPlan plan;
  plan.options.patience = 1;
  for (int i = 0; i < 1500; ++i) plan.names.push_back("LAMP" + std::to_string(i) + "X_O_ON");
  const PanelBench bench(plan);
  std::list<HttpClient> crowd;
  for (int i = 0; i < 8; ++i) {
    crowd.emplace_back(bench.port, 4096);
    crowd.back().send(bench.request("GET", "/api/v1/stream"));
    CHECK(contains(crowd.back().read_until("\r\n\r\n"), "200 OK"));
  }
  bool on = false;
  bench.wait_for([&] {
    on = !on;
    std::string set;
    for (int i = 0; i < 1500; ++i) {
      set +=
          (set.empty() ? "\"L_P_LAMP" : ",\"L_P_LAMP") + std::to_string(i) + (on ? "X_O_ON\":true" : "X_O_ON\":false");
    }
    bench.act("{\"set\":{" + set + "}}");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    HttpClient client(bench.port);
    client.send(bench.request("GET", "/api/v1/stream"));
    return contains(client.read_until("\r\n\r\n"), "200 OK");
  });
}

TEST_CASE("A plant that is busy takes a bounded number of acts and questions") {
  PanelBench bench;
  bench.hold(true);
  std::list<HttpClient> waiting;
  const auto freeze = [&](std::size_t times) {
    std::string acts = R"({"freeze":true})";
    for (std::size_t i = 1; i < times; ++i) acts += R"(,{"freeze":true})";
    return bench.request("POST", "/api/v1/acts", "{\"acts\":[" + acts + "]}");
  };
  const auto is_busy = [&](const std::string& request) {
    const HttpAnswer answer = bench.send(request);
    return answer.status == 429 && contains(answer.body, "too many acts wait for the plant");
  };
  for (const std::size_t times : {100U, 78U}) {
    waiting.emplace_back(bench.port);
    waiting.back().send(freeze(times));
  }
  CHECK(is_busy(freeze(100)));
  for (std::size_t i = 0; i < 60; ++i) {
    waiting.emplace_back(bench.port);
    waiting.back().send(i < 20 ? freeze(2) : bench.request("GET", "/api/v1/why?name=L_P_AGV"));
  }
  CHECK(is_busy(bench.request("GET", "/api/v1/why?name=L_P_AGV")));
  bench.hold(false);
  std::size_t done = 0;
  for (HttpClient& client : waiting) done += client.answer().status == 200 ? 1U : 0U;
  CHECK(done == 60);
}

TEST_CASE("Other methods, paths and bytes get an answer, or the connection ends") {
  const PanelBench bench;
  CHECK(bench.send(bench.request("PUT", "/api/v1/acts", "{}")).status == 405);
  CHECK(bench.send(bench.request("GET", "/../../etc/passwd")).status == 404);
  CHECK(bench.send(bench.request("GET", "/%2e%2e/%2e%2e/etc/passwd")).status == 404);
  CHECK(bench.send(bench.request("GET", "/api/v1/picture%")).status == 400);
  CHECK(bench.send(bench.request("GET", "/api/v1/at?t=0")).status == 404);
  CHECK(bench.send("nonsense\r\n\r\n").status == 400);
  CHECK(bench.send(replaced(forcing(bench), "application/json", "text/plain")).status == 400);
  for (const std::string query : {"symbols=x", "symbols=1,", "symbols=9999", "devices=-1", "from=a", "after=-1"}) {
    INFO(query);
    CHECK(bench.send(bench.request("GET", "/api/v1/chart?" + query)).status == (query == "symbols=1," ? 200 : 400));
  }
  CHECK(bench.send(bench.request("GET", "/api/v1/picture")).status == 200);
}

}  // namespace
}  // namespace symplant::test
