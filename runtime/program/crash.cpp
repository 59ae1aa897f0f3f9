// Reports a program that crashes.
#include "symplant/program/crash.hpp"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string_view>

namespace symplant::program {
namespace {

struct Signal {
  int number;
  std::string_view name;
};
constexpr std::array<Signal, 5> kSignals{
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};
constexpr int kEnvironment = 3;
constexpr int kLongestCall = 10;  // s

/// The call that runs. A signal handler has nothing else of what it reports.
struct Call {
  const char* volatile name = nullptr;  ///< null: none
  volatile std::int64_t scan = 0;
  volatile tables::Time now = 0;
};
thread_local Call call;
/// How many calls began, to see whether one goes on.
thread_local volatile std::uint64_t calls = 0;
std::array<struct sigaction, kSignals.size()> before;
alignas(16) std::array<char, 64 * 1024> stack;  // a program may have used up its own

/// Text in the memory of a signal handler.
class Text {
 public:
  void add(std::string_view text) {
    const std::size_t size = std::min(text.size(), bytes_.size() - size_);
    std::memcpy(bytes_.data() + size_, text.data(), size);
    size_ += size;
  }
  void add(std::uint64_t number) {
    std::array<char, 20> digits{};
    std::size_t at = digits.size();
    do {
      digits[--at] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    add({digits.data() + at, digits.size() - at});
  }
  /// "8.12 s"
  void add_seconds(tables::Time time) {
    add(static_cast<std::uint64_t>(time / tables::kSecond));
    auto rest = static_cast<std::uint64_t>(time % tables::kSecond);
    if (rest != 0) add(".");
    for (std::uint64_t unit = tables::kSecond / 10; rest != 0; unit /= 10) {
      add(rest / unit);
      rest %= unit;
    }
    add(" s");
  }
  /// " in scan 812 (8.12 s)", of the call that runs.
  void add_call() {
    if (call.scan < 0) {
      add(" at its start or end (");
    } else {
      add(" in scan ");
      add(static_cast<std::uint64_t>(call.scan));
      add(" (");
    }
    add_seconds(call.now);
    add(")");
  }
  void write() const {
    if (::write(STDERR_FILENO, bytes_.data(), size_) < 0) return;  // there is nowhere to report that
  }

 private:
  std::array<char, 512> bytes_{};
  std::size_t size_ = 0;
};

void report(int signal) {
  if (call.name == nullptr) {  // not of a program
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      if (kSignals[i].number == signal) ::sigaction(signal, &before[i], nullptr);
    }
    ::raise(signal);
    return;
  }
  Text text;
  text.add("error: program `");
  text.add(std::string_view(call.name));
  text.add("` ended by ");
  for (const Signal& known : kSignals) {
    if (known.number == signal) text.add(known.name);
  }
  text.add_call();
  text.add("\n");
  text.write();
  ::_exit(kEnvironment);
}

/// Called once a second.
void look_at_call(int) {
  static volatile std::uint64_t seen = 0;
  static volatile int times = 0;
  if (call.name == nullptr || calls != seen) {
    seen = calls;
    times = 0;
    return;
  }
  times = times + 1;
  if (times < kLongestCall) return;
  Text text;
  text.add("error: program `");
  text.add(std::string_view(call.name));
  text.add("` does not return");
  text.add_call();
  text.add(" after 10 s\n");
  text.write();
  ::_exit(kEnvironment);
}

}  // namespace

CrashReport::CrashReport() {
  stack_t alternate{};
  alternate.ss_sp = stack.data();
  alternate.ss_size = stack.size();
  ::sigaltstack(&alternate, nullptr);
  struct sigaction action {};
  action.sa_handler = report;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i].number, &action, &before[i]);
}

CrashReport::~CrashReport() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i].number, &before[i], nullptr);
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  ::sigaltstack(&none, nullptr);
}

CallLimit::CallLimit() {
  struct sigaction action {};
  action.sa_handler = look_at_call;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  ::sigaction(SIGALRM, &action, nullptr);
  const itimerval each_second{{1, 0}, {1, 0}};
  ::setitimer(ITIMER_REAL, &each_second, nullptr);
}

CallLimit::~CallLimit() {
  const itimerval never{};
  ::setitimer(ITIMER_REAL, &never, nullptr);
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  ::sigaction(SIGALRM, &action, nullptr);
}

Called::Called(const char* name, std::int64_t scan, tables::Time now) noexcept {
  call.scan = scan;
  call.now = now;
  calls = calls + 1;
  call.name = name;
}

Called::~Called() { call.name = nullptr; }

}  // namespace symplant::program
