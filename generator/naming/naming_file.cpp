// Reads and checks a naming.json.
#include "naming/naming_file.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "naming/entries.hpp"
#include "naming/links_file.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"

namespace symplant::naming {
namespace {

using description::DescriptionFault;
using description::FaultKind;
using description::flag_member;
using description::member;
using description::Pointer;
using description::text_or_empty;
using description::ticked;

constexpr std::string_view kVersion = "symplant-naming";

/// Another kind of JSON file, recognized by one of its keys.
struct OtherFile {
  std::string_view key;
  std::string_view words;
};
constexpr std::array kOtherFiles{
    OtherFile{"symplant", "this is a plant description, not a naming rule; give it as PLANT"},
    OtherFile{"symplant-scenario", "this is a scenario, not a naming rule; give it to `symplant run PLANT --scenario`"},
    OtherFile{"symplant-model", "this is output of `symplant model --format json`, not a naming rule"},
    OtherFile{"$id", "this looks like a JSON Schema, not a naming rule"},
};

/// Why a value is not a naming rule of this version; nothing if it may be one.
std::optional<DescriptionFault> why_not(const Json& root) {
  const auto fault = [](std::string pointer, std::string message, bool at_key = false) {
    DescriptionFault found{std::move(pointer), std::move(message), 0, FaultKind::shape};
    found.at_key = at_key;
    return found;
  };
  if (!root.is_object()) {
    return fault("", "this is not an object; a naming rule is an object with `\"symplant-naming\": 1` and `rules`");
  }
  if (const Json* version = member(root, kVersion); version != nullptr) {
    if (!version->is_number_integer() || *version == 1) return std::nullopt;
    return fault("/" + std::string(kVersion),
                 *version > 1 ? "this is version " + version->dump() +
                                    " of the format, but this symplant reads version 1; use a newer symplant"
                              : "unknown format version " + version->dump() + "; write 1");
  }
  for (const OtherFile& other : kOtherFiles) {
    if (root.contains(other.key)) return fault("/" + std::string(other.key), std::string(other.words), true);
  }
  if (root.contains("rules")) return std::nullopt;  // the schema check reports what is missing
  return fault("", "this is JSON, but not a naming rule, which has `\"symplant-naming\": 1` and `rules`");
}

class NamingReader {
 public:
  NamingReader(Json& root, std::string_view base, NamingReading& reading)
      : root_(root), base_(std::string(base)), reading_(reading), faults_(reading.faults) {}

  void read() {
    take_out_relays();
    check_shape();
    naming_.name = text_or_empty(root_, "name");
    read_normalise();
    if (const std::string* separators = description::text_member(root_, "separators")) {
      naming_.separators = *separators;
    }
    naming_.ignore = texts_of(root_, "ignore");
    for_each("rules", [&](const Json& entry, const Pointer& here) {
      naming_.rules.push_back(rule_entry(entry, here, faults_));
    });
    for_each("rest", [&](const Json& entry, const Pointer& here) {
      naming_.rest.push_back(rule_entry(entry, here, faults_));
      if (naming_.rest.back().role == name::Role::io) {
        faults_.add(here, "a rule of `rest` needs a role, since it reads only what nothing links; add `role`",
                    description::FaultKind::contradiction);
      }
    });
    read_fixed();
    read_direction();
    if (text_or_empty(root_, "units") == "device") naming_.units = name::Units::device;
    read_tasks();
    read_links();
    read_archetypes();
    reading_.naming = std::move(naming_);
  }

 private:
  /// Reports archetypes of the model `relay`, which this version does not support, and reads them as others.
  void take_out_relays() {
    const auto archetypes = root_.find("archetypes");
    if (archetypes == root_.end() || !archetypes->is_array()) return;
    for (std::size_t i = 0; i < archetypes->size(); ++i) {
      Json& entry = (*archetypes)[i];
      if (text_or_empty(entry, "model") != "relay") continue;
      faults_.add(base_ / "archetypes" / i / "model",
                  "the model `relay` is not supported by this version of symplant; remove the archetype");
      entry = {{"name", text_or_empty(entry, "name")}, {"model", "constant"}, {"event", "*"}};
    }
  }

  void check_shape() {
    static const json::Schema schema(naming_schema());
    for (json::Fault& fault : schema.check(root_)) {
      reading_.faults.push_back(
          {base_.text() + fault.pointer, std::move(fault.message), fault.column, FaultKind::shape, fault.at_key});
    }
  }

  /// Calls `read(entry, pointer)` for each object of an array.
  template <class Read>
  void for_each(std::string_view key, Read&& read) {
    const Json* array = member(root_, key);
    if (array == nullptr || !array->is_array()) return;
    for (std::size_t i = 0; i < array->size(); ++i) read((*array)[i], base_ / key / i);
  }

  void read_normalise() {
    const Json* normalise = member(root_, "normalise");
    if (normalise == nullptr) return;
    name::Normalise& own = naming_.normalise;
    own.collapse = optional_flag(*normalise, "collapse").value_or(own.collapse);
    own.line_break = text_or_empty(*normalise, "line-break");
    own.camel_case = flag_member(*normalise, "camel-case");
    if (const Json* columns = member(*normalise, "columns"); columns != nullptr && columns->is_number_unsigned()) {
      own.columns = columns->get<std::uint32_t>();
    }
    own.replace = replacements_of(*normalise);
  }

