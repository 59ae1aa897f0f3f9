// Checks that code uses no heap, no lock and no system call: uses inside the guard are recorded by name.
//
// A program that does not use the guard has no cost. With the guard, the functions of heap and locks are interposed
// (interpose.hpp): they record only in a thread that is guarded at that moment, and always do their normal work. The
// trap of system calls (seccomp, x86-64 Linux) does the same; it is set per thread and cannot be removed. Not detected:
// calls that the kernel serves in user space (clock_gettime in the vDSO), page faults (thread_faults.hpp counts them),
// locks made of atomics only, and locks that a library takes internally.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace symplant::exec {

/// The function of a custom behavior that runs, and its unit (see DoingNow).
struct Doing {
  const char* function = nullptr;  ///< null: not in a custom behavior
  std::uint32_t unit = 0;
};

/// A forbidden call in guarded code.
struct Violation {
  enum class Kind : std::uint8_t { heap, lock, system_call };
  Kind kind = Kind::heap;
  const char* name = nullptr;    ///< of the function; null for a system call
  long number = 0;               ///< of the system call
  const void* caller = nullptr;  ///< the instruction after the call
  Doing doing;
};

/// "heap: operator new", "system call: write".
std::string act_of(const Violation& violation);
/// The function that made the call, or its file and offset; empty if unknown.
std::string caller_of(const Violation& violation);
/// "heap: operator new, called from main".
std::string words(const Violation& violation);

inline constexpr std::size_t kMostViolations = 64;  ///< kept per thread; all are counted

struct GuardReport {
  std::vector<Violation> violations;  ///< the first kMostViolations, in order of time
  std::uint64_t count = 0;            ///< number of all violations
  std::string no_hooks;               ///< why heap and locks were not checked; empty if they were
  std::string no_trap;                ///< why system calls were not checked; empty if they were

  /// One line per violation.
  std::string text() const;
};

/// Runs `work` in a separate thread, with the trap and inside the guard.
GuardReport run_guarded(const std::function<void()>& work);
/// As run_guarded(), but `work` constructs a Guard itself around the code to check, such as a cycle that sleeps.
GuardReport run_watched(const std::function<void()>& work);

/// The calling thread is guarded during the lifetime of a Guard. Guards may be nested.
class Guard {
 public:
  Guard() noexcept;
  ~Guard();
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
};

/// Suspends all guards of the calling thread during its lifetime, for example for the sleep between two cycles.
class Unguarded {
 public:
  Unguarded() noexcept;
  ~Unguarded();
  Unguarded(const Unguarded&) = delete;
  Unguarded& operator=(const Unguarded&) = delete;

 private:
  int depth_;
};

/// Violations of the calling thread during its lifetime are attributed to `doing`.
class DoingNow {
 public:
  explicit DoingNow(Doing doing) noexcept;
  ~DoingNow();
  DoingNow(const DoingNow&) = delete;
  DoingNow& operator=(const DoingNow&) = delete;

 private:
  Doing before_;
};

/// Traps every system call of the calling thread permanently; it can no longer start threads or processes. Returns the
/// reason if that is not possible, else an empty text.
std::string trap_system_calls();

/// The violations of the calling thread since the last call.
GuardReport take_violations();

}  // namespace symplant::exec
