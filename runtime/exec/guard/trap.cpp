// Traps the system calls of a thread with seccomp: records them if the thread is guarded, then makes them.
//
// The filter allows calls from one instruction, in symplant_guard_forward below. Every other call raises SIGSYS; the
// handler records the call and makes it from that instruction.
#include <cerrno>
#include <cstring>
#include <string>

#include "symplant/exec/guard/record.hpp"
#include "symplant/exec/guard/thread_sanitizer.hpp"

#if defined(__linux__) && defined(__x86_64__)

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>

extern "C" {
/// `call` is the number of the system call and its six arguments.
long symplant_guard_forward(const long* call) noexcept;
extern const char symplant_guard_forward_return[];  // NOLINT: an address in code
}

__asm__(R"(
  .text
  .globl symplant_guard_forward
  .globl symplant_guard_forward_return
  .type symplant_guard_forward, @function
symplant_guard_forward:
  movq 0(%rdi), %rax
  movq 16(%rdi), %rsi
  movq 24(%rdi), %rdx
  movq 32(%rdi), %r10
  movq 40(%rdi), %r8
  movq 48(%rdi), %r9
  movq 8(%rdi), %rdi
  syscall
symplant_guard_forward_return:
  ret
  .size symplant_guard_forward, .-symplant_guard_forward
)");

namespace symplant::exec {
namespace {

std::string failed(const char* what) { return std::string(what) + ": " + std::strerror(errno); }

/// Sets the signal mask of the interrupted context: a mask set in the handler would be lost when it returns. SIGSYS is
/// never blocked, as a trap would then end the process.
long set_mask(ucontext_t& context, long how, const std::uint64_t* set, std::uint64_t* old) noexcept {
  std::uint64_t mask = 0;
  std::memcpy(&mask, &context.uc_sigmask, sizeof mask);
  if (old != nullptr) *old = mask;
  if (set == nullptr) return 0;
  if (how == SIG_BLOCK) {
    mask |= *set;
  } else if (how == SIG_UNBLOCK) {
    mask &= ~*set;
  } else {
    mask = *set;
  }
  mask &= ~(std::uint64_t{1} << (SIGSYS - 1));
  std::memcpy(&context.uc_sigmask, &mask, sizeof mask);
  return 0;
}

constexpr int kFromFilter = 1;  ///< SYS_SECCOMP of the kernel's siginfo.h, which glibc's does not have

bool starts_another(long number) noexcept {
  return number == SYS_clone || number == SYS_clone3 || number == SYS_fork || number == SYS_vfork;
}

void on_trap(int, siginfo_t* info, void* raw) noexcept {
  if (info->si_code != kFromFilter) return;
  auto& context = *static_cast<ucontext_t*>(raw);
  auto& registers = context.uc_mcontext.gregs;
  const long number = info->si_syscall;
  if (guard::guarded()) guard::record({Violation::Kind::system_call, nullptr, number, info->si_call_addr, {}});
  if (starts_another(number)) {  // the new thread or process would start in this handler
    registers[REG_RAX] = -ENOSYS;
  } else if (number == SYS_rt_sigprocmask) {
    // Registers hold addresses as numbers.
    // NOLINTBEGIN(performance-no-int-to-ptr)
    registers[REG_RAX] =
        set_mask(context, registers[REG_RDI], reinterpret_cast<const std::uint64_t*>(registers[REG_RSI]),
                 reinterpret_cast<std::uint64_t*>(registers[REG_RDX]));
    // NOLINTEND(performance-no-int-to-ptr)
  } else {
    const long call[] = {number,
                         registers[REG_RDI],
                         registers[REG_RSI],
                         registers[REG_RDX],
                         registers[REG_R10],
                         registers[REG_R8],
                         registers[REG_R9]};
    registers[REG_RAX] = symplant_guard_forward(call);
  }
}

std::string handle_traps() {
  struct sigaction action {};
  action.sa_sigaction = on_trap;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0) return failed("sigaction");
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGSYS);
  if (const int fault = pthread_sigmask(SIG_UNBLOCK, &set, nullptr); fault != 0) {
    errno = fault;
    return failed("pthread_sigmask");
  }
  return {};
}

constexpr sock_filter load(std::size_t offset) {
  return {BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)};
}
/// Skips `otherwise` instructions if the loaded word is not `value`.
constexpr sock_filter unless(std::uint32_t value, std::uint8_t otherwise) {
  return {BPF_JMP | BPF_JEQ | BPF_K, 0, otherwise, value};
}
constexpr sock_filter give(std::uint32_t verdict) { return {BPF_RET | BPF_K, 0, 0, verdict}; }

std::string set_filter() {
  const auto index = reinterpret_cast<std::uintptr_t>(symplant_guard_forward_return);
  const auto low = static_cast<std::uint32_t>(index);
  const auto high = static_cast<std::uint32_t>(index >> 32);
  constexpr std::size_t kIndex = offsetof(seccomp_data, instruction_pointer);
  std::array program = {load(offsetof(seccomp_data, arch)),
                        unless(AUDIT_ARCH_X86_64, 8),
                        load(offsetof(seccomp_data, nr)),
                        unless(SYS_rt_sigreturn, 1),  // the return from a signal handler
                        give(SECCOMP_RET_ALLOW),
                        load(kIndex),
                        unless(low, 3),
                        load(kIndex + 4),
                        unless(high, 1),
                        give(SECCOMP_RET_ALLOW),
                        give(SECCOMP_RET_TRAP)};
  const sock_fprog filter{program.size(), program.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return failed("prctl(PR_SET_NO_NEW_PRIVS)");
  if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) != 0) return failed("seccomp");
  return {};
}

/// Checks the trap with one call: some emulated kernels accept a filter and ignore it.
std::string try_trap() {
  {
    const Guard guard;
    syscall(SYS_getppid);
  }
  return take_violations().count == 1 ? "" : "seccomp: the filter is set but nothing is trapped";
}

}  // namespace

std::string trap_system_calls() {
  if (guard::kBesideThreadSanitizer) return "the thread sanitizer delivers signals late";
  std::string fault = handle_traps();
  if (fault.empty()) fault = set_filter();
  return fault.empty() ? try_trap() : fault;
}

}  // namespace symplant::exec

#else

namespace symplant::exec {

std::string trap_system_calls() { return "system calls are trapped on x86-64 Linux only"; }

}  // namespace symplant::exec

#endif
