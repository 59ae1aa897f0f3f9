// Files of results.
#include "suite/results.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

namespace symplant::suite {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kVersionKey = "symplant-test";
constexpr int kVersion = 1;

std::string line_of(const Header& header) {
  return OrderedJson{{kVersionKey, kVersion}, {"suite", header.suite}, {"results", header.count}}.dump(
      -1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string numbered_line(std::size_t number, const Result& result) {
  return fmt::format("{{\"number\":{},{}", number, line_of(result).substr(1));
}

}  // namespace

Results::Results(Header header, const std::string& path, std::string& error)
    : header_(std::move(header)), places_(header_.count, -1) {
  std::string name = path;
  if (path.empty()) {
    name = (std::filesystem::temp_directory_path() / fmt::format("symplant-{:08x}.jsonl", std::random_device()()))
               .string();
    temporary_ = name;
  }
  errno = 0;
  file_ = std::make_unique<std::fstream>(name, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc);
  const std::string line = line_of(header_) + "\n";
  *file_ << line << std::flush;
  end_ = static_cast<std::int64_t>(line.size());
  if (!*file_) error = fmt::format("cannot write `{}`: {}", name, std::strerror(errno));
}

Results::~Results() {
  std::error_code ignored;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
}

std::string Results::add(std::size_t number, const Result& result) {
  const std::string line = numbered_line(number, result) + "\n";
  file_->seekp(end_);
  *file_ << line << std::flush;
  if (!*file_) return fmt::format("cannot write results: {}", std::strerror(errno));
  places_[number] = end_;
  end_ += static_cast<std::int64_t>(line.size());
  return "";
}

Result Results::read(std::size_t number) const {
  std::string line;
  file_->seekg(places_[number]);
  std::getline(*file_, line);
  return result_of(line).value_or(Result{});
}

std::string read_results(const std::vector<std::string>& files, Header& header,
                         const std::function<std::string(std::size_t, const Result&)>& take) {
  std::vector<const std::string*> whose;
  for (const std::string& path : files) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string line;
    if (!file || !std::getline(file, line)) {
      return fmt::format("cannot read `{}`: {}", path, errno != 0 ? std::strerror(errno) : "it is empty");
    }
    const OrderedJson first = OrderedJson::parse(line, nullptr, false);
    if (!first.is_object() || first.value(kVersionKey, OrderedJson()) != kVersion || !first.contains("suite") ||
        !first["suite"].is_string() || !first.contains("results") || !first["results"].is_number_unsigned()) {
      return fmt::format("{}:1: these are no results of `symplant test -o`", path);
    }
    Header here{first["suite"], first["results"]};
    if (whose.empty()) {
      header = here;
      whose.assign(here.count, nullptr);
    }
    if (here != header) {
      return fmt::format("{}:1: this file is of `{}` with {} results, but the earlier files are of `{}` with {}", path,
                         here.suite, here.count, header.suite, header.count);
    }
    for (std::size_t row = 2; std::getline(file, line); ++row) {
      if (file.eof()) break;  // a line without its end: the process was killed while it wrote
      const OrderedJson json = OrderedJson::parse(line, nullptr, false);
      const auto result = result_of(line);
      if (!result || !json.contains("number") || !json["number"].is_number_unsigned() ||
          json["number"].get<std::size_t>() >= header.count) {
        return fmt::format("{}:{}: this is no result", path, row);
      }
      const auto number = json["number"].get<std::size_t>();
      if (whose[number] != nullptr) {
        return fmt::format("{}:{}: `{}` is in `{}` already", path, row, result->title(), *whose[number]);
      }
      whose[number] = &path;
      if (std::string error = take(number, *result); !error.empty()) return error;
    }
  }
  return "";
}

}  // namespace symplant::suite
