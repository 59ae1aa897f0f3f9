// Proof that code uses no heap, no lock and no system call: what it does of these inside the guard is recorded by name.
//
// A program that does not ask for it pays nothing. Who asks has the functions of heap and locks interposed
// (interpose.hpp); they record only on a thread that is guarded at that moment, and always do what they were called
// for. So does the trap of system calls (seccomp, x86-64 Linux), which is set thread by thread and cannot be taken away
// again. Not seen: calls that the kernel serves in user space (clock_gettime of the vDSO), page faults
// (thread_faults.hpp counts them), locks built of atomics alone, and locks that a library takes within itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace symplant::exec {

/// Whose code runs, as far as the guard was told.
struct Doing {
  const char* function = nullptr;  ///< null: nobody said
  std::uint32_t unit = 0;
};

/// What guarded code did that it must not do.
struct Violation {
  enum class Kind : std::uint8_t { heap, lock, system_call };
  Kind kind = Kind::heap;
  const char* name = nullptr;    ///< of the function; null for a system call
  long number = 0;               ///< of the system call
  const void* caller = nullptr;  ///< the instruction behind the call
  Doing doing;
};

/// "heap: operator new", "system call: write".
std::string act_of(const Violation& violation);
/// The function that the call came from, or its file and place there.
std::string caller_of(const Violation& violation);
/// "heap: operator new, called from main".
std::string words(const Violation& violation);

inline constexpr std::size_t kMostViolations = 64;  ///< of one thread that are kept; all are counted

struct GuardReport {
  std::vector<Violation> violations;  ///< in their order
  std::uint64_t count = 0;
  std::string no_hooks;  ///< why heap and locks could not be looked at; empty: they were
  std::string no_trap;   ///< why system calls could not be trapped; empty: they were

  /// A line each.
  std::string text() const;
};

/// Runs `work` on a thread of its own, under the trap and inside the guard.
GuardReport run_guarded(const std::function<void()>& work);
/// The same for work that makes a Guard itself where it wants to be looked at: a cycle that sleeps between its cycles.
GuardReport run_watched(const std::function<void()>& work);

/// While one lives, the calling thread is guarded.
class Guard {
 public:
  Guard() noexcept;
  ~Guard();
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
};

/// While one lives, the calling thread is not guarded, however many guards it is in: for the sleep between two cycles.
class Unguarded {
 public:
  Unguarded() noexcept;
  ~Unguarded();
  Unguarded(const Unguarded&) = delete;
  Unguarded& operator=(const Unguarded&) = delete;

 private:
  int depth_;
};

/// What is recorded on the calling thread while one lives is said to be of this code.
class DoingNow {
 public:
  explicit DoingNow(Doing doing) noexcept;
  ~DoingNow();
  DoingNow(const DoingNow&) = delete;
  DoingNow& operator=(const DoingNow&) = delete;

 private:
  Doing before_;
};

/// Every system call of the calling thread is trapped from now on, for good; a thread or process cannot be started from
/// it any more. Gives why that cannot be; empty: it is so.
std::string trap_system_calls();

/// What was recorded on the calling thread since the last call.
GuardReport take_violations();

}  // namespace symplant::exec
