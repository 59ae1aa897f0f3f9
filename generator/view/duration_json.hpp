// A duration as JSON.
#pragma once

#include "description/duration.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// Nanoseconds, the parameters of a random time, or a formula of seconds.
inline void write_time(const description::Duration& time, JsonWriter& json) {
  if (time.kind == description::Duration::Kind::fixed) return json.value(time.a);
  const bool uniform = time.kind == description::Duration::Kind::uniform;
  json.begin_object();
  if (time.kind == description::Duration::Kind::seconds) {
    json.member("seconds", *time.formula);
    return json.end_object();
  }
  json.member(uniform ? "min" : "mean", time.a);
  json.member(uniform ? "max" : "sigma", time.b);
  json.end_object();
}

}  // namespace symplant::view
