// Files of results.
#include "batch/result_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

namespace symplant::batch {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::size_t kMostResults = 100'000'000;  ///< more would be a damaged file

std::string line_of(const Header& header) {
  const OrderedJson json{{header.key, kVersion}, {"of", header.of}, {"results", header.count}};
  const std::string text = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  return fmt::format("{},\"more\":{}}}", text.substr(0, text.size() - 1), header.more);
}

std::optional<Header> header_of(const std::string& line, const std::string& key) {
  const OrderedJson json = OrderedJson::parse(line, nullptr, false);
  if (!json.is_object() || json.value(key, OrderedJson()) != kVersion || !json.contains("of") ||
      !json["of"].is_string() || !json.contains("results") || !json["results"].is_number_unsigned() ||
      json["results"].get<std::size_t>() > kMostResults || !json.contains("more") || json["more"].is_null()) {
    return std::nullopt;
  }
  return Header{key, json["of"], json["results"], json["more"].dump()};
}

/// `test -o` for the key `symplant-test`.
std::string command_of(const std::string& key) { return "symplant " + key.substr(key.find('-') + 1) + " -o"; }

/// Reads one file after another.
class FilesReader {
 public:
  FilesReader(const std::string& key, Header& header, const TakeLine& take) : key_(key), header_(header), take_(take) {}

  std::string read(const std::string& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string line;
    if (!file || !std::getline(file, line)) {
      return fmt::format("cannot read `{}`: {}", path, errno != 0 ? std::strerror(errno) : "it is empty");
    }
    if (std::string wrong = begin(line); !wrong.empty()) return fmt::format("{}:1: {}", path, wrong);
    for (std::size_t row = 2; std::getline(file, line); ++row) {
      if (file.eof()) break;  // a line without its end: the process was killed while it wrote
      if (std::string wrong = take(line, path); !wrong.empty()) return fmt::format("{}:{}: {}", path, row, wrong);
    }
    return "";
  }

 private:
  std::string begin(const std::string& line) {
    const auto here = header_of(line, key_);
    if (!here) return fmt::format("these are no results of `{}`", command_of(key_));
    if (in_.empty()) {
      header_ = *here;
      in_.assign(here->count, nullptr);
    }
    if (*here == header_) return "";
    if (here->of == header_.of && here->count == header_.count) {
      return fmt::format("this file is of another run of `{}` than the earlier files", here->of);
    }
    return fmt::format("this file is of `{}` with {} results, but the earlier files are of `{}` with {}", here->of,
                       here->count, header_.of, header_.count);
  }

  std::string take(const std::string& line, const std::string& path) {
    const OrderedJson json = OrderedJson::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("number") || !json["number"].is_number_unsigned() ||
        json["number"].get<std::size_t>() >= header_.count) {
      return "this is no result";
    }
    const auto number = json["number"].get<std::size_t>();
    const std::string* const already = std::exchange(in_[number], &path);
    return take_(number, line, already);
  }

  const std::string& key_;
  Header& header_;
  const TakeLine& take_;
  std::vector<const std::string*> in_;  ///< by number: the file
};

}  // namespace

ResultFile::ResultFile(Header header, const std::string& path, std::string& error)
    : header_(std::move(header)), offsets_(header_.count, -1) {
  std::string name = path;
  if (path.empty()) {
    name = (std::filesystem::temp_directory_path() / fmt::format("symplant-{:08x}.jsonl", std::random_device()()))
               .generic_string();
    temporary_ = name;
  }
  errno = 0;
  file_ = std::make_unique<std::fstream>(name, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc);
  const std::string line = line_of(header_) + "\n";
  *file_ << line << std::flush;
  end_ = static_cast<std::int64_t>(line.size());
  if (!*file_) error = fmt::format("cannot write `{}`: {}", name, std::strerror(errno));
}

ResultFile::~ResultFile() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

std::string ResultFile::add(std::size_t number, std::string_view object) {
  const std::string line = fmt::format("{{\"number\":{},{}\n", number, object.substr(1));
  file_->seekp(end_);
  *file_ << line << std::flush;
  if (!*file_) return fmt::format("cannot write results: {}", std::strerror(errno));
  offsets_[number] = end_;
  end_ += static_cast<std::int64_t>(line.size());
  return "";
}

std::string ResultFile::read(std::size_t number) const {
  std::string line;
  file_->seekg(offsets_[number]);
  std::getline(*file_, line);
  return line;
}

std::string read_result_files(const std::vector<std::string>& files, const std::string& key, Header& header,
                              const TakeLine& take) {
  FilesReader reader(key, header, take);
  for (const std::string& path : files) {
    if (std::string error = reader.read(path); !error.empty()) return error;
  }
  return "";
}

}  // namespace symplant::batch
