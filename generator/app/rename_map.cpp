// The renames that findings propose.
#include "app/rename_map.hpp"

#include <algorithm>
#include <unordered_set>

#include "convert/cells.hpp"
#include "text/ascii.hpp"

namespace symplant::app {

void RenameMap::add(const model::PlantModel& plant, const diag::Diagnostics& findings) {
  const auto all = findings.all();
  if (std::all_of(all.begin(), all.end(), [](const auto& finding) { return finding.renames.empty(); })) return;
  std::unordered_set<std::string> taken;
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) taken.insert(text::to_upper(row.name));
  }
  std::unordered_set<std::string> renamed;
  for (const diag::Diagnostic& finding : all) {
    for (const diag::Rename& rename : finding.renames) {
      if (rename.from == rename.to || !renamed.insert(text::to_upper(rename.from)).second) continue;
      if (taken.insert(text::to_upper(rename.to)).second) {
        rows_.push_back({rename, finding.rule->slug});
      } else {
        ++taken_;
      }
    }
  }
}

std::size_t RenameMap::safe() const {
  return static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.rename.safe; }));
}

base::TextSource RenameMap::text() const {
  return [rows = rows_](base::TextSink& sink) {
    base::PartCollector parts(sink);
    parts.add("old,new,address,safe,why\n");
    std::string line;
    for (const Row& row : rows) {
      line.clear();
      convert::append_protected_cell(line, row.rename.from);
      convert::append_protected_cell(line += ',', row.rename.to);
      convert::append_protected_cell(line += ',', row.rename.address);
      parts.add(line.append(row.rename.safe ? ",yes," : ",no,").append(row.why) += '\n');
    }
    parts.finish();
  };
}

}  // namespace symplant::app
