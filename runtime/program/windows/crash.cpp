// Reports a program that crashes, by the exceptions of Windows.
#include "symplant/program/crash.hpp"

#include <windows.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include "symplant/program/crash_text.hpp"

namespace symplant::program {
namespace {

struct Exception {
  DWORD code;
  std::string_view words;
};
constexpr std::array<Exception, 7> kExceptions{{{EXCEPTION_ACCESS_VIOLATION, "ended by an access violation"},
                                                {EXCEPTION_IN_PAGE_ERROR, "ended by an error of reading a page"},
                                                {EXCEPTION_INT_DIVIDE_BY_ZERO, "ended by a division by zero"},
                                                {EXCEPTION_INT_OVERFLOW, "ended by a division that overflows"},
                                                {EXCEPTION_ILLEGAL_INSTRUCTION, "ended by an illegal instruction"},
                                                {EXCEPTION_PRIV_INSTRUCTION, "ended by a privileged instruction"},
                                                {EXCEPTION_STACK_OVERFLOW, "ended by a stack overflow"}}};
constexpr ULONG kStackForReport = 64 * 1024;

std::mutex mutex;  ///< of `call`, for the thread that looks at it
Call call;         // programs are called by one thread
std::atomic<DWORD> calling_thread{0};
std::atomic<std::uint64_t> calls{0};
LPTOP_LEVEL_EXCEPTION_FILTER filter_before = nullptr;
void (*abort_before)(int) = nullptr;

[[noreturn]] void end(const CrashText& words) {
  const std::string_view text = words.text();
  DWORD count = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), text.data(), static_cast<DWORD>(text.size()), &count, nullptr);
  TerminateProcess(GetCurrentProcess(), kCrashExitCode);
  for (;;) Sleep(INFINITE);
}

bool is_in_call() { return call.name != nullptr && calling_thread.load() == GetCurrentThreadId(); }

/// For what the program does not handle itself.
LONG WINAPI report(EXCEPTION_POINTERS* fault) {
  if (!is_in_call()) return EXCEPTION_CONTINUE_SEARCH;
  for (const Exception& known : kExceptions) {
    if (known.code == fault->ExceptionRecord->ExceptionCode) end({call, known.words});
  }
  end({call, "ended by an exception that nothing handles"});
}

/// abort(), also by an assertion or an exception of C++ that nothing handles.
void report_abort(int /*signal*/) {
  if (is_in_call()) end({call, "ended by abort()"});
}

/// Looks once a second at the call that runs.
class Watch {
 public:
  Watch() : thread_([this](const std::stop_token& stop) { look(stop); }) {}

 private:
  void look(const std::stop_token& stop) {
    std::unique_lock lock(sleep_);
    std::uint64_t seen = 0;
    for (int times = 0; !stop.stop_requested();) {
      wake_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
      const std::scoped_lock no_end_of_call(mutex);
      const bool goes_on = call.name != nullptr && calls.load() == seen;
      times = goes_on ? times + 1 : 0;
      seen = calls.load();
      if (times >= kLongestCall) end({call, "does not return", " after 10 s"});
    }
  }

  std::mutex sleep_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

std::optional<Watch> watch;

}  // namespace

CrashReport::CrashReport() {
  ULONG stack = kStackForReport;
  SetThreadStackGuarantee(&stack);
  filter_before = SetUnhandledExceptionFilter(report);
  abort_before = std::signal(SIGABRT, report_abort);
}

CrashReport::~CrashReport() {
  SetUnhandledExceptionFilter(filter_before);
  std::signal(SIGABRT, abort_before);
}

CallLimit::CallLimit() { watch.emplace(); }

CallLimit::~CallLimit() { watch.reset(); }

Called::Called(const char* name, std::int64_t scan, tables::Time now) noexcept {
  const std::scoped_lock lock(mutex);
  call.scan = scan;
  call.now = now;
  calls.store(calls.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  calling_thread.store(GetCurrentThreadId(), std::memory_order_relaxed);
  call.name = name;
}

Called::~Called() {
  const std::scoped_lock lock(mutex);
  call.name = nullptr;
}

}  // namespace symplant::program
