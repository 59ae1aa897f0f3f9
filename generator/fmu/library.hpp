// The libraries that the tool packs into FMUs: of any plant, one for each platform.
#pragma once

#include <span>
#include <string_view>

namespace symplant::fmu {

struct Library {
  std::string_view platform;   ///< of FMI 2.0: "linux64", "win64"
  std::string_view extension;  ///< ".so", ".dll"
  std::string_view bytes;
};

/// Those that the tool was built with.
std::span<const Library> libraries();

}  // namespace symplant::fmu
