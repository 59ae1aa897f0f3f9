// A file that takes the place of another once it is whole.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/descriptor.hpp"
#include "base/text_source.hpp"

namespace symplant::base {

/// A new file in a folder, under a name of its own, which goes away again unless it is put in place. Every function
/// gives 0, or the system's number of what went wrong.
class NewFile {
 public:
  NewFile() : file_(-1) {}
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool is_open() const { return static_cast<bool>(file_); }
  int open(const std::filesystem::path& folder);
  int append(std::string_view content) { return write_all(file_.number(), content); }
  /// Sets its permissions, where any are given, and closes it.
  int finish(std::optional<mode_t> mode);
  /// Takes the place of `target`, whatever is there.
  int replace(const std::filesystem::path& target);
  /// Takes the place where nothing is: EEXIST else.
  int link_as(const std::filesystem::path& target);

 private:
  Descriptor file_;
  std::string path_;  ///< empty: there is nothing to take away
};

/// Makes the file at a path, a plain file or nothing, hold a text, comparing both part by part: from the first
/// difference on it is written anew beside its place, and put there when it is whole. A link stays a link: what it
/// points to is replaced.
class Replacement final : public TextSink {
 public:
  /// `mode` are the permissions of the file that is there; nothing: there is none.
  Replacement(const std::string& path, std::optional<mode_t> mode);

  void put(std::string_view part) override;
  /// After the last part: 0, or what went wrong; then all is as it was.
  int finish();
  /// Whether the file holds another text than before.
  bool changed() const { return changed_; }

 private:
  /// From here on it is written: what was equal so far is copied.
  int begin();

  std::filesystem::path target_;
  std::optional<mode_t> mode_;
  Descriptor old_;
  NewFile made_;
  std::size_t equal_ = 0;  ///< bytes that were found equal
  int fault_ = 0;
  bool changed_ = false;
};

}  // namespace symplant::base
