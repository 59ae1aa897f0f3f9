// A file system for tests: files in memory, and faults where a test needs them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_system.hpp"

namespace symplant::test {

class MemoryFileSystem final : public base::FileSystem {
 public:
  std::map<std::string, std::string> files;
  /// By path: why it cannot be read or written.
  std::map<std::string, std::string> faults;
  /// Files that a write has changed, in order.
  std::vector<std::string> written;

  base::Result<std::string, base::FileError> read(const std::string& path) const override {
    if (const auto fault = faults.find(path); fault != faults.end()) return error("read", path, fault->second);
    const auto file = files.find(path);
    if (file == files.end()) return error("read", path, "there is no such file or folder");
    return file->second;
  }

  base::Result<bool, base::FileError> write(const std::string& path, std::string_view content) override {
    if (const auto fault = faults.find(path); fault != faults.end()) return error("write", path, fault->second);
    const auto file = files.find(path);
    if (file != files.end() && file->second == content) return false;
    files[path] = std::string(content);
    written.push_back(path);
    return true;
  }

  base::Result<bool, base::FileError> write_new(const std::string& path, std::string_view content) override {
    if (exists(path)) return false;
    return write(path, content);
  }

  bool exists(const std::string& path) const override { return files.count(path) != 0; }

  std::vector<std::string> list(const std::string& folder) const override {
    const std::string prefix = folder == "." ? "" : folder + "/";
    std::vector<std::string> names;
    for (const auto& [path, content] : files) {
      if (path.starts_with(prefix) && path.find('/', prefix.size()) == std::string::npos) {
        names.push_back(path.substr(prefix.size()));
      }
    }
    return names;
  }

 private:
  static base::FileError error(const std::string& act, const std::string& path, const std::string& why) {
    return {"cannot " + act + " `" + path + "`: " + why};
  }
};

}  // namespace symplant::test
