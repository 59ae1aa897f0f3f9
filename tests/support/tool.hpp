// The tool in process: a command line in, its files in memory, all its output as text.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "app/tool.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {

struct ToolRun {
  int code = 0;
  std::string out;
  std::string err;
};

inline ToolRun run_tool(std::vector<std::string> arguments, base::FileSystem& files) {
  arguments.insert(arguments.begin(), "symplant");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  std::ostringstream out;
  std::ostringstream err;
  app::Context context{files, out, err};
  const int code = app::run_tool(static_cast<int>(arguments.size()), argv.data(), context);
  return {code, out.str(), err.str()};
}

inline ToolRun run_tool(const std::vector<std::string>& arguments) {
  MemoryFileSystem files;
  return run_tool(arguments, files);
}

}  // namespace symplant::test
