// Builds JSON texts piece by piece.
#pragma once

#include "symplant/trace/json_text.hpp"

namespace symplant::panel {

using trace::index_or_null;
using trace::put;
using trace::put_comma;
using trace::put_indexes;
using trace::put_key;
using trace::put_member;
using trace::put_text;

}  // namespace symplant::panel
