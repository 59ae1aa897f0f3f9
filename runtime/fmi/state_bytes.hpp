// The state of an instance as bytes that an importer may keep.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "symplant/fmi/instance.hpp"

namespace symplant::fmi {

struct ReadState {
  InstanceState state;
  std::uint8_t extra;
};

/// `extra` is a number of the caller. Valid for the same build of the library. O(state).
std::string state_bytes(const InstanceState& state, std::uint8_t extra, std::uint64_t model_hash);

/// Nothing if the bytes are not from state_bytes(), are damaged, or of another plant or version. O(state).
std::optional<ReadState> read_state(std::string_view bytes, std::uint64_t model_hash);

}  // namespace symplant::fmi
