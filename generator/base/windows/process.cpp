// Other programs by CreateProcess: pipes, a time limit, no shell.
#include "base/process.hpp"

#include <windows.h>

#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace symplant::base {
namespace {

using Kind = ProcessError::Kind;

ProcessError failure(Kind kind, const ProcessCall& call, const std::string& what) {
  return {kind, "`" + call.program + "` " + what};
}

std::string last_fault() { return std::system_category().message(static_cast<int>(GetLastError())); }

/// Owns a handle and closes it.
class Handle {
 public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  ~Handle() { close(); }
  Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  HANDLE get() const { return handle_; }
  void close() {
    if (handle_ != nullptr) CloseHandle(std::exchange(handle_, nullptr));
  }

 private:
  HANDLE handle_;
};

struct Pipe {
  Handle read;
  Handle write;
};

/// A pipe of which the child inherits both ends until one is kept back.
std::optional<Pipe> pipe_of_child() {
  SECURITY_ATTRIBUTES inherited{sizeof inherited, nullptr, TRUE};
  HANDLE read = nullptr;
  HANDLE write = nullptr;
  if (CreatePipe(&read, &write, &inherited, 0) == 0) return std::nullopt;
  return Pipe{Handle(read), Handle(write)};
}

void keep_back(const Handle& end) { SetHandleInformation(end.get(), HANDLE_FLAG_INHERIT, 0); }

/// As the C library of the child splits it: a quotation mark and the backslashes before it get a backslash each.
std::string quoted(const std::string& argument) {
  std::string text = "\"";
  std::size_t slashes = 0;
  for (const char c : argument) {
    if (c == '"') text.append(slashes + 1, '\\');
    slashes = c == '\\' ? slashes + 1 : 0;
    text += c;
  }
  return text.append(slashes, '\\') + '"';
}

/// The program on the path, and not one in the working folder, where anyone may have put it; empty: not found.
std::wstring found_on_path(const std::string& program) {
  const DWORD size = GetEnvironmentVariableW(L"PATH", nullptr, 0);
  std::wstring path(size, L'\0');
  path.resize(GetEnvironmentVariableW(L"PATH", path.data(), size));
  std::array<wchar_t, 32'768> found{};
  const std::wstring name = std::filesystem::path(program).wstring();
  const DWORD length = SearchPathW(path.c_str(), name.c_str(), L".exe", found.size(), found.data(), nullptr);
  return length < found.size() ? std::wstring(found.data(), length) : std::wstring();
}

/// A group of processes that ends with its handle: the program, and what it starts.
Handle group_that_ends() {
  Handle group(CreateJobObjectW(nullptr, nullptr));
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(group.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return group;
}

std::wstring command_line(const ProcessCall& call) {
  std::string text = quoted(call.program);
  for (const std::string& argument : call.arguments) text += " " + quoted(argument);
  return std::filesystem::path(text).wstring();
}

class Child {
 public:
  explicit Child(const ProcessCall& call) : call_(call) {}
  ~Child() {
    if (process_.get() != nullptr) end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::optional<ProcessError> start() {
    auto in = pipe_of_child();
    auto out = pipe_of_child();
    if (!in || !out) return failure(Kind::failed, call_, "has no pipes: " + last_fault());
    const std::wstring file = found_on_path(call_.program);
    if (file.empty()) return failure(Kind::absent, call_, "is not on the path");
    keep_back(in->write);
    keep_back(out->read);
    STARTUPINFOW how{};
    how.cb = sizeof how;
    how.dwFlags = STARTF_USESTDHANDLES;
    how.hStdInput = in->read.get();
    how.hStdOutput = out->write.get();
    SetHandleInformation(nothing_.get(), HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    how.hStdError = nothing_.get();
    PROCESS_INFORMATION made{};
    std::wstring line = command_line(call_);
    if (CreateProcessW(file.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW | CREATE_SUSPENDED, nullptr,
                       nullptr, &how, &made) == 0) {
      return failure(Kind::failed, call_, "could not be started: " + last_fault());
    }
    AssignProcessToJobObject(group_.get(), made.hProcess);
    ResumeThread(made.hThread);
    CloseHandle(made.hThread);
    process_ = Handle(made.hProcess);
    in_ = std::move(in->write);
    out_ = std::move(out->read);
    return std::nullopt;
  }

  Result<std::string, ProcessError> finish() {
    std::string output;
    bool is_much = false;
    std::jthread writer([this] { write(); });
    std::jthread reader([&] { is_much = !read(output); });
    const bool ended = WaitForSingleObject(process_.get(), static_cast<DWORD>(call_.limit.count())) == WAIT_OBJECT_0;
    DWORD code = 0;
    GetExitCodeProcess(process_.get(), &code);
    if (!ended) end();
    writer.join();
    reader.join();
    process_.close();
    if (is_much) return failure(Kind::too_large, call_, "wrote too much");
    if (!ended) {
      return failure(Kind::too_slow, call_, "took more than " + std::to_string(call_.limit.count()) + " ms");
    }
    if (code != 0) return failure(Kind::failed, call_, "ended with code " + std::to_string(code));
    return output;
  }

 private:
  void end() { TerminateJobObject(group_.get(), 1); }

  void write() {
    std::string_view rest = call_.input;
    DWORD count = 0;
    while (!rest.empty() && WriteFile(in_.get(), rest.data(), static_cast<DWORD>(rest.size()), &count, nullptr) != 0) {
      rest.remove_prefix(count);
    }
    in_.close();
  }

  /// Until the program closes its output; false if that was too much, and the program is ended.
  bool read(std::string& output) {
    std::array<char, 65'536> buffer{};
    DWORD count = 0;
    while (ReadFile(out_.get(), buffer.data(), buffer.size(), &count, nullptr) != 0 && count != 0) {
      output.append(buffer.data(), count);
      if (output.size() <= call_.most_output) continue;
      end();
      return false;
    }
    return true;
  }

  const ProcessCall& call_;
  Handle group_ = group_that_ends();
  Handle nothing_{
      CreateFileW(L"NUL", GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr, OPEN_EXISTING, 0, nullptr)};
  Handle in_;
  Handle out_;
  Handle process_;
};

}  // namespace

Result<std::string, ProcessError> SystemProcessRunner::run(const ProcessCall& call) {
  Child child(call);
  if (auto error = child.start()) return *error;
  return child.finish();
}

}  // namespace symplant::base
