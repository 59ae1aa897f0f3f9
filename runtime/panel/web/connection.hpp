// One connection of the panel's web server: requests one after the other, or a stream.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "symplant/panel/web/client.hpp"
#include "symplant/panel/web/outbox.hpp"
#include "symplant/panel/web/routes.hpp"
#include "symplant/panel/web/shared.hpp"

namespace symplant::panel::web {

using Tcp = boost::asio::ip::tcp;
using Error = boost::beast::error_code;

/// Used by the server's thread only.
class Connection final : public Client, public std::enable_shared_from_this<Connection> {
 public:
  Connection(Tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {}

  void start();
  bool is_idle() const override { return state_ == State::reading; }
  bool is_stream() const override { return state_ == State::streaming; }
  bool sees_all() const override { return panel::sees_all(role_); }
  void close() override;
  void abandon() override;
  void send(const Bytes& event) override;
  void look(Clock::time_point now) override;
  std::optional<double> rate(Clock::time_point now) const override;
  std::size_t waiting() const override { return out_.size(); }

 private:
  class Pledge;
  enum class State { reading, answering, streaming, closed };

  void read();
  void header_read(Error error);
  void read_done(Error error);
  void answer(const Request& request);
  void reply(Reply found);
  void refuse(Answer answer);
  void write_answer(const Reply& found, const Bytes& body, bool packed, bool by_encoding);
  void begin_stream(const Reply& found);
  void watch();
  void write_next();
  void written();
  std::uint64_t acknowledged() const;

  boost::beast::tcp_stream stream_;
  Shared& shared_;
  boost::beast::flat_buffer buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  State state_ = State::reading;
  bool keep_alive_ = true;
  bool accepts_gzip_ = false;
  std::optional<StreamPlaces::Kind> place_;  ///< of a stream
  Role role_ = Role::viewer;                 ///< of the client of a stream
  Outbox out_;
  bool writing_ = false;
  bool is_late_ = false;            ///< a picture is due
  std::uint64_t taken_ = 0;         ///< bytes that the system has taken
  std::uint64_t acknowledged_ = 0;  ///< bytes that the client had acknowledged at the last look()
  Clock::time_point heard_{};       ///< when `acknowledged_` last grew, or nothing was left to be acknowledged
  std::uint64_t before_ = 0;        ///< bytes acknowledged before this answer
  Clock::time_point begun_{};       ///< when this answer began
  char ignored_ = 0;
};

}  // namespace symplant::panel::web
