// Reads and writes files, behind an interface that tests can replace.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "base/text_source.hpp"

namespace symplant::base {

/// Why a file could not be read or written; the message names the file.
struct FileError {
  std::string message;
};

class FileSystem {
 public:
  virtual ~FileSystem() = default;

  /// All bytes of a file. A directory, a missing file and missing permission are errors.
  virtual Result<std::string, FileError> read(const std::string& path) const = 0;

  /// Replaces a file atomically: writes a temporary file in the same folder and renames it, so that a reader sees the
  /// old or the new content. Makes missing folders. Returns false, and leaves the file untouched, if nothing changes.
  virtual Result<bool, FileError> write(const std::string& path, std::string_view content) = 0;

  /// The same as write() for a text that is made while it is written. It may be compared with the existing file before
  /// anything is written. The default holds the whole text in memory.
  virtual Result<bool, FileError> write_made(const std::string& path, const TextSource& content) {
    return write(path, text_of(content));
  }

  /// Whether a file holds exactly this text; false if it cannot be read.
  virtual bool holds(const std::string& path, const TextSource& content) const {
    const auto there = read(path);
    return there && *there == text_of(content);
  }

  /// Writes a new file and makes missing folders. Returns false, and changes nothing, if the path exists.
  virtual Result<bool, FileError> write_new(const std::string& path, std::string_view content) = 0;

  /// Whether the path exists, readable or not.
  virtual bool exists(const std::string& path) const = 0;

  /// The names of all files and folders in a folder, in any order; none if it cannot be read.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
};

/// Files on the disk of the machine.
class DiskFileSystem final : public FileSystem {
 public:
  Result<std::string, FileError> read(const std::string& path) const override;
  Result<bool, FileError> write(const std::string& path, std::string_view content) override;
  Result<bool, FileError> write_made(const std::string& path, const TextSource& content) override;
  bool holds(const std::string& path, const TextSource& content) const override;
  Result<bool, FileError> write_new(const std::string& path, std::string_view content) override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
};

}  // namespace symplant::base
