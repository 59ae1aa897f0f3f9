// The limit of files that a process may open.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <optional>

namespace symplant::link::net {

/// The soft limit of descriptors raised by `clients`, at most to the hard limit; nothing if the hard limit is too small
/// for the clients and a few files.
std::optional<rlim_t> limit_for(rlimit limit, std::size_t clients) noexcept;

}  // namespace symplant::link::net
