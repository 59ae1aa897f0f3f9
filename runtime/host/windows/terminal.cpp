// The console of Windows.
#include "symplant/host/terminal.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace symplant::host {
namespace {

HANDLE console() { return GetStdHandle(STD_OUTPUT_HANDLE); }

}  // namespace

bool is_terminal(Stream stream) { return _isatty(static_cast<int>(stream)) != 0; }

std::size_t terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO about{};
  if (GetConsoleScreenBufferInfo(console(), &about) == 0) return 0;
  return static_cast<std::size_t>(about.srWindow.Right - about.srWindow.Left + 1);
}

bool would_take(Stream /*stream*/) { return true; }

bool output_is_full() { return false; }

void write_error_now(std::string_view text) {
  DWORD count = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), text.data(), static_cast<DWORD>(text.size()), &count, nullptr);
}

void set_up_streams() {
  for (const Stream stream : {Stream::input, Stream::output, Stream::error}) {
    _setmode(static_cast<int>(stream), _O_BINARY);  // line ends stay as they are
  }
  SetConsoleOutputCP(CP_UTF8);
  SetConsoleCP(CP_UTF8);
  DWORD mode = 0;  // colors and the status line
  if (GetConsoleMode(console(), &mode) != 0) SetConsoleMode(console(), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

}  // namespace symplant::host
