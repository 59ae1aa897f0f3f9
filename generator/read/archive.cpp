// The parts of a zip archive.
#include "read/archive.hpp"

#include <zip.h>

#include <algorithm>
#include <utility>

namespace symplant::read {

namespace {

constexpr std::string_view kZip = "PK\x03\x04";
constexpr zip_int64_t kMostParts = 1000;
constexpr std::uint64_t kMostUnpacked = 2'000'000'000;  ///< read as a stream
constexpr std::uint64_t kMostRatio = 100;
constexpr std::uint64_t kSmall = 1 << 20;  ///< unpacked sizes up to this are harmless whatever the ratio

}  // namespace

Archive::Archive(Handle handle, std::string noun, std::size_t packed)
    : handle_(std::move(handle)),
      noun_(std::move(noun)),
      budget_(std::min(kMostUnpacked, std::max<std::uint64_t>(kSmall, kMostRatio * packed))) {}

bool Archive::is_one(std::string_view bytes) { return bytes.starts_with(kZip); }

base::Result<Archive, ArchiveFault> Archive::open(std::string_view bytes, std::string noun) {
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
  if (source == nullptr) return ArchiveFault{"there is not enough memory for the " + noun};
  Handle handle(zip_open_from_source(source, ZIP_RDONLY, nullptr), zip_discard);
  if (handle == nullptr) {
    zip_source_free(source);
    return ArchiveFault{"the " + noun + " is damaged: it is no zip archive"};
  }
  if (zip_get_num_entries(handle.get(), 0) > kMostParts) {
    return ArchiveFault{"the " + noun + " has more than 1,000 parts"};
  }
  return Archive(std::move(handle), std::move(noun), bytes.size());
}

bool Archive::has(const std::string& path) const { return zip_name_locate(handle_.get(), path.c_str(), 0) >= 0; }

std::vector<std::string> Archive::paths() const {
  std::vector<std::string> paths;
  for (zip_int64_t i = 0; i < zip_get_num_entries(handle_.get(), 0); ++i) {
    const char* const path = zip_get_name(handle_.get(), static_cast<zip_uint64_t>(i), 0);
    if (path != nullptr) paths.emplace_back(path);
  }
  return paths;
}

std::optional<ArchiveFault> Archive::stream(const std::string& path, const Sink& sink) {
  zip_stat_t stat{};
  if (zip_stat(handle_.get(), path.c_str(), 0, &stat) != 0) {
    return ArchiveFault{"the " + noun_ + " has no part `" + path + "`"};
  }
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE) {
    return ArchiveFault{"the " + noun_ + " is encrypted"};
  }
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> part(zip_fopen(handle_.get(), path.c_str(), 0), zip_fclose);
  if (part == nullptr) return ArchiveFault{"the part `" + path + "` of the " + noun_ + " cannot be unpacked"};
  std::string rest;
  while (true) {
    constexpr std::size_t kStep = 256 * 1024;
    const std::size_t before = rest.size();
    rest.resize(before + kStep);
    const zip_int64_t got = zip_fread(part.get(), rest.data() + before, kStep);
    rest.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got < 0) return ArchiveFault{"the part `" + path + "` of the " + noun_ + " is damaged"};
    if (got == 0) return std::nullopt;
    if (static_cast<std::uint64_t>(got) > budget_) {
      return ArchiveFault{"the " + noun_ + " is larger than 2 GB unpacked, or unpacks to more than 100 times its size"};
    }
    budget_ -= static_cast<std::uint64_t>(got);
    if (const auto what = sink(rest)) return ArchiveFault{"the part `" + path + "` " + *what};
  }
}

base::Result<std::string, ArchiveFault> Archive::whole(const std::string& path) {
  std::string text;
  const auto fault = stream(path, [&](std::string& rest) -> std::optional<std::string> {
    text += std::exchange(rest, {});
    return std::nullopt;
  });
  if (fault) return *fault;
  return text;
}

}  // namespace symplant::read
