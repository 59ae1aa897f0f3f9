// Makes a facet of symbols that lead to states or report them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "pairing/work.hpp"
#include "text/ascii.hpp"

namespace symplant::pairing {

class FacetBuilder {
 public:
  explicit FacetBuilder(const Work& work) : work_(work) {}

  /// Adds a symbol of a state. `rest`: the vocabulary says that the state is the rest position. The first symbol of a
  /// state has its name as task. O(1).
  void add(std::uint32_t input, std::string_view state, bool rest);
  /// Adds one more state of an event.
  void add_again(std::uint32_t event, std::string_view state);
  bool has_symbols() const { return count_ != 0; }
  /// The facet of the symbols added since the last call: members, states and base. `device` is the first symbol of its
  /// device, whose words are left out of the texts of sensors. Numbered states keep their order by number.
  Facet take(std::uint32_t device, bool numbered);

 private:
  struct StateDraft {
    std::string name;
    bool rest = false;
    std::vector<std::uint32_t> operations;
    std::vector<std::uint32_t> events;
  };

  std::span<StateDraft> states() { return {states_.data(), count_}; }
  std::span<const StateDraft> states() const { return {states_.data(), count_}; }
  StateDraft& state_of(std::string_view name, bool rest);
  void sort_states(Facet& facet);
  void add_operations(Facet& facet);
  void add_events(Facet& facet);
  /// The index of the state that a spring returns to; kNone without one.
  std::uint32_t rest_of_spring() const;
  std::shared_ptr<const description::DeviceDescription> base(std::uint32_t rest);
  /// A task for a symbol that is not the first of its state.
  std::string further_task(std::uint32_t input);
  std::string unique(std::string task);

  struct Further {
    bool operation;
    std::uint32_t state;
    std::string task;
  };

  const Work& work_;
  std::vector<StateDraft> states_;  ///< the first `count_` are in use, the memory of the others is kept
  std::size_t count_ = 0;
  std::vector<std::uint32_t> unnamed_;  ///< states that no symbol names
  std::vector<Further> further_;        ///< symbols that are not the first of their state
  /// Bases by content, because many devices have equal ones.
  std::unordered_map<std::string, std::shared_ptr<const description::DeviceDescription>> bases_;
  std::unordered_map<std::string, std::size_t, text::HashIgnoringCase, text::EqualIgnoringCase> by_name_;
  std::unordered_map<std::string, std::size_t, text::HashIgnoringCase, text::EqualIgnoringCase> taken_;
  bool shared_ = false;  ///< an event reports several states
  std::uint32_t device_ = kNone;
};

}  // namespace symplant::pairing
