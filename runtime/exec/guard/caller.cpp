// Names the function of a call, by the loader.
#include <cxxabi.h>
#include <dlfcn.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec {

std::string caller_of(const Violation& violation) {
  Dl_info info{};
  if (dladdr(violation.caller, &info) == 0) return {};
  if (info.dli_sname == nullptr) {
    const std::string_view path = info.dli_fname == nullptr ? "" : info.dli_fname;
    const auto index = static_cast<const char*>(violation.caller) - static_cast<const char*>(info.dli_fbase);
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), index, 16).ptr;
    return std::string(path.substr(path.find_last_of('/') + 1)) + "+0x" + std::string(digits.data(), end);
  }
  int fault = 0;
  const std::unique_ptr<char, decltype(&std::free)> readable(
      abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &fault), &std::free);
  return fault == 0 ? readable.get() : info.dli_sname;
}

}  // namespace symplant::exec
