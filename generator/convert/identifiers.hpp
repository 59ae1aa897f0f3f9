// Names that a target accepts.
#pragma once

#include <string>
#include <string_view>

namespace symplant::convert {

/// Whether a name is an identifier of IEC 61131-3: ASCII letters, digits and single `_`, no digit first, no `_` last,
/// and no keyword, type or standard function.
bool is_iec_identifier(std::string_view name);

/// Whether a name is a keyword, type or standard function of IEC 61131-3.
bool is_iec_reserved(std::string_view name);

/// An identifier that reads like `utf8_name`, which is returned unchanged if it is one. ASCII characters that cannot be
/// in an identifier become `_`, others `u` and their number (`밸브1` is `uBC38uBE0C1`); `_` is put before a digit and
/// a keyword. Different names may give one identifier. O(name).
std::string iec_identifier(std::string_view utf8_name);

/// Whether TIA Portal accepts a name of a tag: at most 128 characters, no `"` and no control characters.
bool is_tia_name(std::string_view name);

/// The name with `'` for `"`, blanks for control characters, and cut to `most` characters.
std::string tia_name(std::string_view utf8_name);

}  // namespace symplant::convert
