// The table of ready naming rules.
#include "naming/profiles.hpp"

#include <algorithm>
#include <array>

#include "description/faults.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::naming {

std::string_view profile_camel_case();
std::string_view profile_gx_works_body();
std::string_view profile_hungarian();
std::string_view profile_isa_5_1();
std::string_view profile_ls_body();
std::string_view profile_rockwell_body();
std::string_view profile_strict();
std::string_view profile_tia_prefix();

namespace {

constexpr std::array kProfiles{
    Profile{"camel-case", &profile_camel_case}, Profile{"gx-works-body", &profile_gx_works_body},
    Profile{"hungarian", &profile_hungarian},   Profile{"isa-5.1", &profile_isa_5_1},
    Profile{"ls-body", &profile_ls_body},       Profile{"rockwell-body", &profile_rockwell_body},
    Profile{"strict", &profile_strict},         Profile{"tia-prefix", &profile_tia_prefix},
};

std::string_view without_mark(std::string_view name) { return name.starts_with('@') ? name.substr(1) : name; }

}  // namespace

std::string_view Profile::summary() const {
  constexpr std::string_view kMark = "// ";
  const std::string_view line = text().substr(0, text().find('\n'));
  return line.starts_with(kMark) ? line.substr(kMark.size()) : std::string_view();
}

std::span<const Profile> profiles() { return kProfiles; }

const Profile* find_profile(std::string_view name) {
  const auto* found = std::find_if(kProfiles.begin(), kProfiles.end(),
                                   [&](const Profile& profile) { return profile.name == without_mark(name); });
  return found == kProfiles.end() ? nullptr : found;
}

std::string no_such_profile(std::string_view name) {
  tables::NearestName nearest(without_mark(name));
  for (const Profile& profile : kProfiles) nearest.offer(profile.name);
  return "unknown naming profile " + description::ticked(name) + "; " +
         (nearest.name().empty() ? "`symplant naming` lists all"
                                 : "did you mean " + description::ticked(nearest.name()) + "?");
}

}  // namespace symplant::naming
