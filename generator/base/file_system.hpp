// Files as a parameter: the tool's come from disk, a test's from memory.
#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "base/text_source.hpp"

namespace symplant::base {

/// Why a file could not be read or written, in words that name it.
struct FileError {
  std::string message;
};

class FileSystem {
 public:
  virtual ~FileSystem() = default;

  /// All bytes of a file. A directory, a missing file, one without permission are errors.
  virtual Result<std::string, FileError> read(const std::string& path) const = 0;

  /// Writes a file whole: beside its place first, then renamed, so that whoever reads sees the old or the new one.
  /// Makes missing folders. Leaves a file with the same content alone (its time too) and gives false.
  virtual Result<bool, FileError> write(const std::string& path, std::string_view content) = 0;

  /// The same of a text that is made while it is written. It may be compared with what is there before anything is
  /// written; while it is made nothing of it shows. The default holds it whole.
  virtual Result<bool, FileError> write_made(const std::string& path, const TextSource& content) {
    return write(path, text_of(content));
  }

  /// Whether a file holds just this text; false where it cannot be read.
  virtual bool holds(const std::string& path, const TextSource& content) const {
    const auto there = read(path);
    return there && *there == text_of(content);
  }

  /// Writes a file where there is none, missing folders too; gives false, and leaves it alone, where anything is there.
  virtual Result<bool, FileError> write_new(const std::string& path, std::string_view content) = 0;

  /// Whether anything is there, readable or not.
  virtual bool exists(const std::string& path) const = 0;
};

/// The machine's own files.
class DiskFileSystem final : public FileSystem {
 public:
  Result<std::string, FileError> read(const std::string& path) const override;
  Result<bool, FileError> write(const std::string& path, std::string_view content) override;
  Result<bool, FileError> write_made(const std::string& path, const TextSource& content) override;
  bool holds(const std::string& path, const TextSource& content) const override;
  Result<bool, FileError> write_new(const std::string& path, std::string_view content) override;
  bool exists(const std::string& path) const override;
};

}  // namespace symplant::base
