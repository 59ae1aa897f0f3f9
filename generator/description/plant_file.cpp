// Reads and checks a plant.json.
#include "description/plant_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "description/json_entry.hpp"
#include "description/plant_schema.hpp"
#include "elements/alarm/entry.hpp"
#include "elements/follow/entry.hpp"
#include "elements/malfunction/entry.hpp"
#include "elements/material/entry.hpp"
#include "elements/requirement/entry.hpp"
#include "elements/scene/entry.hpp"
#include "elements/signal/entry.hpp"
#include "elements/times/entry.hpp"
#include "elements/value/entry.hpp"
#include "read/io_words.hpp"
#include "read/readers.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"
#include "text/ascii.hpp"

namespace symplant::description {
namespace {

using Json = nlohmann::json;

/// What the value of a key describes.
struct Element {
  std::string_view key;
  void (*read)(const Json& value, ShapeFaults& faults, Description& description);
};

/// The entries of an array or an object, each read by `read`; nothing of a value of another type, which has a fault.
template <class Read>
void each(const Json& value, bool is_of_type, Read read) {
  if (!is_of_type) return;
  for (const auto& [key, entry] : value.items()) read(key, entry);
}

/// Faults are reported in this order.
constexpr std::array kElements{
    Element{"follow", [](const Json& value, ShapeFaults&,
                         Description& description) { description.follow = follow_entries(value); }},
    Element{"values", [](const Json& value, ShapeFaults& faults,
                         Description& description) { description.values = value_entries(value, faults); }},
    Element{"signals", [](const Json& value, ShapeFaults& faults,
                          Description& description) { description.signals = signal_entries(value, faults); }},
    Element{"devices",
            [](const Json& value, ShapeFaults& faults, Description& description) {
              each(value, value.is_object(), [&](const std::string& path, const Json& entry) {
                description.devices.push_back(device_entry(path, entry, faults));
              });
            }},
    Element{"times", [](const Json& value, ShapeFaults& faults,
                        Description& description) { description.times = times_entries(value, faults); }},
    Element{"material", [](const Json& value, ShapeFaults& faults,
                           Description& description) { description.material = material_entry(value, faults); }},
    Element{"malfunctions",
            [](const Json& value, ShapeFaults& faults, Description& description) {
              description.malfunctions = malfunction_entries(value, faults);
            }},
    Element{"requirements",
            [](const Json& value, ShapeFaults& faults, Description& description) {
              description.requirements = requirement_entries(value, faults);
            }},
    Element{"links",
            [](const Json& value, ShapeFaults& faults, Description& description) {
              each(value, value.is_array(), [&](const std::string& index, const Json& entry) {
                description.links.push_back(link_entry(entry, Pointer("/links") / index, faults));
              });
            }},
    Element{"programs",
            [](const Json& value, ShapeFaults& faults, Description& description) {
              each(value, value.is_array(), [&](const std::string& index, const Json& entry) {
                description.programs.push_back(program_entry(entry, Pointer("/programs") / index, faults));
              });
            }},
};

class PlantFileReader {
 public:
  PlantFileReader(const Json& root, std::vector<DescriptionFault>& faults) : root_(root), faults_(faults) {}

  PlantFile read(std::string_view stem) {
    file_.name = text_or_empty(root_, "name");
    check_text(file_.name, Pointer("/name"), faults_);
    if (file_.name.empty()) file_.name = stem;
    read_lists();
    read_naming();
    read_defaults();
    read_symbol_patterns();
    for (const Element& element : kElements) {
      if (const Json* value = member(root_, element.key)) element.read(*value, faults_, file_.description);
    }
    read_check();
    read_view();
    file_.description.scene = scene_of(root_, faults_);
    return std::move(file_);
  }

 private:
  void read_lists() {
    const Json* lists = member(root_, "symbols");
    if (lists == nullptr || !lists->is_array()) return;
    for (std::size_t i = 0; i < lists->size(); ++i) {
      const Json& value = (*lists)[i];
      ListReference list;
      if (value.is_string()) {
        list.file = value.get<std::string>();
      } else {
        list = list_object(value, Pointer("/symbols") / i);
      }
      file_.symbols.push_back(std::move(list));
    }
  }

  ListReference list_object(const Json& value, const Pointer& here) {
    ListReference list;
    list.file = text_or_empty(value, "file");
    list.controller = text_or_empty(value, "controller");
    if (!list.controller.empty() && !is_controller_name(list.controller)) {
      faults_.add(here / "controller", ticked(list.controller) +
                                           " is not a valid controller name for `--link NAME=URL`; "
                                           "remove `=`, `:`, control characters and blanks at its ends");
    }
    list.prefix = text_or_empty(value, "prefix");
    check_text(list.prefix, here / "prefix", faults_);
    list.format = text_or_empty(value, "format");
    if (!list.format.empty()) check_format(list.format, here / "format");
    if (const std::string* encoding = text_member(value, "encoding"); encoding != nullptr && !encoding->empty()) {
      list.encoding = text::encoding_of_name(*encoding);
      if (!list.encoding) faults_.add(here / "encoding", no_such_encoding(*encoding));
    }
    read_columns(value, here / "columns", list.columns);
    if (const std::string* words = text_member(value, "cio"); words != nullptr) {
      auto ranges = read::io_words_of(*words);
      if (!ranges) faults_.add(here / "cio", ranges.error());
      if (ranges) list.io_words = std::move(*ranges);
    }
    if (const Json* part = member(value, "part"); part != nullptr && part->is_number_unsigned()) {
      list.part = part->get<std::size_t>();
    }
    const std::string xy = text_or_empty(value, "xy");
    if (xy == "hex") list.xy = address::Radix::hexadecimal;
    if (xy == "octal") list.xy = address::Radix::octal;
    return list;
  }

