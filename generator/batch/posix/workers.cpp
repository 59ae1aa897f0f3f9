// Processes that are copies of this one, and pipes to them.
#include "batch/workers.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "symplant/program/crash.hpp"

namespace symplant::batch {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr int kPatience = 100;            // ms
constexpr std::size_t kMostWords = 4000;  // bytes

using Pipe = std::array<int, 2>;  // where it is read, where it is written

bool write_all(int file, const void* bytes, std::size_t size) {
  const auto* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(file, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int file, void* bytes, std::size_t size) {
  auto* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t read = ::read(file, at, size);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    at += read;
    size -= static_cast<std::size_t>(read);
  }
  return true;
}

/// In the process that works: pieces come as numbers, answers go with their sizes.
[[noreturn]] void serve(int pieces, int answers, const std::function<std::string(std::size_t)>& work) {
  const program::CallLimit limit;
  std::uint64_t piece = 0;
  while (read_all(pieces, &piece, sizeof piece)) {
    const std::string answer = work(piece);
    const std::uint64_t size = answer.size();
    if (!write_all(answers, &size, sizeof size) || !write_all(answers, answer.data(), answer.size())) break;
  }
  ::_exit(0);
}

/// How a process ended, for one that wrote nothing.
std::string ending(int status) {
  if (WIFSIGNALED(status)) return fmt::format("the process of the case was ended by {}", ::strsignal(WTERMSIG(status)));
  return fmt::format("the process of the case ended with exit code {}", WEXITSTATUS(status));
}

class Worker {
 public:
  bool start(const std::vector<Worker>& others, const std::function<std::string(std::size_t)>& work) {
    Pipe pieces{};
    Pipe answers{};
    if (::pipe(pieces.data()) != 0 || ::pipe(answers.data()) != 0) return false;
    if (!words_) words_.reset(std::tmpfile());
    if (!words_) return false;
    process_ = ::fork();
    if (process_ < 0) return false;
    if (process_ == 0) {
      for (const Worker& other : others) other.close_files();  // else they would not see the end of their pieces
      ::close(pieces[1]);
      ::close(answers[0]);
      ::setpgid(0, 0);  // Ctrl-C is for the first process
      ::dup2(::fileno(words_.get()), STDOUT_FILENO);
      ::dup2(::fileno(words_.get()), STDERR_FILENO);
      serve(pieces[0], answers[1], work);
    }
    ::close(pieces[0]);
    ::close(answers[1]);
    pieces_ = pieces[1];
    answers_ = answers[0];
    piece_ = kNone;
    return true;
  }

  bool runs() const { return process_ > 0; }
  bool is_busy() const { return piece_ != kNone; }
  std::size_t piece() const { return piece_; }
  int answers() const { return answers_; }

  /// False if the process has ended.
  bool give(std::size_t piece) {
    piece_ = piece;
    if (::ftruncate(::fileno(words_.get()), 0) == 0) ::lseek(::fileno(words_.get()), 0, SEEK_SET);
    const std::uint64_t number = piece;
    return write_all(pieces_, &number, sizeof number);
  }

  /// Takes the answer that is there. False if the process has ended instead.
  bool take(std::string& answer) {
    std::uint64_t size = 0;
    if (!read_all(answers_, &size, sizeof size)) return false;
    answer.resize(size);
    if (!read_all(answers_, answer.data(), size)) return false;
    piece_ = kNone;
    return true;
  }

  /// Waits for the end of the process. Returns what it wrote for its piece, or how it ended.
  std::string end() {
    ::close(pieces_);
    ::close(answers_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    piece_ = kNone;
    std::string words(kMostWords, '\0');
    const off_t end = ::lseek(::fileno(words_.get()), 0, SEEK_END);
    const off_t begin = std::max<off_t>(0, end - static_cast<off_t>(words.size()));  // the last words say how it ended
    words.resize(static_cast<std::size_t>(
        std::max<ssize_t>(0, ::pread(::fileno(words_.get()), words.data(), words.size(), begin))));
    return words.empty() ? ending(status) : words;
  }

  void kill() const { ::kill(process_, SIGKILL); }

 private:
  void close_files() const {
    if (!runs()) return;
    ::close(pieces_);
    ::close(answers_);
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  pid_t process_ = -1;
  int pieces_ = -1;
  int answers_ = -1;
  std::unique_ptr<std::FILE, Close> words_;  ///< standard output and error of the process
  std::size_t piece_ = kNone;
};

class Pool {
 public:
  Pool(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& work,
       const std::function<void(const Done&)>& done)
      : count_(count), workers_(std::max<std::size_t>(1, std::min(jobs, count))), work_(work), done_(done) {}

  std::string run(const std::function<bool()>& stop) {
    std::string error;
    while (error.empty() && !stop() && (next_ < count_ || busy() != 0)) {
      error = hand_out();
      if (error.empty()) wait();
    }
    for (Worker& worker : workers_) {
      if (!worker.runs()) continue;
      if (worker.is_busy()) worker.kill();
      worker.end();
    }
    return error;
  }

 private:
  std::size_t busy() const {
    return static_cast<std::size_t>(std::count_if(
        workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.runs() && worker.is_busy(); }));
  }

  std::string hand_out() {
    for (Worker& worker : workers_) {
      if (next_ == count_ || (worker.runs() && worker.is_busy())) continue;
      if (!worker.runs() && !worker.start(workers_, work_)) {
        return fmt::format("cannot start a process: {}", std::strerror(errno));
      }
      if (!worker.give(next_++)) ended(worker);
    }
    return "";
  }

  void wait() {
    std::vector<pollfd> files;
    std::vector<Worker*> whose;
    for (Worker& worker : workers_) {
      if (!worker.runs() || !worker.is_busy()) continue;
      files.push_back({worker.answers(), POLLIN, 0});
      whose.push_back(&worker);
    }
    if (::poll(files.data(), files.size(), kPatience) <= 0) return;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (files[i].revents == 0) continue;
      const std::size_t piece = whose[i]->piece();
      std::string answer;
      whose[i]->take(answer) ? done_({piece, std::move(answer), ""}) : ended(*whose[i]);
    }
  }

  void ended(Worker& worker) {
    const std::size_t piece = worker.piece();
    done_({piece, "", worker.end()});
  }

  const std::size_t count_;
  std::size_t next_ = 0;
  std::vector<Worker> workers_;
  const std::function<std::string(std::size_t)>& work_;
  const std::function<void(const Done&)>& done_;
};

}  // namespace

std::string do_in_processes(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& work,
                            const std::function<void(const Done&)>& done, const std::function<bool()>& stop) {
  struct sigaction ignored {};
  ignored.sa_handler = SIG_IGN;  // a process that ended is noticed by its answers
  struct sigaction before {};
  ::sigaction(SIGPIPE, &ignored, &before);
  std::string error = Pool(count, jobs, work, done).run(stop);
  ::sigaction(SIGPIPE, &before, nullptr);
  return error;
}

}  // namespace symplant::batch
