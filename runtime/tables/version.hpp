// The version of the runtime; generated code checks it.
#pragma once

namespace symplant::tables {

inline constexpr int kVersionMajor = 0;
inline constexpr int kVersionMinor = 1;
inline constexpr int kVersionPatch = 0;

/// Layout of the tables: generated code compiles only against a runtime of the same number.
inline constexpr int kTablesVersion = 6;

/// "0.1.0"
const char* version() noexcept;

}  // namespace symplant::tables