  void read_columns(const Json& value, const Pointer& here, read::ColumnMap& columns) {
    const Json* given = member(value, "columns");
    if (given == nullptr || !given->is_object()) return;
    for (const auto& [word, column] : given->items()) {
      if (!column.is_string() && !column.is_number_unsigned()) continue;  // already reported
      auto next = read::with_column(columns, word, column.is_string() ? column.get<std::string>() : column.dump());
      if (next) {
        columns = std::move(*next);
      } else {
        faults_.add(here / word, next.error());
      }
    }
  }

  void check_format(const std::string& format, const Pointer& here) {
    std::string known;
    tables::NearestName nearest(format);
    for (const read::ReaderInfo* reader : read::readers()) {
      if (reader->name == format) return;
      nearest.offer(reader->name);
      known += (known.empty() ? "" : ", ") + ticked(reader->name);
    }
    faults_.add(here, "unknown list format " + ticked(format) + "; choose one of " + known +
                          (nearest.name().empty() ? "" : "; did you mean " + ticked(nearest.name()) + "?"));
  }

  void read_naming() {
    const Json* naming = member(root_, "naming");
    if (naming == nullptr) return;
    if (naming->is_string()) file_.naming = naming->get<std::string>();
    if (naming->is_object()) file_.naming_text = naming->dump();
  }

  void read_defaults() {
    const Json* defaults = member(root_, "defaults");
    if (defaults == nullptr) return;
    const Pointer here("/defaults");
    Defaults& own = file_.description.defaults;
    own.travel = time_member(*defaults, "travel", here, faults_).value_or(own.travel);
    own.dwell = time_member(*defaults, "dwell", here, faults_).value_or(own.dwell);
    own.actuation = actuation_member(*defaults).value_or(own.actuation);
    own.sequence = sequence_member(*defaults).value_or(own.sequence);
    own.overrun = overrun_member(*defaults, here, faults_).value_or(own.overrun);
    own.step = step_member(*defaults, "step", here, faults_).value_or(own.step);
  }

  void read_symbol_patterns() {
    file_.description.inverted = texts_member(root_, "inverted");
    file_.description.plain = texts_member(root_, "plain");
    file_.description.alarms = alarms_of(root_);
    if (const Json* io = member(root_, "io")) {
      file_.description.io = {texts_member(*io, "events"), texts_member(*io, "operations")};
    }
  }

  void read_view() {
    const Json* view = member(root_, "view");
    if (view == nullptr || !view->is_object()) return;
    for (const auto& [device, entry] : view->items()) {
      GivenView given{device};
      const Json* const x = member(entry, "x");
      const Json* const y = member(entry, "y");
      if (x != nullptr && x->is_number_unsigned()) given.x = x->get<std::int32_t>();
      if (y != nullptr && y->is_number_unsigned()) given.y = y->get<std::int32_t>();
      if ((x == nullptr) != (y == nullptr)) {
        faults_.add(Pointer("/view") / std::string_view(device), "a place has `x` and `y`; add the other one");
      }
      given.group = text_or_empty(entry, "group");
      check_text(given.group, Pointer("/view") / std::string_view(device), faults_);
      given.shape = tables::shape_of_name(text_or_empty(entry, "shape"));
      file_.description.view.push_back(std::move(given));
    }
  }

  void read_check() {
    const Json* check = member(root_, "check");
    if (check == nullptr) return;
    if (const Json* ignore = member(*check, "ignore"); ignore != nullptr && ignore->is_array()) {
      for (const Json& one : *ignore) {
        const std::string finding = text_or_empty(one, "finding");
        file_.description.check.ignore.push_back({text_or_empty(one, "rule"),
                                                  text_or_empty(one, finding.empty() ? "symbols" : "of"),
                                                  text_or_empty(one, "why"), text_or_empty(one, "until"), finding});
      }
    }
    if (const Json* severity = member(*check, "severity"); severity != nullptr && severity->is_object()) {
      for (const auto& [rule, value] : severity->items()) {
        if (value.is_string()) file_.description.check.severity.emplace_back(rule, value.get<std::string>());
      }
    }
    if (const Json* conventions = member(*check, "conventions"); conventions != nullptr && conventions->is_array()) {
      for (const Json& one : *conventions) file_.description.check.conventions.push_back(convention_of(one));
    }
  }

