// Hooks of heap and lock functions: they record a call if the thread is guarded, then call the original function.
#include "symplant/exec/guard/hooks.hpp"

#include <array>
#include <cstddef>
#include <tuple>

#include "symplant/exec/guard/record.hpp"

namespace symplant::exec::guard {
namespace {

/// Above 0 inside a hook: nested calls (`operator new` calls malloc) are not recorded again.
constinit thread_local int inside = 0;

class Noted {
 public:
  Noted(bool wanted, Violation::Kind kind, const char* name, const void* caller) noexcept {
    if (wanted && inside == 0) note(kind, name, caller);
    ++inside;
  }
  ~Noted() { --inside; }
  Noted(const Noted&) = delete;
  Noted& operator=(const Noted&) = delete;
};

using Kind = Violation::Kind;

/// The hook of the function in row `Row` of kRows. With `Frees`, a call with a null pointer is not recorded.
template <std::size_t Row, bool Frees, class Result, class... Arguments>
struct Function {
  static constinit inline void* next = nullptr;
  static Result call(Arguments... arguments);
};

template <std::size_t Row, class... Arguments>
using Gives = Function<Row, false, void*, Arguments...>;
template <std::size_t Row, class... Arguments>
using Takes = Function<Row, true, void, void*, Arguments...>;
template <std::size_t Row, class... Arguments>
using Locks = Function<Row, false, int, void*, Arguments...>;

template <class Which>
Hook hook(const char* symbol, const char* name, Kind kind) noexcept {
  return {symbol, name, kind, reinterpret_cast<void*>(&Which::call), &Which::next};
}

constexpr const char* kNew = "operator new";
constexpr const char* kDelete = "operator delete";
using Size = std::size_t;

const std::array kRows = {
    hook<Gives<0, Size>>("malloc", "malloc", Kind::heap),
    hook<Gives<1, Size, Size>>("calloc", "calloc", Kind::heap),
    hook<Gives<2, void*, Size>>("realloc", "realloc", Kind::heap),
    hook<Takes<3>>("free", "free", Kind::heap),
    hook<Gives<4, Size, Size>>("memalign", "memalign", Kind::heap),
    hook<Gives<5, Size, Size>>("aligned_alloc", "aligned_alloc", Kind::heap),
    hook<Function<6, false, int, void**, Size, Size>>("posix_memalign", "posix_memalign", Kind::heap),
    hook<Gives<7, Size>>("_Znwm", kNew, Kind::heap),
    hook<Gives<8, Size>>("_Znam", kNew, Kind::heap),
    hook<Gives<9, Size, const void*>>("_ZnwmRKSt9nothrow_t", kNew, Kind::heap),
    hook<Gives<10, Size, const void*>>("_ZnamRKSt9nothrow_t", kNew, Kind::heap),
    hook<Gives<11, Size, Size>>("_ZnwmSt11align_val_t", kNew, Kind::heap),
    hook<Gives<12, Size, Size>>("_ZnamSt11align_val_t", kNew, Kind::heap),
    hook<Gives<13, Size, Size, const void*>>("_ZnwmSt11align_val_tRKSt9nothrow_t", kNew, Kind::heap),
    hook<Gives<14, Size, Size, const void*>>("_ZnamSt11align_val_tRKSt9nothrow_t", kNew, Kind::heap),
    hook<Takes<15>>("_ZdlPv", kDelete, Kind::heap),
    hook<Takes<16>>("_ZdaPv", kDelete, Kind::heap),
    hook<Takes<17, Size>>("_ZdlPvm", kDelete, Kind::heap),
    hook<Takes<18, Size>>("_ZdaPvm", kDelete, Kind::heap),
    hook<Takes<19, Size>>("_ZdlPvSt11align_val_t", kDelete, Kind::heap),
    hook<Takes<20, Size>>("_ZdaPvSt11align_val_t", kDelete, Kind::heap),
    hook<Takes<21, Size, Size>>("_ZdlPvmSt11align_val_t", kDelete, Kind::heap),
    hook<Takes<22, Size, Size>>("_ZdaPvmSt11align_val_t", kDelete, Kind::heap),
    hook<Locks<23>>("pthread_mutex_lock", "pthread_mutex_lock", Kind::lock),
    hook<Locks<24>>("pthread_mutex_trylock", "pthread_mutex_trylock", Kind::lock),
    hook<Locks<25, const void*>>("pthread_mutex_timedlock", "pthread_mutex_timedlock", Kind::lock),
    hook<Locks<26, int, const void*>>("pthread_mutex_clocklock", "pthread_mutex_clocklock", Kind::lock),
    hook<Locks<27>>("pthread_rwlock_rdlock", "pthread_rwlock_rdlock", Kind::lock),
    hook<Locks<28>>("pthread_rwlock_wrlock", "pthread_rwlock_wrlock", Kind::lock),
    hook<Locks<29>>("pthread_rwlock_tryrdlock", "pthread_rwlock_tryrdlock", Kind::lock),
    hook<Locks<30>>("pthread_rwlock_trywrlock", "pthread_rwlock_trywrlock", Kind::lock),
    hook<Locks<31>>("pthread_spin_lock", "pthread_spin_lock", Kind::lock),
    hook<Locks<32>>("pthread_spin_trylock", "pthread_spin_trylock", Kind::lock),
    hook<Locks<33, void*>>("pthread_cond_wait", "pthread_cond_wait", Kind::lock),
    hook<Locks<34, void*, const void*>>("pthread_cond_timedwait", "pthread_cond_timedwait", Kind::lock),
    hook<Locks<35>>("sem_wait", "sem_wait", Kind::lock),
    hook<Locks<36>>("sem_trywait", "sem_trywait", Kind::lock),
    hook<Locks<37, void*, int, const void*>>("pthread_cond_clockwait", "pthread_cond_clockwait", Kind::lock),
    hook<Locks<38, const void*>>("pthread_rwlock_timedrdlock", "pthread_rwlock_timedrdlock", Kind::lock),
    hook<Locks<39, const void*>>("pthread_rwlock_timedwrlock", "pthread_rwlock_timedwrlock", Kind::lock),
    hook<Locks<40, int, const void*>>("pthread_rwlock_clockrdlock", "pthread_rwlock_clockrdlock", Kind::lock),
    hook<Locks<41, int, const void*>>("pthread_rwlock_clockwrlock", "pthread_rwlock_clockwrlock", Kind::lock),
    hook<Locks<42, const void*>>("sem_timedwait", "sem_timedwait", Kind::lock),
    hook<Locks<43, int, const void*>>("sem_clockwait", "sem_clockwait", Kind::lock),
    hook<Locks<44>>("pthread_barrier_wait", "pthread_barrier_wait", Kind::lock),
};

template <std::size_t Row, bool Frees, class Result, class... Arguments>
Result Function<Row, Frees, Result, Arguments...>::call(Arguments... arguments) {
  bool wanted = true;
  if constexpr (Frees) wanted = std::get<0>(std::tuple<Arguments...>(arguments...)) != nullptr;
  const Noted noted(wanted, kRows[Row].kind, kRows[Row].name, __builtin_return_address(0));
  return reinterpret_cast<Result (*)(Arguments...)>(next)(arguments...);
}

}  // namespace

std::span<const Hook> hooks() noexcept { return kRows; }

}  // namespace symplant::exec::guard
