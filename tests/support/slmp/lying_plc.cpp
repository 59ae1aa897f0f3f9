// A PLC that distorts its replies.
#include "support/slmp/lying_plc.hpp"

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "support/slmp/distortions.hpp"

namespace symplant::test::slmp {
namespace {

constexpr std::array<std::string_view, kDistortions> kDistortionNames = {
    "honest",           "late",           "held",           "doubled",         "bytewise",    "halved",
    "truncated",        "reset_within",   "foreign_serial", "wrong_subheader", "wrong_route", "length_too_long",
    "length_too_short", "length_huge",    "garbage",        "bare_error",      "short_error", "extra_data",
    "missing_data",     "trailing_bytes", "other_code",     "silent",          "reset",       "end_code",
    "closed",           "refused"};
static_assert(static_cast<std::size_t>(Distortion::refused) + 1 == kDistortions);

}  // namespace

std::string_view name_of(Distortion distortion) { return kDistortionNames[static_cast<std::size_t>(distortion)]; }

bool is_harmless(Distortion distortion) {
  return distortion == Distortion::honest || distortion == Distortion::bytewise || distortion == Distortion::halved;
}

class LyingPlc::Liar {
 public:
  explicit Liar(LieOptions options) : options_(std::move(options)), draws_(options_.seed) {
    for (std::size_t i = 1; i < kDistortions && options_.kinds.empty(); ++i) all_.push_back(static_cast<Distortion>(i));
    if (!options_.kinds.empty()) all_ = options_.kinds;
  }

  Delivery deliver(const Exchange& exchange) {
    const std::lock_guard lock(mutex_);
    Distortion kind = choose();
    if (kind == Distortion::foreign_serial && !exchange.request.is_4e) kind = Distortion::wrong_subheader;
    const ReplyLayout layout = reply_layout(exchange.request.is_4e, exchange.code);
    if (kind == Distortion::missing_data && exchange.reply.size() == layout.data) kind = Distortion::length_too_short;
    ++counts_[static_cast<std::size_t>(kind)];
    Delivery delivery = delivery_of(kind, exchange);
    prepend_held(exchange.peer, delivery);
    if (kind == Distortion::held) held_[exchange.peer.id].push_back(exchange.reply);
    return delivery;
  }

  void set_once(Distortion kind) {
    const std::lock_guard lock(mutex_);
    once_ = kind;
  }
  void set_always(std::optional<Distortion> kind) {
    const std::lock_guard lock(mutex_);
    always_ = kind;
  }
  std::size_t count(Distortion kind) const {
    const std::lock_guard lock(mutex_);
    return counts_[static_cast<std::size_t>(kind)];
  }

 private:
  Distortion choose() {
    if (once_) return *std::exchange(once_, std::nullopt);
    if (always_) return *always_;
    if (draws_.below(1000) >= options_.lies_per_thousand) return Distortion::honest;
    return all_[draws_.below(all_.size())];
  }

  Delivery delivery_of(Distortion kind, const Exchange& exchange);
  void prepend_held(const Peer& peer, Delivery& delivery);

  LieOptions options_;
  std::vector<Distortion> all_;
  Draws draws_;
  std::optional<Distortion> once_;
  std::optional<Distortion> always_;
  std::array<std::size_t, kDistortions> counts_{};
  std::map<std::size_t, std::vector<Bytes>> held_;  ///< replies that a peer does not have yet
  mutable std::mutex mutex_;
};

Delivery LyingPlc::Liar::delivery_of(Distortion kind, const Exchange& exchange) {
  Delivery delivery;
  const Bytes& reply = exchange.reply;
  const auto add = [&](Bytes bytes, std::chrono::milliseconds after = {}) {
    delivery.parts.push_back({std::move(bytes), after});
  };
  switch (kind) {
    case Distortion::late:
      add(reply, options_.late_by);
      break;
    case Distortion::doubled:
      add(exchange.peer.is_udp ? reply : joined(reply, reply));
      if (exchange.peer.is_udp) add(reply);
      break;
    case Distortion::bytewise:
      for (const std::uint8_t byte : reply) add({byte});
      break;
    case Distortion::halved: {
      const std::size_t first = 1 + draws_.below(reply.size() - 1);
      add(front(reply, first));
      add(back(reply, first), options_.pause);
      break;
    }
    case Distortion::truncated:
    case Distortion::reset_within:
      add(front(reply, 1 + draws_.below(reply.size() - 1)));
      delivery.resets = kind == Distortion::reset_within;
      break;
    case Distortion::held:
    case Distortion::silent:
      break;
    case Distortion::refused:
      delivery.refuses_for = options_.refuses_for;
      delivery.resets = true;
      break;
    case Distortion::reset:
      delivery.resets = true;
      break;
    case Distortion::closed:
      add(reply);
      delivery.resets = true;
      break;
    default:
      add(distorted(kind, exchange, draws_));
  }
  return delivery;
}

/// Over TCP in one segment with the first part, so that the client has both at once.
void LyingPlc::Liar::prepend_held(const Peer& peer, Delivery& delivery) {
  const auto at = held_.find(peer.id);
  if (at == held_.end() || delivery.parts.empty()) return;
  Bytes stale;
  for (const Bytes& reply : at->second) {
    if (peer.is_udp) {
      delivery.parts.insert(delivery.parts.begin(), {reply, {}});
    } else {
      stale = joined(stale, reply);
    }
  }
  if (!peer.is_udp) delivery.parts.front().bytes = joined(stale, delivery.parts.front().bytes);
  held_.erase(at);
}

LyingPlc::LyingPlc(PlcOptions options, LieOptions lies)
    : liar_(std::make_unique<Liar>(std::move(lies))),
      plc_(std::move(options), [this](const Exchange& exchange) { return liar_->deliver(exchange); }) {}
LyingPlc::~LyingPlc() = default;

SlmpPlc& LyingPlc::plc() { return plc_; }
std::uint16_t LyingPlc::port() { return plc_.port(); }

void LyingPlc::lie_once(Distortion distortion) { liar_->set_once(distortion); }
void LyingPlc::lie_always(Distortion distortion) { liar_->set_always(distortion); }
void LyingPlc::follow_schedule() { liar_->set_always(std::nullopt); }
std::size_t LyingPlc::count(Distortion distortion) const { return liar_->count(distortion); }

std::size_t LyingPlc::lies() const {
  std::size_t all = 0;
  for (std::size_t i = 1; i < kDistortions; ++i) all += count(static_cast<Distortion>(i));
  return all;
}

}  // namespace symplant::test::slmp
