// A short summary of a plant, printed at the start of a run.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::host {

/// The file names of the plant's symbol lists, separated by commas; only the first ones if there are many.
std::string lists_text(const tables::PlantTables& tables);

/// The plant's inputs, the devices that can move, the operations that move a device or are read, and the events that
/// are not driven. `more` are further lines, after the first. A behavior in `behaviours` drives the events of its
/// devices.
std::string summary(const tables::PlantTables& tables, std::uint64_t model_hash,
                    std::span<const std::string_view> more = {}, std::span<const engine::Behaviour> behaviours = {});

/// A line for each behavior that replaces functions of the model, and for each that the program has no code for; else
/// empty.
std::string behaviour_lines(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours);

/// A line for each formula that the user's C++ replaces; else empty.
std::string formula_lines(const tables::ValueTables& values);

/// A line for each malfunction that cuts a link, for a run in virtual time.
std::string cut_link_lines(const tables::PlantTables& tables, const std::vector<bool>& with_program);

}  // namespace symplant::host
