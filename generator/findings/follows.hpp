// Which rules explain findings of others, and when.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "diag/diagnostic.hpp"
#include "model/plant_model.hpp"
#include "text/ascii.hpp"

namespace symplant::findings {

/// What a rule's findings are to others.
struct RuleRole {
  /// What the finding's `about` says, and so where its consequences are looked for.
  enum class Of : std::uint8_t {
    device,            ///< the last is a device: anything there may follow
    device_and_lacks,  ///< a device, then the symbols that it lacks
    slip,              ///< a symbol, its device as written, the one that is meant; more symbols, each with its device
    row,               ///< a symbol: anything in its device may follow
    lost_row,          ///< a symbol that its device lacks
    name,              ///< a name that breaks the rule
    one_sided,         ///< the last is a device: its rest state may follow
    symbol,            ///< only what is told of the same symbol follows
  };
  int rule = 0;  ///< the number in its id
  Of subject = Of::device;
  std::uint8_t rank = 0xFF;     ///< a finding follows from one of a lower rank only
  bool explains = false;        ///< others may follow from it
  bool follows_device = false;  ///< it may follow from what is told of its device
  bool follows_symbol = false;  ///< it may follow from what is told of its symbol

  bool follows() const { return follows_device || follows_symbol; }
  bool reports_rest_state() const;
  /// It tells that a symbol lacks the other side of its task.
  bool lacks_side() const;
};
RuleRole role_of(const diag::RuleInfo& rule);

/// A symbol that a device lacks; `task` is empty and `direction` unset where they are not known.
struct Lost {
  std::optional<name::Direction> direction;
  std::string task;

  static Lost of_words(std::string_view direction, std::string_view task);
};

struct Root {
  std::uint32_t finding;  ///< a place among the findings
  RuleRole role;
  std::string_view symbol;  ///< the first that it is about
  std::optional<Lost> lost;
};

class Facts {
 public:
  explicit Facts(const model::PlantModel& plant) : plant_(plant) {}

  /// Whether a finding of the device of that path comes of the root's lost symbol. O(1), but for the first time.
  bool follows(const diag::Diagnostic& finding, std::string_view path, const Root& root);

 private:
  const model::Unit* unit_of(std::string_view path);

  const model::PlantModel& plant_;
  text::ByName<const model::Unit*> units_;
};

}  // namespace symplant::findings
