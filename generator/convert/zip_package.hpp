// Packs texts into a zip container. The only file of this floor that uses libzip.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "convert/writer.hpp"

namespace symplant::convert {

/// A text that is made piece by piece, so that it is never whole in memory.
struct PackagePart {
  std::string name;                               ///< "xl/workbook.xml"
  std::function<std::string(std::size_t)> piece;  ///< by number, from 0; empty after the last; equal in every call
};

/// The bytes of the container. Equal texts give equal bytes: all parts have the same date. Makes each text twice,
/// because its length is written before it. The error is that of libzip.
base::Result<std::string, WriteError> zip_package(const std::vector<PackagePart>& parts);

}  // namespace symplant::convert
