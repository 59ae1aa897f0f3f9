// The parts of a zip archive, with limits against damaged and hostile ones. The only user of libzip.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

struct zip;

namespace symplant::read {

/// What is wrong, for the user.
struct ArchiveFault {
  std::string what;
};

class Archive {
 public:
  /// Takes what it can from the front of `rest`. Returns what is wrong.
  using Sink = std::function<std::optional<std::string>(std::string& rest)>;

  /// Begins as zip archives do.
  static bool is_one(std::string_view bytes);
  /// `noun`: what the archive is to the user, such as "workbook". The bytes must outlive it. O(parts).
  static base::Result<Archive, ArchiveFault> open(std::string_view bytes, std::string noun);

  bool has(const std::string& path) const;
  std::vector<std::string> paths() const;
  /// The unpacked part. O(unpacked bytes).
  base::Result<std::string, ArchiveFault> whole(const std::string& path);
  /// Hands a part on piece by piece. O(unpacked bytes).
  std::optional<ArchiveFault> stream(const std::string& path, const Sink& sink);

 private:
  using Handle = std::unique_ptr<zip, void (*)(zip*)>;

  Archive(Handle handle, std::string noun, std::size_t packed);

  Handle handle_;
  std::string noun_;
  std::uint64_t budget_;  ///< bytes that may still be unpacked
};

}  // namespace symplant::read
