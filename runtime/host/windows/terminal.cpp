// The console of Windows.
#include "symplant/host/terminal.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace symplant::host {
namespace {

HANDLE handle_of(Stream stream) {
  constexpr DWORD kHandles[] = {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE, STD_ERROR_HANDLE};
  return GetStdHandle(kHandles[static_cast<std::size_t>(stream)]);
}

UINT output_before = 0;
UINT input_before = 0;

void (*stop_run)() = nullptr;

/// In a separate thread. Windows ends the process when this returns, or after some seconds.
BOOL WINAPI closing(DWORD event) {
  if (event == CTRL_C_EVENT) return FALSE;  // a signal
  stop_run();
  if (event != CTRL_BREAK_EVENT) Sleep(INFINITE);
  return TRUE;
}

/// Colors and the status line.
bool understands_sequences(Stream stream) {
  DWORD mode = 0;
  HANDLE const console = handle_of(stream);
  return GetConsoleMode(console, &mode) != 0 && SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

}  // namespace

bool is_terminal(Stream stream) {
  DWORD mode = 0;
  if (stream == Stream::input) return GetConsoleMode(handle_of(stream), &mode) != 0;
  return understands_sequences(stream);
}

bool can_redraw_lines() { return true; }

std::size_t terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO about{};
  if (GetConsoleScreenBufferInfo(handle_of(Stream::output), &about) == 0) return 0;
  return static_cast<std::size_t>(about.srWindow.Right - about.srWindow.Left + 1);
}

bool would_take(Stream /*stream*/) { return true; }

bool output_is_full() { return false; }

void write_error_now(std::string_view text) {
  DWORD count = 0;
  WriteFile(handle_of(Stream::error), text.data(), static_cast<DWORD>(text.size()), &count, nullptr);
}

void set_up_streams() {
  for (const Stream stream : {Stream::input, Stream::output, Stream::error}) {
    _setmode(static_cast<int>(stream), _O_BINARY);  // line ends stay as they are
  }
  output_before = GetConsoleOutputCP();
  input_before = GetConsoleCP();
  if (output_before == 0) return;  // no console
  SetConsoleOutputCP(CP_UTF8);
  SetConsoleCP(CP_UTF8);
}

void on_closing(void (*stop)()) {
  stop_run = stop;
  SetConsoleCtrlHandler(closing, TRUE);
}

// Unlike ExitProcess(), it does not wait for anything that a thread that it ended may have held.
void end_process(int code) {
  TerminateProcess(GetCurrentProcess(), static_cast<UINT>(code));
  for (;;) Sleep(INFINITE);
}

void restore_streams() {
  if (output_before == 0) return;
  SetConsoleOutputCP(output_before);
  SetConsoleCP(input_before);
}

}  // namespace symplant::host
