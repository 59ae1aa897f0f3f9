// What the system knows of the streams of the program: terminals, and whether a write would wait.
#pragma once

#include <cstddef>
#include <string_view>

namespace symplant::host {

enum class Stream { input = 0, output = 1, error = 2 };

bool is_terminal(Stream stream);

/// Whether a line of a terminal can be drawn again.
bool can_redraw_lines();

/// Columns of the terminal of standard output; nothing is known: 0.
std::size_t terminal_columns();

/// Whether a write would not wait now, as far as known; also if the reader is gone. Waits for nothing.
bool would_take(Stream stream);

/// Whether a pipe or a terminal that this process writes to is full.
bool output_is_full();

/// Writes to standard error without the buffers of the program, if it would take it.
void write_error_now(std::string_view text);

/// Call once, first: the standard streams carry bytes, and a terminal shows them as UTF-8.
void set_up_streams();
/// Calls `stop` when the window of the terminal is closed, if the system reports that otherwise than by a signal.
void on_closing(void (*stop)());
/// Ends the process without the destruction of anything, after the streams are flushed.
[[noreturn]] void end_process(int code);
/// Call last: the terminal shows text of other programs as before.
void restore_streams();

}  // namespace symplant::host
