// Examines a link against a live PLC.
#include "symplant/link/doctor/doctor.hpp"

#include <utility>

#include "symplant/link/kinds.hpp"

namespace symplant::link::doctor {

Examined examine(const LinkChoice& link, const tables::PlantTables& tables, const Options& options) {
  if (std::string fault = url_fault(link.url); !fault.empty()) {
    return LinkError{LinkError::Kind::usage, std::move(fault)};
  }
  const Kind* const kind = kind_of(link.url);
  if (kind->examine == nullptr) {
    return LinkError{LinkError::Kind::usage,
                     "`" + link.url + "` has no PLC to examine: give the URL of a link to a PLC"};
  }
  return kind->examine(rest_of(link.url), link, tables, options);
}

}  // namespace symplant::link::doctor
