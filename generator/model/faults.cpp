// Words and places of a description's faults.
#include "model/faults.hpp"

namespace symplant::model {

std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string missing(const std::string& what, std::string_view nearest) {
  return "there is no " + what + (nearest.empty() ? "" : ", the nearest is " + quoted(nearest));
}

Pointer Pointer::operator/(std::string_view key) const {
  std::string text = text_ + "/";
  for (const char c : key) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return Pointer(std::move(text));
}

Pointer device_pointer(const DeviceDescription& device) { return Pointer("/devices") / device.path; }

}  // namespace symplant::model
