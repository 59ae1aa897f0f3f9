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

// Neither the working folder nor the one for temporary files is searched: anyone may put a DLL there.
void* load_object(const std::string& path, const std::string& folder, std::string& fault) {
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOOPENFILEERRORBOX);  // no window for a DLL that is missing
  const DLL_DIRECTORY_COOKIE added = AddDllDirectory(fs::path(folder).make_preferred().c_str());
  HMODULE const object =
      LoadLibraryExW(fs::path(path).make_preferred().c_str(), nullptr, LOAD_LIBRARY_SEARCH_DEFAULT_DIRS);
  if (object == nullptr) fault = std::system_category().message(static_cast<int>(GetLastError()));
  if (added != nullptr) RemoveDllDirectory(added);
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
