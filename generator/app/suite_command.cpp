// What the parts of the command test share.
#include "app/suite_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <thread>

#include "diag/visible_text.hpp"

namespace symplant::app {

CaseFolder::CaseFolder()
    : path_(std::filesystem::temp_directory_path() / fmt::format("symplant-{:08x}", std::random_device()())) {
  std::filesystem::create_directory(path_, error_);
}

CaseFolder::~CaseFolder() { std::filesystem::remove_all(path_, error_); }

std::string CaseFolder::error() const {
  return error_ ? fmt::format("cannot make the folder `{}`: {}", path_.string(), error_.message()) : "";
}

std::string CaseFolder::trace(std::size_t number) const { return (path_ / fmt::format("{}.jsonl", number)).string(); }

std::size_t jobs_of(const TestOptions& options) {
  if (!options.links.empty()) return 1;  // there is one PLC
  return options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
}

void fail_test(Context& context, const std::string& message, int code) {
  context.err << "error: " << diag::visible(message) << "\n";
  context.exit_code = code;
}

}  // namespace symplant::app
