// All rules over the plant model. The files in rules/ have those of one subject each.
#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "check/rule.hpp"

namespace symplant::check {

extern const Rule kWrongNumberOfLevels;        // SP201
extern const Rule kEmptyLevel;                 // SP202
extern const Rule kDirectionNotIo;             // SP203
extern const Rule kIllegalCharacter;           // SP204
extern const Rule kNameSlip;                   // SP205
extern const Rule kPathAmbiguous;              // SP206
extern const Rule kRoleTaken;                  // SP207
extern const Rule kNamedOtherwise;             // SP208
extern const Rule kDirectionConflict;          // SP209
extern const Rule kLettersAlike;               // SP210
extern const Rule kTwoSpellings;               // SP211
extern const Rule kTextCut;                    // SP212
extern const Rule kNameTooLong;                // SP213
extern const Rule kReservedWord;               // SP214
extern const Rule kDuplicateSymbol;            // SP301
extern const Rule kSymbolDeclaredDifferently;  // SP302
extern const Rule kAddressUsedTwice;           // SP303
extern const Rule kEventDrivenTwice;           // SP304
extern const Rule kDirectionAgainstAddress;    // SP305
extern const Rule kTypeAgainstAddress;         // SP306
extern const Rule kAddressNotUnderstood;       // SP307
extern const Rule kRadixAssumed;               // SP308
extern const Rule kNoAddress;                  // SP309
extern const Rule kInitialNotUnderstood;       // SP310
extern const Rule kOperationInitialIgnored;    // SP311
extern const Rule kByteOnNoRegister;           // SP312
extern const Rule kTypeOfNoIo;                 // SP313
extern const Rule kRadixDisagrees;             // SP314
extern const Rule kAddressesContradict;        // SP315
extern const Rule kSymbolsOverlap;             // SP316
extern const Rule kAddressWithoutNumber;       // SP317
extern const Rule kNoIo;                       // SP318
extern const Rule kAddressesOverlap;           // SP319
extern const Rule kWordAndBits;                // SP320
extern const Rule kSeriesBroken;               // SP321
extern const Rule kCommentTwice;               // SP322
extern const Rule kIoNameInMemory;             // SP323
extern const Rule kSeveralLists;               // SP330
extern const Rule kOperationWithoutEvent;      // SP401
extern const Rule kEventWithoutOperation;      // SP402
extern const Rule kUnitWithoutEvents;          // SP403
extern const Rule kEventNotDriven;             // SP404
extern const Rule kTwoWordsOneState;           // SP405
extern const Rule kUnitTooLarge;               // SP406
extern const Rule kTaskClaimedTwice;           // SP407
extern const Rule kInitialAmbiguous;           // SP408
extern const Rule kSequenceAmbiguous;          // SP409
extern const Rule kInitialByRowOrder;          // SP410
extern const Rule kSequenceGap;                // SP411
extern const Rule kSequenceRepeated;           // SP412
extern const Rule kOneTaskAlone;               // SP413
extern const Rule kShapeLacksSymbol;           // SP414
extern const Rule kNoDevice;                   // SP415
extern const Rule kTasksLookParallel;          // SP416
extern const Rule kEndWithoutSensor;           // SP417
extern const Rule kInferredRestState;          // SP501
extern const Rule kInferredSingleSolenoid;     // SP502
extern const Rule kInferredSequence;           // SP503
extern const Rule kUnreachableState;           // SP610
extern const Rule kStateNeverLeft;             // SP611
extern const Rule kZeroTimeLoop;               // SP612
extern const Rule kCycleOfDisables;            // SP613
extern const Rule kConditionNeverHolds;        // SP614
extern const Rule kConditionAlwaysHolds;       // SP615
extern const Rule kRequirementDecided;         // SP616
extern const Rule kConditionNotExamined;       // SP617

// Of the section `check` of plant.json, and of --baseline: not found by check_plant().
extern const Rule kIgnoreWithoutFinding;  // SP620
extern const Rule kIgnoreIsOver;          // SP621
extern const Rule kUnknownRule;           // SP622
extern const Rule kBindingRule;           // SP623
extern const Rule kDateNotUnderstood;     // SP624
extern const Rule kRuleRenamed;           // SP625
extern const Rule kBaselineStale;         // SP626
extern const Rule kBaselineNotValid;      // SP627

// Of `material` in plant.json.
extern const Rule kPartSensorNotDescribed;  // SP630
extern const Rule kTrackNeverMoves;         // SP631
extern const Rule kTransferWithoutParts;    // SP632
extern const Rule kPartsNeverLeave;         // SP633

/// In the order of their ids.
inline constexpr std::array kRules{
    &kWrongNumberOfLevels,
    &kEmptyLevel,
    &kDirectionNotIo,
    &kIllegalCharacter,
    &kNameSlip,
    &kPathAmbiguous,
    &kRoleTaken,
    &kNamedOtherwise,
    &kDirectionConflict,
    &kLettersAlike,
    &kTwoSpellings,
    &kTextCut,
    &kNameTooLong,
    &kReservedWord,
    &kDuplicateSymbol,
    &kSymbolDeclaredDifferently,
    &kAddressUsedTwice,
    &kEventDrivenTwice,
    &kDirectionAgainstAddress,
    &kTypeAgainstAddress,
    &kAddressNotUnderstood,
    &kRadixAssumed,
    &kNoAddress,
    &kInitialNotUnderstood,
    &kOperationInitialIgnored,
    &kByteOnNoRegister,
    &kTypeOfNoIo,
    &kRadixDisagrees,
    &kAddressesContradict,
    &kSymbolsOverlap,
    &kAddressWithoutNumber,
    &kNoIo,
    &kAddressesOverlap,
    &kWordAndBits,
    &kSeriesBroken,
    &kCommentTwice,
    &kIoNameInMemory,
    &kSeveralLists,
    &kOperationWithoutEvent,
    &kEventWithoutOperation,
    &kUnitWithoutEvents,
    &kEventNotDriven,
    &kTwoWordsOneState,
    &kUnitTooLarge,
    &kTaskClaimedTwice,
    &kInitialAmbiguous,
    &kSequenceAmbiguous,
    &kInitialByRowOrder,
    &kSequenceGap,
    &kSequenceRepeated,
    &kOneTaskAlone,
    &kShapeLacksSymbol,
    &kNoDevice,
    &kTasksLookParallel,
    &kEndWithoutSensor,
    &kInferredRestState,
    &kInferredSingleSolenoid,
    &kInferredSequence,
    &kUnreachableState,
    &kStateNeverLeft,
    &kZeroTimeLoop,
    &kCycleOfDisables,
    &kConditionNeverHolds,
    &kConditionAlwaysHolds,
    &kRequirementDecided,
    &kConditionNotExamined,
    &kIgnoreWithoutFinding,
    &kIgnoreIsOver,
    &kUnknownRule,
    &kBindingRule,
    &kDateNotUnderstood,
    &kRuleRenamed,
    &kBaselineStale,
    &kBaselineNotValid,
    &kPartSensorNotDescribed,
    &kTrackNeverMoves,
    &kTransferWithoutParts,
    &kPartsNeverLeave,
};

/// For the rules about names: narrows the location of a symbol's name to the faulty part, if the name is in the file as
/// it is.
void narrow(diag::Location& location, const model::Symbol& symbol);
std::string_view faulty_part(const model::Symbol& symbol);
/// Whether a name has this fault, and needs a separate finding.
bool breaks_rule(const Subject& subject, const model::Symbol& symbol, name::NameFault fault);
/// For each list of the plant: whether its names follow another rule than the plant's. O(symbols).
std::vector<bool> lists_named_otherwise(const model::PlantModel& plant);
/// A symbol whose name breaks the naming rule, and what it explains: the missing symbol that it may be, and the model
/// of its device if the fault is behind the device's levels.
diag::Subjects about_name(const model::PlantModel& plant, const model::Symbol& symbol);
/// Whether the naming rule makes contradictions of names and addresses errors.
bool conflicts_are_errors(const model::PlantModel& plant);
/// Adds a finding for each symbol whose name says another direction than its address.
void report_direction_conflicts(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics);

/// What a symbol loses that is in no device: "no device drives it", "it drives no device".
std::string_view consequence(const model::Symbol& symbol);

/// Whether a state of the unit switches an event by `outputs`. `event` is an index in Unit::events.
bool switched_by_outputs(const model::Unit& unit, std::uint32_t event);

/// Two symbols of one device with one task and direction: since names are unique, the address of one overruled its
/// name.
struct TaskClaim {
  std::uint32_t overruled;
  std::uint32_t other;
  bool other_dropped;  ///< it is the other one that is in no device, its row being the later one
};
std::vector<TaskClaim> task_claims(const model::PlantModel& plant);

/// The names that addresses overrule: whether such a name gives this task and direction of a unit. SP305 or SP407
/// reports it, so no other rule needs to report the symbol as missing. Construction: O(symbols).
class OverruledNames {
 public:
  explicit OverruledNames(const model::PlantModel& plant);
  bool has(const model::Unit& unit, const model::State& state, name::Direction direction) const;

 private:
  std::set<std::string> names_;
};

/// Whether the only two tasks of a unit look like forms of one word, such as START and STARTED: SP405 reports them.
bool is_one_word_twice(const Subject& subject, const model::Unit& unit);

/// Whether operations of this task have no feedback by nature, such as RESET: SP401 does not expect an event.
bool needs_no_feedback(std::string_view task);

/// Which rule about the list reports that nothing leads to a state.
enum class Unled : std::uint8_t {
  no,            ///< none: something leads there, or it is not for want of a symbol
  two_words,     ///< SP405, or SP401 of the only other task
  overruled,     ///< SP305 or SP407
  ambiguous,     ///< SP409
  no_operation,  ///< SP402
};
Unled unled(const Subject& subject, const model::Unit& unit, std::uint32_t state);

}  // namespace symplant::check
