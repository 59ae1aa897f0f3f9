// Reading the files of a plant.
#include "app/read_inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/list_files.hpp"
#include "description/description_rules.hpp"
#include "elements/malfunction/file.hpp"
#include "elements/scene/file.hpp"
#include "naming/load.hpp"
#include "read/loading.hpp"
#include "symplant/json/location.hpp"
#include "symplant/tables/file_name.hpp"

namespace symplant::app {
namespace {

namespace fs = std::filesystem;

bool is_blank(std::string_view bytes) { return bytes.find_first_not_of(" \t\r\n") == bytes.npos; }

class InputReader {
 public:
  InputReader(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
              diag::Diagnostics& diagnostics)
      : options_(options), files_(files), progress_(progress), diagnostics_(diagnostics) {}

  std::optional<Inputs> read() {
    progress_.stage("reading " + options_.plant);
    inputs_.name = fs::path(options_.plant).stem().generic_string();
    auto bytes = files_.read(options_.plant);
    const bool described = bytes && description::is_plant_file(options_.plant, *bytes);
    if (described || (bytes && !options_.times.empty())) {
      const bool has_read = options_.times.empty() ? read_description(options_.plant, std::move(*bytes))
                                                   : read_description(options_.plant + "+times", with_times(described));
      return has_read && read_more() ? std::optional(std::move(inputs_)) : std::nullopt;
    }
    read::ReadOptions how = options_.read;
    how.xy = options_.xy;
    auto table = bytes ? read::read_symbol_list(options_.plant, std::move(*bytes), how, diagnostics_)
                       : read::read_symbol_list(options_.plant, how, files_, diagnostics_);
    if (!table) return std::nullopt;
    add_list(std::move(*table), {}, options_.xy);
    inputs_.io = options_.io;
    naming::NamingReference given;
    given.file = options_.naming;
    if (!read_naming(given) || !read_more()) return std::nullopt;
    return std::move(inputs_);
  }

 private:
  /// False if the naming rule has a fault; true without one.
  bool read_naming(const naming::NamingReference& reference) {
    if (reference.empty()) return true;
    if (!reference.file.empty()) progress_.stage("reading " + reference.file);
    inputs_.naming_parts = naming::load_naming(reference, files_, diagnostics_);
    if (inputs_.naming_parts == nullptr) return false;
    inputs_.naming = inputs_.naming_parts->rule;
    return true;
  }

  /// What the option gives, else what the plant.json gives.
  naming::NamingReference naming_of(description::PlantFile& file) const {
    naming::NamingReference reference;
    reference.file = options_.naming;
    if (!reference.file.empty()) return reference;
    const json::Fault here{"/naming", {}, 0, false};
    reference.where = inputs_.source->location(inputs_.source->places({&here, 1}).front());
    reference.folder = inputs_.source->folder(here.pointer);
    reference.file = std::move(file.naming);
    reference.inline_text = std::move(file.naming_text);
    reference.pointer = inputs_.source->origin(here.pointer).pointer;
    return reference;
  }

  /// What the option gives, else what the plant.json gives.
  void take_io(const description::GivenIo& given) {
    inputs_.io = options_.io;
    if (!inputs_.io.empty()) return;
    inputs_.io.add(given.events, name::Direction::event, "/io/events");
    inputs_.io.add(given.operations, name::Direction::operation, "/io/operations");
  }

  void add_list(read::SymbolTable table, const description::ListReference& reference,
                std::optional<address::Radix> xy) {
    inputs_.lists.push_back(
        {std::make_shared<read::SymbolTable>(std::move(table)), reference.controller, reference.prefix, xy});
  }

