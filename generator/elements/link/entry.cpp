// Reads one entry of `links` in plant.json.
#include <nlohmann/json.hpp>

#include "description/ip_address.hpp"
#include "description/json_entry.hpp"
#include "symplant/link/opc_ua/node_id.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

std::optional<std::uint32_t> number_member(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  if (value == nullptr || !value->is_number_unsigned()) return std::nullopt;
  const auto number = value->get<std::uint64_t>();
  return number <= 65'536 ? std::optional(static_cast<std::uint32_t>(number)) : std::nullopt;
}

std::optional<link::WordOrder> word_order_member(const Json& object) {
  const std::string text = text_or_empty(object, "word-order");
  if (text == "low-first") return link::WordOrder::low_first;
  if (text == "high-first") return link::WordOrder::high_first;
  return std::nullopt;
}

std::optional<link::OnLoss> on_loss_member(const Json& object) {
  const std::string text = text_or_empty(object, "on-loss");
  if (text == "hold") return link::OnLoss::hold;
  if (text == "zero") return link::OnLoss::zero;
  return std::nullopt;
}

class LinkReader {
 public:
  LinkReader(const Json& entry, Pointer here, ShapeFaults& faults)
      : entry_(entry), here_(std::move(here)), faults_(faults) {}

  LinkDescription read() {
    link_.url = text_or_empty(entry_, "url");
    link_.controller = text_or_empty(entry_, "controller");
    if (entry_.is_object()) {
      for (const auto& [key, value] : entry_.items()) {
        if (key != "url" && key != "controller") link_.has_settings = true;
      }
    }
    link::LinkSettings& settings = link_.settings;
    link_.word_order = word_order_member(entry_);
    settings.on_loss = on_loss_member(entry_).value_or(settings.on_loss);
    if (text_or_empty(entry_, "plant-on-loss") == "freeze") settings.plant_on_loss = link::PlantOnLoss::freeze;
    settings.loss_after = time_above_zero(entry_, "loss-after", here_, settings.loss_after);
    settings.resync = time_member(entry_, "resync", here_, faults_).value_or(settings.resync);
    settings.idle = idle_member();
    settings.connections = number_member(entry_, "connections").value_or(settings.connections);
    read_sizes();
    read_status_and_watchdog();
    read_clock();
    read_keep();
    link_.exclude = texts_member(entry_, "exclude");
    read_map();
    return std::move(link_);
  }

 private:
  tables::Time idle_member() {
    const auto idle = time_member(entry_, "idle", here_, faults_);
    if (idle && *idle != 0 && *idle < tables::kSecond) {
      faults_.add(here_ / "idle",
                  "the time is shorter than 1 s, so a connection would be closed between two requests; write `0s` for "
                  "never, or a longer time such as `60s`");
    }
    return idle.value_or(link::LinkSettings{}.idle);
  }

  tables::Time time_above_zero(const Json& object, std::string_view key, const Pointer& here, tables::Time otherwise) {
    const auto time = time_member(object, key, here, faults_);
    if (time && *time == 0) faults_.add(here / key, "the time is 0; write a longer one, such as `500ms`");
    return time.value_or(otherwise);
  }

  void read_sizes() {
    const Json* size = member(entry_, "size");
    if (size == nullptr) return;
    const auto set = [&](link::Plane plane, std::string_view key) {
      link_.settings.sizes[static_cast<std::size_t>(plane)] = number_member(*size, key).value_or(0);
    };
    set(link::Plane::operation_bits, "coils");
    set(link::Plane::event_bits, "discrete-inputs");
    set(link::Plane::operation_numbers, "holding-registers");
    set(link::Plane::event_numbers, "input-registers");
  }

  void read_status_and_watchdog() {
    link::LinkSettings& settings = link_.settings;
    if (text_or_empty(entry_, "status") == "off") settings.status_block = link::kNowhere;
    if (const auto number = number_member(entry_, "status")) settings.status_block = *number;
    const Json* watchdog = member(entry_, "watchdog");
    if (watchdog == nullptr) return;
    settings.watchdog = number_member(*watchdog, "register").value_or(link::kNowhere);
    settings.watchdog_within = time_above_zero(*watchdog, "within", here_ / "watchdog", settings.watchdog_within);
  }

