// Files by Windows. The program's manifest makes UTF-8 the code page of narrow names.
#include "base/disk.hpp"

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace symplant::base::disk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostAtOnce = std::size_t{1} << 30U;

About about(const struct _stat64& found) {
  const unsigned type = found.st_mode & _S_IFMT;
  const Kind kind = type == _S_IFREG ? Kind::regular : type == _S_IFDIR ? Kind::folder : Kind::other;
  return {kind, static_cast<std::uint64_t>(found.st_size), 0, 0};
}

/// The errno of the latest failed call of Windows.
int last_fault() {
  const std::error_code fault(static_cast<int>(GetLastError()), std::system_category());
  return fault.default_error_condition().value();
}

/// Another program, such as a scanner of viruses, may read the file for a moment.
bool is_momentary(DWORD fault) { return fault == ERROR_SHARING_VIOLATION || fault == ERROR_ACCESS_DENIED; }

int rename(const std::string& from, const std::string& to, DWORD how) {
  constexpr int kAttempts = 10;
  constexpr DWORD kPause = 50;  // ms
  const fs::path source(from);
  const fs::path target(to);
  for (int attempt = 1; MoveFileExW(source.c_str(), target.c_str(), how) == 0; ++attempt) {
    if (attempt == kAttempts || !is_momentary(GetLastError())) return last_fault();
    Sleep(kPause);
  }
  return 0;
}

/// Whether a name means a device: `NUL`, `con`, in Windows 10 also `C:/x/con.txt`, and a pipe.
bool is_device(const std::wstring& name) {
  constexpr std::wstring_view kDevices = LR"(\\.\)";
  std::array<wchar_t, kDevices.size() + MAX_PATH> full{};
  const DWORD size = GetFullPathNameW(name.c_str(), full.size(), full.data(), nullptr);
  return size < full.size() && std::wstring_view(full.data(), size).starts_with(kDevices);
}

}  // namespace

About about(const std::string& path) {
  const std::wstring name = fs::path(path).wstring();
  if (is_device(name)) return {.kind = Kind::other};
  WIN32_FILE_ATTRIBUTE_DATA found{};
  if (GetFileAttributesExW(name.c_str(), GetFileExInfoStandard, &found) == 0) return About{.fault = last_fault()};
  if ((found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return {.kind = Kind::folder};
  return {.kind = Kind::regular, .size = std::uint64_t{found.nFileSizeHigh} << 32U | found.nFileSizeLow};
}

About about(int file) {
  struct _stat64 found {};
  return ::_fstat64(file, &found) == 0 ? about(found) : About{.fault = errno};
}

bool exists(const std::string& path) { return GetFileAttributesW(fs::path(path).c_str()) != INVALID_FILE_ATTRIBUTES; }

int open_to_read(const std::string& path) {
  if (about(path).kind == Kind::folder) {
    errno = EISDIR;  // Windows calls it a lack of permission
    return -1;
  }
  return ::_wopen(fs::path(path).c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int open_to_write(const std::string& path) {
  return ::_wopen(fs::path(path).c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

int open_new(const std::string& path) {
  constexpr int kHow = _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT;
  return ::_wopen(fs::path(path).c_str(), kHow, _S_IREAD | _S_IWRITE);
}

std::ptrdiff_t read(int file, char* bytes, std::size_t size) {
  return ::_read(file, bytes, static_cast<unsigned>(std::min(size, kMostAtOnce)));
}

std::ptrdiff_t write(int file, const char* bytes, std::size_t size) {
  return ::_write(file, bytes, static_cast<unsigned>(std::min(size, kMostAtOnce)));
}

int rewind(int file) { return ::_lseeki64(file, 0, SEEK_SET) == 0 ? 0 : errno; }
int close(int file) { return ::_close(file) == 0 ? 0 : errno; }
int set_permissions(int /*file*/, unsigned /*permissions*/) { return 0; }

int rename_over(const std::string& from, const std::string& to) { return rename(from, to, MOVEFILE_REPLACE_EXISTING); }
int rename_new(const std::string& from, const std::string& to) { return rename(from, to, 0); }

void remove(const std::string& path) { DeleteFileW(fs::path(path).c_str()); }

unsigned long process_number() { return GetCurrentProcessId(); }

}  // namespace symplant::base::disk
