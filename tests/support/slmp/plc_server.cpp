// Serves requests between scans, and scans.
#include "support/slmp/plc_server.hpp"

#include <cstdio>

namespace symplant::test::slmp {
namespace {

constexpr std::uint32_t kRunStateRegister = 203;

struct Model {
  std::string_view name;
  std::uint16_t code;
};
// By family. The code of the FX5U is not in the reference.
constexpr std::array kModels = {Model{"Q06UDVCPU", 0x0368}, Model{"L16HCPU", 0x48C2}, Model{"R08CPU", 0x4801},
                                Model{"FX5U-32MR/ES", 0x4A21}};

Cpu cpu_of(const PlcOptions& options) {
  const Model& model = kModels[static_cast<std::size_t>(options.profile.family)];
  Cpu cpu;
  cpu.profile = options.profile;
  cpu.code = options.code;
  cpu.has_octal_input_output = options.has_octal_ascii_on_fx5 && options.profile.family == Family::fx5;
  cpu.route = options.route;
  cpu.model = options.model.empty() ? std::string(model.name) : options.model;
  cpu.model_code = options.model_code == 0 ? model.code : options.model_code;
  return cpu;
}

std::string command_text(const LoggedRequest& request) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04X/%04X of %u points: %04X", unsigned{request.command},
                unsigned{request.subcommand}, unsigned{request.points}, unsigned{request.end_code});
  return text.data();
}

/// Whether a client that knows the family would not get this end code.
bool is_violation(const LoggedRequest& request) {
  const bool asks_for_ability = request.command == kReadModel || request.command == kLoopback;
  return request.end_code != kOk && request.end_code != kNotInRun &&
         !(request.end_code == kCommand && asks_for_ability);
}

}  // namespace

SlmpPlc::Server::Server(PlcOptions options, DeliveryHook hook)
    : memory(options.profile.family),
      writes_in_run(options.writes_in_run),
      options_(std::move(options)),
      hook_(std::move(hook)),
      cpu_(cpu_of(options_)) {
  write_run_state();
  sockets = std::make_unique<PlcSockets>(
      SocketOptions{options_.tcp, options_.udp, options_.port, options_.most_connections}, *this);
  const bool scans_itself = options_.program || !options_.refreshed.empty();
  if (scans_itself && options_.scan_interval.count() > 0) scan_thread_ = std::thread([this] { scan_loop(); });
}

SlmpPlc::Server::~Server() {
  sockets.reset();
  {
    const std::lock_guard lock(change_mutex_);
    stops_ = true;
  }
  change_.notify_all();
  if (scan_thread_.joinable()) scan_thread_.join();
}

std::size_t SlmpPlc::Server::received(const Peer& peer, std::span<const std::uint8_t> bytes,
                                      std::vector<Delivery>& out) {
  note_requests(peer, bytes);
  std::size_t used = 0;
  while (used < bytes.size()) {
    const FoundRequest found = find_request(bytes.subspan(used), options_.code);
    if (found.found == Found::foreign) {
      log.add_violation("a request with a foreign subheader, code or length");
      if (!peer.is_udp) ++unanswered_[peer.id];
      used = bytes.size();
      break;
    }
    if (peer.is_udp && found.size != bytes.size()) {
      log.add_violation("a datagram that is not one whole request");
      used = bytes.size();
      break;
    }
    if (found.found == Found::part) break;
    used += found.size;
    answer(peer, found.frame, out);
  }
  changed();
  return used;
}

/// Counts the requests without a reply before any of them is served.
void SlmpPlc::Server::note_requests(const Peer& peer, std::span<const std::uint8_t> bytes) {
  std::size_t outstanding = peer.is_udp ? 0 : unanswered_[peer.id] + (peer.awaits_reply ? 1 : 0);
  bool has_3e = false;
  bool has_new = false;
  while (!bytes.empty()) {
    const FoundRequest found = find_request(bytes, options_.code);
    if (found.found != Found::request) break;
    ++outstanding;
    has_new = true;
    has_3e |= !found.frame.is_4e;
    bytes = bytes.subspan(found.size);
  }
  log.note_outstanding(outstanding);
  if (has_new && has_3e && outstanding > 1) log.add_violation("a 3E request before the reply to the one before it");
}