  void read_clock() {
    const Json* clock = member(entry_, "clock");
    if (clock == nullptr) return;
    const Pointer here = here_ / "clock";
    link::ClockSettings& settings = link_.settings.clock;
    link_.clock_of = text_or_empty(*clock, "of");
    settings.unit = time_above_zero(*clock, "unit", here, settings.unit);
    settings.limit = time_above_zero(*clock, "limit", here, settings.limit);
    if (settings.unit > tables::kSecond) {
      faults_.add(here / "unit", "the time is longer than 1 s; write a shorter one, such as `1ms`");
    } else if (settings.limit != 0 && settings.limit < settings.unit) {
      faults_.add(here / "limit", "the time is shorter than one count of the clock; write a longer one, such as `10s`");
    }
  }

  void read_keep() {
    const Json* keep = member(entry_, "keep");
    if (keep == nullptr || !keep->is_array()) return;
    for (std::size_t i = 0; i < keep->size(); ++i) {
      if (!(*keep)[i].is_string()) continue;
      const std::string text = (*keep)[i].get<std::string>();
      const auto address = canonical_ip_address(text);
      if (!address) {
        faults_.add(
            here_ / "keep" / i,
            ticked(text) + " is not the numeric address of a host; write one such as `192.168.1.10` or `fd00::10`");
      }
      link_.keep.push_back(address.value_or(text));
    }
  }

  void read_map() {
    const Json* map = member(entry_, "map");
    if (map == nullptr || !map->is_array()) return;
    for (std::size_t i = 0; i < map->size(); ++i) link_.map.push_back(map_entry((*map)[i], here_ / "map" / i));
  }

  std::optional<std::string> node_member(const Json& value, const Pointer& here) {
    const std::string* text = text_member(value, "node");
    if (text == nullptr || text->empty()) return std::nullopt;
    if (const std::string problem = link::opc_ua::template_problem(*text); !problem.empty()) {
      faults_.add(here / "node", ticked(*text) + ": " + problem);
    }
    return *text;
  }

  MapEntry map_entry(const Json& value, const Pointer& here) {
    int speaks_of = 0;
    for (const std::string_view key : {"area", "range", "symbol"}) speaks_of += member(value, key) != nullptr ? 1 : 0;
    if (value.is_object() && speaks_of != 1) {
      faults_.add(here, speaks_of == 0
                            ? "this entry does not name its symbols; give it an `area`, a `range` or a `symbol`"
                            : "this entry has more than one of `area`, `range` and `symbol`; write an entry for each");
    }
    const auto is_there = [&](std::string_view key) { return member(value, key) != nullptr; };
    if (speaks_of == 1 && !is_there("number") && !is_there("node") && !is_there("word-order") && !is_there("on-loss")) {
      faults_.add(here,
                  "this entry sets nothing for its symbols; give it a `number`, a `node`, a `word-order` or `on-loss`");
    }
    MapEntry entry;
    if (const std::string* area = text_member(value, "area"); area != nullptr) {
      entry.by = MapEntry::By::area;
      entry.text = *area;
    } else if (const Json* range = member(value, "range"); range != nullptr) {
      entry.by = MapEntry::By::range;
      if (range->is_array() && range->size() == 2 && (*range)[0].is_string() && (*range)[1].is_string()) {
        entry.text = (*range)[0].get<std::string>();
        entry.last = (*range)[1].get<std::string>();
      }
    } else {
      entry.text = text_or_empty(value, "symbol");
    }
    entry.number = number_member(value, "number");
    entry.node = node_member(value, here);
    entry.word_order = word_order_member(value);
    entry.on_loss = on_loss_member(value);
    return entry;
  }

  const Json& entry_;
  const Pointer here_;
  ShapeFaults& faults_;
  LinkDescription link_;
};

}  // namespace

LinkDescription link_entry(const Json& entry, const Pointer& here, ShapeFaults& faults) {
  return LinkReader(entry, here, faults).read();
}

bool is_controller_name(std::string_view name) {
  if (name.empty() || name.front() == ' ' || name.back() == ' ') return false;
  return std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == '=' || c == ':' || byte < 0x20 || byte == 0x7F;
  });
}

}  // namespace symplant::description
