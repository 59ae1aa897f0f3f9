// Shared objects by dlopen().
#include "symplant/program/shared_object.hpp"

#include <dlfcn.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace symplant::program {

const bool can_remove_loaded = true;
const char* const how_to_compile = "compile it as a shared library (-shared -fPIC)";

void* load_object(const std::string& path, const std::string& /*folder*/, std::string& fault) {
  void* const object = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object != nullptr) return object;
  const char* const why = ::dlerror();
  fault = why == nullptr ? "unknown" : why;
  return nullptr;
}

void unload_object(void* object) { ::dlclose(object); }

void* exported(void* object, const char* name) { return ::dlsym(object, name); }

bool is_loaded(const std::string& path) {
  void* const object = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
  if (object != nullptr) ::dlclose(object);
  return object != nullptr;
}

std::string new_temporary_file() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  std::string path = (error ? std::filesystem::path("/tmp") : folder) / "symplant-program-XXXXXX";
  const int file = ::mkstemp(path.data());
  if (file < 0) return {};
  ::close(file);
  return path;
}

}  // namespace symplant::program
