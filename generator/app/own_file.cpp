// The mark of a file that symplant writes.
#include "app/own_file.hpp"

#include <fmt/format.h>

#include "symplant/tables/digest.hpp"

namespace symplant::app {
namespace {

constexpr std::string_view kMark = "// written by symplant, which replaces this file only if it is not edited: ";

}  // namespace

std::string with_mark(std::string_view text) {
  tables::Fnv1a64 digest;
  digest.text(text);
  return fmt::format("{}{:016x}\n{}", kMark, digest.value(), text);
}

bool has_mark(std::string_view file) { return file.starts_with(kMark); }

bool is_unedited(std::string_view file) {
  const std::size_t end = file.find('\n');
  return end != std::string_view::npos && with_mark(file.substr(end + 1)) == file;
}

}  // namespace symplant::app
