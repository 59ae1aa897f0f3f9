// The families' profiles.
#include "support/slmp/plc_profile.hpp"

namespace symplant::test::slmp {

Limits PlcProfile::limits(bool with_iqr_subcommand, Code code) const {
  const bool is_ascii = code == Code::ascii;
  if (with_iqr_subcommand) return {960, is_ascii ? 3584U : 7168U, 96, 960, 94, 60, 960, 9};
  if (family == Family::fx5) return {is_ascii ? 480U : 960U, is_ascii ? 1792U : 3584U, 192, 1920, 188, 120, 960, 4};
  return {960, is_ascii ? 3584U : 7168U, 192, 1920, 188, 120, 960, 4};
}

PlcProfile profile_of(Family family, Port port) {
  const bool is_e71 = port == Port::e71;
  const bool is_plain = (family == Family::q || family == Family::l) && !is_e71;
  const bool is_fx5 = family == Family::fx5;
  PlcProfile profile{};
  profile.family = family;
  profile.port = port;
  profile.has_4e = !is_plain;
  profile.has_iqr_subcommands = family == Family::iqr && !is_e71;
  profile.has_model = !is_plain;
  profile.has_blocks = !is_plain;
  profile.has_bit_batches = true;
  profile.has_loopback = !is_plain;
  profile.writes_steps = is_fx5 || is_e71;
  profile.foreign_subcommand = is_e71 ? kLength : kCommand;
  profile.too_many_words = is_fx5 ? kPoints2 : kPoints1;
  profile.too_many_bits = is_fx5 ? kPoints1 : kPoints2;
  profile.too_many_random_words = is_e71 ? kE71RandomPoints : kRandomWords;
  profile.out_of_range = is_fx5 ? kBeyondLastDevice : kNumberOutOfRange;
  return profile;
}

}  // namespace symplant::test::slmp
