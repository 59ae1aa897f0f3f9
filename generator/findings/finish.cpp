// Fold, apply settings, select, roll up.
#include "findings/finish.hpp"

#include <utility>

#include "findings/folding.hpp"
#include "findings/roll_up.hpp"
#include "findings/settings.hpp"

namespace symplant::findings {

diag::Diagnostics finish(diag::Diagnostics findings, const description::GivenCheck& settings, std::string_view today,
                         const Selection& selection, const Known& known) {
  fold(findings);
  const bool has_settings = !settings.severity.empty() || !settings.ignore.empty();
  if (has_settings) findings = apply_settings(findings, settings, today);
  if (!selection.takes_all()) findings = select(findings, selection);
  if (has_settings || !selection.takes_all()) fold(findings);  // what lost its cause may have another one
  findings.show_consequences();
  if (known.baseline != nullptr) findings = known.baseline->apply(known.plant, findings);
  return roll_up(std::move(findings));
}

}  // namespace symplant::findings
