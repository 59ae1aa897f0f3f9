// The signals that end a run: SIGINT and SIGTERM.
#pragma once

#include <atomic>

namespace symplant::host {

/// Catches them from now on, and forgets any that came before. A write to a closed connection is no signal, either.
void catch_signals();

/// Set by a signal. One for the whole process, since a handler can only reach what is global.
const std::atomic<bool>& stop_requested();

}  // namespace symplant::host