  void read_fixed() {
    const Json* fixed = member(root_, "fixed");
    if (fixed == nullptr) return;
    constexpr std::array<std::pair<std::string_view, name::Level>, 3> kLevels{
        {{"line", name::Level::line}, {"process", name::Level::process}, {"device", name::Level::device}}};
    for (const auto& [key, level] : kLevels) {
      const std::string text = text_or_empty(*fixed, key);
      if (text.empty()) continue;
      description::check_text(text, base_ / "fixed" / key, faults_);
      naming_.fixed.emplace_back(level, text);
    }
  }

  void read_direction() {
    const Json* direction = member(root_, "direction");
    if (direction == nullptr) return;
    std::vector<name::Evidence>& evidence = naming_.direction.evidence;
    if (member(*direction, "evidence") != nullptr) evidence.clear();
    constexpr std::array<std::pair<std::string_view, name::Evidence>, 4> kEvidence{
        {{"address", name::Evidence::address},
         {"field", name::Evidence::field},
         {"class", name::Evidence::klass},
         {"prefix", name::Evidence::prefix}}};
    for (const std::string& text : texts_of(*direction, "evidence")) {
      const auto* found =
          std::find_if(kEvidence.begin(), kEvidence.end(), [&](const auto& one) { return one.first == text; });
      if (found != kEvidence.end()) evidence.push_back(found->second);
    }
    const std::string conflict = text_or_empty(*direction, "on-conflict");
    naming_.direction.conflict_is_error = conflict == "error";
    if (conflict != "address") return;
    const auto address = std::find(evidence.begin(), evidence.end(), name::Evidence::address);
    if (address == evidence.end()) {
      faults_.add(base_ / "direction" / "on-conflict",
                  "`evidence` does not list `address`, so it cannot decide; add it, or remove `on-conflict`",
                  FaultKind::contradiction);
    } else {
      std::rotate(evidence.begin(), address, address + 1);
    }
  }

  void read_tasks() {
    const Json* tasks = member(root_, "tasks");
    if (tasks == nullptr) return;
    name::TaskRules& own = naming_.tasks;
    own.vocabulary = optional_flag(*tasks, "vocabulary").value_or(own.vocabulary);
    own.sequence = flag_member(*tasks, "sequence");
    own.pairs = pairs_of(*tasks, "pairs");
    for (std::size_t i = 0; i < own.pairs.size(); ++i) {
      if (own.pairs[i].first != own.pairs[i].second) continue;
      faults_.add(base_ / "tasks" / "pairs" / i,
                  "a pair of two equal words; write the words of both ends of the motion", FaultKind::contradiction);
    }
    if (const Json* affixes = member(*tasks, "affixes"); affixes != nullptr) {
      own.operation_affixes = texts_of(*affixes, "operation");
      own.event_affixes = texts_of(*affixes, "event");
    }
    if (const Json* synonyms = member(*tasks, "synonyms"); synonyms != nullptr && synonyms->is_object()) {
      for (const auto& [words, canonical] : synonyms->items()) {
        if (canonical.is_string()) own.synonyms.emplace_back(words, canonical.get<std::string>());
      }
    }
    if (const auto index = optional_flag(*tasks, "sensor-index")) {
      own.sensor_index = *index ? name::SensorIndex::on : name::SensorIndex::off;
    } else if (text_or_empty(*tasks, "sensor-index") == "appended") {
      own.sensor_index = name::SensorIndex::appended;
    }
  }

  void read_links() {
    reading_.links_file = text_or_empty(root_, "links");
    for_each("links", [&](const Json& row, const Pointer& here) {
      const auto cell = [&](std::size_t index) {
        return row.is_array() && index < row.size() && row[index].is_string() ? row[index].get<std::string>()
                                                                              : std::string();
      };
      name::NamedLink link{cell(0), cell(1), cell(2)};
      const bool first = naming_.links.empty();
      naming_.links.push_back(std::move(link));
      const std::string fault = link_fault(naming_.links.back(), first);
      if (!fault.empty()) faults_.add(here, fault, FaultKind::contradiction);
    });
  }

  void read_archetypes() {
    for_each("archetypes", [&](const Json& entry, const Pointer& here) {
      name::Archetype archetype = archetype_entry(entry, here, faults_);
      const auto same = std::find_if(naming_.archetypes.begin(), naming_.archetypes.end(),
                                     [&](const name::Archetype& other) { return other.name == archetype.name; });
      if (same != naming_.archetypes.end() && !archetype.name.empty()) {
        DescriptionFault fault{(here / "name").text(),
                               ticked(archetype.name) + " is the name of two archetypes; rename one of them"};
        const auto index = static_cast<std::size_t>(same - naming_.archetypes.begin());
        fault.related = (base_ / "archetypes" / index / "name").text();
        fault.related_message = "the other archetype";
        reading_.faults.push_back(std::move(fault));
      }
      naming_.archetypes.push_back(std::move(archetype));
    });
  }

  Json& root_;
  Pointer base_;
  NamingReading& reading_;
  description::ShapeFaults faults_;
  name::Naming naming_;
};

NamingReading read(std::string_view text, std::string_view base) {
  NamingReading reading;
  json::Document document = json::parse(text);
  reading.syntax = std::move(document.faults);
  if (document.root == nullptr) return reading;
  if (!base.empty() && document.root->is_object()) document.root->emplace(kVersion, 1);
  if (auto fault = why_not(*document.root)) {
    fault->pointer.insert(0, base);
    reading.faults.push_back(std::move(*fault));
    return reading;
  }
  NamingReader(*document.root, base, reading).read();
  return reading;
}

}  // namespace

NamingReading read_naming(std::string_view text) { return read(text, {}); }

NamingReading read_inline_naming(std::string_view text, std::string_view base) { return read(text, base); }

}  // namespace symplant::naming
