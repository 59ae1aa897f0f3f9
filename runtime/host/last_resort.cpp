// Ends a run that does not end after a signal.
#include "symplant/host/last_resort.hpp"

#include <chrono>
#include <string_view>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/terminal.hpp"

namespace symplant::host {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kLook{100};
constexpr milliseconds kSameWish{200};  ///< a closed terminal may send its signal twice
constexpr milliseconds kPatience{500};
constexpr int kLooks = 3;  ///< a slow reader takes something in between

[[noreturn]] void end_at_once(std::string_view why) {
  write_error_now(why);
  end_process(kEnvironment);
}

}  // namespace

LastResort::LastResort() {
  thread_ = std::jthread([this](const std::stop_token& done) { look(done); });
}

LastResort::~LastResort() {
  thread_.request_stop();
  thread_.join();
}

void LastResort::look(const std::stop_token& done) {
  std::unique_lock lock(mutex_);
  const auto wait = [&] { wake_.wait_for(lock, done, kLook, [] { return false; }); };
  while (!done.stop_requested() && !stop_requested().load()) wait();
  const Clock::time_point reported = Clock::now();
  int wishes = 0;
  int not_taken = 0;  // looks in a row
  for (; !done.stop_requested(); wait()) {
    const auto since = Clock::now() - reported;
    if (since < kSameWish) {
      wishes = stop_wishes();
    } else if (stop_wishes() != wishes) {
      end_at_once("error: ended at once by a second signal; outputs may be incomplete\n");
    }
    not_taken = output_is_full() ? not_taken + 1 : 0;
    if (since < kPatience) continue;
    if (!begun_.load()) end_at_once("error: ended by a signal before the run began\n");
    if (not_taken >= kLooks) {
      end_at_once("error: ended by a signal while an output was blocked; outputs may be incomplete\n");
    }
  }
}

}  // namespace symplant::host
