// Replaces a file with a new one once the new one is complete.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/descriptor.hpp"
#include "base/text_source.hpp"

namespace symplant::base {

/// A new file in a folder, under a temporary name. The destructor removes it unless it was renamed. Every
/// function returns 0 or errno.
class NewFile {
 public:
  NewFile() : file_(-1) {}
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool is_open() const { return static_cast<bool>(file_); }
  int open(const std::filesystem::path& folder);
  int append(std::string_view content) { return write_all(file_.number(), content); }
  /// Sets the permissions, if given, and closes the file.
  int finish(std::optional<unsigned> permissions);
  /// Renames the file to `target` and replaces what exists there.
  int replace(const std::filesystem::path& target);
  /// Gives the file the name `target`; EEXIST if that exists.
  int appear_as(const std::filesystem::path& target);

 private:
  Descriptor file_;
  std::string path_;  ///< empty: there is nothing to remove
};

/// Makes the file at a path hold a text; the path is a regular file or does not exist. Compares both part by part. From
/// the first difference on it writes a temporary file, which replaces the old one when it is complete. A symbolic link
/// stays a link: its target is replaced.
class Replacement final : public TextSink {
 public:
  /// `permissions`: those of the existing file; nothing if there is no file.
  Replacement(const std::string& path, std::optional<unsigned> permissions);

  void put(std::string_view part) override;
  /// Call after the last part. Returns 0 or errno; on failure the old file is unchanged.
  int finish();
  /// Whether the content of the file changed.
  bool changed() const { return changed_; }

 private:
  /// Starts the temporary file and copies the part that was equal.
  int begin();

  std::filesystem::path target_;
  std::optional<unsigned> permissions_;
  Descriptor old_;
  NewFile made_;
  std::size_t equal_ = 0;  ///< the number of equal bytes at the beginning
  int fault_ = 0;
  bool changed_ = false;
};

}  // namespace symplant::base
