// The options and helper functions of the command test.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "app/context.hpp"
#include "app/options.hpp"
#include "app/prepared_plant.hpp"
#include "suite/suite.hpp"

namespace symplant::app {

/// One part of several: `2/8`.
struct Shard {
  std::size_t index = 1;  ///< from 1
  std::size_t count = 1;

  bool has(std::size_t number) const { return number % count == index - 1; }
};

struct TestOptions {
  std::string folder;
  std::vector<std::string> cases;  ///< those to run; empty: all
  std::vector<std::string> programs;
  std::vector<std::string> links;
  std::vector<suite::Speed> speeds{suite::Speed::normal};
  bool update = false;
  std::size_t jobs = 0;  ///< 0: as many as there are processors
  Shard shard;
  std::string base;       ///< the case from which others are proposed; empty: no case is proposed
  std::size_t most = 50;  ///< the most cases that are proposed
  std::vector<std::string> merged;
  std::string output;
  std::string junit;
  std::string html;
  PlantOptions plant;
};

/// A temporary folder for files of cases. The destructor removes it.
class CaseFolder {
 public:
  CaseFolder();
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  ~CaseFolder();

  /// Empty, or why it could not be made.
  std::string error() const;
  std::string path() const { return path_.string(); }
  std::string trace(std::size_t number) const;

 private:
  std::filesystem::path path_;
  std::error_code error_;
};

/// How many processes run cases.
std::size_t jobs_of(const TestOptions& options);

/// Shows an error, and sets the exit code.
void fail_test(Context& context, const std::string& message, int code);

/// Writes cases into the folder of a suite: each does what the base case does, and one thing more.
void propose_cases(const TestOptions& options, const suite::Suite& suite, const PreparedPlant& prepared,
                   Context& context);

}  // namespace symplant::app
