// One connection of the panel's web server.
#include "symplant/panel/web/connection.hpp"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <chrono>
#include <string>
#include <utility>
#include <variant>

#include "symplant/link/net/peer.hpp"
#include "symplant/panel/scene/scene.hpp"
#include "symplant/panel/web/gzip.hpp"
#include "symplant/panel/web/request.hpp"
#include "symplant/panel/web/response_head.hpp"

namespace symplant::panel::web {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;

constexpr std::uint32_t kLongestHeader = 8 * 1024;
constexpr std::uint64_t kLongestBody = 64 * 1024;
constexpr std::size_t kMostWaiting = std::size_t{4} << 20;  ///< bytes of events that a client has not read
constexpr std::size_t kLeastPacked = 1024;
constexpr int kSendBuffer = 256 * 1024;  ///< of the system: what it takes is not known to have arrived

/// Whether a client sent something else than HTTP; not whether it closed, or was too slow.
bool is_malformed(const Error& error) {
  return error.category() == http::make_error_code(http::error::bad_method).category() &&
         error != http::error::end_of_stream && error != http::error::partial_message;
}

Answer failed_answer() {
  return error_answer(500, "an internal error of symplant, described in its log; the plant keeps running");
}

}  // namespace

/// An answer that comes later, from any thread: the first one counts. If none comes, the client gets an error.
class Connection::Pledge {
 public:
  explicit Pledge(std::shared_ptr<Connection> to) : to_(std::move(to)) {}
  ~Pledge() {
    to_->shared_.guard.run("an answer", [this] { give(failed_answer()); });
  }
  Pledge(const Pledge&) = delete;
  Pledge& operator=(const Pledge&) = delete;

  void give(Answer answer) {
    if (given_.exchange(true)) return;
    asio::post(to_->shared_.context, [to = to_, done = std::move(answer)]() mutable {
      to->reply({Reply::Kind::now, std::move(done)});
    });
  }
  void withdraw() { given_ = true; }

 private:
  std::shared_ptr<Connection> to_;
  std::atomic<bool> given_{false};
};

void Connection::start() {
  Error ignored;
  stream_.socket().set_option(Tcp::no_delay(true), ignored);
  stream_.socket().set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
  read();
}

void Connection::close() {
  if (std::exchange(state_, State::closed) == State::closed) return;
  if (place_) shared_.places.leave(*place_);
  Error ignored;
  stream_.socket().shutdown(Tcp::socket::shutdown_both, ignored);
  stream_.close();
  shared_.connections.remove(shared_from_this());
}

void Connection::abandon() {
  Error ignored;
  stream_.socket().set_option(asio::socket_base::linger(true, 0), ignored);
  close();
}

void Connection::send(const Bytes& event) {
  if (is_late_) return;
  out_.add(event);
  if (out_.size() > kMostWaiting) {
    is_late_ = true;
    out_.drop();
  }
  write_next();
}

/// The bytes that the client's system has acknowledged.
std::uint64_t Connection::acknowledged() const {
  const auto socket = static_cast<int>(const_cast<boost::beast::tcp_stream&>(stream_).socket().native_handle());
  return taken_ - std::min<std::uint64_t>(taken_, link::net::unacknowledged(socket));
}

void Connection::look(Clock::time_point now) {
  if (state_ != State::answering && state_ != State::streaming) return;
  const std::uint64_t acknowledged_now = acknowledged();
  if (acknowledged_now != acknowledged_ || (out_.empty() && acknowledged_now == taken_)) {
    acknowledged_ = acknowledged_now;
    heard_ = now;
  } else if (now - heard_ >= shared_.patience) {
    abandon();
  }
}

std::optional<double> Connection::rate(Clock::time_point now) const {
  const std::chrono::duration<double> age = now - begun_;
  if (state_ != State::answering || out_.empty() || age < std::chrono::seconds(1)) return std::nullopt;
  return static_cast<double>(acknowledged() - before_) / age.count();
}

void Connection::read() {
  state_ = State::reading;
  auto& all = shared_.connections;
  all.splice(all.end(), all, std::find(all.begin(), all.end(), shared_from_this()));
  parser_.emplace();
  parser_->header_limit(kLongestHeader);
  parser_->body_limit(kLongestLayout);
  stream_.expires_after(shared_.patience);  // for the whole request
  http::async_read_header(stream_, buffer_, *parser_,
                          [self = shared_from_this()](Error error, std::size_t) { self->header_read(error); });
}

/// The rest of the request, whose limit depends on its target.
void Connection::header_read(Error error) {
  if (state_ == State::closed) return;
  if (error || parser_->is_done()) return read_done(error);
  if (parser_->get().target() != boost::beast::string_view(kLayoutTarget.data(), kLayoutTarget.size())) {
    if (parser_->content_length().value_or(0) > kLongestBody) return read_done(http::error::body_limit);
    parser_->body_limit(kLongestBody);
  }
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](Error failed, std::size_t) { self->read_done(failed); });
}

