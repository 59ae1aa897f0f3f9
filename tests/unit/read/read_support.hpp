// Shared parts of the tests of reading: reading from memory, and a table as text.
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "diag/text.hpp"
#include "read/readers.hpp"
#include "support/golden.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::test {

inline const std::string kGoldens = std::string(SYMPLANT_GOLDEN_READ) + "/";

struct Reading {
  std::optional<read::SymbolTable> table;
  diag::Diagnostics diagnostics;
};

inline Reading read_text(const std::string& bytes, const std::string& name = "list.csv",
                         const read::ReadOptions& options = {}) {
  MemoryFileSystem files;
  files.files[name] = bytes;
  Reading reading;
  reading.table = read::read_symbol_list(name, options, files, reading.diagnostics);
  return reading;
}

/// Under its name without the folder, so that messages are the same everywhere.
inline Reading read_golden(const std::string& path) {
  return read_text(read_bytes(path), std::filesystem::path(path).filename().string());
}

/// How often a hostile text repeats something.
inline constexpr int kMany = 100'000;

inline std::string repeated(std::string_view text, int times) {
  std::string all;
  all.reserve(text.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Reads a text in less than two seconds, also if the tests run several at a time on a slow machine.
inline Reading read_soon(const std::string& text, const std::string& name = "list.csv",
                         const read::ReadOptions& options = {}) {
  const auto begin = std::chrono::steady_clock::now();
  Reading reading = read_text(text, name, options);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  CHECK(reading.table.has_value() != reading.diagnostics.has_errors());
  return reading;
}

/// The lists of a folder by name, without the expected results.
inline std::vector<std::string> lists_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.find("expected.txt") == std::string::npos) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline std::string rows_as_text(const read::SymbolTable& table) {
  std::string text;
  for (const read::ListRow& row : table.rows) {
    for (const std::string_view cell :
         {row.klass, row.name, row.vendor_address, row.iec_address, row.type, row.initial, row.comment}) {
      text.append(cell).append("|");
    }
    text.back() = '\n';
  }
  return text;
}

/// The same with what only few rows have: `scope`, `alias`, `parent` (the comment of the parent).
inline std::string rows_with_extras(const read::SymbolTable& table) {
  std::string text;
  for (const read::ListRow& row : table.rows) {
    text += std::to_string(row.line) + ": ";
    for (const std::string_view cell :
         {row.klass, row.name, row.vendor_address, row.iec_address, row.type, row.initial, row.comment}) {
      text.append(cell).append("|");
    }
    const read::RowExtra& extra = table.extra_of(row);
    if (!extra.scope.empty()) text.append(" scope: ").append(extra.scope);
    if (!extra.alias.empty()) text.append(" alias: ").append(extra.alias);
    if (!extra.parent_comment.empty()) text.append(" parent: ").append(extra.parent_comment);
    text += '\n';
  }
  return text;
}

}  // namespace symplant::test
