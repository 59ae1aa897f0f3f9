// The entry point of the tool symplant.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include "app/tool.hpp"
#include "base/file_system.hpp"
#include "base/process.hpp"

namespace {

/// The local date.
std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 16> text{};
  if (localtime_r(&now, &parts) == nullptr) return {};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

std::string working_folder() {
  std::error_code unknown;
  return std::filesystem::current_path(unknown).string();
}

#if defined(__SANITIZE_ADDRESS__)
#define SYMPLANT_LEAKS_ARE_LOOKED_FOR 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SYMPLANT_LEAKS_ARE_LOOKED_FOR 1
#endif
#endif
#ifdef SYMPLANT_LEAKS_ARE_LOOKED_FOR
constexpr bool kLeaksAreLookedFor = true;
#else
constexpr bool kLeaksAreLookedFor = false;
#endif

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  symplant::base::DiskFileSystem files;
  const bool colour_wanted = std::getenv("NO_COLOR") == nullptr;
  symplant::app::Context context{files, std::cout, std::cerr};
  context.today = today();
  context.folder = working_folder();
  context.colour_out = colour_wanted && isatty(fileno(stdout)) != 0;
  context.colour_err = colour_wanted && isatty(fileno(stderr)) != 0;
  symplant::base::SystemProcessRunner programs;
  context.programs = &programs;
  context.progress = isatty(fileno(stderr)) != 0;
  if (isatty(fileno(stdin)) != 0 && isatty(fileno(stdout)) != 0) context.answers = &std::cin;
  int code = symplant::app::run_tool(argc, argv, context);
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "error: cannot write the output (the disk is full, or the reader of the pipe has ended)\n";
    code = 3;
  }
  std::cerr.flush();
  std::fflush(nullptr);
  if (kLeaksAreLookedFor) return code;
  std::_Exit(code);  // skips the destruction of the plant in `context`
}
