// The controller's command line.
#include "options.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace excell {

const char* const kUsage =
    "usage: excell_controller HOST:PORT [options]\n"
    "\n"
    "The stand-in PLC of the cell: a scan-cycle program, a Modbus TCP client of the plant.\n"
    "\n"
    "  --cycles N            end after N cycles of the cell (default 0: run until a signal)\n"
    "  --scan MS             time of one scan (default 10)\n"
    "  --connect-timeout MS  how long to retry the connection (default 5000)\n"
    "  --step-timeout MS     give up if a step waits longer for its input (default 10000)\n"
    "  --help                print this\n"
    "\n"
    "exit code: 0 good, 1 a cycle was not completed, 2 usage, 3 no connection\n"
    "example:   excell_controller 127.0.0.1:5020 --cycles 3\n";

namespace {

bool parse_number(std::string_view text, std::uint32_t least, std::uint32_t most, std::uint32_t& number) {
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  return fault == std::errc() && stop == end && number >= least && number <= most;
}

bool parse_address(std::string_view text, Options& options, std::string& error) {
  const std::size_t colon = text.rfind(':');
  std::uint32_t port = 0;
  if (colon == std::string_view::npos || colon == 0 || !parse_number(text.substr(colon + 1), 1, 65'535, port)) {
    error = "`" + std::string(text) + "` is not HOST:PORT";
    return false;
  }
  std::string_view host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  options.host = host;
  options.port = std::to_string(port);
  return true;
}

struct NumberOption {
  std::string_view name;
  std::uint32_t least;
  void (*set)(Options& options, std::uint32_t number);
};

constexpr std::uint32_t kMost = 1'000'000'000;
constexpr std::array kNumberOptions = {
    NumberOption{"--cycles", 0, [](Options& options, std::uint32_t number) { options.cycles = number; }},
    NumberOption{"--scan", 1,
                 [](Options& options, std::uint32_t number) { options.scan = std::chrono::milliseconds(number); }},
    NumberOption{
        "--connect-timeout", 0,
        [](Options& options, std::uint32_t number) { options.connect_timeout = std::chrono::milliseconds(number); }},
    NumberOption{
        "--step-timeout", 1,
        [](Options& options, std::uint32_t number) { options.step_timeout = std::chrono::milliseconds(number); }},
};

/// Sets the option `name` to `value`; false if there is no such option, or the value is not a valid number.
bool parse_number_option(std::string_view name, const char* value, Options& options, std::string& error) {
  for (const NumberOption& option : kNumberOptions) {
    if (option.name != name) continue;
    std::uint32_t number = 0;
    if (value == nullptr || !parse_number(value, option.least, kMost, number)) {
      error = std::string(name) + " takes a number of at least " + std::to_string(option.least);
      return false;
    }
    option.set(options, number);
    return true;
  }
  error = "`" + std::string(name) + "` is not an option";
  return false;
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv, std::string& error) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--help" || word == "-h") {
      options.help = true;
      return options;
    }
    if (word.substr(0, 1) == "-") {
      if (!parse_number_option(word, i + 1 < argc ? argv[i + 1] : nullptr, options, error)) return std::nullopt;
      ++i;
    } else if (!options.port.empty()) {
      error = "`" + std::string(word) + "` is one argument too many";
      return std::nullopt;
    } else if (!parse_address(word, options, error)) {
      return std::nullopt;
    }
  }
  if (options.port.empty()) {
    error = "HOST:PORT is missing";
    return std::nullopt;
  }
  return options;
}

}  // namespace excell
