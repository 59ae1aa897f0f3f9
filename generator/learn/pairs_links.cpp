// Pairs as a file of links.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "convert/link_row.hpp"
#include "learn/pairs_formats.hpp"

namespace symplant::learn {
namespace {

using model::PlantModel;

/// Writes the pairs of one operation after the other.
class LinksWriter {
 public:
  LinksWriter(const Pairs& pairs, const PlantModel& plant, const std::set<std::size_t>& refused)
      : pairs_(pairs), plant_(plant), refused_(refused) {}

  std::string run() {
    for (std::size_t first = 0; first < pairs_.pairs.size();) {
      std::size_t end = first + 1;
      while (end < pairs_.pairs.size() && pairs_.pairs[end].operation == pairs_.pairs[first].operation) ++end;
      write_operation(first, end);
      first = end;
    }
    return std::move(text_);
  }

 private:
  void write_operation(std::size_t first, std::size_t end) {
    std::vector<const Pair*> drives;
    std::vector<const Pair*> inverted;
    for (std::size_t i = first; i < end; ++i) {
      const Pair& pair = pairs_.pairs[i];
      if (!refused_.contains(i)) (pair.inverted ? inverted : drives).push_back(&pair);
    }
    if (drives.empty() && inverted.empty()) return;
    if (pairs_.pairs[first].named)
      return write_comments(drives, inverted, "names pair the operation, which a row would undo");
    if (drives.empty()) {
      return write_comments({}, inverted,
                            "no row can say that an event is on while an operation is off; use an archetype of the "
                            "model `mirror` with `inverted`");
    }
    const std::string state = state_of(*drives.front());
    std::string operation(name(drives.front()->operation));
    for (const Pair* pair : drives) write_row(*pair, std::exchange(operation, std::string()), state);
    const std::string rest = state == "ON" ? "OFF" : "NOT_" + state;
    for (const Pair* pair : inverted) write_row(*pair, "", rest);
  }

  void write_row(const Pair& pair, const std::string& operation, const std::string& state) {
    write_comment(evidence(pair));
    text_ += convert::link_row({operation, std::string(name(pair.event)), state});
  }

  void write_comments(const std::vector<const Pair*>& drives, const std::vector<const Pair*>& inverted,
                      std::string_view why) {
    for (const auto* pairs : {&drives, &inverted}) {
      for (const Pair* pair : *pairs) {
        write_comment(fmt::format("{} -> {}{}: {} ({})", name(pair->operation), pair->inverted ? "not " : "",
                                  name(pair->event), evidence(*pair), why));
      }
    }
  }

  void write_comment(const std::string& comment) { text_ += "# " + convert::on_one_line(comment) + "\n"; }

  std::string_view name(std::uint32_t symbol) const { return plant_.symbols[symbol].name(); }

  /// The task of the operation, or ON; other operations of its device lead to other states.
  std::string state_of(const Pair& pair) {
    const model::SymbolReading& operation = plant_.symbols[pair.operation].reading;
    const model::SymbolReading& event = plant_.symbols[pair.event].reading;
    const std::string device(operation.is_named() ? operation.device_path()
                             : event.is_named()   ? event.device_path()
                                                  : name(pair.operation));
    const std::string task = operation.task().empty() ? "ON" : std::string(operation.task());
    std::set<std::string>& states = states_[device];
    std::string state = task;
    for (int number = 2; !states.insert(state).second; ++number) state = task + "_" + std::to_string(number);
    return state;
  }

  const Pairs& pairs_;
  const PlantModel& plant_;
  const std::set<std::size_t>& refused_;
  std::string text_{convert::kLinksHeader};
  std::map<std::string, std::set<std::string>> states_;  ///< by device: those that an operation leads to
};

}  // namespace

std::string pairs_links(const Pairs& pairs, const PlantModel& plant, const std::set<std::size_t>& refused) {
  return LinksWriter(pairs, plant, refused).run();
}

}  // namespace symplant::learn
