// What a target cannot hold, counted by kind, and the names that were changed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace symplant::convert {

/// A kind of loss: "12 initial values are not written: a tag table has none: `A`, `B`, `C` and 9 more".
struct Loss {
  std::string_view one;   ///< "initial value is not written"
  std::string_view many;  ///< "initial values are not written"
  std::string_view why;   ///< "a tag table has none"
};

/// An old name and the new one.
using Rename = std::pair<std::string, std::string>;

class Report {
 public:
  /// `loss` must outlive the report: kinds are identified by their address.
  void add(const Loss& loss, std::string_view name);
  void rename(std::string_view from, std::string_view to, const Loss& why);

  /// One line for each kind, in the order of their first loss. Safe to show.
  std::vector<std::string> lines() const;
  /// The changed names, in the order of the rows.
  const std::vector<Rename>& renames() const { return renames_; }

 private:
  struct Count {
    const Loss* loss;
    std::size_t count = 0;
    std::vector<std::string> examples = {};
  };
  Count& count_of(const Loss& loss);

  std::vector<Count> counts_;
  std::vector<Rename> renames_;
};

}  // namespace symplant::convert
