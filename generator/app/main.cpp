// The entry point of the tool symplant.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

#include "app/tool.hpp"
#include "base/file_system.hpp"
#include "base/process.hpp"
#include "symplant/host/terminal.hpp"
#include "symplant/host/words.hpp"

namespace {

std::string working_folder() {
  std::error_code unknown;
  return std::filesystem::current_path(unknown).generic_string();
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
  using symplant::host::is_terminal;
  using symplant::host::Stream;
  symplant::host::set_up_streams();
  std::ios::sync_with_stdio(false);
  symplant::base::DiskFileSystem files;
  const bool colour_wanted = std::getenv("NO_COLOR") == nullptr;
  symplant::app::Context context{files, std::cout, std::cerr};
  context.today = symplant::host::today();
  context.folder = working_folder();
  context.colour_out = colour_wanted && is_terminal(Stream::output);
  context.colour_err = colour_wanted && is_terminal(Stream::error);
  symplant::base::SystemProcessRunner programs;
  context.programs = &programs;
  context.progress = is_terminal(Stream::error);
  if (is_terminal(Stream::input) && is_terminal(Stream::output)) context.answers = &std::cin;
  int code = symplant::app::run_tool(argc, argv, context);
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "error: cannot write the output (the disk is full, or the reader of the pipe has ended)\n";
    code = 3;
  }
  std::cerr.flush();
  std::fflush(nullptr);
  symplant::host::restore_streams();
  if (kLeaksAreLookedFor) return code;
  symplant::host::end_process(code);  // skips the destruction of the plant in `context`
}
