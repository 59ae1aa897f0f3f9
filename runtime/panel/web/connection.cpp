// One connection of the panel's web server.
#include "symplant/panel/web/connection.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

namespace symplant::panel::web {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;

constexpr std::size_t kMostStreams = 8;
constexpr std::uint32_t kLongestHeader = 8 * 1024;
constexpr std::uint64_t kLongestBody = 64 * 1024;
constexpr std::size_t kMostWaiting = std::size_t{4} << 20;  ///< bytes that a client has not read

constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Whether a client sent something else than HTTP; not whether it closed, or was too slow.
bool is_malformed(const Error& error) {
  return error.category() == http::make_error_code(http::error::bad_method).category() &&
         error != http::error::end_of_stream && error != http::error::partial_message;
}

template <class Message>
void set_headers(Message& message, std::string_view content_type) {
  const auto set = [&](const char* name, std::string_view value) {
    message.set(name, boost::beast::string_view(value.data(), value.size()));
  };
  set("Content-Type", content_type);
  set("Content-Security-Policy", kPolicy);
  set("Cache-Control", "no-store");
  set("X-Content-Type-Options", "nosniff");
  set("Referrer-Policy", "no-referrer");
  set("Cross-Origin-Resource-Policy", "same-origin");
  set("Cross-Origin-Opener-Policy", "same-origin");
}

std::string_view text_of(boost::beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

void Connection::start() {
  Error ignored;
  stream_.socket().set_option(Tcp::no_delay(true), ignored);
  read();
}

void Connection::close() {
  if (std::exchange(state_, State::closed) == State::closed) return;
  if (counted_) --shared_.streams;
  Error ignored;
  stream_.socket().shutdown(Tcp::socket::shutdown_both, ignored);
  stream_.close();
  shared_.connections.remove(shared_from_this());
}

std::shared_ptr<const std::string> Shared::picture() {
  if (picture_ == nullptr) {
    picture_ = std::make_shared<const std::string>("event: picture\ndata: " + source.picture() + "\n\n");
  }
  return picture_;
}

void Connection::send(const std::shared_ptr<const std::string>& event) {
  if (is_late_) return;
  events_.push_back(event);
  waiting_ += event->size();
  if (waiting_ > kMostWaiting) {
    is_late_ = true;
    events_.clear();
    waiting_ = 0;
  }
  write_next();
}

void Connection::read() {
  state_ = State::reading;
  auto& all = shared_.connections;
  all.splice(all.end(), all, std::find(all.begin(), all.end(), shared_from_this()));
  parser_.emplace();
  parser_->header_limit(kLongestHeader);
  parser_->body_limit(kLongestBody);
  stream_.expires_after(shared_.patience);  // for the whole request
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](Error error, std::size_t) { self->read_done(error); });
}

void Connection::read_done(Error error) {
  if (state_ == State::closed) return;
  if (error == http::error::header_limit || error == http::error::body_limit) {
    const bool header = error == http::error::header_limit;
    keep_alive_ = false;
    return reply({Reply::Kind::now,
                  error_answer(header ? 431 : 413, header ? "the header is over 8 KiB" : "the body is over 64 KiB")});
  }
  if (error && !is_malformed(error)) return close();
  if (error) {
    keep_alive_ = false;
    return reply({Reply::Kind::now, error_answer(400, "this is not a request of HTTP/1.1")});
  }
  const auto& message = parser_->get();
  keep_alive_ = message.keep_alive();
  answer();
}

void Connection::answer() {
  state_ = State::answering;
  const auto& message = parser_->get();
  const Request request{text_of(message.method_string()),
                        text_of(message.target()),
                        {text_of(message[http::field::host]), text_of(message[http::field::origin]),
                         text_of(message[http::field::authorization])},
                        text_of(message["X-Symplant-Run"]),
                        text_of(message[http::field::content_type]),
                        message.body()};
  const auto later = [self = shared_from_this()](Answer done) {
    asio::post(self->shared_.context, [self, done = std::move(done)]() mutable {
      self->reply({Reply::Kind::now, std::move(done)});
    });
  };
  Reply found = shared_.routes.answer(request, later);
  if (found.kind == Reply::Kind::stream) return begin_stream();
  if (found.kind == Reply::Kind::now) reply(std::move(found));
}

void Connection::reply(Reply found) {
  if (state_ == State::closed) return;
  state_ = State::answering;
  const bool is_file = !found.content.empty();
  response_.emplace(static_cast<http::status>(found.answer.status), 11);
  set_headers(*response_, found.content_type);
  if (!found.file_name.empty()) {
    response_->set(http::field::content_disposition, "attachment; filename=\"" + found.file_name + "\"");
  }
  response_->body() = is_file ? std::string(found.content) : std::move(found.answer.body);
  response_->keep_alive(keep_alive_);
  response_->prepare_payload();
  stream_.expires_after(shared_.patience);
  http::async_write(stream_, *response_, [self = shared_from_this()](Error error, std::size_t) {
    if (error || !self->keep_alive_) return self->close();
    self->read();
  });
}

void Connection::begin_stream() {
  if (shared_.streams >= kMostStreams) {
    return reply({Reply::Kind::now, error_answer(503, "8 clients look already; close one of them")});
  }
  state_ = State::streaming;
  ++shared_.streams;
  counted_ = true;
  header_.emplace(http::status::ok, 11);
  set_headers(*header_, "text/event-stream");
  header_->keep_alive(false);
  serializer_.emplace(*header_);
  writing_ = true;
  stream_.expires_after(shared_.patience);
  http::async_write_header(stream_, *serializer_, [self = shared_from_this()](Error error, std::size_t) {
    self->writing_ = false;
    self->is_late_ = true;
    error ? self->close() : self->write_next();
  });
  watch();
}

/// A client that closes, or sends more, ends its stream.
void Connection::watch() {
  stream_.socket().async_read_some(asio::buffer(&ignored_, 1),
                                   [self = shared_from_this()](Error, std::size_t) { self->close(); });
}

void Connection::write_next() {
  if (state_ != State::streaming || writing_ || (!is_late_ && events_.empty())) return;
  std::shared_ptr<const std::string> event = is_late_ ? shared_.picture() : events_.front();
  if (!std::exchange(is_late_, false)) {
    waiting_ -= event->size();
    events_.pop_front();
  }
  writing_ = true;
  stream_.expires_after(shared_.patience);
  const asio::const_buffer bytes = asio::buffer(*event);
  asio::async_write(stream_, bytes, [self = shared_from_this(), event = std::move(event)](Error error, std::size_t) {
    self->writing_ = false;
    if (error) return self->close();
    self->stream_.expires_never();
    self->write_next();
  });
}

}  // namespace symplant::panel::web
