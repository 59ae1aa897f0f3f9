// The panel's web server over a source that a test makes.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "support/catch.hpp"
#include "support/http_client.hpp"
#include "symplant/panel/web/open_port.hpp"
#include "symplant/panel/web/server.hpp"

namespace symplant::test {

/// Answers with texts, or by functions, which may throw.
class MadeSource final : public panel::Source {
 public:
  void put_description(std::string& json, panel::Role) override {
    ++described;
    json += ",\"text\":\"" + std::string(description_size, 'd') + "\"";
  }
  bool acts() const override { return true; }
  std::optional<panel::Reply> get(std::string_view, const std::map<std::string, std::string>&, const panel::Sender&,
                                  const panel::Answered& later) override {
    return answer_get ? answer_get(later) : std::nullopt;
  }
  void post(std::string_view, std::string_view, const panel::Sender&, const panel::Answered& later) override {
    answer_post(later);
  }
  std::string picture(panel::Role) override { return make_picture ? make_picture() : "{}"; }
  panel::News changes(bool) override {
    const std::string changes = make_changes ? make_changes() : "";
    return {changes, changes};
  }

  std::size_t description_size = 0;
  std::atomic<int> described{0};
  std::function<std::optional<panel::Reply>(const panel::Answered&)> answer_get;
  std::function<void(const panel::Answered&)> answer_post;
  std::function<std::string()> make_picture;
  std::function<std::string()> make_changes;
};

/// Serves a source on a free port. The source must be ready before begin().
class ServedSource {
 public:
  explicit ServedSource(int patience = 10)
      : opened_(panel::open_port({.address = "127.0.0.1:0"})),
        routes_(source, open().access, "run"),
        guard_([this](const std::string& message) {
          const std::lock_guard lock(mutex_);
          messages_.push_back(message);
        }),
        patience_(patience),
        port(open().listener.bound.port) {}

  void begin() {
    server_.emplace(std::move(open().listener), routes_, source, guard_, patience_, [] {});
  }

  /// A request with the headers of the page; `more` are whole lines.
  std::string request(const std::string& method, const std::string& target, const std::string& more = "",
                      const std::string& body = "") const {
    return method + " " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
           "\r\nAuthorization: Bearer " + token() +
           "\r\nX-Symplant-Run: run\r\nContent-Type: application/json\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n" + more + "\r\n" + body;
  }
  std::string token() const {
    const std::string link = open().access.link(panel::Role::trainer);
    return link.substr(link.find("token=") + 6);
  }
  HttpAnswer send(const std::string& text) const {
    HttpClient client(port);
    client.send(text);
    return client.answer();
  }
  HttpAnswer get(const std::string& target, const std::string& more = "") const {
    return send(request("GET", target, more));
  }
  std::vector<std::string> messages() {
    const std::lock_guard lock(mutex_);
    return messages_;
  }
  /// Waits until something holds, for at most 60 s.
  static void wait_for(const std::function<bool()>& holds) {
    for (int i = 0; i < 6000; ++i) {
      if (holds()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL("it did not happen in 60 s");
  }

  MadeSource source;

 private:
  panel::OpenPort& open() { return std::get<panel::OpenPort>(opened_); }
  const panel::OpenPort& open() const { return std::get<panel::OpenPort>(opened_); }

  std::variant<panel::OpenPort, link::LinkError> opened_;
  panel::Routes routes_;
  std::mutex mutex_;
  std::vector<std::string> messages_;
  panel::Guard guard_;
  int patience_;
  std::optional<panel::Server> server_;

 public:
  std::uint16_t port;
};

}  // namespace symplant::test
