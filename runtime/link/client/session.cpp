// The exchange of a client link with its PLC.
#include "symplant/link/client/session.hpp"

#include <algorithm>
#include <utility>

#include "symplant/link/client/event_lanes.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::client {

namespace {

constexpr std::size_t kRefusedInAPass = 4;  ///< events that the PLC refused and that are written again

}  // namespace

Session::Session(Dialog& dialog, const tables::PlantTables& tables, const image::Map& map, const ClientTimes& times,
                 image::Images& images, bool arm)
    : dialog_(dialog),
      images_(images),
      tables_(tables),
      points_(map.points),
      times_(times),
      arm_(arm),
      outbox_(tables, map),
      retries_(event_lanes(tables, map)),
      bits_(image::bit_words(map.size(Plane::event_bits))),
      numbers_(map.size(Plane::event_numbers)) {
  zeros_.resize(std::max(bits_.size(), numbers_.size()));
}

bool Session::may_write(const Identity& identity) {
  switch (identity.kind) {
    case Identity::Kind::verified:
      messages_.add("connected: " + identity.message);
      return true;
    case Identity::Kind::wrong:
      messages_.add("writes nothing: " + identity.message);
      return false;
    case Identity::Kind::unverifiable:
      break;
  }
  messages_.add(arm_ ? "connected, armed: " + identity.message
                     : "not armed, writes nothing: " + identity.message +
                           "; check the address and the map, then give `--arm`");
  return arm_;
}

Fault Session::begin(tables::Time now) {
  passed_ = false;
  Fault fault;
  const Identity identity = dialog_.identify(fault);
  if (fault) return fault;
  armed_.store(may_write(identity), std::memory_order_relaxed);
  dialog_.retry_rejected();
  outbox_.restart();
  retries_.clear();
  suspects_.clear();
  wrote_ = false;
  next_refresh_ = now + times_.refresh;
  next_look_back_ = now + times_.read_back;
  return {};
}

/// A pass that looks back writes nothing, and the next one writes: what the PLC holds is compared with what it had a
/// pass before, and a late copy of the answer can be recognized before the next request is sent. It comes before the
/// refresh, which would make all events unknown.
Fault Session::pass(tables::Time now, std::uint32_t losses, bool leaving) {
  Fault fault = read(now, losses);
  if (!fault && is_armed()) {
    const bool looks_back = !leaving && wrote_ && times_.read_back != 0 && now >= next_look_back_;
    wrote_ = !looks_back;
    if (looks_back) {
      fault = look_back(now);
    } else {
      if (now >= next_refresh_) {
        next_refresh_ = now + times_.refresh;
        outbox_.forget();
      }
      fault = write(events(leaving), now);
      if (!fault && leaving) left_.store(true, std::memory_order_relaxed);
    }
  }
  report_refused();
  offer();
  return fault.kind == Fault::Kind::rejected ? Fault() : fault;
}

/// `rejected` if the reading is not complete.
Fault Session::read(tables::Time now, std::uint32_t losses) {
  if (images_.release(losses)) images_.publish(signs() == 0);
  const image::Planes planes = images_.planes();
  Fault fault = dialog_.read({planes.operation_bits, planes.operation_numbers}, now);
  if (fault) return fault;
  passed_ = true;
  images_.touch_all();
  images_.publish(true);
  signs_.fetch_add(1, std::memory_order_release);  // after the image, so that a cycle that sees it has the image
  return {};
}

/// What is to be written: the plant's events, or zeros at its end.
Events Session::events(bool leaving) {
  if (leaving && times_.zero_at_end) {
    return {std::span(zeros_).first(bits_.size()), std::span(zeros_).first(numbers_.size())};
  }
  images_.take_events();
  const image::Planes planes = images_.planes();
  return {planes.event_bits, planes.event_numbers};
}

