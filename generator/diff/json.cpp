// A difference as JSON, for programs: every change.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "diff/formats.hpp"
#include "view/json_writer.hpp"

namespace symplant::diff {
namespace {

constexpr std::array<std::string_view, kFields> kFieldKeys{"name", "address", "type", "initial", "comment", "other"};
constexpr std::array<std::string_view, 6> kCauseKeys{"added",   "removed", "replaced",
                                                     "shifted", "retyped", "modelled"};  // in the order of Cause::Kind

class JsonDifference {
 public:
  JsonDifference(const Comparison& comparison, view::JsonWriter& json)
      : of_(comparison), difference_(comparison.difference), json_(json) {}

  void write() {
    json_.begin_object();
    json_.member("symplant-diff", kJsonVersion);
    write_plant("before", of_.before, of_.before_name, 0);
    write_plant("after", of_.after, of_.after_name, 1);
    json_.member("equal", difference_.empty());
    json_.key("same_model");
    if (difference_.same_model) {
      json_.value(*difference_.same_model);
    } else {
      json_.null();
    }
    json_.key("symbols");
    json_.array(difference_.symbols, [&](const SymbolChange& change) { write_symbol(change); });
    json_.key("symbol_causes");
    json_.array(difference_.symbol_causes, [&](const Cause& cause) { write_cause(cause); });
    json_.key("devices");
    json_.array(difference_.devices, [&](const DeviceChange& change) { write_device(change); });
    json_.key("device_causes");
    json_.array(difference_.device_causes, [&](const Cause& cause) { write_cause(cause); });
    json_.key("plant");
    write_items(difference_.plant);
    json_.end_object();
  }

 private:
  void write_plant(std::string_view key, const model::PlantModel& plant, const std::string& name, std::size_t side) {
    json_.key(key);
    json_.begin_object();
    json_.member("file", name);
    json_.member("plant", plant.name);
    json_.member("symbols", difference_.rows[side]);
    json_.member("devices", plant.units.size());
    json_.key("model_hash");
    if (const auto& hash = difference_.model_hash[side]) {
      json_.value(fmt::format("{:016x}", *hash));
    } else {
      json_.null();
    }
    json_.end_object();
  }

  void write_row(std::string_view key, const model::PlantModel& plant, const RowRef& at) {
    if (!at.exists()) return;
    const read::ListRow& row = at.in(plant);
    json_.key(key);
    json_.begin_object();
    json_.member("name", row.name);
    json_.member("address", row.vendor_address);
    json_.member("iec_address", row.iec_address);
    json_.member("type", row.type);
    json_.member("initial", row.initial);
    json_.member("comment", row.comment);
    json_.member("list", plant.lists[at.list].name());
    json_.member("row", row.line);
    json_.end_object();
  }

  void write_symbol(const SymbolChange& change) {
    json_.begin_object();
    json_.member("change", change.added() ? "added" : change.removed() ? "removed" : "changed");
    if (!change.added() && !change.removed()) {
      json_.key("fields");
      json_.begin_array();
      for (std::size_t field = 0; field < kFields; ++field) {
        if (change.fields.has(static_cast<Field>(field))) json_.value(kFieldKeys[field]);
      }
      json_.end_array();
    }
    write_row("before", of_.before, change.before);
    write_row("after", of_.after, change.after);
    json_.end_object();
  }

  void write_cause(const Cause& cause) {
    json_.begin_object();
    json_.member("cause", kCauseKeys[static_cast<std::size_t>(cause.kind)]);
    if (!cause.before.empty()) json_.member("before", cause.before);
    if (!cause.after.empty()) json_.member("after", cause.after);
    json_.member("count", cause.members.size());
    json_.key("members");
    json_.array(cause.members, [&](std::uint32_t member) { json_.value(member); });
    json_.end_object();
  }

  void write_items(const std::vector<ItemChange>& items) {
    json_.array(items, [&](const ItemChange& item) {
      json_.begin_object();
      json_.member("element", item.element);
      if (!item.key.empty()) json_.member("key", item.key);
      if (item.before) json_.member("before", *item.before);
      if (item.after) json_.member("after", *item.after);
      if (item.follows) json_.member("follows", true);
      json_.end_object();
    });
  }

  void write_device(const DeviceChange& change) {
    json_.begin_object();
    json_.member("change", change.added()     ? "added"
                           : change.removed() ? "removed"
                           : change.renamed   ? "renamed"
                                              : "changed");
    if (!change.added()) json_.member("before", of_.before.units[change.before].path);
    if (!change.removed()) json_.member("after", of_.after.units[change.after].path);
    json_.key("model");
    write_items(change.items);
    json_.end_object();
  }

  const Comparison& of_;
  const Difference& difference_;
  view::JsonWriter& json_;
};

}  // namespace

void write_json(const Comparison& comparison, base::TextSink& sink) {
  view::JsonWriter json(sink, view::JsonWriter::Form::indented);
  JsonDifference(comparison, json).write();
  json.finish();
  sink.put("\n");
}

}  // namespace symplant::diff
