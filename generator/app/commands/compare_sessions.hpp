// symplant compare with two sessions at the panel.
#pragma once

#include <string>

#include "app/context.hpp"

namespace symplant::app {

/// Whether a file holds a session at the panel; false if it cannot be read. Reads its first 256 bytes.
bool is_session_file(const std::string& path);

/// Compares the session of a trainee with that of an expert, as text or as a page, in the file `output`, or on
/// `context.out` if that is empty. Sets the exit code to 2 if a session cannot be read or they are of two plants.
void compare_session_files(const std::string& expert, const std::string& trainee, bool as_page,
                           const std::string& output, Context& context);

}  // namespace symplant::app
