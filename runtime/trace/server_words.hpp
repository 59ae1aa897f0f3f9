// The texts of findings of a server link about the requests of its clients.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "symplant/tables/missed_pulse.hpp"
#include "symplant/tables/refusal.hpp"

namespace symplant::trace {

/// The symbol of a finding.
struct ServedSymbol {
  std::string words;  ///< `PLC output Y0001, operation P2 of EXLINE_MB_AGV (symbols.csv:4)`
  bool inverted = false;
};

// Each is one sentence, as finding_words() gives it.

std::string not_read_words(const ServedSymbol& symbol, const tables::MissedPulse& pulse);
std::string not_sampled_words(const ServedSymbol& symbol, const tables::MissedPulse& pulse);
/// `writers`: the IPv4 addresses of two clients, the first one in the upper half; 0: unknown.
std::string several_writers_words(const ServedSymbol& symbol, std::uint64_t writers);
/// A request that the server of `link` answered with an exception.
std::string refused_by_server_words(const tables::Refusal& refusal, std::string_view link);

}  // namespace symplant::trace
