// The requests of one reading, some of which the PLC may refuse.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "symplant/link/client/dialog.hpp"
#include "symplant/link/client/retry.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::client {

/// Sends requests in their order. One that is refused twice in a row is divided in halves, again and again, until the
/// refused symbols are alone; the other ones go on. In one run at most kAgain refused requests are sent again, so that
/// they delay the others little.
template <class Request>
class RequestList {
 public:
  static constexpr int kAgain = 4;

  RequestList() = default;
  explicit RequestList(std::vector<Request> requests) : whole_(std::move(requests)) { join(); }

  std::size_t size() const noexcept { return entries_.size(); }
  /// Whether the latest run did not send some part of a refused request, so that it is not known yet whether the PLC
  /// accepts that part.
  bool is_dividing() const noexcept { return dividing_; }
  /// Makes all requests due.
  void retry() noexcept {
    for (Entry& entry : entries_) entry.retry.accept();
    whole_for_ = kFirstWhole;
  }

  /// `users` has
  ///   Fault send(const Request&, bool first, Answer&): `first`: it was not refused before;
  ///   std::vector<Request> parts(const Request&, Answer): for the answer over_gaps the same request without gaps, for
  ///   the answer refused its halves; empty if the request cannot be divided;
  ///   void leave_out(const Request&): the PLC refuses it permanently.
  /// The result is `rejected` if the PLC accepted no request, or if is_dividing().
  template <class Users>
  Fault run(tables::Time now, Users& users) {
    if (divided_ && all_accepted() && now >= join_at_) join();
    bool any = entries_.empty();
    int again = kAgain;
    dividing_ = false;
    for (std::size_t i = 0; i < entries_.size();) {
      if (entries_[i].retry.is_refused() && (again == 0 || !entries_[i].retry.is_due(now))) {
        dividing_ = dividing_ || !entries_[i].retry.is_tried();
        ++i;
        continue;
      }
      if (entries_[i].retry.is_refused()) --again;
      Answer answer = Answer::accepted;
      if (Fault fault = users.send(entries_[i].request, !entries_[i].retry.is_refused(), answer)) return fault;
      if (answer == Answer::accepted) {
        entries_[i].retry.accept();
        any = true;
      } else if (refuse(i, now, answer, users)) {
        continue;  // its parts are in its position
      }
      ++i;
    }
    return {any && !dividing_ ? Fault::Kind::none : Fault::Kind::rejected};
  }

 private:
  struct Entry {
    Request request;
    Retry retry;
  };

  /// True if the request was replaced by its parts.
  template <class Users>
  bool refuse(std::size_t i, tables::Time now, Answer answer, Users& users) {
    if (answer == Answer::over_gaps) return replace(i, users.parts(entries_[i].request, answer), {});
    Retry& retry = entries_[i].retry;
    retry.refuse(now, answer);
    if (answer == Answer::busy) return false;
    if (retry.refusals() == 2 && replace(i, users.parts(entries_[i].request, answer), Retry::suspect())) {
      if (!std::exchange(divided_, true)) {
        join_at_ = now + whole_for_;
        whole_for_ = std::min(2 * whole_for_, kLastWhole);
      }
      return true;
    }
    if (retry.refusals() == Retry::kLasting) users.leave_out(entries_[i].request);
    return false;
  }

  bool replace(std::size_t i, std::vector<Request> parts, Retry retry) {
    if (parts.empty()) return false;
    const auto at = entries_.begin() + static_cast<std::ptrdiff_t>(i);
    std::vector<Entry> entries;
    entries.reserve(parts.size());
    for (Request& part : parts) entries.push_back({std::move(part), retry});
    entries_.insert(entries_.erase(at), std::make_move_iterator(entries.begin()),
                    std::make_move_iterator(entries.end()));
    return true;
  }

  bool all_accepted() const noexcept {
    return std::none_of(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.retry.is_refused(); });
  }

  void join() {
    entries_.clear();
    for (const Request& request : whole_) entries_.push_back({request, {}});
    divided_ = false;
  }

  static constexpr tables::Time kFirstWhole = 5 * tables::kSecond;
  static constexpr tables::Time kLastWhole = 600 * tables::kSecond;

  std::vector<Request> whole_;
  std::vector<Entry> entries_;
  bool dividing_ = false;
  bool divided_ = false;                  ///< some entries are halves
  tables::Time join_at_ = 0;              ///< of divided ones
  tables::Time whole_for_ = kFirstWhole;  ///< from the next division to the time when its parts may be joined
};

}  // namespace symplant::link::client