void SlmpPlc::Server::answer(const Peer& peer, const RequestFrame& request, std::vector<Delivery>& out) {
  if (request.is_4e && !cpu_.profile.has_4e) log.add_violation("a 4E request to a PLC that has only 3E");
  if (is_silent || (request.is_4e && !cpu_.profile.has_4e)) return log_without_reply(peer, request);
  Outcome outcome;
  {
    const std::lock_guard lock(scan_mutex_);
    cpu_.accepts_writes = writes_in_run || !is_running_;
    outcome = execute(request, cpu_, memory);
  }
  outcome.log.is_udp = peer.is_udp;
  note_violations(outcome);
  log.add(outcome.log);
  Exchange exchange{peer, request, options_.code, outcome.end_code,
                    encode_reply(request, options_.code, outcome.end_code, outcome.data)};
  Delivery delivery;
  if (hook_) {
    delivery = hook_(exchange);
  } else {
    delivery.parts.push_back({std::move(exchange.reply), {}});
  }
  if (!peer.is_udp && delivery.parts.empty()) ++unanswered_[peer.id];
  out.push_back(std::move(delivery));
}

void SlmpPlc::Server::note_violations(const Outcome& outcome) {
  if (is_violation(outcome.log)) log.add_violation(command_text(outcome.log));
  if (outcome.has_duplicate) log.add_violation("a request that writes a point twice");
}

void SlmpPlc::Server::log_without_reply(const Peer& peer, const RequestFrame& request) {
  LoggedRequest entry;
  entry.is_udp = peer.is_udp;
  entry.is_4e = request.is_4e;
  entry.has_reply = false;
  entry.command = request.command;
  entry.subcommand = request.subcommand;
  log.add(std::move(entry));
  if (!peer.is_udp) ++unanswered_[peer.id];
}

void SlmpPlc::Server::accepted(const Peer& peer) {
  unanswered_[peer.id] = 0;
  changed();
}

void SlmpPlc::Server::refused_connection() {
  ++refused_connections;
  log.add_violation("a connection above the most that the PLC serves");
  changed();
}

void SlmpPlc::Server::closed(const Peer& peer) {
  unanswered_.erase(peer.id);
  changed();
}

void SlmpPlc::Server::scan_once() {
  {
    const std::lock_guard lock(scan_mutex_);
    if (!is_running_) return;
    for (const DeviceRange& range : options_.refreshed) {
      for (std::uint32_t i = 0; i < range.count; ++i) {
        memory.set_bit(range.device, range.first + i, terminals_.contains(range.first + i));
      }
    }
    if (options_.program) options_.program(memory);
    ++scans;
  }
  changed();
}

void SlmpPlc::Server::scan_loop() {
  std::unique_lock lock(change_mutex_);
  while (!change_.wait_for(lock, options_.scan_interval, [&] { return stops_; })) {
    lock.unlock();
    scan_once();
    lock.lock();
  }
}

void SlmpPlc::Server::set_running(bool on) {
  const std::lock_guard lock(scan_mutex_);
  if (is_running_ != on && options_.clears_x_at_run_change) {
    for (std::uint32_t x = 0; x < memory.points("X"); ++x) memory.set_bit("X", x, false);
  }
  is_running_ = on;
  write_run_state();
}

void SlmpPlc::Server::write_run_state() {
  if (memory.points("SD") > kRunStateRegister) memory.set_word("SD", kRunStateRegister, is_running_ ? 0 : 2);
}

void SlmpPlc::Server::set_terminal(std::uint32_t x_number, bool on) {
  const std::lock_guard lock(scan_mutex_);
  if (on) terminals_.insert(x_number);
  if (!on) terminals_.erase(x_number);
}

void SlmpPlc::Server::changed() {
  {
    const std::lock_guard lock(change_mutex_);
    ++changes_;
  }
  change_.notify_all();
}

bool SlmpPlc::Server::wait_until(const std::function<bool()>& holds, std::chrono::milliseconds patience) const {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::unique_lock lock(change_mutex_);
  while (true) {
    const std::uint64_t seen = changes_;
    lock.unlock();
    if (holds()) return true;
    lock.lock();
    if (!change_.wait_until(lock, deadline, [&] { return changes_ != seen; })) {
      lock.unlock();
      return holds();
    }
  }
}

}  // namespace symplant::test::slmp
