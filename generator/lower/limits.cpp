// SP701 plant-too-large: what the engine's tables cannot hold.
#include "lower/limits.hpp"

#include <array>
#include <utility>

namespace symplant::lower {
namespace {

constexpr std::string_view kPage =
    R"(A plant can have at most 8,388,607 types of devices (devices of equal structure share one type) and 2,147,483,647
bits each of operations and events. This plant has more.

**What the model loses.** It cannot be built.

**How to fix it.** Split it into several plants.
)";

}  // namespace

const diag::RuleInfo kPlantTooLarge{"SP701", "plant-too-large", diag::Severity::error,
                                    "the plant has more types or bits than the engine can number", kPage};

std::string beyond_limits(const Sizes& sizes) {
  struct Limit {
    std::uint64_t size;
    std::uint64_t most;
    const char* what;
  };
  const std::array<Limit, 3> limits{{{sizes.types, kMaxTypes, " types of devices"},
                                     {sizes.operation_bits, kMaxBits, " bits of operations"},
                                     {sizes.event_bits, kMaxBits, " bits of events"}}};
  for (const Limit& limit : limits) {
    if (limit.size <= limit.most) continue;
    return "the plant has " + std::to_string(limit.size) + limit.what + ", but at most " + std::to_string(limit.most) +
           " are supported; split it into several plants";
  }
  return "";
}

void check_limits(const EngineTables& tables, diag::Diagnostics& diagnostics) {
  std::string message = beyond_limits({tables.types.size(), tables.operation_bits, tables.event_bits});
  if (!message.empty()) diagnostics.add(kPlantTooLarge, std::move(message), {});
}

}  // namespace symplant::lower
