// Results on disk: only the offset of each is in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::batch {

/// The first line of a file of results.
struct Header {
  std::string key;         ///< of its version, which names the command: `symplant-test`
  std::string of;          ///< what the results are about, for messages
  std::size_t count = 0;   ///< results of all parts
  std::string more = "0";  ///< what else the results have in common, as JSON in one line

  friend bool operator==(const Header&, const Header&) = default;
};

/// One line for each number from 0 to Header::count - 1, or none yet. The file begins with the header, then has the
/// lines in any order. Not thread-safe.
class ResultFile {
 public:
  /// Writes to `path`, or, if it is empty, to a temporary file. `error` is set if that fails.
  ResultFile(Header header, const std::string& path, std::string& error);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();

  const Header& header() const { return header_; }
  /// Adds a JSON object, complete on disk when it returns. Empty, or why it cannot be written.
  std::string add(std::size_t number, std::string_view object);
  bool has(std::size_t number) const { return offsets_[number] >= 0; }
  /// Reads a line; has() must be true.
  std::string read(std::size_t number) const;

 private:
  Header header_;
  std::unique_ptr<std::fstream> file_;
  std::vector<std::int64_t> offsets_;  ///< of each line; -1: none
  std::int64_t end_ = 0;
  std::string temporary_;  ///< its path, to be removed
};

/// Takes a line with its number. `already`: a file that has the number, too; null: none. Returns what is wrong, or
/// empty.
using TakeLine = std::function<std::string(std::size_t number, const std::string& line, const std::string* already)>;

/// Reads files of results of one run in parts, with `key`, in which each number is once. Empty, or what is wrong:
/// `a.jsonl:3: ...`. `header` is that of the first file.
std::string read_result_files(const std::vector<std::string>& files, const std::string& key, Header& header,
                              const TakeLine& take);

/// Results in a file. Result has `std::string title() const`, `std::string line() const`, an object of JSON in one
/// line, and `static std::optional<Result> of_line(std::string_view)`.
template <class Result>
class Results {
 public:
  Results(Header header, const std::string& path, std::string& error) : file_(std::move(header), path, error) {}

  const Header& header() const { return file_.header(); }
  std::string add(std::size_t number, const Result& result) { return file_.add(number, result.line()); }
  bool has(std::size_t number) const { return file_.has(number); }
  Result read(std::size_t number) const { return Result::of_line(file_.read(number)).value_or(Result{}); }

 private:
  ResultFile file_;
};

/// read_result_files() for such results.
template <class Result, class Take>
std::string read_results(const std::vector<std::string>& files, const std::string& key, Header& header, Take take) {
  const TakeLine take_line = [&](std::size_t number, const std::string& line, const std::string* already) {
    const std::optional<Result> result = Result::of_line(line);
    if (!result) return std::string("this is no result");
    if (already != nullptr) return "`" + result->title() + "` is in `" + *already + "` already";
    return std::string(take(number, *result));
  };
  return read_result_files(files, key, header, take_line);
}

}  // namespace symplant::batch
