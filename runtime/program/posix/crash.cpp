// Reports a program that crashes, by signals.
#include "symplant/program/crash.hpp"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <string_view>

#include "symplant/program/crash_text.hpp"

namespace symplant::program {
namespace {

struct Signal {
  int number;
  std::string_view words;
};
constexpr std::array<Signal, 5> kSignals{{{SIGSEGV, "ended by SIGSEGV"},
                                          {SIGBUS, "ended by SIGBUS"},
                                          {SIGFPE, "ended by SIGFPE"},
                                          {SIGILL, "ended by SIGILL"},
                                          {SIGABRT, "ended by SIGABRT"}}};

thread_local Call call;
/// How many calls began, to see whether one goes on.
thread_local volatile std::uint64_t calls = 0;
std::array<struct sigaction, kSignals.size()> before;
alignas(16) std::array<char, 64 * 1024> stack;  // a program may have used up its own

[[noreturn]] void end(const CrashText& words) {
  const std::string_view text = words.text();
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) ::_exit(kCrashExitCode);  // there is nowhere to report that
  ::_exit(kCrashExitCode);
}

void report(int signal) {
  if (call.name == nullptr) {  // not of a program
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      if (kSignals[i].number == signal) ::sigaction(signal, &before[i], nullptr);
    }
    ::raise(signal);
    return;
  }
  for (const Signal& known : kSignals) {
    if (known.number == signal) end({call, known.words});
  }
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
  end({call, "does not return", " after 10 s"});
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
