// What the parts of the command test share.
#include "app/suite_command.hpp"

#include <fmt/format.h>

#include <random>

namespace symplant::app {

CaseFolder::CaseFolder()
    : path_(std::filesystem::temp_directory_path() / fmt::format("symplant-{:08x}", std::random_device()())) {
  std::filesystem::create_directory(path_, error_);
}

CaseFolder::~CaseFolder() { std::filesystem::remove_all(path_, error_); }

std::string CaseFolder::error() const {
  return error_ ? fmt::format("cannot make the folder `{}`: {}", path_.generic_string(), error_.message()) : "";
}

std::string CaseFolder::trace(std::size_t number) const {
  return (path_ / fmt::format("{}.jsonl", number)).generic_string();
}

}  // namespace symplant::app
