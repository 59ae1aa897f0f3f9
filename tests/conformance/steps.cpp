// Plays the steps of a row.
#include <stdexcept>

#include "player.hpp"

namespace symplant::conformance {

namespace {

/// The texts to the left and right of a word.
std::pair<std::string, std::string> cut(const std::string& text, const std::string& at) {
  const std::size_t where = text.find(at);
  if (where == text.npos) throw std::runtime_error("`" + text + "` lacks `" + at + "`");
  return {text.substr(0, where), text.substr(where + at.size())};
}

class Steps {
 public:
  Steps(const Server& server, Memory& memory) : server_(server), memory_(memory), client_(connect_to(server)) {}

  std::string play(const Row& row) {
    for (const std::string& step : row.steps) {
      std::string fault = one(step);
      if (!fault.empty() || over_) return fault;
    }
    return {};
  }

 private:
  std::string one(const std::string& step) {
    const std::size_t blank = step.find(' ');
    const std::string verb = step.substr(0, blank);
    const std::string rest = blank == step.npos ? "" : step.substr(blank + 1);
    if (verb == "ask") return ask(rest);
    if (verb == "frame") return frame(rest), "";
    if (verb == "bytes") return append(bytes(rest)), "";
    if (verb == "go") return client_.send(pending_), pending_.clear(), "";
    if (verb == "got") return got(rest);
    if (verb == "unit") return unit_ = bytes(rest).at(0), "";
    if (verb == "closed") return answered("closed", {}, -1);
    if (verb == "becomes") return becomes(rest), "";
    if (verb == "do") return play_procedure(rest, server_, memory_);
    throw std::runtime_error("`" + step + "` is no step");
  }

  Bytes bytes(const std::string& text) const { return pattern(text, server_.sizes).plain(); }
  void append(const Bytes& bytes) { pending_.insert(pending_.end(), bytes.begin(), bytes.end()); }

  void frame(const std::string& text) {
    Bytes all = bytes(text);
    const int transaction = all.at(0) << 8 | all.at(1);
    all.erase(all.begin(), all.begin() + 2);
    append(test::RawClient::frame(transaction, all, 0, unit_));
  }

  std::string ask(const std::string& text) {
    const auto [request, answer] = cut(text, " = ");
    const Bytes pdu = bytes(request);
    client_.send(test::RawClient::frame(++transaction_, pdu, 0, unit_));
    return answered(answer, pdu, transaction_);
  }

  std::string got(const std::string& text) {
    const auto [transaction, answer] = cut(text, " ");
    return answered(answer, {}, std::stoi(transaction, nullptr, 16));
  }

  std::string answered(const std::string& text, const Bytes& request, int transaction) {
    std::vector<std::string> allowed = split(text, " / ");
    if (server_.strict) allowed.resize(1);
    bool silence = false;
    std::vector<std::string> answers;
    for (const std::string& group : allowed) {
      for (const std::string& answer : split(group, " | ")) {
        answers.push_back(answer);
        silence = silence || answer == "none";
      }
    }
    // If no answer is expected, do not wait: the answer to a further request must come first.
    if (silence) client_.send(test::RawClient::frame(kProbe, {1, 0, 0, 0, 1}, 0, unit_));
    const Seen seen = next_frame(client_);
    if (silence && seen.kind == Seen::Kind::frame && seen.transaction == kProbe) return {};
    for (const std::string& answer : answers) {
      if (!is(answer, seen, request, transaction)) continue;
      over_ = seen.kind == Seen::Kind::closed;
      if (!silence) return {};
      const Seen probe = next_frame(client_);
      return probe.transaction == kProbe ? "" : "then " + probe.text();
    }
    const bool foreign = seen.kind == Seen::Kind::frame && transaction >= 0 && seen.transaction != transaction;
    return foreign ? "another transaction's answer" : seen.text();
  }

  bool is(const std::string& answer, const Seen& seen, Bytes request, int transaction) const {
    if (answer == "closed") return seen.kind == Seen::Kind::closed;
    if (answer == "none" || seen.kind != Seen::Kind::frame) return false;
    if (seen.transaction != transaction || seen.unit != unit_) return false;
    if (answer == "head" && request.size() > 5) request.resize(5);
    if (answer == "same" || answer == "head") return seen.pdu == request;
    return pattern(answer, server_.sizes).matches(seen.pdu);
  }

  void becomes(const std::string& text) {
    const std::vector<std::string> parts = words(text);
    std::uint32_t at = address_of(parts.at(1), server_.sizes);
    for (std::size_t i = 2; i < parts.size(); ++i, ++at) {
      if (parts[0] == "C") {
        memory_.coils.at(at) = parts[i] == "1";
      } else {
        memory_.registers.at(at) = static_cast<std::uint16_t>(std::stoul(parts[i], nullptr, 16));
      }
    }
  }

  static constexpr int kProbe = 0x7E57;

  const Server& server_;
  Memory& memory_;
  test::RawClient client_;
  Bytes pending_;
  std::uint8_t unit_ = 1;
  int transaction_ = 0x100;
  bool over_ = false;
};

}  // namespace

std::string play_steps(const Row& row, const Server& server, Memory& memory) { return Steps(server, memory).play(row); }

}  // namespace symplant::conformance
