// The state of a panel: the session as files.
#include "symplant/panel/operate/desk.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/whole_file.hpp"

namespace symplant::panel {
namespace {

/// Returns why a file cannot be written, or an empty text.
std::string write_file(const std::string& path, std::string_view text) {
  const std::string failure = trace::write_whole_file(path, text);
  return failure.empty() ? "" : fmt::format("cannot write `{}`: {}", path, failure);
}

}  // namespace

std::string Desk::session_json() const {
  std::string json = "{\"symplant-session\":1";
  put_member(json, "plant", setup_.names.tables().name);
  put(json, R"(,"model_hash":"{:016x}","seed":{},"t":{})", setup_.plant.model_hash(), setup_.seed, operator_.now());
  put_key(json, "acts");
  session_.put(json, 0, Role::trainer);
  put_key(json, "findings");
  put_findings(json, 0, Role::trainer);
  put_key(json, "exercise");
  if (exercise_ != nullptr) {
    exercise_->put(json, Role::trainer);
  } else {
    json += "null";
  }
  put_key(json, "training");
  training_.put(json, MalfunctionRuns::kMostRuns);
  return json + "}\n";
}

std::string Desk::session_junit() const {
  std::vector<trace::TestCase> cases;
  if (exercise_ != nullptr) exercise_->add_cases(cases);
  for (const Found& found : findings_) {
    if (!found.step.empty()) cases.push_back({"scenario: " + found.step, found.time, found.text});
  }
  for (std::uint32_t r = 0; r < violations_.size(); ++r) {
    const Violation& violation = violations_[r];
    cases.push_back({fmt::format("requirement: {}", setup_.names.requirement(r)), violation.since,
                     violation.count == 0 ? "" : fmt::format("violated, {} in all", violation.count)});
  }
  return trace::junit_xml(setup_.names.tables().name, cases, operator_.now());
}

Answer Desk::session_file(std::string_view kind) {
  if (kind == "start") {
    if (session_.from() == nullptr) return error_answer(404, "the session does not begin with a snapshot");
    return {200, trace::snapshot_bytes(setup_.names.tables().name, session_.from()->snapshot)};
  }
  if (kind == "session") return {200, session_json()};
  if (kind == "junit") return {200, session_junit()};
  if (setup_.with_plc) {
    return error_answer(422, "with a PLC the session cannot be played again: only the acts at the panel are known");
  }
  if (!session_.is_complete()) {
    return error_answer(422, "the session has more than 100000 acts on the plant, or more than 32 MiB of them");
  }
  return {200, session_.scenario("session.start.snapshot", operator_.now())};
}

void Desk::layout_saved(const Sender& sender) {
  log(operator_.now(), 0, name_of_hand(sender.role), "\"layout\":\"saved\"", false, sender.name);
}

/// Writes the files of a session: next to a PLC without the scenario. Returns why not, or an empty text.
std::string Desk::save_session(const std::string& name) {
  std::string error = write_file(snapshots_.path(name, ".session.json"), session_json());
  if (error.empty()) error = write_file(snapshots_.path(name, ".junit.xml"), session_junit());
  if (!error.empty() || setup_.with_plc || !session_.is_complete()) return error;
  const std::string start = name + ".start";
  if (session_.from() != nullptr) {
    error = trace::write_snapshot(snapshots_.path(start, ".snapshot"), setup_.names.tables().name,
                                  session_.from()->snapshot);
  }
  if (!error.empty()) return error;
  return write_file(snapshots_.path(name, ".scenario.json"), session_.scenario(start + ".snapshot", operator_.now()));
}

}  // namespace symplant::panel
