// Interposes functions in a running program: replaces their addresses in the tables that the loader filled.
#include "symplant/exec/guard/interpose.hpp"

#if defined(__linux__) && defined(__LP64__)

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "symplant/exec/guard/hooks.hpp"
#include "symplant/exec/guard/thread_sanitizer.hpp"

// The loader's tables hold addresses as numbers.
// NOLINTBEGIN(performance-no-int-to-ptr)

namespace symplant::exec::guard {
namespace {

#if defined(__x86_64__)
constexpr std::uint64_t kJumpSlot = R_X86_64_JUMP_SLOT;
constexpr std::uint64_t kGlobalData = R_X86_64_GLOB_DAT;
#elif defined(__aarch64__)
constexpr std::uint64_t kJumpSlot = R_AARCH64_JUMP_SLOT;
constexpr std::uint64_t kGlobalData = R_AARCH64_GLOB_DAT;
#else
constexpr std::uint64_t kJumpSlot = ~std::uint64_t{0};
constexpr std::uint64_t kGlobalData = ~std::uint64_t{0};
#endif

/// The tables in the dynamic section of a loaded file.
struct Tables {
  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela) * calls = nullptr;  ///< relocations of functions called
  std::size_t calls_size = 0;
  const ElfW(Rela) * others = nullptr;
  std::size_t others_size = 0;
};

Tables tables_of(ElfW(Addr) base, const ElfW(Dyn) * entry) noexcept {
  Tables tables;
  for (; entry->d_tag != DT_NULL; ++entry) {
    // glibc has relocated most of these to addresses, but not in files with a read-only section.
    const ElfW(Addr) address = entry->d_un.d_ptr < base ? base + entry->d_un.d_ptr : entry->d_un.d_ptr;
    switch (entry->d_tag) {
      case DT_SYMTAB:
        tables.symbols = reinterpret_cast<const ElfW(Sym)*>(address);
        break;
      case DT_STRTAB:
        tables.names = reinterpret_cast<const char*>(address);
        break;
      case DT_JMPREL:
        tables.calls = reinterpret_cast<const ElfW(Rela)*>(address);
        break;
      case DT_PLTRELSZ:
        tables.calls_size = entry->d_un.d_val / sizeof(ElfW(Rela));
        break;
      case DT_RELA:
        tables.others = reinterpret_cast<const ElfW(Rela)*>(address);
        break;
      case DT_RELASZ:
        tables.others_size = entry->d_un.d_val / sizeof(ElfW(Rela));
        break;
      default:
        break;
    }
  }
  return tables;
}

const Hook* hook_of(std::string_view name) noexcept {
  for (const Hook& hook : hooks()) {
    if (name == hook.symbol && *hook.next != nullptr) return &hook;
  }
  return nullptr;
}

struct Search {
  std::size_t replaced = 0;
  bool refused = false;
};

/// Writes one address. The slot may lie in a read-only page (RELRO), which is made writable for the write.
bool write_slot(void** slot, void* value, const dl_phdr_info& file) noexcept {
  const auto page_size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto index = reinterpret_cast<std::uintptr_t>(slot);
  bool constant = false;
  for (int i = 0; i < file.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = file.dlpi_phdr[i];
    const ElfW(Addr) begin = file.dlpi_addr + part.p_vaddr;
    constant = constant || (part.p_type == PT_GNU_RELRO && index >= begin && index < begin + part.p_memsz);
  }
  void* const page = reinterpret_cast<void*>(index & ~(page_size - 1));
  if (constant && mprotect(page, page_size, PROT_READ | PROT_WRITE) != 0) return false;
  __atomic_store_n(slot, value, __ATOMIC_RELEASE);
  return !constant || mprotect(page, page_size, PROT_READ) == 0;
}

void replace(const ElfW(Rela) * row, std::size_t count, const Tables& tables, const dl_phdr_info& file,
             Search& search) noexcept {
  for (const ElfW(Rela)* const end = row + count; row != end; ++row) {
    const std::uint64_t type = ELF64_R_TYPE(row->r_info);
    if (type != kJumpSlot && type != kGlobalData) continue;
    const Hook* hook = hook_of(tables.names + tables.symbols[ELF64_R_SYM(row->r_info)].st_name);
    if (hook == nullptr) continue;
    auto* const slot = reinterpret_cast<void**>(file.dlpi_addr + row->r_offset);
    if (*slot == nullptr || *slot == hook->ours) continue;  // a weak symbol that is undefined
    if (write_slot(slot, hook->ours, file)) {
      ++search.replaced;
    } else {
      search.refused = true;
    }
  }
}

int look_at(dl_phdr_info* file, std::size_t, void* raw) noexcept {
  auto& search = *static_cast<Search*>(raw);
  const std::string_view name = file->dlpi_name;
  if (name.find("ld-linux") != name.npos || name.find("vdso") != name.npos) return 0;  // they have separate heaps
  for (int i = 0; i < file->dlpi_phnum; ++i) {
    if (file->dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    const auto* const dynamic = reinterpret_cast<const ElfW(Dyn)*>(file->dlpi_addr + file->dlpi_phdr[i].p_vaddr);
    const Tables tables = tables_of(file->dlpi_addr, dynamic);
    if (tables.symbols == nullptr || tables.names == nullptr) continue;
    if (tables.calls != nullptr) replace(tables.calls, tables.calls_size, tables, *file, search);
    if (tables.others != nullptr) replace(tables.others, tables.others_size, tables, *file, search);
  }
  return 0;
}

}  // namespace

std::string interpose() {
  if (kBesideThreadSanitizer) return "the thread sanitizer replaces the same functions";
  for (const Hook& hook : hooks()) {
    if (*hook.next == nullptr) *hook.next = dlsym(RTLD_DEFAULT, hook.symbol);
  }
  static bool done = false;
  if (done) return {};
  Search search;
  dl_iterate_phdr(look_at, &search);
  if (search.refused) return "the loader's table of functions cannot be written";
  if (search.replaced == 0) return "the program is linked statically";
  done = true;
  return {};
}

}  // namespace symplant::exec::guard

#else

namespace symplant::exec::guard {

std::string interpose() { return "functions are interposed on 64-bit Linux only"; }

}  // namespace symplant::exec::guard

// NOLINTEND(performance-no-int-to-ptr)

#endif
