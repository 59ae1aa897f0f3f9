// The table of writers, and writing symbols in any of their formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "convert/writer.hpp"

namespace symplant::convert {

std::span<const WriterInfo* const> writers();

/// Null for an unknown name.
const WriterInfo* find_writer(std::string_view name);
/// The writer of files with this extension (".csv"), regardless of case; null for any other.
const WriterInfo* writer_of_extension(std::string_view extension);

/// Makes the output and reports what the format cannot hold. The text refers to the symbols.
base::Result<Output, WriteError> write(const WriterInfo& writer, const Writing& writing);

}  // namespace symplant::convert
