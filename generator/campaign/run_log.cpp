// What a run did, as far as a campaign compares it.
#include "campaign/run_log.hpp"

namespace symplant::campaign {

void RunLog::take(const trace::Record& record) {
  using Kind = trace::Record::Kind;
  switch (record.kind) {
    case Kind::change:
      return symbols.push_back({record.time, record.value, record.of});
    case Kind::value:
      return outputs.push_back({record.time, record.value, record.of});
    case Kind::unit:
      return units.push_back({record.time, record.value & ((std::uint64_t{1} << trace::kUnitBits) - 1), record.of});
    case Kind::malfunction:
      return malfunctions.push_back({record.time, record.more ? 1U : 0U, record.of});
    case Kind::finding:
      if (record.finding == tables::FindingKind::requirement_violated && !violation) {
        violation = Violation{record.time, record.of};
      }
      return;
    default:
      return;
  }
}

recording::Recording recorded(const RunLog& log, const trace::PlantNames& names, const std::vector<bool>& chosen,
                              const char* name) {
  return recording::of_run(log.symbols, log.end, names, chosen, name);
}

}  // namespace symplant::campaign
