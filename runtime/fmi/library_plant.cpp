// The plant of an FMU's library.
#include "symplant/fmi/library_plant.hpp"

#ifdef _WIN32
#include <windows.h>
#endif

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

namespace symplant::fmi {
namespace {

#ifdef _WIN32
constexpr bool kWindows = true;
#else
constexpr bool kWindows = false;
#endif

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// `%20` is a byte; a percent sign without two digits is itself.
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped =
        text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
    plain.push_back(escaped ? static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2])) : text[i]);
    if (escaped) i += 2;
  }
  return plain;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Null if it cannot be opened. Streams of C++ would triple the size of the library.
std::unique_ptr<std::FILE, CloseFile> open_file(const std::string& path) {
#ifdef _WIN32
  const int size = MultiByteToWideChar(CP_UTF8, 0, path.c_str(), -1, nullptr, 0);
  std::wstring wide(static_cast<std::size_t>(size), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, path.c_str(), -1, wide.data(), size);
  return std::unique_ptr<std::FILE, CloseFile>(_wfopen(wide.c_str(), L"rb"));
#else
  return std::unique_ptr<std::FILE, CloseFile>(std::fopen(path.c_str(), "rb"));
#endif
}

std::optional<std::string> read_file(const std::string& path) {
  const auto file = open_file(path);
  if (file == nullptr) return std::nullopt;
  std::string bytes;
  std::array<char, 65'536> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file.get())) bytes.append(part.data(), size);
  if (std::ferror(file.get()) != 0) return std::nullopt;
  return bytes;
}

}  // namespace

std::string path_of_uri(std::string_view uri, bool windows) {
  constexpr std::string_view kScheme = "file:";
  if (uri.substr(0, kScheme.size()) != kScheme) return std::string(uri);
  std::string_view path = uri.substr(kScheme.size());
  if (path.substr(0, 2) == "//") {  // an authority, which is empty or this machine
    const std::size_t end = path.find('/', 2);
    path = end == path.npos ? std::string_view() : path.substr(end);
  }
  std::string plain = without_escapes(path);
  if (windows && plain.size() > 2 && plain[0] == '/' && plain[2] == ':') plain.erase(0, 1);
  return plain;
}

std::variant<LibraryPlant, std::string> LibraryPlant::load(std::string_view resources) {
  LibraryPlant plant;
  plant.compiled_ = compiled_plant();
  if (plant.compiled_ != nullptr) return plant;
  const std::string path = path_of_uri(resources, kWindows) + "/" + std::string(kTablesName);
  const auto bytes = read_file(path);
  if (!bytes) return "cannot read `" + path + "`: the importer must unpack the whole FMU";
  auto read = LoadedTables::read(*bytes);
  if (auto* const error = std::get_if<std::string>(&read)) return "`" + path + "`: " + *error;
  plant.loaded_ = std::get<std::unique_ptr<const LoadedTables>>(std::move(read));
  if (!plant.tables().behaviour_units.empty()) {
    return "the plant has custom behaviors, which are C++: this library does not have them; make the FMU with "
           "symplant_add_fmu()";
  }
  return plant;
}

}  // namespace symplant::fmi
