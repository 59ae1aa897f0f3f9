// What fuzz targets share: the entry that libFuzzer calls, oracles, the whole road of the tool in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/file_system.hpp"
#include "model/plant_model.hpp"

/// Tries one input. 0, or -1 where it is none of the target's inputs at all; ends the program where an oracle is
/// contradicted.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace symplant::fuzz {

/// An oracle: ends the program, with these words, where it does not hold.
void require(bool holds, std::string_view what);

/// What every stage promises to the next.
bool is_utf8(std::string_view text);

/// The list that conditions and plant descriptions are tried on: devices of all shapes, numbers, names of every script.
std::string_view fixed_list();

/// From files to C++ and pages, as far as the input gets. `plant` names a file of `files`. Findings lie within their
/// files and are valid JSON, what is generated is printable ASCII, and the same each time.
void compile_all(const std::string& plant, const base::FileSystem& files);

/// The model of the fixed list.
const model::PlantModel& fixed_plant();

}  // namespace symplant::fuzz
