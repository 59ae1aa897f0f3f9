// A shared library with a PLC program.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "symplant/program.h"

namespace symplant::program {

/// Why a program cannot be used; `environment` decides the exit code (3, otherwise 2).
struct LoadError {
  std::string message;
  bool environment = false;
};

/// An open library. The program that it exports is valid while it is open. Not copyable; closes the library at the end.
class Library {
 public:
  /// Opens the library, with all that it needs, and checks what it exports. `copied`: opens a copy of the file, so that
  /// two programs of one library have separate variables. Code of the library's constructors runs.
  static std::variant<std::unique_ptr<Library>, LoadError> open(const std::string& path, bool copied = false);

  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library();

  const symplant_program& program() const { return *program_; }

 private:
  Library(void* handle, const symplant_program* program, std::string copy)
      : handle_(handle), program_(program), copy_(std::move(copy)) {}

  void* handle_;
  const symplant_program* program_;
  std::string copy_;  ///< a file to remove at the end; empty: none
};

/// Why a program does not fit this interface; empty if it does.
std::string program_fault(const symplant_program* program);

/// Whether this process still has a library, though it was closed: its variables keep their values from run to run. So
/// do those of C++ that are unique (STB_GNU_UNIQUE), unless it is compiled with -fno-gnu-unique.
bool is_still_loaded(const std::string& path);

/// A digest of a file, as hexadecimal digits; empty if it cannot be read. O(file).
std::string file_digest(const std::string& path);

}  // namespace symplant::program
