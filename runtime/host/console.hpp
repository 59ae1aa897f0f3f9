// The output of a run to its user, from any thread, without interleaving.
#pragma once

#include <mutex>
#include <ostream>
#include <string>
#include <string_view>

namespace symplant::host {

/// Standard output and messages, shared by the threads of a run. Any thread may call each function; while several
/// threads run, only these functions may use `out` and `err`. The status line is redrawn after each output.
class Console {
 public:
  /// Both streams must outlive it, and may be the same.
  Console(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}

  /// Writes a message to `err`: one or more lines, each with its line end.
  void message(std::string_view text);
  /// Writes lines to `out`.
  void line(std::string_view text);
  /// Draws a status line without a line end; replaces the previous one.
  void draw(std::string_view status);
  /// Removes the status line.
  void clear();

  /// Whether a write to `out` would not block now, as far as known. It would block, for example, on a terminal stopped
  /// by Ctrl-S.
  bool is_taken() const;

 private:
  void write(std::ostream& stream, std::string_view text);

  std::mutex mutex_;
  std::ostream& out_;
  std::ostream& err_;
  std::string drawn_;
};

/// During its lifetime a write to `stream` does not flush the tied stream, which another thread may use.
class Untied {
 public:
  explicit Untied(std::ostream& stream) : stream_(stream), before_(stream.tie(nullptr)) {}
  Untied(const Untied&) = delete;
  Untied& operator=(const Untied&) = delete;
  ~Untied() { stream_.tie(before_); }

 private:
  std::ostream& stream_;
  std::ostream* before_;
};

}  // namespace symplant::host
