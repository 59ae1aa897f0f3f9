// From named symbols to the plant model, in two stages: what the names say, then what the description adds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/derived.hpp"
#include "model/list_input.hpp"

namespace symplant::model {

/// The first stage: classifies the rows and groups the symbols by device. Units have operations and events and no
/// states yet. `lists` holds at least one list, and one naming rule has parsed all of them. Names of controllers
/// compare without regard to the case of ASCII letters. `reader` has read the lists. Symbols that follow a condition of
/// `description`, which may be null, are in no unit. O(rows * patterns for symbols).
Derived derive(const std::vector<ListInput>& lists, std::string plant_name,
               std::shared_ptr<const name::SymbolReader> reader, const description::Description* description = nullptr);

/// The second stage, with the same description: matches the description's entries with devices, derives each unit's
/// model, resolves relations, shared addresses and links. A null `description` means that there is none; `source` is
/// its file, null without one; `naming_files` are the files of the naming rule. Errors of the description are in
/// Evidence::faults. O(rows), O(states squared) within a unit, and O(entries) of the description, where a `*` counts as
/// one entry for each state.
Derived describe(Derived derived, std::shared_ptr<const description::Description> description,
                 std::shared_ptr<const description::PlantSource> source = nullptr,
                 std::vector<std::string> naming_files = {});

}  // namespace symplant::model
