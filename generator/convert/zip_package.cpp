// Packs texts into a zip container. The only file of this floor that uses libzip.
#include "convert/zip_package.hpp"

#include <zip.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

namespace symplant::convert {
namespace {

constexpr std::uint16_t kFirstDosDate = 33;  ///< 1980-01-01
constexpr std::uint32_t kLevel = 3;          ///< of compression: half the time of the default, a tenth more bytes

/// A part while libzip reads it.
class PieceReader {
 public:
  explicit PieceReader(const PackagePart& part) : part_(part) {
    zip_error_init(&error_);
    for (std::size_t i = 0;; ++i) {
      const std::size_t size = part.piece(i).size();
      if (size == 0) return;
      size_ += size;
    }
  }

  ~PieceReader() { zip_error_fini(&error_); }
  PieceReader(const PieceReader&) = delete;
  PieceReader& operator=(const PieceReader&) = delete;

  std::uint64_t size() const { return size_; }
  zip_error_t* error() { return &error_; }

  void open() {
    number_ = 0;
    at_ = 0;
    current_ = part_.piece(0);
  }

  std::size_t read(char* to, std::size_t most) {
    std::size_t done = 0;
    while (done < most && !current_.empty()) {
      const std::size_t count = std::min(most - done, current_.size() - at_);
      std::memcpy(to + done, current_.data() + at_, count);
      done += count;
      at_ += count;
      if (at_ < current_.size()) continue;
      current_ = part_.piece(++number_);
      at_ = 0;
    }
    return done;
  }

 private:
  const PackagePart& part_;
  zip_error_t error_{};
  std::uint64_t size_ = 0;
  std::size_t number_ = 0;
  std::size_t at_ = 0;  ///< in the current piece
  std::string current_;
};

zip_int64_t serve(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command) {
  auto& reader = *static_cast<PieceReader*>(user);
  switch (command) {
    case ZIP_SOURCE_OPEN:
      reader.open();
      return 0;
    case ZIP_SOURCE_READ:
      return static_cast<zip_int64_t>(reader.read(static_cast<char*>(data), static_cast<std::size_t>(length)));
    case ZIP_SOURCE_STAT: {
      auto& stat = *static_cast<zip_stat_t*>(data);
      zip_stat_init(&stat);
      stat.valid = ZIP_STAT_SIZE;
      stat.size = reader.size();
      return static_cast<zip_int64_t>(sizeof stat);
    }
    case ZIP_SOURCE_SUPPORTS:
      return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                            ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
    case ZIP_SOURCE_ERROR:
      return zip_error_to_data(reader.error(), data, length);
    default:
      return 0;
  }
}

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;
using Source = std::unique_ptr<zip_source_t, FreeSource>;

/// False if the library has an error.
bool add_part(zip_t* archive, const PackagePart& part, PieceReader& reader) {
  zip_source_t* const source = zip_source_function(archive, serve, &reader);
  if (source == nullptr) return false;
  const zip_int64_t index = zip_file_add(archive, part.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto number = static_cast<zip_uint64_t>(index);
  return zip_set_file_compression(archive, number, ZIP_CM_DEFLATE, kLevel) == 0 &&
         zip_file_set_dostime(archive, number, 0, kFirstDosDate, 0) == 0;
}

std::string content(zip_source_t* source) {
  std::string bytes;
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) return bytes;
  bytes.resize(static_cast<std::size_t>(stat.size));
  const zip_int64_t count = zip_source_read(source, bytes.data(), stat.size);
  bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  zip_source_close(source);
  return bytes;
}

}  // namespace

base::Result<std::string, WriteError> zip_package(const std::vector<PackagePart>& parts) {
  zip_error_t error;
  zip_error_init(&error);
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (buffer == nullptr) return WriteError{zip_error_strerror(&error)};
  Archive archive(zip_open_from_source(buffer.get(), ZIP_CREATE | ZIP_TRUNCATE, &error));
  if (archive == nullptr) return WriteError{zip_error_strerror(&error)};
  zip_source_keep(buffer.get());  // the archive owns one reference
  std::vector<std::unique_ptr<PieceReader>> readers;
  for (const PackagePart& part : parts) {
    readers.push_back(std::make_unique<PieceReader>(part));
    if (!add_part(archive.get(), part, *readers.back())) return WriteError{zip_strerror(archive.get())};
  }
  if (zip_close(archive.get()) != 0) return WriteError{zip_strerror(archive.get())};
  static_cast<void>(archive.release());
  return content(buffer.get());
}

}  // namespace symplant::convert
