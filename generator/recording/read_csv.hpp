// Reads tables of other tools: a row a time, a row a change, or columns of times and values side by side.
#pragma once

#include <iosfwd>
#include <string>

#include "recording/reading.hpp"

namespace symplant::recording {

/// Only changes are kept; the first value of a symbol is its first change. The first time is 0. Within a column of
/// times, and in a long table for each symbol, times must not go back. O(file), and O(changes * log(changes)) unless
/// there is one column of times and a column for each symbol.
ReadRecording read_csv(std::istream& file, const std::string& name, const ReadOptions& options);

}  // namespace symplant::recording
