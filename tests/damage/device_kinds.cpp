// Damage to the symbols of a device: missing symbols, numbers out of sequence, other words.
#include <algorithm>
#include <cstdio>

#include "damage/kinds.hpp"

namespace symplant::damage {
namespace {

constexpr std::size_t kSiblings = 4;  ///< similar devices, the damaged one included: fewer give no evidence

std::size_t siblings(const Shop& shop, const Device& device) {
  return static_cast<std::size_t>(std::count_if(shop.devices.begin(), shop.devices.end(), [&](const Device& other) {
    return class_of(other.levels.device) == class_of(device.levels.device);
  }));
}

bool is_common(const Shop& shop, const Device& device) { return siblings(shop, device) >= kSiblings; }

std::vector<std::size_t> rows_of(const Task& task) {
  std::vector<std::size_t> rows;
  if (task.operation) rows.push_back(*task.operation);
  if (task.event) rows.push_back(*task.event);
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// Removes rows; the roots keep pointing at the remaining rows.
void erase(Damaged& damaged, std::vector<std::size_t> rows) {
  std::sort(rows.rbegin(), rows.rend());
  for (const std::size_t row : rows) {
    damaged.list.rows.erase(damaged.list.rows.begin() + static_cast<std::ptrdiff_t>(row));
    for (std::size_t& root : damaged.roots) root -= root > row ? 1U : 0U;
  }
}

void rename(Damaged& damaged, std::size_t row, const std::string& task) {
  Levels levels = *levels_of(damaged.list.rows[row].name);
  levels.task = task;
  damaged.list.rows[row].name = levels.name();
}

/// Whether a part of the task is left after one of its symbols is lost, or two other tasks are.
bool can_lose(const Device& device, const Task& task) {
  return (task.operation && task.event) || device.tasks.size() > 2;
}

/// Removes a symbol of a device that has others; any of those may carry the finding.
Damaged lose(const Shop& shop, Dice& dice, std::optional<std::size_t> Task::*side) {
  const Device& device = pick_device(shop, dice, [&](const Device& at) {
    return is_common(shop, at) && at.rows.size() > 1 &&
           std::any_of(at.tasks.begin(), at.tasks.end(),
                       [&](const Task& task) { return can_lose(at, task) && (task.*side).has_value(); });
  });
  std::vector<std::size_t> indexes;
  for (const Task& task : device.tasks) {
    if (can_lose(device, task) && task.*side) indexes.push_back(*(task.*side));
  }
  const std::size_t lost = dice.pick(indexes);
  Damaged damaged{shop.list, {}};
  for (const std::size_t row : device.rows) {
    if (row != lost) damaged.roots.push_back(row);
  }
  erase(damaged, {lost});
  return damaged;
}

Damaged lose_operation(const Shop& shop, Dice& dice) { return lose(shop, dice, &Task::operation); }
Damaged lose_event(const Shop& shop, Dice& dice) { return lose(shop, dice, &Task::event); }

/// An event on a PLC memory bit is no longer an input.
Damaged move_to_memory(const Shop& shop, Dice& dice) {
  const Device& device = pick_device(shop, dice, [&](const Device& at) {
    return is_common(shop, at) && at.rows.size() > 1 &&
           std::all_of(at.tasks.begin(), at.tasks.end(), [&](const Task& task) { return can_lose(at, task); });
  });
  const std::size_t lost = dice.pick(device.rows);
  Damaged damaged{shop.list, {lost}};
  damaged.list.rows[lost].vendor = "M" + std::to_string(100 + dice.below(4'000));
  damaged.list.rows[lost].iec = "";
  return damaged;
}

/// Removes the operation and the event of a task; one task is left.
Damaged lose_task(const Shop& shop, Dice& dice) {
  const Device& device =
      pick_device(shop, dice, [&](const Device& at) { return is_common(shop, at) && at.tasks.size() == 2; });
  const std::size_t lost = dice.below(2);
  Damaged damaged{shop.list, rows_of(device.tasks[1 - lost])};
  erase(damaged, rows_of(device.tasks[lost]));
  return damaged;
}

bool is_sequence(const Device& device, std::size_t least) {
  for (std::size_t i = 0; i < device.tasks.size(); ++i) {
    if (digits_of(device.tasks[i].word) != std::to_string(i + 1)) return false;
  }
  return device.tasks.size() >= least;
}

/// Gives a task another number. Its rows and those of the task `with` are the roots.
Damaged renumber(const Shop& shop, const Device& device, std::size_t task, std::size_t number, std::size_t with) {
  Damaged damaged{shop.list, rows_of(device.tasks[task])};
  for (const std::size_t row : rows_of(device.tasks[task])) {
    rename(damaged, row, letters_of(device.tasks[task].word) + std::to_string(number));
  }
  for (const std::size_t row : rows_of(device.tasks[with])) {
    if (with != task) damaged.roots.push_back(row);
  }
  return damaged;
}

/// P1 P2 P4: the last number is one too high.
Damaged leave_gap(const Shop& shop, Dice& dice) {
  const Device& device = pick_device(shop, dice, [](const Device& at) { return is_sequence(at, 3); });
  const std::size_t last = device.tasks.size() - 1;
  return renumber(shop, device, last, last + 2, last);
}

/// all rows of a middle task are lost.
Damaged lose_step(const Shop& shop, Dice& dice) {
  const Device& device = pick_device(shop, dice, [](const Device& at) { return is_sequence(at, 4); });
  const std::size_t lost = 1 + dice.below(device.tasks.size() - 2);
  Damaged damaged{shop.list, rows_of(device.tasks[lost + 1])};
  erase(damaged, rows_of(device.tasks[lost]));
  return damaged;
}

/// the second or the first of the two has the wrong number.
Damaged repeat_number(const Shop& shop, Dice& dice) {
  const Device& device = pick_device(shop, dice, [](const Device& at) {
    return is_sequence(at, 3) && letters_of(at.tasks[0].word) != letters_of(at.tasks[1].word);
  });
  const std::size_t first = dice.below(device.tasks.size() - 1);
  return renumber(shop, device, first + 1, first + 1, first);
}

/// O_OPEN and I_OPENED.
Damaged bend_word(const Shop& shop, Dice& dice) {
  const auto bends = [](const Task& task) {
    return task.operation && task.event && digits_of(task.word).empty() && task.word.size() >= 3 &&
           task.word.back() != 'E';
  };
  const Device& device =
      pick_device(shop, dice, [&](const Device& at) { return std::any_of(at.tasks.begin(), at.tasks.end(), bends); });
  std::vector<Task> tasks;
  std::copy_if(device.tasks.begin(), device.tasks.end(), std::back_inserter(tasks), bends);
  const Task task = dice.pick(tasks);
  Damaged damaged{shop.list, {*task.event}};
  rename(damaged, *task.event, task.word + "ED");
  return damaged;
}

/// A row was filled down in a spreadsheet: the number in the task counts up, but it is one device.
Damaged run_on(const Shop& shop, Dice& dice) {
  const std::size_t row = pick_row(shop, dice, [](const Cells& cells, const Levels& at) {
    return cells.type == "BOOL" && at.direction == "I" && !digits_of(at.device).empty();
  });
  const Levels levels = *levels_of(shop.list.rows[row].name);
  Damaged damaged{shop.list, {}};
  for (std::size_t i = 0; i < 80; ++i) {
    Levels more = levels;
    more.task = letters_of(levels.task) + std::to_string(i + 101);
    Cells cells = shop.list.rows[row];
    char vendor[16];
    std::snprintf(vendor, sizeof vendor, "X%04X", static_cast<unsigned>(0x3000 + i));
    cells.name = more.name();
    cells.vendor = vendor;
    cells.iec = "%IX" + std::to_string(0x3000 + i);
    cells.initial = "FALSE";
    damaged.list.rows.insert(damaged.list.rows.begin() + static_cast<std::ptrdiff_t>(row + 1 + i), std::move(cells));
  }
  for (const Device& device : damaged.list.devices()) {
    if (device.levels.path() == levels.path()) damaged.roots = device.rows;
  }
  return damaged;
}

}  // namespace

std::vector<Kind> device_kinds() {
  return {
      {"operation-lost", "the row of an operation lost", "shape-lacks-symbol", lose_operation},
      {"event-lost", "the row of an event lost", "shape-lacks-symbol", lose_event},
      {"memory-address", "a bit of the PLC's memory for an input or output", "io-name-in-memory", move_to_memory},
      {"task-lost", "all rows of a task lost, of two", "shape-lacks-symbol", lose_task},
      {"number-skipped", "a gap in the sequence numbers, as in `P1 P2 P4`", "sequence-gap", leave_gap},
      {"step-lost", "all rows of a step lost", "sequence-gap", lose_step},
      {"number-repeated", "a sequence number twice, as in `HOME1 JOB2 DONE2`", "sequence-repeated", repeat_number},
      {"word-bent", "another form of the word, as in `O_OPEN`, `I_OPENED`", "two-words-one-state", bend_word},
      {"device-run-on", "80 symbols of one device, since a row was dragged down", "unit-too-large", run_on},
  };
}

}  // namespace symplant::damage
