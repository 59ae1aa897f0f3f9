// Shared parts of the fuzz targets: the entry that libFuzzer calls, oracles, all stages of the tool in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/file_system.hpp"
#include "model/plant_model.hpp"

/// Tries one input. Returns 0, or -1 if the target does not accept the input; ends the program if an oracle
/// fails.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace symplant::fuzz {

/// An oracle: ends the program with this message if the condition is false.
void require(bool holds, std::string_view what);

/// The guarantees of every stage to the next.
bool is_utf8(std::string_view text);

/// The list for conditions and plant descriptions: devices of all shapes, numbers, names of every script.
std::string_view fixed_list();

/// From files to C++ and pages, as far as the input gets. `plant` names a file of `files`. Findings lie within their
/// files and are valid JSON, what is generated is printable ASCII, and the same each time.
void compile_all(const std::string& plant, const base::FileSystem& files);

/// The model of the fixed list.
const model::PlantModel& fixed_plant();

}  // namespace symplant::fuzz
