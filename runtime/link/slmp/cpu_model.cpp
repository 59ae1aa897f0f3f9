// The CPU model that a PLC reports, compared with the family of the link.
#include "symplant/link/slmp/cpu_model.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "symplant/link/slmp/end_code.hpp"

namespace symplant::link::slmp {

using client::Identity;

namespace {

constexpr std::size_t kNameSize = 16;
constexpr std::uint32_t kModernCodes = 0x48;  ///< high byte of the model codes of iQ-R and iQ-L

std::string_view family_name(Family family) {
  constexpr std::array<std::string_view, 4> kNames = {"q", "l", "iqr", "fx5"};
  return kNames[static_cast<std::size_t>(family)];
}

/// By the model's name: Q03UDECPU, L26CPU-BT, R08CPU, FX5U-32MT/ES. The iQ-L has names of L and codes of iQ-R.
std::optional<Family> family_of(std::string_view name, std::uint32_t code) {
  if (name.starts_with("FX5")) return Family::fx5;
  if (name.empty()) return std::nullopt;
  if (name.front() == 'R') return Family::iqr;
  if (name.front() == 'Q') return Family::q;
  if (name.front() != 'L') return std::nullopt;
  return code >> 8 == kModernCodes ? Family::iqr : Family::l;
}

/// The name of the model, without blanks at its end, in printable ASCII.
std::string name_in(std::span<const std::uint8_t> data) {
  std::string name;
  for (const std::uint8_t c : data.first(std::min(data.size(), kNameSize))) {
    name += c > ' ' && c < 0x7F ? static_cast<char>(c) : ' ';
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

}  // namespace

Identity identity_of(const Reply& reply, const Framing& framing) {
  if (reply.end_code != 0) {
    return {Identity::Kind::unverifiable,
            "the PLC does not report its CPU model, so it cannot be compared with family=" +
                std::string(family_name(framing.family)) + " (" + end_code_text(reply.end_code, framing) + ")"};
  }
  const std::string name = name_in(reply.data);
  std::uint16_t code = 0;
  if (reply.data.size() > kNameSize) {
    DataReader(reply.data.subspan(kNameSize), framing.code).words({&code, 1});
  }
  const auto family = family_of(name, code);
  if (!family) {
    return {Identity::Kind::unverifiable, name.empty() ? "it answers the request for its CPU model without a name"
                                                       : "its CPU model `" + name + "` is unknown"};
  }
  if (*family == framing.family) return {Identity::Kind::verified, "CPU `" + name + "`"};
  return {Identity::Kind::wrong, "its CPU is `" + name +
                                     "`, but the link has family=" + std::string(family_name(framing.family)) +
                                     "; set family=" + std::string(family_name(*family)) + " if this is the right PLC"};
}

}  // namespace symplant::link::slmp
