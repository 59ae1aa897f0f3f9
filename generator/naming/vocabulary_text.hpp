// The words that ship, as text for people and editors.
#pragma once

#include <string>

namespace symplant::naming {

/// A JSON object of the words that every naming rule knows, by use.
std::string vocabulary_text();

}  // namespace symplant::naming
