// The violations of each thread, and guarded work in a separate thread.
#include <algorithm>
#include <array>
#include <thread>

#include "symplant/exec/guard/guard.hpp"
#include "symplant/exec/guard/interpose.hpp"
#include "symplant/exec/guard/record.hpp"
#include "symplant/exec/guard/system_calls.hpp"

namespace symplant::exec {
namespace {

struct Thread {
  int depth = 0;
  Doing doing;
  std::uint64_t count = 0;
  std::array<Violation, kMostViolations> first;
};

constinit thread_local Thread self{};

}  // namespace

namespace guard {

bool guarded() noexcept { return self.depth > 0; }

void record(const Violation& violation) noexcept {
  if (self.count < kMostViolations) {
    self.first[self.count] = violation;
    self.first[self.count].doing = self.doing;
  }
  ++self.count;
}

}  // namespace guard

std::string act_of(const Violation& violation) {
  static constexpr std::array<const char*, 3> kKinds = {"heap: ", "lock: ", "system call: "};
  const std::string kind = kKinds[static_cast<std::size_t>(violation.kind)];
  return kind + (violation.name == nullptr ? guard::system_call_name(violation.number) : violation.name);
}

std::string words(const Violation& violation) {
  const std::string caller = caller_of(violation);
  return act_of(violation) + (caller.empty() ? "" : ", called from " + caller);
}

std::string GuardReport::text() const {
  std::string text;
  for (const Violation& violation : violations) text += words(violation) + "\n";
  if (count > violations.size()) text += "and " + std::to_string(count - violations.size()) + " more\n";
  return text;
}

DoingNow::DoingNow(Doing doing) noexcept : before_(self.doing) { self.doing = doing; }

DoingNow::~DoingNow() { self.doing = before_; }

Guard::Guard() noexcept { ++self.depth; }

Guard::~Guard() { --self.depth; }

Unguarded::Unguarded() noexcept : depth_(self.depth) { self.depth = 0; }

Unguarded::~Unguarded() { self.depth = depth_; }

GuardReport take_violations() {
  GuardReport report;
  report.count = self.count;
  const auto kept = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(self.count, kMostViolations));
  report.violations.assign(self.first.begin(), self.first.begin() + kept);
  self.count = 0;
  return report;
}

GuardReport run_watched(const std::function<void()>& work) {
  GuardReport report;
  const std::string no_hooks = guard::interpose();
  std::thread thread([&] {
    const std::string no_trap = trap_system_calls();
    work();
    report = take_violations();
    report.no_trap = no_trap;
  });
  thread.join();
  report.no_hooks = no_hooks;
  return report;
}

GuardReport run_guarded(const std::function<void()>& work) {
  return run_watched([&] {
    const Guard guard;
    work();
  });
}

}  // namespace symplant::exec
