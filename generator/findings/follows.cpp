// The table of causes and consequences.
#include "findings/follows.hpp"

#include <algorithm>
#include <charconv>

namespace symplant::findings {
namespace {

using Of = RuleRole::Of;

/// Rules by the numbers of their ids, in the order of their rank as roots.
namespace sp {
constexpr int kAddressesContradict = 315;
constexpr int kNameSlip = 205;
constexpr int kSymbolDeclaredDifferently = 302;
constexpr int kTypeAgainstAddress = 306;
constexpr int kTypeOfNoIo = 313;
constexpr int kUnitTooLarge = 406;
constexpr int kDirectionAgainstAddress = 305;
constexpr int kTaskClaimedTwice = 407;
constexpr int kInitialNotUnderstood = 310;
constexpr int kTwoWordsOneState = 405;
constexpr int kSequenceRepeated = 412;
constexpr int kSequenceGap = 411;
constexpr int kOneTaskAlone = 413;
constexpr int kShapeLacksSymbol = 414;
constexpr int kUnitWithoutEvents = 403;
constexpr int kEventNotDriven = 404;
// Those that only follow.
constexpr int kAddressUsedTwice = 303;
constexpr int kEventDrivenTwice = 304;
constexpr int kOperationWithoutEvent = 401;
constexpr int kEventWithoutOperation = 402;
constexpr int kSequenceAmbiguous = 409;
constexpr int kInitialByRowOrder = 410;
constexpr int kOperationInitialIgnored = 311;
constexpr int kInferredRestState = 501;
constexpr int kInferredSingleSolenoid = 502;
constexpr int kInferredSequence = 503;
}  // namespace sp

constexpr std::uint8_t kLast = 10;

int number_of(const diag::RuleInfo& rule) {
  int number = 0;
  std::from_chars(rule.id.data() + 2, rule.id.data() + rule.id.size(), number);  // SP201
  return number;
}

bool same(std::string_view a, std::string_view b) { return text::equal_ignoring_case(a, b); }

/// Whether the symbol is one of those that the finding says the device lacks.
bool is_reported_lacking(const diag::Diagnostic& finding, std::string_view path, const Lost& lost) {
  if (!lost.direction || lost.task.empty()) return true;
  const std::string name =
      std::string(path) + (*lost.direction == name::Direction::operation ? "_O_" : "_I_") + lost.task;
  return std::any_of(finding.about.begin() + 1, finding.about.end(),
                     [&](const std::string& reported) { return same(reported, name); });
}

/// The task of a symbol's name, its last level.
std::string_view task_of(std::string_view name) { return name.substr(name.rfind('_') + 1); }

bool may_be(const Lost& lost, name::Direction direction) { return !lost.direction || *lost.direction == direction; }

bool may_be(const Lost& lost, name::Direction direction, std::string_view task) {
  return may_be(lost, direction) && (lost.task.empty() || same(lost.task, task));
}

}  // namespace

bool RuleRole::reports_rest_state() const { return rule == sp::kInferredRestState; }

bool RuleRole::lacks_side() const { return rule == sp::kOperationWithoutEvent || rule == sp::kEventWithoutOperation; }

RuleRole role_of(const diag::RuleInfo& rule) {
  const int number = number_of(rule);
  switch (number) {
    case sp::kAddressesContradict:
      return {number, Of::symbol, 0, true, false, false};
    case 201:
    case 202:
    case 203:
    case 204:  // the rules of faulty names
      return {number, Of::name, 1, true, false, false};
    case sp::kNameSlip:
      return {number, Of::slip, 1, true, false, false};
    case sp::kSymbolDeclaredDifferently:
      return {number, Of::row, 2, true, false, false};
    case sp::kTypeAgainstAddress:
    case sp::kTypeOfNoIo:
      return {number, Of::lost_row, 2, true, false, false};
    case sp::kUnitTooLarge:
      return {number, Of::device, 2, true, false, false};
    case sp::kDirectionAgainstAddress:
    case sp::kTaskClaimedTwice:
      return {number, Of::row, 3, true, false, true};
    case sp::kInitialNotUnderstood:
      return {number, Of::row, 4, true, false, false};
    case sp::kTwoWordsOneState:
      return {number, Of::device, 5, true, true, false};
    case sp::kSequenceRepeated:
      return {number, Of::device, 6, true, true, false};
    case sp::kSequenceGap:
      return {number, Of::device, 7, true, true, false};
    case sp::kOneTaskAlone:
      return {number, Of::device_and_lacks, 8, true, true, false};
    case sp::kShapeLacksSymbol:
      return {number, Of::device_and_lacks, 9, true, true, false};
    case sp::kUnitWithoutEvents:
    case sp::kEventNotDriven:
      return {number, Of::one_sided, kLast, true, true, false};
    case sp::kAddressUsedTwice:
    case sp::kEventDrivenTwice:
    case sp::kOperationInitialIgnored:
      return {number, Of::device, kLast, false, false, true};
    case sp::kOperationWithoutEvent:
    case sp::kEventWithoutOperation:
    case sp::kSequenceAmbiguous:
    case sp::kInitialByRowOrder:
    case sp::kInferredRestState:
    case sp::kInferredSingleSolenoid:
    case sp::kInferredSequence:
      return {number, Of::device, kLast, false, true, false};
    default:
      return {number};
  }
}

Lost Lost::of_words(std::string_view direction, std::string_view task) {
  Lost lost;
  if (same(direction, "O")) lost.direction = name::Direction::operation;
  if (same(direction, "I")) lost.direction = name::Direction::event;
  if (task != "*") lost.task = task;
  return lost;
}

bool Facts::follows(const diag::Diagnostic& finding, std::string_view path, const Root& root) {
  const int effect = role_of(*finding.rule).rule;
  if (root.role.rule == sp::kInitialNotUnderstood) {
    return effect == sp::kInitialByRowOrder ||
           (effect == sp::kEventNotDriven && same(finding.about.front(), root.symbol));
  }
  if (root.role.rule == sp::kSequenceGap &&
      (effect == sp::kOperationWithoutEvent || effect == sp::kEventWithoutOperation)) {
    return false;
  }
  if (!root.lost) return true;
  const Lost& lost = *root.lost;
  switch (effect) {
    case sp::kOperationWithoutEvent:
      return may_be(lost, name::Direction::event, task_of(finding.about.front()));
    case sp::kEventWithoutOperation:
      return may_be(lost, name::Direction::operation, task_of(finding.about.front()));
    case sp::kUnitWithoutEvents:
      return may_be(lost, name::Direction::event);
    case sp::kEventNotDriven:
      return may_be(lost, name::Direction::operation);
    case sp::kOneTaskAlone:
    case sp::kShapeLacksSymbol:
      return is_reported_lacking(finding, path, lost);
    case sp::kInferredRestState: {
      const model::Unit* unit = unit_of(path);  // with the lost event it would have been one task all the same
      return unit == nullptr || !same(unit->states.back().name, lost.task) || may_be(lost, name::Direction::operation);
    }
    default:
      return true;
  }
}

const model::Unit* Facts::unit_of(std::string_view path) {
  if (units_.empty()) {
    units_.reserve(plant_.units.size());
    for (const model::Unit& unit : plant_.units) units_.emplace(unit.path, &unit);
  }
  const auto found = units_.find(path);
  return found == units_.end() ? nullptr : found->second;
}

}  // namespace symplant::findings
