// The texts of what a server link finds in the requests of its clients.
#pragma once

#include <string>
#include <string_view>

#include "symplant/tables/refusal.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::trace {

// Each one sentence, as finding_words() gives it; `found` is of this kind.

std::string not_read_words(const FoundThing& found, const PlantNames& names);
std::string not_sampled_words(const FoundThing& found, const PlantNames& names);
std::string several_writers_words(const FoundThing& found, const PlantNames& names);

/// A request that the server of `link` answered with an exception.
std::string refused_by_server_words(const tables::Refusal& refusal, std::string_view link);

}  // namespace symplant::trace
