// Runs another program within limits and measures it.
#include "process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "text/utf8.hpp"

namespace symplant::hostile {
namespace {

constexpr std::size_t kKept = 64 * 1024;

rlim_t address_space = RLIM_INFINITY;

void send(int descriptor, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(127);
}

/// Between fork and exec: only what a child may do.
[[noreturn]] void become(std::vector<char*>& argv, const std::string& folder, const std::string& out,
                         const std::string& err) {
  const rlimit cpu{100, 100};
  const rlimit no_core{0, 0};
  const rlimit space{address_space, address_space};
  if (::chdir(folder.c_str()) != 0) ::_exit(127);
  ::setrlimit(RLIMIT_CPU, &cpu);
  if (address_space != RLIM_INFINITY) ::setrlimit(RLIMIT_AS, &space);
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::alarm(120);  // remains active after exec
  send(STDOUT_FILENO, out);
  send(STDERR_FILENO, err);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0) ::_exit(127);
  ::execv(argv.front(), argv.data());
  ::_exit(127);
}

/// Line ends and tabs do not count.
void look_for_control_characters(const std::string& text, Run& run) {
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    run.ill_formed = run.ill_formed || !point.valid || point.value == 0x7F ||
                     (point.value < 0x20 && point.value != '\n' && point.value != '\t');
    run.steers_terminal = run.steers_terminal || (point.value >= 0x80 && point.value < 0xA0);
    at += point.length;
  }
}

std::string taken_in(const std::string& path, Run& run) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  look_for_control_characters(text, run);
  if (text.size() > kKept) text.resize(kKept);
  return text;
}

}  // namespace

void limit_address_space(long kilobytes) { address_space = static_cast<rlim_t>(kilobytes) * 1024; }

Run run(const std::vector<std::string>& arguments, const std::string& folder, const std::string& scratch) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string out = scratch + "/stdout";
  const std::string err = scratch + "/stderr";
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot start another program");
  if (child == 0) become(argv, folder, out, err);

  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0) {
  }
  Run result;
  if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  result.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  result.peak_kilobytes = used.ru_maxrss;
  result.out = taken_in(out, result);
  result.err = taken_in(err, result);
  return result;
}

}  // namespace symplant::hostile
