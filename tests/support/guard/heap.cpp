// The allocator's functions, interposed: noted where the thread is guarded, then done by glibc's own.
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "support/guard/record.hpp"

extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* memory, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
void __libc_free(void* memory) noexcept;
}

namespace {

using symplant::test::Violation;

void note(const char* name, const void* caller) noexcept {
  symplant::test::guard::note(Violation::Kind::heap, name, caller);
}

void* made(const char* name, const void* caller, std::size_t size, std::size_t alignment) {
  note(name, caller);
  void* const memory = alignment == 0 ? __libc_malloc(size) : __libc_memalign(alignment, size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void gone(void* memory, const void* caller) noexcept {
  if (memory != nullptr) note("operator delete", caller);
  __libc_free(memory);
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
  note("malloc", __builtin_return_address(0));
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  note("calloc", __builtin_return_address(0));
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  note("realloc", __builtin_return_address(0));
  return __libc_realloc(memory, size);
}

void free(void* memory) noexcept {
  if (memory != nullptr) note("free", __builtin_return_address(0));
  __libc_free(memory);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  note("memalign", __builtin_return_address(0));
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  note("aligned_alloc", __builtin_return_address(0));
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  note("posix_memalign", __builtin_return_address(0));
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr) return ENOMEM;
  *memory = found;
  return 0;
}

}  // extern "C"

// The forms for arrays, and those that do not throw, are the library's: they call these.
void* operator new(std::size_t size) { return made("operator new", __builtin_return_address(0), size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return made("operator new", __builtin_return_address(0), size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { gone(memory, __builtin_return_address(0)); }
void operator delete(void* memory, std::size_t) noexcept { gone(memory, __builtin_return_address(0)); }
void operator delete(void* memory, std::align_val_t) noexcept { gone(memory, __builtin_return_address(0)); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  gone(memory, __builtin_return_address(0));
}
