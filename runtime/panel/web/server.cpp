// The web server of the panel.
#include "symplant/panel/web/server.hpp"

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <list>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "symplant/link/net/system.hpp"
#include "symplant/panel/web/connection.hpp"

namespace symplant::panel {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t kMostConnections = 64;
constexpr auto kPeriod = milliseconds(40);  ///< of the stream

}  // namespace

struct Server::Parts {
  Parts(link::net::Listener listener, Routes& routes, Source& source, Guard& guard, int patience,
        std::function<void()> every_second)
      : shared(routes, source, guard, patience),
        acceptor(shared.context),
        timer(shared.context),
        each_second(std::move(every_second)) {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    ::getsockname(link::net::native(listener.socket.get()), reinterpret_cast<sockaddr*>(&storage), &size);
    acceptor.assign(storage.ss_family == AF_INET6 ? web::Tcp::v6() : web::Tcp::v4(),
                    link::net::native(listener.socket.release()));
    accept();
    tick(std::chrono::steady_clock::now());
    thread = std::thread([this] { serve(); });
  }

  ~Parts() {
    shared.context.stop();
    thread.join();
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  /// Until the context is stopped. What no other guard catches ends one connection at most.
  void serve() {
    while (!shared.guard.run("a connection", [this] { shared.context.run(); })) {
    }
  }

  void accept() {
    acceptor.async_accept([this](web::Error error, web::Tcp::socket socket) {
      if (error) {  // such as too many open files: other connections must close first
        timer_for_accept.emplace(shared.context, milliseconds(100));
        timer_for_accept->async_wait([this](web::Error stopped) {
          if (!stopped) accept();
        });
        return;
      }
      shared.guard.run("a connection", [&] { admit(std::move(socket)); });
      accept();
    });
  }

  void admit(web::Tcp::socket socket) {
    if (shared.connections.size() >= kMostConnections && !shared.close_one(web::Clock::now())) return;
    const auto connection = std::make_shared<web::Connection>(std::move(socket), shared);
    shared.connections.push_back(connection);
    connection->start();
  }

  void tick(std::chrono::steady_clock::time_point last) {
    const auto next = std::max(last + kPeriod, std::chrono::steady_clock::now());
    timer.expires_at(next);
    timer.async_wait([this, next](web::Error error) {
      if (error) return;
      shared.forget_pictures();
      if (++ticks % (1000 / kPeriod.count()) == 0) second(next);
      if (!shared.places.empty()) shared.guard.run("GET /api/v1/stream", [this] { send_changes(); });
      tick(next);
    });
  }

  void second(std::chrono::steady_clock::time_point now) {
    shared.guard.run("GET /api/v1/stream", each_second);
    const std::list<std::shared_ptr<web::Client>> all = shared.connections;  // a look may close one
    for (const std::shared_ptr<web::Client>& each : all) each->look(now);
    if (std::exchange(is_quiet, true)) shared.broadcast(keep_alive);
  }

  /// The event `changes`; null: nothing new.
  Bytes event_of(const std::string& changes) {
    return changes.empty() ? nullptr : shared.outgoing.share("event: changes\ndata: " + changes + "\n\n");
  }

  void send_changes() {
    const bool for_others = shared.has_others();
    const News news = shared.source.changes(for_others);
    const bool whole = shared.source.begun_again();
    const Bytes all = whole ? shared.picture(true) : event_of(news.all);
    const Bytes shown = !for_others ? nullptr : whole ? shared.picture(false) : event_of(news.shown);
    if (all == nullptr && shown == nullptr) return;
    is_quiet = false;
    shared.broadcast(all, shown);
  }

  web::Shared shared;
  web::Tcp::acceptor acceptor;
  boost::asio::steady_timer timer;
  std::optional<boost::asio::steady_timer> timer_for_accept;
  std::function<void()> each_second;
  std::uint64_t ticks = 0;
  bool is_quiet = false;                                                  ///< no event in this second
  const Bytes keep_alive = std::make_shared<const std::string>(":\n\n");  ///< so that a client that is gone is noticed
  std::thread thread;
};

Server::Server(link::net::Listener listener, Routes& routes, Source& source, Guard& guard, int patience,
               std::function<void()> each_second)
    : parts_(std::make_unique<Parts>(std::move(listener), routes, source, guard, patience, std::move(each_second))) {}

Server::~Server() = default;

}  // namespace symplant::panel
