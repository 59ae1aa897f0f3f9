// From a request to its answer, independent of the network.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "symplant/panel/answer.hpp"
#include "symplant/panel/role.hpp"
#include "symplant/panel/web/access.hpp"
#include "symplant/panel/web/content.hpp"

namespace symplant::panel {

/// The target of requests whose bodies may be up to kLongestLayout bytes long.
inline constexpr std::string_view kLayoutTarget = "/api/v1/layout";

struct Request {
  std::string_view method;
  std::string_view target;  ///< path and query
  Claim claim;
  std::string_view run;  ///< X-Symplant-Run
  std::string_view content_type;
  std::string_view body;
  bool accepts_gzip = false;
  std::string_view name = {};  ///< X-Symplant-Name
};

/// What a request gets.
struct Reply {
  enum class Kind : std::uint8_t {
    now,     ///< `content`, or else `answer` with `content_type`
    later,   ///< the function given to answer() is called
    stream,  ///< the stream of the plant's state
  };
  Kind kind = Kind::now;
  Answer answer = {};
  std::string_view content_type = "application/json";
  std::shared_ptr<Content> content = {};  ///< the same for all clients; may be null
  bool packable = true;                   ///< the body may be sent as gzip
  std::string file_name = {};             ///< the client stores the answer under this name; empty: it shows it
  Role role = Role::viewer;               ///< of a stream: its client's
  bool has_token = false;                 ///< of a stream: its client has a token
};

/// Changes for the stream. Empty: nothing new.
struct News {
  std::string all;    ///< for trainers
  std::string shown;  ///< for the other roles, which do not see everything
};

/// The interface of docs/panel-interface.md over a desk, or over a recording.
class Source {
 public:
  virtual ~Source() = default;
  /// The answer of GET /api/v1/plant without its first keys, which are the same for all. It never changes.
  virtual void put_description(std::string& json, Role role) = 0;
  virtual bool acts() const = 0;
  /// The answer to a GET of any other path of the interface; nothing if the path is unknown.
  virtual std::optional<Reply> get(std::string_view path, const std::map<std::string, std::string>& query,
                                   const Sender& sender, const Answered& later) = 0;
  virtual void post(std::string_view path, std::string_view body, const Sender& sender, const Answered& later) = 0;
  /// The event `picture` of the stream, as a role sees it.
  virtual std::string picture(Role role) = 0;
  /// What changed since the last call, for the event `changes`. `for_others`: News::shown is needed.
  virtual News changes(bool for_others) = 0;
  /// Whether all clients need the picture again.
  virtual bool begun_again() { return false; }
};

/// Checks access, and finds what a request asks for. For the panel's thread.
class Routes {
 public:
  /// `run`: a text that differs after each start.
  Routes(Source& source, const Access& access, std::string run = random_token());

  /// `later` may be called by another thread, once, if the reply says so; also before answer() returns. Throws what the
  /// source throws.
  Reply answer(const Request& request, const Answered& later);

 private:
  Reply get(const Request& request, const Answered& later);
  Reply post(const Request& request, const Answered& later);
  Reply description(Role role);
  Reply page_file(std::string_view path);

  Source& source_;
  const Access& access_;
  std::string run_;
  std::array<std::shared_ptr<Content>, kRoles> descriptions_;  ///< by role; null until it is asked for
  std::map<std::string_view, std::shared_ptr<Content>> page_;  ///< the files that were asked for, by their names
  std::int64_t second_ = 0;                                    ///< the second of the clock in which `acts_` are counted
  std::array<int, kRoles> acts_{};
};

/// Divides a target into its path, which begins with `/`, and its query, both decoded; false if it is not of this form.
bool split_target(std::string_view target, std::string& path, std::map<std::string, std::string>& query);

}  // namespace symplant::panel
