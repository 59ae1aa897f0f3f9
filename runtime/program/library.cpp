// A shared library with a PLC program.
#include "symplant/program/library.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "symplant/program/shared_object.hpp"

namespace symplant::program {
namespace {

using Entry = const symplant_program* (*)();

/// A copy of a file in the folder for temporary files; its path, or nothing with `errno`.
std::optional<std::string> copy_of(const std::string& path) {
  const std::string copy = new_temporary_file();
  if (copy.empty()) return std::nullopt;
  std::error_code error;
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing, error);
  if (!error) return copy;
  errno = error.default_error_condition().value();
  std::filesystem::remove(copy, error);
  return std::nullopt;
}

}  // namespace

std::string program_fault(const symplant_program* program) {
  if (program == nullptr) return "symplant_program_v1() returns no program";
  if (program->version != 1) {
    return fmt::format("the version of its program is {}; this symplant runs version 1", program->version);
  }
  if (program->size < sizeof(symplant_program)) {
    return fmt::format("its program has {} bytes, those of version 1 have {}: compile it with this symplant/program.h",
                       program->size, sizeof(symplant_program));
  }
  if (program->name == nullptr || *program->name == '\0') return "its program has no name";
  if (program->create == nullptr || program->scan == nullptr || program->destroy == nullptr) {
    return "its program lacks one of the functions `create`, `scan` and `destroy`";
  }
  if (program->period_ns < 0) return fmt::format("the period of its program is below 0: {} ns", program->period_ns);
  if (program->count != 0 && program->variables == nullptr)
    return "its program has a `count` of variables, but no `variables`";
  return {};
}

std::variant<std::unique_ptr<Library>, LoadError> Library::open(const std::string& path, bool copied) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return LoadError{fmt::format("cannot read the program `{}`: {}", path,
                                 error ? error.message() : std::string("it is not a file"))};
  }
  // A path without a slash would be searched for among the system's libraries.
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  std::string file = std::filesystem::absolute(path).string();
  if (copied) {
    const auto copy = copy_of(path);
    if (!copy) return LoadError{fmt::format("cannot copy the program `{}`: {}", path, std::strerror(errno)), true};
    file = *copy;
  }
  std::string why;
  void* const handle = load_object(file, folder, why);
  std::string remains = copied ? file : "";
  if (copied && (can_remove_loaded || handle == nullptr)) {
    std::filesystem::remove(std::exchange(remains, ""), error);
  }
  if (handle == nullptr) {
    return LoadError{fmt::format("cannot open the program `{}`: {}; {}", path, why, how_to_compile)};
  }
  const auto entry = std::bit_cast<Entry>(exported(handle, "symplant_program_v1"));
  std::string fault =
      "it does not export symplant_program_v1(); compile it with symplant/program.h (docs/testing-programs.md)";
  const symplant_program* program = nullptr;
  if (entry != nullptr) {
    program = entry();
    fault = program_fault(program);
  }
  std::unique_ptr<Library> library(new Library(handle, program, std::move(remains)));
  if (fault.empty()) return library;
  return LoadError{fmt::format("cannot use the program `{}`: {}", path, fault)};
}

Library::~Library() {
  unload_object(handle_);
  std::error_code ignored;
  if (!copy_.empty()) std::filesystem::remove(copy_, ignored);
}

bool is_still_loaded(const std::string& path) {
  std::error_code unknown;
  return is_loaded(std::filesystem::absolute(path, unknown).string());
}

std::string file_digest(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  std::uint64_t hash = 0xCBF2'9CE4'8422'2325U;  // FNV-1a
  std::array<char, 1 << 16> bytes{};
  while (file) {
    file.read(bytes.data(), bytes.size());
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash = (hash ^ static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)])) * 0x100'0000'01B3U;
    }
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace symplant::program
