// The web server of the panel.
#include "symplant/panel/web/server.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <list>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "symplant/panel/web/connection.hpp"

namespace symplant::panel {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t kMostConnections = 64;
constexpr auto kPeriod = milliseconds(40);  ///< of the stream

}  // namespace

struct Server::Parts {
  Parts(link::net::Listener listener, Routes& routes, Source& source, int patience, std::function<void()> every_second)
      : shared(routes, source, patience),
        acceptor(shared.context),
        timer(shared.context),
        each_second(std::move(every_second)) {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    ::getsockname(listener.socket.get(), reinterpret_cast<sockaddr*>(&storage), &size);
    acceptor.assign(storage.ss_family == AF_INET6 ? web::Tcp::v6() : web::Tcp::v4(), ::dup(listener.socket.get()));
    accept();
    tick(std::chrono::steady_clock::now());
    thread = std::thread([this] { shared.context.run(); });
  }

  ~Parts() {
    shared.context.stop();
    thread.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void accept() {
    acceptor.async_accept([this](web::Error error, web::Tcp::socket socket) {
      if (error) {  // such as too many open files: other connections must close first
        timer_for_accept.emplace(shared.context, milliseconds(100));
        timer_for_accept->async_wait([this](web::Error stopped) {
          if (!stopped) accept();
        });
        return;
      }
      make_room();
      if (shared.connections.size() < kMostConnections) {
        shared.connections.push_back(std::make_shared<web::Connection>(std::move(socket), shared));
        shared.connections.back()->start();
      }
      accept();
    });
  }

  /// Closes the connection that has been idle for longest if there are too many.
  void make_room() {
    if (shared.connections.size() < kMostConnections) return;
    const auto idle = std::find_if(shared.connections.begin(), shared.connections.end(),
                                   [](const std::shared_ptr<web::Connection>& each) { return each->is_idle(); });
    if (idle != shared.connections.end()) std::shared_ptr<web::Connection>(*idle)->close();
  }

  void tick(std::chrono::steady_clock::time_point last) {
    const auto next = std::max(last + kPeriod, std::chrono::steady_clock::now());
    timer.expires_at(next);
    timer.async_wait([this, next](web::Error error) {
      if (error) return;
      if (++ticks % (1000 / kPeriod.count()) == 0) each_second();
      shared.forget_picture();
      if (shared.streams != 0) send_changes();
      tick(next);
    });
  }

  /// The event of this period; null: nothing new.
  std::shared_ptr<const std::string> news() {
    std::string changes = shared.source.changes();
    if (shared.source.begun_again()) return shared.picture();
    if (changes.empty()) return nullptr;
    return std::make_shared<const std::string>("event: changes\ndata: " + changes + "\n\n");
  }

  void send_changes() {
    const std::shared_ptr<const std::string> event = news();
    if (event == nullptr) return;
    const std::list<std::shared_ptr<web::Connection>> all = shared.connections;
    for (const std::shared_ptr<web::Connection>& each : all) {
      if (each->is_stream()) each->send(event);
    }
  }

  web::Shared shared;
  web::Tcp::acceptor acceptor;
  boost::asio::steady_timer timer;
  std::optional<boost::asio::steady_timer> timer_for_accept;
  std::function<void()> each_second;
  std::uint64_t ticks = 0;
  std::thread thread;
};

Server::Server(link::net::Listener listener, Routes& routes, Source& source, int patience,
               std::function<void()> each_second)
    : parts_(std::make_unique<Parts>(std::move(listener), routes, source, patience, std::move(each_second))) {}

Server::~Server() = default;

}  // namespace symplant::panel
