// Compares two rows field by field.
#pragma once

#include <optional>
#include <string_view>

#include "address/address.hpp"
#include "diff/difference.hpp"

namespace symplant::diff {

/// The address of a row that counts; nothing if the row has no readable address.
std::optional<address::Address> address_of(const model::PlantModel& plant, const RowRef& at);

/// The address as the list writes it: the vendor's, else the IEC one; empty without one.
std::string_view written_address(const read::ListRow& row);

/// Whether two cells name one type, in the words of any tool.
bool same_type(std::string_view a, std::string_view b);

/// What differs between two rows. Spellings of one value do not differ: `X1F` and `X001F`, `BOOL` and `Bool`, an empty
/// initial value and FALSE. `other` is a class, a scope or a second address, compared between lists of one format only.
Fields differing_fields(const model::PlantModel& before, const RowRef& a, const model::PlantModel& after,
                        const RowRef& b);

}  // namespace symplant::diff