  /// A description in the plant's folder that includes the plant, or has it as its list, and then the times.
  std::string with_times(bool described) const {
    const fs::path plant(options_.plant);
    const fs::path times(options_.times);
    const bool is_relative = times.is_relative() && !plant.parent_path().empty();
    std::string from_plant =
        is_relative ? times.lexically_relative(plant.parent_path()).generic_string() : times.generic_string();
    if (from_plant.empty())
      from_plant = fs::absolute(times).lexically_normal().generic_string();  // one of them is absolute
    nlohmann::json root = {{"symplant", 1}, {"include", nlohmann::json::array()}};
    if (!described) root["symbols"] = {plant.filename().generic_string()};
    if (described) root["include"].push_back(plant.filename().generic_string());
    root["include"].push_back(from_plant);
    return root.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }

  bool read_description(const std::string& file, std::string bytes) {
    if (is_blank(bytes)) {
      description::add_empty_file(file, diagnostics_);
      return false;
    }
    auto text = read::decode_file(file, std::move(bytes), diagnostics_, "save it as UTF-8");
    if (!text) return false;
    description::PlantFileReading reading =
        description::read_plant_file(std::make_shared<text::SourceFile>(file, std::move(text->text)), inputs_.name,
                                     [this](const std::string& path) { return open_included(path); });
    inputs_.source = std::move(reading.source);
    inputs_.readable = reading.sound();
    description::add_findings(inputs_.source->files().front(), reading.syntax, diagnostics_);
    for (const description::FileFaults& included : reading.included) {
      description::add_findings(included.file, included.syntax, diagnostics_);
      description::add_findings(included.file, included.faults, diagnostics_);
    }
    inputs_.faults = std::move(reading.faults);
    if (reading.file) check_model_of(reading.file->description.scene);
    const bool has_lists = reading.file && read_lists(reading.file->symbols);
    const bool has_naming = reading.file && read_naming(naming_of(*reading.file));
    if (has_lists && has_naming) {
      inputs_.name = reading.file->name;
      take_io(reading.file->description.io);
      inputs_.description = std::make_shared<const description::Description>(std::move(reading.file->description));
      return true;
    }
    description::add_findings(*inputs_.source, inputs_.faults, diagnostics_);
    return false;
  }

  /// The model may be in the folder of --panel-files instead, which is known at run time only.
  void check_model_of(const description::GivenScene& scene) {
    if (!tables::is_model_name(scene.model)) return;
    const std::string path = (fs::path(inputs_.source->folder("/view3d/model")) / scene.model).generic_string();
    if (!files_.exists(path)) return;
    progress_.stage("reading " + path);
    const auto bytes = files_.read(path);
    if (bytes) description::check_model(*bytes, scene, inputs_.faults);
  }

  description::OpenedFile open_included(const std::string& path) {
    progress_.stage("reading " + path);
    auto bytes = files_.read(path);
    if (!bytes) return {nullptr, bytes.error().message};
    if (is_blank(*bytes)) {
      description::add_empty_file(path, diagnostics_);
      return {};
    }
    auto text = read::decode_file(path, std::move(*bytes), diagnostics_, "save it as UTF-8");
    if (!text) return {};
    return {std::make_shared<text::SourceFile>(path, std::move(text->text)), {}};
  }

  /// Adds what other files have to the description. False if one cannot be read.
  bool read_more() { return read_more_malfunctions() && read_more_conventions(); }

  bool read_more_malfunctions() {
    if (inputs_.description != nullptr) inputs_.own_malfunctions = inputs_.description->malfunctions.size();
    if (options_.malfunctions.empty()) return true;
    inputs_.malfunctions = read_text(options_.malfunctions);
    if (inputs_.malfunctions == nullptr) return false;
    description::MalfunctionsReading reading = description::read_malfunctions(inputs_.malfunctions->text());
    if (!is_valid(inputs_.malfunctions, reading)) return false;
    extend_description([&](description::Description& all) {
      all.malfunctions.insert(all.malfunctions.end(), std::make_move_iterator(reading.malfunctions.begin()),
                              std::make_move_iterator(reading.malfunctions.end()));
    });
    return true;
  }

