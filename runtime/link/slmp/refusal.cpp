// Packs a request that a MELSEC PLC refused into a tables::Refusal.
#include "symplant/link/slmp/refusal.hpp"

#include "symplant/link/slmp/end_code.hpp"

namespace symplant::link::slmp {

namespace {

constexpr std::uint8_t kRefusedWriting = 0x10;
constexpr std::uint8_t kRefusedOctal = 0x80;
constexpr std::uint32_t kNumberBits = 24;
static_assert(kMostDevices == std::uint32_t{1} << kNumberBits);

}  // namespace

tables::Refusal refusal_of(const RefusedRequest& request, Family family, std::uint16_t end_code) {
  const int function = static_cast<int>(request.access) | (request.writing ? kRefusedWriting : 0) |
                       (family == Family::fx5 ? kRefusedOctal : 0);
  const std::uint32_t code = info_of(request.first.kind).code;
  return {tables::Refusal::Side::slmp_client, static_cast<std::uint8_t>(function), end_code,
          code << kNumberBits | (request.first.number & (kMostDevices - 1))};
}

std::string refusal_text(const tables::Refusal& refusal) {
  const auto kind = kind_with_code(static_cast<std::uint8_t>(refusal.address >> kNumberBits));
  const Family family = (refusal.function & kRefusedOctal) != 0 ? Family::fx5 : Family::iqr;
  const Device first{kind.value_or(0), refusal.address & (kMostDevices - 1)};
  return std::string((refusal.function & kRefusedWriting) != 0 ? "writing from " : "reading from ") +
         device_text(first, family) + " on: " + end_code_text(refusal.code, {.family = family});
}

client::Answer answer_of(std::uint16_t end_code) noexcept {
  return end_code_of(end_code).remedy == Remedy::try_again ? client::Answer::busy : client::Answer::refused;
}

}  // namespace symplant::link::slmp