Fault Session::write(const Events& events, tables::Time now) {
  unwritten_.clear();
  const auto changes = outbox_.changes(events);
  if (!changes.empty()) {
    if (Fault fault = dialog_.write(changes, unwritten_)) return fault;
    outbox_.confirm(changes);
  }
  std::vector<Unwritten> refused;
  for (const Unwritten& one : unwritten_) {
    outbox_.forget({&one.change, 1});
    if (one.answer == Answer::refused) refused.push_back(one);
  }
  if (!refused.empty()) outbox_.hold(retries_.add(refused, now));
  return write_refused(events, now);
}

/// Each event that the PLC refused alone, a few of them in a pass.
Fault Session::write_refused(const Events& events, tables::Time now) {
  for (const std::size_t event : retries_.due(now, kRefusedInAPass)) {
    const std::vector<LaneChange> changes = retries_.changes(event, events);
    unwritten_.clear();
    if (Fault fault = dialog_.write(changes, unwritten_)) return fault;
    if (unwritten_.empty()) {
      retries_.accept(event);
      outbox_.release(changes);
      outbox_.confirm(changes);
    } else if (retries_.refuse(event, now, unwritten_.front().answer) && retries_.symbol(event) != tables::kNone) {
      report({tables::FindingKind::symbol_left_out, retries_.symbol(event), pack(unwritten_.front().refusal)});
    }
  }
  return {};
}

/// Reads the events back. Those that differ are written again, those that differ twice in a row are reported.
Fault Session::look_back(tables::Time now) {
  next_look_back_ = now + times_.read_back;
  if (Fault fault = dialog_.read_back({bits_, numbers_}, now)) return fault;
  std::vector<LaneChange> differences = outbox_.differences({bits_, numbers_});
  for (const LaneChange& change : differences) {
    for (const LaneChange& before : suspects_) {
      if (!meet(change, before)) continue;
      const auto both = static_cast<std::uint16_t>(change.mask & before.mask);
      report_lanes(tables::FindingKind::event_overwritten, {change.lane, both, 0}, 0);
    }
  }
  suspects_ = std::move(differences);
  outbox_.forget(suspects_);
  return {};
}

/// Messages and findings of what the PLC has refused in this pass.
void Session::report_refused() {
  for (Rejection& rejection : dialog_.take_rejections()) {
    messages_.add(std::move(rejection.message));
    if (rejection.answer == Answer::busy) continue;
    report({tables::FindingKind::request_refused, tables::kNone, pack(rejection.refusal)});
  }
  for (const LeftOut& left_out : dialog_.take_left_out()) {
    report_lanes(tables::FindingKind::symbol_left_out, left_out.lanes, pack(left_out.refusal));
  }
}

/// A finding of each symbol in the lanes.
void Session::report_lanes(tables::FindingKind kind, const LaneChange& lanes, std::uint64_t value) {
  for (const image::Point& point : points_) {
    const std::vector<LaneChange> own = lanes_of(tables_, point);
    const bool met = std::any_of(own.begin(), own.end(), [&](const LaneChange& lane) { return meet(lane, lanes); });
    if (met) report({kind, point.symbol, value});
  }
}

/// Each symbol, and each refusal, only once.
void Session::report(const LinkFinding& finding) {
  const std::uint64_t key = finding.symbol == tables::kNone ? finding.value : finding.symbol;
  if (reported_.emplace(finding.kind, key).second) to_report_.push_back(finding);
}

std::optional<LinkFinding> Session::take_finding() noexcept {
  const LinkFinding* const oldest = findings_.front();
  if (oldest == nullptr) return std::nullopt;
  const LinkFinding finding = *oldest;
  findings_.pop();
  return finding;
}

void Session::offer() noexcept {
  const auto left = std::find_if_not(to_report_.begin(), to_report_.end(),
                                     [&](const LinkFinding& finding) { return findings_.put(finding); });
  to_report_.erase(to_report_.begin(), left);
}

}  // namespace symplant::link::client
