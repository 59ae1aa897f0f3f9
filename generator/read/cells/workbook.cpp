// Reads the sheets of a workbook as text.
#include "read/cells/workbook.hpp"

#include <zip.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "read/cells/sheet_text.hpp"

namespace symplant::read {

namespace {

constexpr std::string_view kZip = "PK\x03\x04";
constexpr std::string_view kSaveAgain = "; open the workbook and save it again, or save the sheet as CSV";
constexpr zip_int64_t kMostParts = 1000;
constexpr std::uint64_t kMostUnpacked = 2'000'000'000;  ///< read as a stream
constexpr std::uint64_t kMostRatio = 100;
constexpr std::uint64_t kMostText = 128'000'000;  ///< of all sheets, and of the strings that they share
constexpr std::uint64_t kSmall = 1 << 20;         ///< unpacked sizes up to this are harmless whatever the ratio

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Part = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

/// What is wrong, for the user.
struct Fault {
  std::string what;
};
template <class T>
using Outcome = base::Result<T, Fault>;

std::string too_large() {
  return "the workbook is larger than 2 GB unpacked, or unpacks to more than 100 times its size";
}

Archive open_archive(std::string_view bytes) {
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
  if (source == nullptr) return {nullptr, zip_discard};
  zip_t* const archive = zip_open_from_source(source, ZIP_RDONLY, nullptr);
  if (archive == nullptr) zip_source_free(source);
  return {archive, zip_discard};
}

class WorkbookReader {
 public:
  WorkbookReader(zip_t* archive, std::size_t packed)
      : archive_(archive), budget_(std::min(kMostUnpacked, std::max<std::uint64_t>(kSmall, kMostRatio * packed))) {}

  Outcome<std::vector<Sheet>> read() {
    if (zip_get_num_entries(archive_, 0) > kMostParts) return Fault{"the workbook has more than 1,000 parts"};
    const auto book = whole("xl/workbook.xml");
    if (!book) return book.error();
    const auto relations = whole("xl/_rels/workbook.xml.rels");
    if (!relations) return relations.error();
    const auto parts = sheet_parts(*book, *relations);
    if (!parts) return Fault{parts.error()};
    if (parts->empty()) return Fault{"the workbook has no sheet"};
    SharedStrings strings(kMostText);
    if (zip_name_locate(archive_, "xl/sharedStrings.xml", 0) >= 0) {
      if (const auto fault = stream("xl/sharedStrings.xml", strings)) return *fault;
    }
    std::vector<Sheet> sheets;
    for (const SheetPart& part : *parts) {
      if (zip_name_locate(archive_, part.path.c_str(), 0) < 0) continue;  // a chart
      SheetText text(strings.texts(), kMostText - written_);
      if (const auto fault = stream(part.path, text)) return *fault;
      written_ += text.size();
      sheets.push_back({part.name, text.take()});
    }
    return sheets;
  }

 private:
  Outcome<Part> open(const std::string& path) {
    zip_stat_t stat{};
    if (zip_stat(archive_, path.c_str(), 0, &stat) != 0) return Fault{"the workbook has no part `" + path + "`"};
    if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE) {
      return Fault{"the workbook is encrypted"};
    }
    Part part(zip_fopen(archive_, path.c_str(), 0), zip_fclose);
    if (part == nullptr) return Fault{"the part `" + path + "` of the workbook cannot be unpacked"};
    return part;
  }

  /// Appends the next bytes; false at the end. `fault` is set if there are too many, or they cannot be unpacked.
  bool append(zip_file_t* part, const std::string& path, std::string& text, std::optional<Fault>& fault) {
    constexpr std::size_t kStep = 256 * 1024;
    const std::size_t before = text.size();
    text.resize(before + kStep);
    const zip_int64_t got = zip_fread(part, text.data() + before, kStep);
    text.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got < 0) fault = Fault{"the part `" + path + "` of the workbook is damaged"};
    if (got <= 0) return false;
    if (static_cast<std::uint64_t>(got) > budget_) {
      fault = Fault{too_large()};
      return false;
    }
    budget_ -= static_cast<std::uint64_t>(got);
    return true;
  }

  Outcome<std::string> whole(const std::string& path) {
    auto part = open(path);
    if (!part) return part.error();
    std::string text;
    std::optional<Fault> fault;
    while (append(part->get(), path, text, fault)) {
    }
    if (fault) return *fault;
    return text;
  }

  /// Hands a part on piece by piece.
  template <class Sink>
  std::optional<Fault> stream(const std::string& path, Sink& sink) {
    auto part = open(path);
    if (!part) return part.error();
    std::string rest;
    std::optional<Fault> fault;
    while (append(part->get(), path, rest, fault)) {
      if (const auto what = sink.take_from(rest)) return Fault{"the part `" + path + "` " + *what};
    }
    return fault;
  }

  zip_t* archive_;
  std::uint64_t budget_;  ///< bytes that may still be unpacked
  std::uint64_t written_ = 0;
};

}  // namespace

bool is_workbook(std::string_view bytes) {
  return bytes.starts_with(kZip) && bytes.find("xl/workbook.xml") != std::string_view::npos;
}

base::Result<std::vector<Sheet>, std::string> read_workbook(std::string_view bytes) {
  const Archive archive = open_archive(bytes);
  if (archive == nullptr) return "the workbook is damaged: it is no zip archive" + std::string(kSaveAgain);
  auto sheets = WorkbookReader(archive.get(), bytes.size()).read();
  if (!sheets) return sheets.error().what + std::string(kSaveAgain);
  return std::move(*sheets);
}

}  // namespace symplant::read
