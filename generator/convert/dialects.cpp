// The tools for which declarations are written.
#include "convert/dialects.hpp"

#include <algorithm>
#include <array>

namespace symplant::convert {
namespace {

constexpr std::array kDialects{Dialect{"codesys", "CODESYS", kCodesysForm, false, false},
                               Dialect{"twincat", "TwinCAT", kTwinCatForm, true, false},
                               Dialect{"openplc", "OpenPLC", kOpenPlcForm, false, true}};

}  // namespace

std::span<const Dialect> dialects() { return kDialects; }

const Dialect* find_dialect(std::string_view name) {
  const auto found =
      std::find_if(kDialects.begin(), kDialects.end(), [&](const Dialect& dialect) { return dialect.name == name; });
  return found == kDialects.end() ? nullptr : &*found;
}

}  // namespace symplant::convert
