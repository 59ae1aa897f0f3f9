// A list as cells and as text.
#include "damage/shop_list.hpp"

#include <algorithm>
#include <map>

#include "read/readers.hpp"
#include "support/memory_file_system.hpp"

namespace symplant::damage {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::optional<Levels> levels_of(std::string_view name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '_') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != 5) return std::nullopt;
  return Levels{parts[0], parts[1], parts[2], parts[3], parts[4]};
}

std::string letters_of(std::string_view word) {
  return std::string(word.begin(), std::find_if(word.begin(), word.end(), is_digit));
}

std::string digits_of(std::string_view word) { return std::string(word.substr(letters_of(word).size())); }

std::string class_of(std::string_view device) {
  std::string result;
  for (const char c : device) {
    if (!is_digit(c)) {
      result += c;
    } else if (result.empty() || result.back() != '#') {
      result += '#';
    }
  }
  return result;
}

const Task* Device::task(std::string_view word) const {
  const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const Task& task) { return task.word == word; });
  return found == tasks.end() ? nullptr : &*found;
}

std::string ShopList::text() const {
  std::string text = "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n";
  for (const Cells& row : rows) {
    text += row.raw.empty() ? row.klass + "," + row.name + "," + row.vendor + "," + row.iec + "," + row.type + "," +
                                  row.initial + "," + row.comment
                            : row.raw;
    text += "\n";
  }
  return text;
}

std::vector<Device> ShopList::devices() const {
  std::vector<Device> devices;
  std::map<std::string, std::size_t> by_path;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto levels = levels_of(rows[i].name);
    if (!levels || rows[i].type != "BOOL") continue;
    const auto [found, added] = by_path.try_emplace(levels->path(), devices.size());
    if (added) devices.push_back({*levels, {}, {}});
    Device& device = devices[found->second];
    device.rows.push_back(i);
    auto task = std::find_if(device.tasks.begin(), device.tasks.end(),
                             [&](const Task& known) { return known.word == levels->task; });
    if (task == device.tasks.end()) task = device.tasks.insert(task, {levels->task, {}, {}});
    (levels->direction == "O" ? task->operation : task->event) = i;
  }
  return devices;
}

bool ShopList::has(std::string_view name) const {
  return std::any_of(rows.begin(), rows.end(), [&](const Cells& row) { return row.name == name; });
}

ShopList read_list(const std::string& text) {
  test::MemoryFileSystem files;
  files.files["list.csv"] = text;
  diag::Diagnostics diagnostics;
  ShopList list;
  const auto table = read::read_symbol_list("list.csv", {}, files, diagnostics);
  if (!table) return list;
  for (const read::ListRow& row : table->rows) {
    list.rows.push_back({std::string(row.klass), std::string(row.name), std::string(row.vendor_address),
                         std::string(row.iec_address), std::string(row.type), std::string(row.initial),
                         std::string(row.comment), ""});
  }
  return list;
}

}  // namespace symplant::damage
