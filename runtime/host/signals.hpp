// The signals that a run handles: SIGINT, SIGTERM and SIGHUP end it, SIGUSR1 requests its status.
#pragma once

#include <atomic>

namespace symplant::host {

/// Handles them from now on, and forgets earlier ones. A SIGHUP that is ignored stays ignored (`nohup`). SIGPIPE and
/// SIGXFSZ (a file above `ulimit -f`) are ignored, too.
void catch_signals();

/// Whether a signal requested the end. One flag for the process, since a handler can only access globals.
const std::atomic<bool>& stop_requested();

/// Number of SIGINT and SIGTERM so far.
int stop_wishes();

/// Whether SIGUSR1 has come since the last call.
bool take_status_request();

}  // namespace symplant::host
