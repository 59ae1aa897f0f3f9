// One connection of the panel's web server: requests one after the other, or a stream.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <cstddef>
#include <deque>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "symplant/panel/web/routes.hpp"

namespace symplant::panel::web {

using Tcp = boost::asio::ip::tcp;
using Error = boost::beast::error_code;

class Connection;

/// What the connections share. All of it is used by the server's thread only.
struct Shared {
  Shared(Routes& all_routes, Source& plant, int seconds) : routes(all_routes), source(plant), patience(seconds) {}

  boost::asio::io_context context;
  Routes& routes;
  Source& source;
  std::chrono::seconds patience;
  std::list<std::shared_ptr<Connection>> connections;  ///< that idle for longest first
  std::size_t streams = 0;

  /// The event `picture` as it is now; made once for all clients that need one at the same time.
  std::shared_ptr<const std::string> picture();
  /// To be called after each change of the source.
  void forget_picture() { picture_ = nullptr; }

 private:
  std::shared_ptr<const std::string> picture_;
};

/// All of it is for the server's thread.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {}

  void start();
  /// Whether it waits for a request, or for the rest of one.
  bool is_idle() const { return state_ == State::reading; }
  bool is_stream() const { return state_ == State::streaming; }
  void close();
  /// Sends an event after those that are not sent yet. A client that does not read them in time gets a picture instead
  /// of all that it missed.
  void send(const std::shared_ptr<const std::string>& event);

 private:
  using TextBody = boost::beast::http::string_body;
  using NoBody = boost::beast::http::empty_body;
  enum class State { reading, answering, streaming, closed };

  void read();
  void read_done(Error error);
  void answer();
  void reply(Reply found);
  void begin_stream();
  void watch();
  void write_next();

  boost::beast::tcp_stream stream_;
  Shared& shared_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<TextBody>> parser_;
  std::optional<boost::beast::http::response<TextBody>> response_;
  std::optional<boost::beast::http::response<NoBody>> header_;
  std::optional<boost::beast::http::response_serializer<NoBody>> serializer_;
  State state_ = State::reading;
  bool keep_alive_ = true;
  bool counted_ = false;  ///< among the streams
  bool writing_ = false;
  bool is_late_ = false;                                   ///< a picture is due
  std::deque<std::shared_ptr<const std::string>> events_;  ///< that wait
  std::size_t waiting_ = 0;                                ///< their bytes
  char ignored_ = 0;
};

}  // namespace symplant::panel::web
