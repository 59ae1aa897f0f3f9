// DLLs of Windows.
#include "symplant/program/shared_object.hpp"

#include <windows.h>

#include <array>
#include <bit>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace symplant::program {
namespace {

namespace fs = std::filesystem;

HMODULE module_of(void* object) { return static_cast<HMODULE>(object); }

}  // namespace

const bool can_remove_loaded = false;
const char* const how_to_compile = "compile it as a DLL for 64-bit Windows (-shared -static)";

void* load_object(const std::string& path, std::string& fault) {
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOOPENFILEERRORBOX);  // no window for a DLL that is missing
  HMODULE const object = LoadLibraryExW(fs::path(path).c_str(), nullptr, LOAD_WITH_ALTERED_SEARCH_PATH);
  if (object == nullptr) fault = std::system_category().message(static_cast<int>(GetLastError()));
  return object;
}

void unload_object(void* object) { FreeLibrary(module_of(object)); }

void* exported(void* object, const char* name) { return std::bit_cast<void*>(GetProcAddress(module_of(object), name)); }

bool is_loaded(const std::string& path) { return GetModuleHandleW(fs::path(path).c_str()) != nullptr; }

std::string new_temporary_file() {
  std::array<wchar_t, MAX_PATH + 1> folder{};
  std::array<wchar_t, MAX_PATH + 1> path{};
  if (GetTempPathW(static_cast<DWORD>(folder.size()), folder.data()) == 0 ||
      GetTempFileNameW(folder.data(), L"sym", 0, path.data()) == 0) {
    errno = EACCES;
    return {};
  }
  return fs::path(path.data()).string();
}

}  // namespace symplant::program
