// What the connections of the server share.
#include "symplant/panel/web/shared.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace symplant::panel::web {
namespace {

/// Comments of 256 KiB in all, in lines of 1 KiB: a client of Linux takes 64 to 128 KiB that it does not read.
const Bytes& probe_event() {
  static const Bytes event = [] {
    const std::string line = ":" + std::string(1022, ' ') + "\n";
    std::string text;
    for (int i = 0; i < 256; ++i) text += line;
    return std::make_shared<const std::string>(text + "\n");
  }();
  return event;
}

}  // namespace

Bytes Shared::picture(bool all) {
  Bytes& kept = pictures_[all ? 1 : 0];
  if (kept == nullptr) {
    const std::string data = source.picture(all ? Role::trainer : Role::trainee);
    kept = outgoing.share("event: picture\ndata: " + data + "\n\n");
  }
  return kept;
}

void Shared::broadcast(const Bytes& all, const Bytes& shown) {
  const std::list<std::shared_ptr<Client>> clients = connections;  // sending may close one
  for (const std::shared_ptr<Client>& each : clients) {
    if (!each->is_stream()) continue;
    const Bytes& event = each->sees_all() ? all : shown;
    if (event != nullptr) each->send(event);
  }
}

bool Shared::has_others() const {
  return std::any_of(connections.begin(), connections.end(),
                     [](const std::shared_ptr<Client>& each) { return each->is_stream() && !each->sees_all(); });
}

void Shared::probe(Clock::time_point now) {
  if (now < next_probe_) return;
  next_probe_ = now + patience;
  broadcast(probe_event());
}

std::shared_ptr<Client> Shared::slowest(Clock::time_point now) const {
  std::shared_ptr<Client> found;
  double least = 0;
  for (const std::shared_ptr<Client>& each : connections) {
    const std::optional<double> rate = each->rate(now);
    if (!rate || (found != nullptr && *rate >= least)) continue;
    found = each;
    least = *rate;
  }
  return found;
}

bool Shared::close_one(Clock::time_point now) {
  const auto idle = std::find_if(connections.begin(), connections.end(),
                                 [](const std::shared_ptr<Client>& each) { return each->is_idle(); });
  if (idle != connections.end()) {
    std::shared_ptr<Client>(*idle)->close();
    return true;
  }
  const std::shared_ptr<Client> slow = slowest(now);
  if (slow != nullptr) slow->abandon();
  return slow != nullptr;
}

bool Shared::relieve(std::size_t bytes, Clock::time_point now) {
  std::size_t had = 0;
  while (had < bytes) {
    const std::shared_ptr<Client> slow = slowest(now);
    if (slow == nullptr) return false;
    had += slow->waiting();
    slow->abandon();
  }
  return true;
}

}  // namespace symplant::panel::web
