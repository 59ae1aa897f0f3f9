// The options and helper functions of the command test.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "app/batch_options.hpp"
#include "app/context.hpp"
#include "app/options.hpp"
#include "app/prepared_plant.hpp"
#include "suite/suite.hpp"

namespace symplant::app {

struct TestOptions : BatchOptions {
  std::string folder;
  std::vector<std::string> cases;  ///< those to run; empty: all
  std::vector<std::string> programs;
  std::vector<suite::Speed> speeds{suite::Speed::normal};
  bool update = false;
  std::string base;       ///< the case from which others are proposed; empty: no case is proposed
  std::size_t most = 50;  ///< the most cases that are proposed
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
  std::string path() const { return path_.generic_string(); }
  std::string trace(std::size_t number) const;

 private:
  std::filesystem::path path_;
  std::error_code error_;
};

/// Writes cases into the folder of a suite: each does what the base case does, and one thing more.
void propose_cases(const TestOptions& options, const suite::Suite& suite, const PreparedPlant& prepared,
                   Context& context);

}  // namespace symplant::app
