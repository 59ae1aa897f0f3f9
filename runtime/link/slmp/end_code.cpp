// End codes of SLMP in plain words (QnUCPU and LCPU Ethernet manuals; observed answers).
#include "symplant/link/slmp/end_code.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace symplant::link::slmp {

namespace {

constexpr const char* kRange = "compare the address with the device ranges in the PLC's parameters";
constexpr const char* kFamilyAction = "check `family`, `frame` and `commands` of the link";
constexpr const char* kSetFrame = "set `frame=3e`";
constexpr const char* kSetCode = "set `code=binary`, as in the port";
constexpr const char* kPassword = "unlock the port, or remove its remote password in the PLC's parameters";

constexpr std::array kRows = {
    EndCode{0x0050, Remedy::configure, "the PLC does not know this frame type", kSetFrame},
    EndCode{0x0055, Remedy::permit, "the PLC is in RUN and its port does not permit writing",
            "set `Enable online change` in the parameters of the port (GX Simulator3: `Enable All (SLMP)`)"},
    EndCode{0x4013, Remedy::permit, "the PLC cannot do this in its operating state", "set the PLC to RUN or STOP"},
    EndCode{0x4030, Remedy::configure, "this device cannot be accessed here", "map the symbol to another device"},
    EndCode{0x4031, Remedy::configure, "a device number is outside of the configured range", kRange},
    EndCode{0x4032, Remedy::configure, "this device is not permitted in this command",
            "map the symbol to another device"},
    EndCode{0x4043, Remedy::configure, "the addressed module cannot answer",
            "check `module` and `station` of the link"},
    EndCode{0x4080, Remedy::configure, "the request data are wrong for the Ethernet module", kFamilyAction},
    EndCode{0x40C0, Remedy::configure, "a label cannot be accessed", "map the symbol to a device"},
    EndCode{0x414A, Remedy::configure, "the module does not permit writing", "map the symbol to another device"},
    EndCode{0x7F22, Remedy::configure, "a network or serial module does not know the command", kFamilyAction},
    EndCode{0x7FE7, Remedy::permit, "the module requires a password", kPassword},
    EndCode{0xC050, Remedy::configure, "the text of the request is not convertible", kSetCode},
    EndCode{0xC051, Remedy::configure, "the number of words is out of range (FX5: of bits)", kFamilyAction},
    EndCode{0xC052, Remedy::configure, "the number of bits is out of range (FX5: of words)", kFamilyAction},
    EndCode{0xC053, Remedy::configure, "the number of listed bits is out of range", kFamilyAction},
    EndCode{0xC054, Remedy::configure, "the number of listed words is out of range", kFamilyAction},
    EndCode{0xC055, Remedy::configure, "the size of file data is out of range", kFamilyAction},
    EndCode{0xC056, Remedy::configure, "the last device is beyond the highest number", kRange},
    EndCode{0xC057, Remedy::configure, "the length of the request does not match its text", kFamilyAction},
    EndCode{0xC058, Remedy::configure, "the length of the request differs after conversion", kFamilyAction},
    EndCode{0xC059, Remedy::configure, "the PLC does not support this command", kFamilyAction},
    EndCode{0xC05B, Remedy::configure, "the CPU cannot read or write this device", "map the symbol to another device"},
    EndCode{0xC05C, Remedy::configure, "the content of the request is wrong, such as bits of a word device",
            kFamilyAction},
    EndCode{0xC05D, Remedy::configure, "no monitored devices are registered", kFamilyAction},
    EndCode{0xC05F, Remedy::try_again, "the target CPU cannot execute the request",
            "check `network`, `station` and `module` of the link"},
    EndCode{0xC060, Remedy::configure, "the data of the request are wrong", kFamilyAction},
    EndCode{0xC061, Remedy::configure, "the length of the data does not match the request", kFamilyAction},
    EndCode{0xC06F, Remedy::configure, "ASCII and binary do not match", "set `code` as in the parameters of the port"},
    EndCode{0xC070, Remedy::configure, "the device extension is not permitted for this target", kFamilyAction},
    EndCode{0xC0B5, Remedy::configure, "the CPU cannot handle the data", kFamilyAction},
    EndCode{0xC200, Remedy::permit, "the remote password is wrong", kPassword},
    EndCode{0xC201, Remedy::permit, "the port is locked by a remote password", kPassword},
    EndCode{0xC204, Remedy::permit, "another device unlocked the remote password", kPassword},
    EndCode{0xC205, Remedy::permit, "the remote password cannot be used here", kPassword},
    EndCode{0xC207, Remedy::configure, "a file name has a wrong length", kFamilyAction},
    EndCode{0xC810, Remedy::permit, "the remote password is wrong", kPassword},
    EndCode{0xC815, Remedy::permit, "the remote password was wrong too often", kPassword},
    EndCode{0xC816, Remedy::permit, "remote password entry is locked", "wait, then unlock the port"},
    EndCode{0xCEE0, Remedy::try_again, "the PLC processes another request", "raise `poll`"},
    EndCode{0xCEE1, Remedy::configure, "the request exceeds the size limit", kFamilyAction},
    EndCode{0xCEE2, Remedy::configure, "the answer exceeds the size limit", kFamilyAction},
    EndCode{0xCF10, Remedy::configure, "the addressed server does not exist", "check `network` and `station`"},
    EndCode{0xCF20, Remedy::configure, "a setting of the request is wrong", kFamilyAction},
    EndCode{0xCF30, Remedy::configure, "the parameter does not exist", kFamilyAction},
    EndCode{0xCF31, Remedy::permit, "another program writes now", "end the other program"},
    EndCode{0xCF70, Remedy::try_again, "an error occurred on the route to the station", "check the network"},
    EndCode{0xCF71, Remedy::try_again, "the station did not answer in time", "raise `timer`, or check the network"},
};

constexpr EndCode kOfCpu{0x4000, Remedy::configure, "an error that the CPU module reports",
                         "look the code up in the manual of the CPU module"};
constexpr EndCode kOther{0xFFFF, Remedy::configure, "an unknown error",
                         "look the code up in the manual of the CPU or Ethernet module"};

static_assert(std::is_sorted(kRows.begin(), kRows.end(),
                             [](const EndCode& a, const EndCode& b) { return a.code < b.code; }));

}  // namespace

std::span<const EndCode> end_codes() noexcept { return kRows; }

const EndCode& end_code_of(std::uint16_t code) noexcept {
  const auto* const found = std::lower_bound(kRows.begin(), kRows.end(), code,
                                             [](const EndCode& row, std::uint16_t c) { return row.code < c; });
  if (found != kRows.end() && found->code == code) return *found;
  return code >= 0x4000 && code <= 0x4FFF ? kOfCpu : kOther;
}

namespace {

/// Without a setting that the link has already.
const char* action_of(const EndCode& row, const Framing& framing) noexcept {
  if (row.action == kSetFrame && framing.frame == FrameType::e3) {
    return "`frame=3e` is already set: check that this port speaks SLMP (MC protocol)";
  }
  if (row.action == kSetCode && framing.code == Code::binary) {
    return "compare the communication data code of the port with `code=binary` of the link";
  }
  return row.action;
}

}  // namespace

std::string end_code_text(std::uint16_t code, const Framing& framing) {
  const EndCode& row = end_code_of(code);
  std::array<char, 8> digits{};
  std::snprintf(digits.data(), digits.size(), "%04X", code);
  return std::string("end code ") + digits.data() + " (" + row.meaning + "): " + action_of(row, framing);
}

}  // namespace symplant::link::slmp
