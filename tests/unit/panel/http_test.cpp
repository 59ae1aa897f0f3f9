// Requests that say unclearly where they end, or from where they come; answers that are compressed.
#include <fmt/format.h>
#include <zlib.h>

#include "symplant/panel/web/gzip.hpp"
#include "symplant/panel/web/page_files.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

const std::string kForceP2 = R"({"acts":[{"force":{"L_P_AGV_I_P2":true}}]})";

/// A request with a line more in its head.
std::string with_line(std::string request, const std::string& line) {
  return request.insert(request.find("\r\n") + 2, line + "\r\n");
}

/// A request of which a header has another value, or is not there if the line is empty.
std::string with_header(std::string request, const std::string& name, const std::string& line) {
  const std::size_t begin = request.find(name + ": ");
  REQUIRE(begin != std::string::npos);
  const std::size_t end = request.find("\r\n", begin) + 2;
  return request.replace(begin, end - begin, line.empty() ? "" : line + "\r\n");
}

/// The text of a gzip that has at most `most` bytes.
std::string unpacked(const std::string& packed, std::size_t most) {
  z_stream stream{};
  REQUIRE(inflateInit2(&stream, MAX_WBITS + 16) == Z_OK);
  std::string text(most + 1, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return text;
}

TEST_CASE("A header that decides about access or length is there once") {
  const PanelBench bench;
  const std::string host = "Host: 127.0.0.1:" + std::to_string(bench.port);
  const std::string origin = "Origin: http://127.0.0.1:" + std::to_string(bench.port);
  for (const std::string& line :
       {host, std::string("Host: evil.example"), "Authorization: Bearer " + bench.token,
        std::string("Authorization: x"), "X-Symplant-Run: " + bench.run, std::string("X-Symplant-Run: y"),
        std::string("Content-Type: application/json"), std::string("content-type: text/plain"),
        "Content-Length: " + std::to_string(kForceP2.size()), std::string("Content-Length: 1"),
        origin + "\r\n" + origin}) {
    INFO(line);
    const HttpAnswer answer = bench.send(with_line(bench.request("POST", "/api/v1/acts", kForceP2), line));
    CHECK(answer.status == 400);
    CHECK(contains(answer.head, "Connection: close\r\n"));
  }
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("A body without a clear end is refused, and what follows is not a request") {
  const PanelBench bench;
  const std::string act = bench.request("POST", "/api/v1/acts", kForceP2);
  const std::string hidden = bench.request("POST", "/api/v1/acts", kForceP2);
  for (const auto& [line, status] :
       std::vector<std::pair<std::string, int>>{{"Transfer-Encoding: gzip", 501},
                                                {"Transfer-Encoding: identity", 501},
                                                {"Transfer-Encoding: gzip, chunked", 501},
                                                {"Transfer-Encoding: chunked, gzip", 501},
                                                {"Transfer-Encoding: chunked, chunked", 501},
                                                {"Transfer-Encoding: xchunked", 501},
                                                {"Transfer-Encoding: \"chunked\"", 501},
                                                {"Transfer-Encoding:", 501},
                                                {"Transfer-Encoding: gzip\r\nTransfer-Encoding: chunked", 400}}) {
    INFO(line);
    HttpClient client(bench.port);
    client.send(with_header(bench.request("GET", "/api/v1/picture"), "Content-Length", line) + "0\r\n\r\n" + hidden);
    const HttpAnswer answer = client.answer();
    CHECK((answer.status == status || answer.status == 400));
    CHECK(contains(answer.head, "Connection: close\r\n"));
    CHECK(client.answer().status == 0);
  }
  for (const std::string line : {"Transfer-Encoding: chunked", "Transfer-Encoding: gzip"}) {  // and a Content-Length
    INFO(line);
    CHECK(bench.send(with_line(act, line)).status == 400);
    CHECK(bench.send(with_line(act, "X: y").insert(act.find("\r\n\r\n") + 6, "\r\n" + line)).status == 400);
  }
  for (const std::string length : {"+5", "-5", "5, 5", "0x5", "5 5", "99999999999999999999", ""}) {
    INFO(length);
    CHECK(bench.send(with_header(act, "Content-Length", "Content-Length: " + length)).status == 400);
  }
  CHECK(bench.value("AGV_I_P2") == false);
  HttpClient chunks(bench.port);
  chunks.send(with_header(bench.request("POST", "/api/v1/acts"), "Content-Length", "Transfer-Encoding: Chunked") +
              fmt::format("{:x}\r\n{}\r\n0\r\n\r\n", kForceP2.size(), kForceP2));
  CHECK(chunks.answer().status == 200);
  CHECK(bench.value("AGV_I_P2") == true);
}

TEST_CASE("HTTP/1.0 has no chunks, and its connection ends with the answer") {
  const PanelBench bench;
  std::string old = bench.request("GET", "/api/v1/picture");
  old.replace(old.find("HTTP/1.1"), 8, "HTTP/1.0");
  const HttpAnswer answer = bench.send(with_line(old, "Connection: keep-alive"));
  CHECK(answer.status == 200);
  CHECK(contains(answer.head, "Connection: close\r\n"));
  CHECK(bench.send(with_header(old, "Content-Length", "Transfer-Encoding: chunked") + "0\r\n\r\n").status == 400);
}

TEST_CASE("A Host is a name or address and the port, and nothing more") {
  const PanelBench bench;
  const std::string port = ":" + std::to_string(bench.port);
  const auto status = [&](const std::string& host) {
    return bench.send(with_header(bench.request("GET", "/"), "Host", "Host: " + host)).status;
  };
  for (const std::string& host : {"[::1].evil.com" + port,
                                  std::string("[::1].evil.com"),
                                  "[::1]evil.com" + port,
                                  "[::1" + port,
                                  "::1" + port,
                                  "[127.0.0.1]" + port,
                                  "[::1]" + port + "evil.com",
                                  "[::1] " + port,
                                  "[]" + port,
                                  "[::1]]" + port,
                                  "127.0.0.1" + port + port,
                                  "127.0.0.1" + port + "@evil.com",
                                  "evil.com@127.0.0.1" + port,
                                  "127.0.0.1 " + port,
                                  "127.1" + port,
                                  "0x7f000001" + port,
                                  "localhost." + port,
                                  "localhost" + port + "/",
                                  "127.0.0.1, 127.0.0.1" + port,
                                  std::string("127.0.0.1:"),
                                  std::string("[::1]:"),
                                  "127.0.0.1:0" + port.substr(1)}) {
    INFO(host);
    CHECK(status(host) == 403);
  }
  for (const std::string& host : {"[::1]" + port, "LocalHost" + port, "127.0.0.1" + port}) {
    INFO(host);
    CHECK(status(host) == 200);
  }
}

TEST_CASE("A client that accepts gzip gets it, and others plain text") {
  const PanelBench bench;
  for (const std::string target : {"/api/v1/plant", "/", "/main.js", "/panel.css", "/api/v1/openapi.json"}) {
    INFO(target);
    const std::string request = bench.request("GET", target);
    const HttpAnswer plain = bench.send(request);
    CHECK_FALSE(contains(plain.head, "Content-Encoding"));
    const HttpAnswer packed = bench.send(with_line(request, "Accept-Encoding: deflate, gzip;q=0.5"));
    CHECK(packed.status == 200);
    CHECK(contains(packed.head, "Content-Encoding: gzip\r\n"));
    CHECK(contains(packed.head, "Vary: Accept-Encoding\r\n"));
    CHECK(contains(plain.head, "Vary: Accept-Encoding\r\n"));
    CHECK(packed.body.size() < plain.body.size());
    if (target != "/api/v1/picture")
      CHECK(unpacked(packed.body, plain.body.size()) == plain.body);  // a picture has the time
  }
  const HttpAnswer error = bench.send(with_line(bench.request("GET", "/none"), "Accept-Encoding: gzip"));
  CHECK_FALSE(contains(error.head, "Content-Encoding"));  // too short
}

TEST_CASE("Accept-Encoding is read as HTTP has it") {
  for (const char* header : {"gzip", "GZIP", "x-gzip", "deflate, gzip", "gzip;q=1.0", "gzip ; q=0.001", "*", "*;q=0.1",
                             "br;q=1.0, gzip;q=0.8, *;q=0", "gzip;Q=1", " \t gzip\t", ",,gzip,", "identity, *;q=0.5"}) {
    INFO(header);
    CHECK(panel::accepts_gzip(header));
  }
  for (const char* header :
       {"", "identity", "gzip;q=0", "gzip;q=0.000", "*;q=0", "gzip;q=0, *", "gzipped", "x gzip", "br", "gzip;q=2",
        "gzip;q=1.1", "gzip;q=-1", "gzip;q=", "gzip;q=0.0001", "gzip;level=9", ";;;"}) {
    INFO(header);
    CHECK_FALSE(panel::accepts_gzip(header));
  }
}

TEST_CASE("gzip keeps every byte") {
  std::string noise;
  std::uint32_t state = 1;
  for (int i = 0; i < 300'000; ++i) noise += static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
  for (const std::string& text : {std::string(), std::string("x"), std::string(5'000'000, 'a'), noise}) {
    CHECK((unpacked(panel::gzip(text), text.size()) == text));
    CHECK((unpacked(panel::gzip(text, panel::Packing::small), text.size()) == text));
  }
}

TEST_CASE("The files of the page are compressed well: all that the 3D view loads is at most 300 kB") {
  std::size_t size = 0;
  int files = 0;
  for (const panel::PageFile& file : panel::page_files()) {
    const std::string_view folder = file.name.substr(0, file.name.find('/'));
    if (folder != "build" && folder != "three" && folder != "view3d") continue;
    size += panel::gzip(file.text, panel::Packing::small).size();
    ++files;
  }
  CHECK(files > 3);
  CHECK(size <= 300'000);
}

}  // namespace
}  // namespace symplant::test
