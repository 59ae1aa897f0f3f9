// Simple arguments, each followed by its value.
#include "property/options.hpp"

#include <charconv>
#include <iostream>

int planted_bug = 0;

namespace symplant::property {
namespace {

constexpr const char* kUsage =
    "property [--plants N] [--seed S] [--minimum K] [--fixtures DIR] [--quiet] [--wrong] [--no-values] [--print]\n"
    "         [--replay FILE|DIR] [--tool FILE] [--bug N]\n";

template <class Number>
bool read_number(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool read_flag(const std::string& name, Options& options) {
  if (name == "--quiet") return options.quiet = true;
  if (name == "--wrong") return options.wrong = true;
  if (name == "--no-values") return !(options.values = false);
  if (name == "--print") return options.print = true;
  return false;
}

bool read_value(const std::string& name, const std::string& value, Options& options) {
  if (name == "--plants") return read_number(value, options.plants);
  if (name == "--seed") return read_number(value, options.seed);
  if (name == "--minimum") return read_number(value, options.minimum);
  if (name == "--bug") return read_number(value, planted_bug);
  if (name == "--fixtures") {
    options.fixtures = value;
  } else if (name == "--replay") {
    options.replay = value;
  } else if (name == "--tool") {
    options.tool = value;
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::optional<Options> read_options(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (read_flag(arguments[i], options)) continue;
    if (i + 1 == arguments.size() || !read_value(arguments[i], arguments[i + 1], options)) {
      std::cerr << "property: `" << arguments[i] << "`\n" << kUsage;
      return std::nullopt;
    }
    ++i;
  }
  return options;
}

}  // namespace symplant::property
