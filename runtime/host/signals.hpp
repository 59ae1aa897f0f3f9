// The signals that a run knows: SIGINT, SIGTERM and SIGHUP end it, SIGUSR1 asks how it stands.
#pragma once

#include <atomic>

namespace symplant::host {

/// Catches them from now on, and forgets any that came before. A SIGHUP that is ignored stays so (`nohup`). A write to
/// a closed connection or pipe is no signal, either.
void catch_signals();

/// Set by a signal. One for the whole process, since a handler can only reach what is global.
const std::atomic<bool>& stop_requested();

/// How many SIGINT and SIGTERM have come.
int stop_wishes();

/// Whether SIGUSR1 has come since the last call.
bool take_status_request();

}  // namespace symplant::host
