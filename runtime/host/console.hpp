// What a run tells its user, by whichever thread, in whole pieces.
#pragma once

#include <mutex>
#include <ostream>
#include <string>
#include <string_view>

namespace symplant::host {

/// Standard output and messages as the threads of a run share them. Each function may be called by any thread; while
/// several run, none but these touches `out` and `err`. A status line that is drawn makes way for what is told.
class Console {
 public:
  /// Both must outlive it, and may be the same.
  Console(std::ostream& out, std::ostream& err) : out_(out), err_(err) {}

  /// A message: a line or several, each with its end.
  void message(std::string_view text);
  /// The like on `out`.
  void line(std::string_view text);
  /// Draws a status line without an end, in the place of the one before.
  void draw(std::string_view status);
  /// Takes it away.
  void clear();

  /// Whether whoever reads `out` takes something now, as far as can be seen: not a terminal stopped by Ctrl-S, say.
  bool is_taken() const;

 private:
  void write(std::ostream& stream, std::string_view text);

  std::mutex mutex_;
  std::ostream& out_;
  std::ostream& err_;
  std::string drawn_;
};

/// As long as it lives a write to `stream` does not flush the one that it is tied to, which another thread may use.
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
