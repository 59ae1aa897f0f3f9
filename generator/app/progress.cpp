// A progress line on a terminal.
#include "app/progress.hpp"

#include <ostream>

namespace symplant::app {

Progress::Progress(std::ostream& err, bool terminal)
    : err_(err), terminal_(terminal), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (shown_) err_ << "\r\033[K" << std::flush;
  shown_ = false;
}

void Progress::stage(const std::string& what) {
  if (!terminal_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  clear();
  err_ << what << " ..." << std::flush;
  shown_ = true;
}

}  // namespace symplant::app
