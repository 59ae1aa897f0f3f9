// The words that ship with the tool: motions, classes and other words of PLC lists in several languages, folded.
#include <array>

#include "name/vocabulary.hpp"

namespace symplant::name {
namespace {

using namespace std::string_view_literals;

// Rest position first. The first spelling of a pair is the canonical one.
constexpr auto kPairs = std::to_array<BuiltInWords::Pair>({
    {"RET", "ADV"},
    {"DOWN", "UP"},
    {"UNCLAMP", "CLAMP", true},
    {"UNLOCK", "LOCK", true},
    {"CLOSE", "OPEN"},
    {"REV", "FWD"},
    {"LEFT", "RIGHT"},
    {"UNLOAD", "LOAD"},
    {"STOP", "RUN"},
});

constexpr auto kSynonyms = std::to_array<BuiltInWords::Synonym>({
    {"back", "RET"},    {"bwd", "RET"},    {"return", "RET"}, {"retract", "RET"},   {"adv", "ADV"},
    {"advance", "ADV"}, {"extend", "ADV"}, {"후진", "RET"},   {"전진", "ADV"},      {"하강", "DOWN"},
    {"상승", "UP"},     {"dn", "DOWN"},    {"clp", "CLAMP"},  {"unclp", "UNCLAMP"}, {"풀림", "UNLOCK"},
    {"잠김", "LOCK"},   {"열림", "OPEN"},  {"닫힘", "CLOSE"}, {"opn", "OPEN"},      {"cls", "CLOSE"},
});

constexpr auto kOperationAffixes = std::to_array<std::string_view>({"sol", "출력", "cmd"});
constexpr auto kEventAffixes = std::to_array<std::string_view>({"end", "완료", "단", "feedback"});

constexpr auto kClasses = std::to_array<BuiltInWords::ClassWord>({
    {"sol", Side::operation},
    {"prs", Side::event},
    {"ls", Side::event},
    {"epb", Side::event},
    {"pbli", Side::event},
    {"inti", Side::event},
    {"into", Side::operation},
    {"pblq", Side::operation},
    {"pblx", Side::event},
    {"phs", Side::event},
    {"ps", Side::event},
    {"eocr", Side::event},
    {"ssp", Side::event},
    {"stl", Side::operation},
    {"wrs", Side::event},
});

constexpr auto kPanel = std::to_array<std::string_view>({"pb", "pbl", "lamp", "sw"});
constexpr auto kAlarm = std::to_array<std::string_view>({"alarm", "fault"});
constexpr auto kData = std::to_array<std::string_view>({"data"});
constexpr auto kSpare = std::to_array<std::string_view>({"spare", "reserve", "예비"});
constexpr auto kHealthy = std::to_array<std::string_view>({"ready", "normal", "ok"});

}  // namespace

const BuiltInWords& built_in_words() {
  static constexpr BuiltInWords kWords{kPairs, kSynonyms, kOperationAffixes, kEventAffixes, kClasses, kPanel, kAlarm,
                                       kData,  kSpare,    kHealthy};
  return kWords;
}

}  // namespace symplant::name
