// Devices that the description makes of symbols.
#include "model/described_devices.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

#include "model/symbol_names.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::DeviceDescription;
using description::Pointer;
using description::ticked;

class Claims {
 public:
  Claims(PlantModel& plant, const SymbolNames& names, description::Faults& faults)
      : plant_(plant), names_(names), faults_(faults) {}

  void claim(const DeviceDescription& device) {
    const name::DeviceLevels& levels = levels_of(device.path);
    for (const auto& [task, symbol] : device.operations) {
      claim({description::device_pointer(device) / "operations" / std::string_view(task)}, task, symbol,
            tables::Direction::operation, levels);
    }
    for (const auto& [task, symbol] : device.events) {
      claim({description::device_pointer(device) / "events" / std::string_view(task)}, task, symbol,
            tables::Direction::event, levels);
    }
  }

 private:
  void claim(const Pointer& here, const std::string& task, const std::string& name, tables::Direction side,
             const name::DeviceLevels& levels) {
    const std::uint32_t index = names_.find(name, here, faults_);
    if (index == kNone) return;
    Symbol& symbol = plant_.symbols[index];
    const bool operation = side == tables::Direction::operation;
    if (symbol.direction != side) {
      faults_.add(here, ticked(name) + (operation ? " is an event, which the PLC reads; move it to `events`"
                                                  : " is an operation, which the PLC writes; move it to `operations`"));
    } else if (const auto [other, added] = claimed_.try_emplace(index, here.text()); !added) {
      description::DescriptionFault fault{here.text(), ticked(name) + " is given twice; remove one"};
      fault.related = other->second;
      fault.related_message = "the other one";
      faults_.add(std::move(fault));
    } else if (symbol.account == Account::follows || symbol.account == Account::plain) {
      faults_.add(here, ticked(name) +
                            (symbol.account == Account::plain ? " is also in `plain`, so it is in no device"
                                                              : " also follows a condition") +
                            "; remove one");
    } else {
      symbol.reading = {&levels, task};
      symbol.described = true;
      symbol.account = Account::modelled;
    }
  }

  /// The levels of the device that names make, if there is one of this path; else the path is all that is known.
  const name::DeviceLevels& levels_of(const std::string& path) {
    if (by_path_.empty()) {
      for (const Symbol& symbol : plant_.symbols) {
        if (symbol.reading.is_named()) by_path_.try_emplace(symbol.reading.device_path(), symbol.reading.levels());
      }
      next_ = plant_.reader->devices();
    }
    if (const auto found = by_path_.find(path); found != by_path_.end()) return *found->second;
    name::DeviceLevels& levels = plant_.described_levels->emplace_back();
    levels.path = path;
    const name::LevelRule* const rule = plant_.levels();
    const std::string_view text = path;
    const std::size_t process = text.find('_');
    const std::size_t device = process == text.npos ? text.npos : text.find('_', process + 1);
    const bool has_levels =
        rule != nullptr && rule->has_path && device != text.npos && text.find('_', device + 1) == text.npos;
    levels.device = has_levels ? text.substr(device + 1) : text;
    if (has_levels) {
      levels.line = text.substr(0, process);
      levels.process = text.substr(process + 1, device - process - 1);
    }
    levels.device_id = next_++;
    by_path_.emplace(levels.path, &levels);
    return levels;
  }

  PlantModel& plant_;
  const SymbolNames& names_;
  description::Faults& faults_;
  text::ByName<const name::DeviceLevels*> by_path_;
  std::unordered_map<std::uint32_t, std::string> claimed_;  ///< symbols, and where they are given
  std::uint32_t next_ = 0;                                  ///< number of the next device
};

}  // namespace

void claim_symbols(PlantModel& plant, const description::Description& description, const SymbolNames& names,
                   description::Faults& faults) {
  const auto count =
      static_cast<std::size_t>(std::count_if(description.devices.begin(), description.devices.end(),
                                             [](const DeviceDescription& device) { return device.names_symbols(); }));
  if (count == 0) return;
  plant.described_levels = std::make_shared<std::vector<name::DeviceLevels>>();
  plant.described_levels->reserve(count);  // symbols point to them
  Claims claims(plant, names, faults);
  for (const DeviceDescription& device : description.devices) {
    if (device.names_symbols()) claims.claim(device);
  }
}

}  // namespace symplant::model