void Connection::read_done(Error error) {
  if (state_ == State::closed) return;
  stream_.expires_never();
  begun_ = heard_ = Clock::now();
  before_ = acknowledged();
  state_ = State::answering;
  if (error == http::error::header_limit) return refuse(error_answer(431, "the header is over 8 KiB"));
  if (error == http::error::body_limit)
    return refuse(error_answer(413, "the body is over 64 KiB, or that of a layout over 1 MiB"));
  if (error && !is_malformed(error)) return close();
  if (error) return refuse(error_answer(400, "this is not a request of HTTP/1.1"));
  const Message& message = parser_->get();
  auto read = read_request(message);
  if (auto* answer = std::get_if<Answer>(&read)) return refuse(std::move(*answer));
  keep_alive_ = message.version() == 11 && message.keep_alive();
  answer(std::get<Request>(read));
}

/// Answers, and closes: it is not known where the next request begins.
void Connection::refuse(Answer answer) {
  keep_alive_ = false;
  reply({Reply::Kind::now, std::move(answer)});
}

void Connection::answer(const Request& request) {
  accepts_gzip_ = request.accepts_gzip;
  const auto pledge = std::make_shared<Pledge>(shared_from_this());
  Reply found;
  const std::string name = std::string(request.method) + " " + std::string(request.target);
  const bool is_found = shared_.guard.run(
      name, [&] { found = shared_.routes.answer(request, [pledge](Answer done) { pledge->give(std::move(done)); }); });
  if (!is_found) return pledge->give(failed_answer());
  if (found.kind == Reply::Kind::later) return;
  pledge->withdraw();
  found.kind == Reply::Kind::stream ? begin_stream(found) : reply(std::move(found));
}

void Connection::reply(Reply found) {
  if (state_ == State::closed) return;
  const std::size_t size = found.content != nullptr ? found.content->plain()->size() : found.answer.body.size();
  const bool by_encoding = size >= kLeastPacked && found.packable;
  const bool packed = by_encoding && accepts_gzip_;
  Bytes body;
  const bool is_made = shared_.guard.run("an answer", [&] {
    if (found.content != nullptr) {
      body = packed ? found.content->packed() : found.content->plain();
    } else {
      body = shared_.outgoing.share(packed ? gzip(found.answer.body) : std::move(found.answer.body));
    }
  });
  if (!is_made) return close();
  const bool is_much = found.content == nullptr && shared_.outgoing.size() > Outgoing::kMost;
  if (is_much && body->size() < shared_.outgoing.size() && !shared_.relieve(body->size(), Clock::now())) {
    found = {Reply::Kind::now, error_answer(503, "too many answers wait to be read; try again")};
    body = shared_.outgoing.share(std::move(found.answer.body));
    return write_answer(found, body, false, false);
  }
  write_answer(found, body, packed, by_encoding);
}

void Connection::write_answer(const Reply& found, const Bytes& body, bool packed, bool by_encoding) {
  const std::string_view type = found.content != nullptr ? found.content->type() : found.content_type;
  out_.add(std::make_shared<const std::string>(
      text_of({found.answer.status, type, body->size(), keep_alive_, packed, by_encoding, found.file_name})));
  out_.add(body);
  write_next();
}

void Connection::begin_stream(const Reply& found) {
  using Kind = StreamPlaces::Kind;
  const Kind kind = panel::sees_all(found.role) ? Kind::trainer
                    : found.has_token           ? Kind::with_token
                                                : Kind::without_token;
  const Clock::time_point now = Clock::now();
  if (shared_.places.is_full(kind)) {
    shared_.probe(now);
    return reply(
        {Reply::Kind::now, error_answer(503, found.has_token ? "all places are taken; close another page of this panel"
                                                             : "4 clients without a token look already; close one of "
                                                               "them, or use the link with the token")});
  }
  role_ = found.role;
  Bytes picture;
  if (!shared_.guard.run("GET /api/v1/stream", [&] { picture = shared_.picture(sees_all()); })) {
    return reply({Reply::Kind::now, failed_answer()});
  }
  shared_.places.take(kind);
  place_ = kind;
  state_ = State::streaming;
  out_.add(std::make_shared<const std::string>(text_of({.content_type = "text/event-stream"})));
  out_.add(std::move(picture));
  write_next();
  watch();
  if (shared_.places.is_full(kind)) shared_.probe(now);
}

/// A client that closes, or sends more, ends its stream.
void Connection::watch() {
  stream_.socket().async_read_some(asio::buffer(&ignored_, 1),
                                   [self = shared_from_this()](Error, std::size_t) { self->close(); });
}

void Connection::write_next() {
  if (writing_ || state_ == State::closed) return;
  if (out_.empty()) return written();
  writing_ = true;
  const std::string_view next = out_.next();
  stream_.async_write_some(asio::buffer(next.data(), next.size()),
                           [self = shared_from_this()](Error error, std::size_t count) {
                             self->writing_ = false;
                             if (error) return self->close();
                             self->taken_ += count;
                             self->out_.taken(count);
                             self->write_next();
                           });
}

/// The system has taken everything.
void Connection::written() {
  if (state_ == State::answering) return keep_alive_ ? read() : close();
  if (!std::exchange(is_late_, false)) return;
  if (!shared_.guard.run("GET /api/v1/stream", [this] { out_.add(shared_.picture(sees_all())); })) return close();
  write_next();
}

}  // namespace symplant::panel::web
