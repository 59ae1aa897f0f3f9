// A client of HTTP/1.1 that sends exactly what a test wants.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "support/raw_client.hpp"

namespace symplant::test {

struct HttpAnswer {
  int status = 0;  ///< 0: the server closed the connection, or did not answer
  std::string head;
  std::string body;
};

/// One connection to a server on the loopback.
class HttpClient {
 public:
  explicit HttpClient(std::uint16_t port, int room = 0) : client_(port, AF_INET, room) {}

  RawClient& raw() { return client_; }

  void send(std::string_view text) const { client_.send(Bytes(text.begin(), text.end())); }

  /// Reads until a text comes, or the connection ends.
  std::string read_until(std::string_view end) {
    while (buffer_.find(end) == std::string::npos && read_more()) {
    }
    const std::size_t at = buffer_.find(end);
    const std::size_t size = at == std::string::npos ? buffer_.size() : at + end.size();
    std::string text = buffer_.substr(0, size);
    buffer_.erase(0, size);
    return text;
  }

  HttpAnswer answer() {
    HttpAnswer answer;
    answer.head = read_until("\r\n\r\n");
    if (answer.head.size() > 12) answer.status = std::atoi(answer.head.c_str() + 9);
    constexpr std::string_view kLength = "Content-Length: ";
    const std::size_t at = answer.head.find(kLength);
    if (at == std::string::npos) return answer;
    const auto size = static_cast<std::size_t>(std::atoi(answer.head.c_str() + at + kLength.size()));
    while (buffer_.size() < size && read_more()) {
    }
    answer.body = buffer_.substr(0, size);
    buffer_.erase(0, answer.body.size());
    return answer;
  }

 private:
  /// False if nothing comes any more.
  bool read_more() {
    const Bytes first = client_.receive(1);
    if (first.empty()) return false;
    char more[65536];
    const ssize_t count = ::recv(client_.descriptor(), more, sizeof more, MSG_DONTWAIT);
    buffer_.append(first.begin(), first.end());
    if (count > 0) buffer_.append(more, static_cast<std::size_t>(count));
    return true;
  }

  RawClient client_;
  std::string buffer_;
};

}  // namespace symplant::test