  bool read_more_conventions() {
    if (options_.conventions.empty()) return true;
    const auto source = read_text(options_.conventions);
    if (source == nullptr) return false;
    description::ConventionsReading reading = description::read_conventions(source->text());
    if (!is_valid(source, reading)) return false;
    extend_description([&](description::Description& all) {
      std::vector<description::GivenCheck::Convention>& own = all.check.conventions;
      own.insert(own.end(), reading.conventions.begin(), reading.conventions.end());
    });
    return true;
  }

  /// The text of a file that is given next to the plant; null, with an error, if it cannot be read.
  std::shared_ptr<const text::SourceFile> read_text(const std::string& path) {
    auto bytes = files_.read(path);
    if (!bytes) {
      diagnostics_.add(description::rule_of(description::FaultKind::shape), bytes.error().message,
                       read::whole_file(path));
      return nullptr;
    }
    auto text = read::decode_file(path, std::move(*bytes), diagnostics_, "save it as UTF-8");
    if (!text) return nullptr;
    return std::make_shared<text::SourceFile>(path, std::move(text->text));
  }

  /// Reports the faults of a part of a description.
  template <class Reading>
  bool is_valid(const std::shared_ptr<const text::SourceFile>& source, const Reading& reading) {
    description::add_findings(source, reading.syntax, diagnostics_);
    description::add_findings(source, reading.faults, diagnostics_);
    return reading.syntax.empty() && reading.faults.empty();
  }

  template <class Change>
  void extend_description(Change change) {
    description::Description all = inputs_.description != nullptr ? *inputs_.description : description::Description();
    change(all);
    inputs_.description = std::make_shared<const description::Description>(std::move(all));
  }

  /// False if a list cannot be read, or there is no list.
  bool read_lists(const std::vector<description::ListReference>& lists) {
    bool all = !lists.empty();
    for (const description::ListReference& reference : lists) {
      if (reference.file.empty()) {  // already reported
        all = false;
        continue;
      }
      const std::string here = "/symbols/" + std::to_string(&reference - lists.data());
      const fs::path named = (fs::path(inputs_.source->folder(here)) / reference.file).lexically_normal();
      const std::vector<std::string> paths = list_files(named.generic_string(), files_);
      if (paths.empty()) {
        inputs_.faults.push_back(
            {here, "no file matches `" + reference.file + "`; correct the path, which is relative to this file"});
        all = false;
      }
      for (const std::string& path : paths) all = read_list(path, reference) && all;
    }
    if (all) name_by_controller();
    return all;
  }

  bool read_list(const std::string& path, const description::ListReference& reference) {
    progress_.stage("reading " + path);
    read::ReadOptions how = options_.read;
    how.described = true;
    if (!reference.format.empty()) how.input_format = reference.format;
    if (reference.encoding) how.encoding = reference.encoding;
    if (!reference.columns.empty()) how.columns = reference.columns;
    if (!reference.io_words.ranges.empty()) how.io_words = reference.io_words;
    how.part = reference.part;
    how.xy = reference.xy ? reference.xy : options_.xy;
    auto table = read::read_symbol_list(path, how, files_, diagnostics_);
    if (table) add_list(std::move(*table), reference, how.xy);
    return table.has_value();
  }

  /// With several controllers, a symbol that has its address as its name is named `PLC2:X0`: names are unique.
  void name_by_controller() {
    const auto is_first = [&](const ReadList& list) { return list.controller == inputs_.lists.front().controller; };
    if (std::all_of(inputs_.lists.begin(), inputs_.lists.end(), is_first)) return;
    for (ReadList& list : inputs_.lists) {
      for (read::ListRow& row : list.table->rows) {
        if (list.controller.empty() || !row.is_named_by_address()) continue;
        row.name = list.table->arena.emplace_back(list.controller + ":" + std::string(row.name));
      }
    }
  }

  const CompileOptions& options_;
  const base::FileSystem& files_;
  Progress& progress_;
  diag::Diagnostics& diagnostics_;
  Inputs inputs_;
};

}  // namespace

std::optional<Inputs> read_inputs(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                  diag::Diagnostics& diagnostics) {
  return InputReader(options, files, progress, diagnostics).read();
}

}  // namespace symplant::app
