// The results of a suite on disk: only the offset of each is in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "suite/result.hpp"

namespace symplant::suite {

/// What a file of results is about.
struct Header {
  std::string suite;      ///< the folder
  std::size_t count = 0;  ///< results of the whole suite
  friend bool operator==(const Header&, const Header&) = default;
};

/// One result for each number from 0 to Header::count - 1, or none yet. A file of results begins with the header, then
/// has a line for each result, in any order.
class Results {
 public:
  /// Writes to `path`, or, if it is empty, to a temporary file. `error` is set if that fails.
  Results(Header header, const std::string& path, std::string& error);
  Results(const Results&) = delete;
  Results& operator=(const Results&) = delete;
  ~Results();

  const Header& header() const { return header_; }
  /// Adds a result, complete on disk when it returns. Empty, or why it cannot be written.
  std::string add(std::size_t number, const Result& result);
  bool has(std::size_t number) const { return places_[number] >= 0; }
  /// Reads a result; has() must be true.
  Result read(std::size_t number) const;

 private:
  Header header_;
  std::unique_ptr<std::fstream> file_;
  std::vector<std::int64_t> places_;  ///< of each line; -1: none
  std::int64_t end_ = 0;
  std::string temporary_;  ///< its path, to be removed
};

/// Reads files of results of one suite, in which each number is once. Calls `take` for each. Empty, or what is wrong:
/// `a.jsonl:3: ...`. `header` is that of the first file.
std::string read_results(const std::vector<std::string>& files, Header& header,
                         const std::function<std::string(std::size_t, const Result&)>& take);

}  // namespace symplant::suite