  static GivenCheck::Convention convention_of(const Json& entry) {
    GivenCheck::Convention convention;
    convention.types = texts_member(entry, "types");
    convention.symbols = text_or_empty(entry, "symbols");
    if (const std::string side = text_or_empty(entry, "side"); !side.empty())
      convention.operation = side == "operation";
    convention.prefix = texts_member(entry, "prefix");
    convention.suffix = texts_member(entry, "suffix");
    convention.letters = text_or_empty(entry, "letters");
    const auto number = [&](const char* key) {
      const Json* const given = member(entry, key);
      return given != nullptr && given->is_number_unsigned() ? given->get<std::uint32_t>() : 0;
    };
    convention.least = number("least");
    convention.most = number("most");
    return convention;
  }

  const Json& root_;
  ShapeFaults faults_;
  PlantFile file_;
};

/// A plant has lists; which file names them is open.
void require_lists(const Json& root, std::vector<DescriptionFault>& faults) {
  if (root.contains("symbols")) return;
  faults.push_back({"", "the key `symbols` is missing here; it holds an array of symbol lists", 0, FaultKind::shape});
  faults.back().at_key = true;
}

/// Makes the paths of programs that an included file names relative to the plant.json.
void find_programs(std::vector<ProgramDescription>& programs, const PlantSource& source) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(source.path()).parent_path();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const fs::path own = source.folder((Pointer("/programs") / i / "file").text());
    if (own == folder) continue;
    const fs::path between = own.lexically_relative(folder);
    programs[i].file = ((between.empty() ? own : between) / programs[i].file).lexically_normal().generic_string();
  }
}

}  // namespace

PlantFileReading read_plant_file(std::shared_ptr<const text::SourceFile> plant, std::string_view stem,
                                 const OpenFile& open) {
  WholeDescription whole = read_whole(std::move(plant), open);
  PlantFileReading reading;
  reading.source = std::move(whole.source);
  reading.complete = whole.complete;
  reading.syntax = std::move(whole.files.front().syntax);
  reading.faults = std::move(whole.files.front().faults);
  std::copy_if(std::make_move_iterator(whole.files.begin() + 1), std::make_move_iterator(whole.files.end()),
               std::back_inserter(reading.included), [](const FileFaults& file) { return !file.sound(); });
  if (whole.root == nullptr) return reading;
  if (reading.complete && reading.included.empty()) require_lists(*whole.root, reading.faults);
  reading.file = PlantFileReader(*whole.root, reading.faults).read(stem);
  sort_as_written(reading.file->description.material, *reading.source);
  sort_as_written(reading.file->description.values, "/values", *reading.source);
  find_programs(reading.file->description.programs, *reading.source);
  return reading;
}

PlantFileReading read_plant_file(std::string_view text, std::string_view stem) {
  return read_plant_file(std::make_shared<text::SourceFile>("plant.json", std::string(text)), stem,
                         [](const std::string&) {
                           return OpenedFile{nullptr, "a description without a file cannot include others"};
                         });
}

std::string no_such_encoding(std::string_view name) {
  std::string known;
  tables::NearestName nearest(name);
  for (const std::string_view each : text::encoding_names()) {
    nearest.offer(each);
    known.append(known.empty() ? "`" : ", `").append(each).append("`");
  }
  return "unknown encoding " + ticked(name) + "; choose one of " + known +
         (nearest.name().empty() ? "" : "; did you mean " + ticked(nearest.name()) + "?");
}

ConventionsReading read_conventions(std::string_view text) {
  constexpr std::string_view kConventionsKey = "/check/conventions";
  ConventionsReading reading;
  json::Document document = json::parse(text);
  reading.syntax = std::move(document.faults);
  if (document.root == nullptr) return reading;
  if (!document.root->is_array()) {
    reading.faults.push_back(
        {"", "this is no list of naming conventions, as `conventions` of a plant.json", 0, FaultKind::shape});
    return reading;
  }
  // As part of a plant description, so that there is one schema.
  Json plant{{"symplant", 1}, {"symbols", {"-"}}, {"check", {{"conventions", std::move(*document.root)}}}};
  for (json::Fault& fault : json::Schema(plant_schema()).check(plant)) {
    reading.faults.push_back(
        {std::move(fault.pointer), std::move(fault.message), fault.column, FaultKind::shape, fault.at_key});
  }
  PlantFile file = PlantFileReader(plant, reading.faults).read("");
  for (DescriptionFault& fault : reading.faults) fault.pointer = fault.pointer.substr(kConventionsKey.size());
  reading.conventions = std::move(file.description.check.conventions);
  return reading;
}

bool is_plant_file(std::string_view path, std::string_view bytes) {
  const auto ends = [&](std::string_view ending) {
    return path.size() > ending.size() && text::equal_ignoring_case(path.substr(path.size() - ending.size()), ending);
  };
  if (ends(".json") || ends(".jsonc")) return true;
  // Skips byte order marks, blanks and the zero bytes of UTF-16.
  const std::size_t first = bytes.find_first_not_of(std::string_view("\xEF\xBB\xBF\xFE\xFF\0 \t\r\n", 10));
  return first != std::string_view::npos && bytes[first] == '{';
}

}  // namespace symplant::description
