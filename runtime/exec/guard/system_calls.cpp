// Names of the system calls that a plant's code may make by mistake.
#include "symplant/exec/guard/system_calls.hpp"

#include <sys/syscall.h>

#include <array>

namespace symplant::exec::guard {
namespace {

struct Name {
  long number;
  const char* name;
};

constexpr std::array kNames = {Name{SYS_read, "read"},
                               Name{SYS_write, "write"},
                               Name{SYS_writev, "writev"},
                               Name{SYS_openat, "openat"},
                               Name{SYS_close, "close"},
                               Name{SYS_lseek, "lseek"},
                               Name{SYS_fsync, "fsync"},
                               Name{SYS_ioctl, "ioctl"},
                               Name{SYS_mmap, "mmap"},
                               Name{SYS_munmap, "munmap"},
                               Name{SYS_mremap, "mremap"},
                               Name{SYS_mprotect, "mprotect"},
                               Name{SYS_madvise, "madvise"},
                               Name{SYS_brk, "brk"},
                               Name{SYS_futex, "futex"},
                               Name{SYS_sched_yield, "sched_yield"},
                               Name{SYS_nanosleep, "nanosleep"},
                               Name{SYS_clock_nanosleep, "clock_nanosleep"},
                               Name{SYS_clock_gettime, "clock_gettime"},
                               Name{SYS_gettimeofday, "gettimeofday"},
                               Name{SYS_getrandom, "getrandom"},
                               Name{SYS_ppoll, "ppoll"},
                               Name{SYS_epoll_pwait, "epoll_wait"},
                               Name{SYS_sendto, "send"},
                               Name{SYS_recvfrom, "recv"},
                               Name{SYS_rt_sigprocmask, "rt_sigprocmask"},
                               Name{SYS_tgkill, "tgkill"},
                               Name{SYS_gettid, "gettid"},
                               Name{SYS_getpid, "getpid"},
                               Name{SYS_exit, "exit"},
                               Name{SYS_exit_group, "exit_group"}};

}  // namespace

std::string system_call_name(long number) {
  for (const Name& known : kNames) {
    if (known.number == number) return known.name;
  }
  return "number " + std::to_string(number);
}

}  // namespace symplant::exec::guard
