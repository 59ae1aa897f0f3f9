// The record of each thread, and guarded work on a thread of its own.
#include "support/guard/guard.hpp"

#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <thread>

#include "support/guard/record.hpp"
#include "support/guard/system_calls.hpp"

namespace symplant::test {
namespace {

struct Thread {
  int depth;
  std::uint64_t count;
  std::array<Violation, kMostViolations> first;
};

constinit thread_local Thread self{};

std::string function_at(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || info.dli_sname == nullptr) return {};
  int fault = 0;
  const std::unique_ptr<char, decltype(&std::free)> readable(
      abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &fault), &std::free);
  return fault == 0 ? readable.get() : info.dli_sname;
}

}  // namespace

namespace guard {

bool guarded() noexcept { return self.depth > 0; }

void record(const Violation& violation) noexcept {
  if (self.count < kMostViolations) self.first[self.count] = violation;
  ++self.count;
}

}  // namespace guard

std::string words(const Violation& violation) {
  static constexpr std::array<const char*, 3> kKinds = {"heap: ", "lock: ", "system call: "};
  std::string text = kKinds[static_cast<std::size_t>(violation.kind)];
  text += violation.name == nullptr ? guard::system_call_name(violation.number) : violation.name;
  const std::string caller = function_at(violation.caller);
  if (!caller.empty()) text += ", called from " + caller;
  return text;
}

std::string GuardReport::text() const {
  std::string text;
  for (const Violation& violation : violations) text += words(violation) + "\n";
  if (count > violations.size()) text += "and " + std::to_string(count - violations.size()) + " more\n";
  return text;
}

Guard::Guard() noexcept { ++self.depth; }

Guard::~Guard() { --self.depth; }

GuardReport take_violations() {
  GuardReport report;
  report.count = self.count;
  const auto kept = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(self.count, kMostViolations));
  report.violations.assign(self.first.begin(), self.first.begin() + kept);
  self.count = 0;
  return report;
}

GuardReport run_guarded(const std::function<void()>& work) {
  GuardReport report;
  std::thread thread([&] {
    const std::string no_trap = trap_system_calls();
    {
      const Guard guard;
      work();
    }
    report = take_violations();
    report.no_trap = no_trap;
  });
  thread.join();
  return report;
}

}  // namespace symplant::test
