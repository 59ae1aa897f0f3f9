// Reads a plant.json and the files that it includes.
#include "description/include.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "description/json_entry.hpp"
#include "description/merge.hpp"
#include "description/plant_schema.hpp"
#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"

namespace symplant::description {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A chain of more includes is a mistake.
constexpr std::size_t kMostNested = 32;
constexpr std::string_view kInclude = "include";

/// Another kind of JSON file, recognized by one of its keys.
struct OtherFile {
  std::string_view key;
  std::string_view words;
};
constexpr std::array kOtherFiles{
    OtherFile{"symplant-scenario", "this is a scenario; give it to `symplant run PLANT --scenario`"},
    OtherFile{"symplant-trace", "this is a trace of a run, not a plant description"},
    OtherFile{"symplant-diagnostics", "this is output of `symplant check --format json`, not a plant description"},
    OtherFile{"symplant-model", "this is output of `symplant model --format json`, not a plant description"},
    OtherFile{"symplant-naming", "this is a naming rule; give it to `--naming`, next to a plant or a list"},
    OtherFile{"$id", "this looks like a JSON Schema, not a plant description"},
    OtherFile{"definitions", "this looks like a JSON Schema, not a plant description"},
    OtherFile{"dependencies", "this looks like the package.json of a JavaScript package, not a plant description"},
    OtherFile{"devDependencies", "this looks like the package.json of a JavaScript package, not a plant description"},
    OtherFile{"scripts", "this looks like the package.json of a JavaScript package, not a plant description"},
    OtherFile{"compilerOptions", "this looks like the tsconfig.json of TypeScript, not a plant description"},
    OtherFile{"configurePresets", "this looks like the CMakePresets.json of CMake, not a plant description"},
};

/// Why a value is not a plant description of this version; nothing if it may be one.
std::optional<DescriptionFault> why_none(const Json& root) {
  const auto fault = [](std::string pointer, std::string message, bool at_key = false) {
    DescriptionFault found{std::move(pointer), std::move(message), 0, FaultKind::shape};
    found.at_key = at_key;
    return found;
  };
  if (!root.is_object()) {
    return fault("", "this is not an object; a plant description is an object with `\"symplant\": 1` and `symbols`");
  }
  if (const Json* version = member(root, "symplant"); version != nullptr) {
    if (!version->is_number_integer() || *version == 1) return std::nullopt;
    if (*version > 1) {
      return fault("/symplant", "this is version " + version->dump() +
                                    " of the format, but this symplant reads version 1; use a newer symplant");
    }
    return fault("/symplant", "unknown format version " + version->dump() + "; write 1");
  }
  for (const OtherFile& other : kOtherFiles) {
    if (root.contains(other.key)) return fault("/" + std::string(other.key), std::string(other.words), true);
  }
  for (const std::string_view own : {"symbols", "devices", "material", "requirements", "times", "include"}) {
    if (root.contains(own)) return std::nullopt;  // the schema check reports what is missing
  }
  return fault("", "this is JSON, but not a plant description, which has `\"symplant\": 1` and `symbols`");
}

/// What a file gives, with all that it includes.
struct Included {
  Json value;
  Origin origin;
};

class IncludeReader {
 public:
  explicit IncludeReader(const OpenFile& open) : open_(open), schema_(plant_schema()) {}

  WholeDescription read(std::shared_ptr<const text::SourceFile> plant) {
    const std::string path = fs::path(plant->path()).lexically_normal().generic_string();
    std::optional<Included> all = read_file(path, std::move(plant));
    if (all) {
      whole_.root = std::make_unique<Json>(std::move(all->value));
      whole_.source = std::make_shared<const PlantSource>(std::move(sources_), std::move(all->origin));
    } else {
      whole_.source = std::make_shared<const PlantSource>(std::move(sources_), Origin());
    }
    return std::move(whole_);
  }

 private:
  /// Nothing if the file is not a plant description of this version.
  std::optional<Included> read_file(const std::string& path, std::shared_ptr<const text::SourceFile> source) {
    const std::size_t file = sources_.size();
    sources_.push_back(source);
    json::Document document = json::parse(source->text());
    whole_.files.push_back({std::move(source), std::move(document.faults), {}});
    if (document.root == nullptr) return std::nullopt;
    if (auto fault = why_none(*document.root)) {
      whole_.files[file].faults.push_back(std::move(*fault));
      return std::nullopt;
    }
    for (json::Fault& fault : schema_.check(*document.root)) {
      whole_.files[file].faults.push_back(
          {std::move(fault.pointer), std::move(fault.message), fault.column, FaultKind::shape, fault.at_key});
    }
    Included all{std::move(*document.root), {file, {}}};
    reading_.push_back(path);
    include_all(all, path, file);
    reading_.pop_back();
    return all;
  }

  /// Merges the files that a file includes into it: the last one wins.
  void include_all(Included& into, const std::string& path, std::size_t file) {
    const Json* const names = member(into.value, kInclude);
    if (names == nullptr || !names->is_array()) return;
    std::vector<const Included*> included;
    std::vector<std::string> seen;
    for (std::size_t i = 0; i < names->size(); ++i) {
      const auto* const name = (*names)[i].get_ptr<const std::string*>();
      if (name == nullptr || name->empty()) continue;  // a fault of its form
      std::string at = (fs::path(path).parent_path() / *name).lexically_normal().generic_string();
      if (std::find(seen.begin(), seen.end(), at) != seen.end()) {
        add_fault(file, i, ticked(*name) + " is included twice; remove one of the two");
        continue;
      }
      const Included* const one = include(*name, at, file, i);
      seen.push_back(std::move(at));
      if (one != nullptr) included.push_back(one);
    }
    if (included.empty()) return;
    if (schema_json_.is_null()) schema_json_ = Json::parse(plant_schema());
    std::for_each(included.rbegin(), included.rend(), [&](const Included* one) {
      merge({into.value, into.origin}, one->value, one->origin, schema_json_);
    });
  }

  /// Null, and a fault, if the file cannot be included.
  const Included* include(const std::string& name, const std::string& at, std::size_t file, std::size_t index) {
    if (std::find(reading_.begin(), reading_.end(), at) != reading_.end()) {
      add_fault(file, index, ticked(name) + " includes itself; remove one of the includes");
      return nullptr;
    }
    if (reading_.size() > kMostNested) {
      add_fault(file, index,
                "more than " + std::to_string(kMostNested) + " files include each other in a chain; remove some");
      return nullptr;
    }
    const auto [known, added] = known_.try_emplace(at);
    if (!added) return known->second ? &*known->second : nullptr;
    OpenedFile opened = open_(at);
    if (opened.source == nullptr) {
      whole_.complete = false;
      if (!opened.why.empty()) add_fault(file, index, std::move(opened.why));
      return nullptr;
    }
    std::optional<Included> one = read_file(at, std::move(opened.source));
    if (one) {
      // They concern the file only.
      for (const std::string_view key : {"$schema", "symplant", "include"}) one->value.erase(std::string(key));
    }
    // Reading may have added others: `known` is still valid, as a map keeps its nodes.
    known->second = std::move(one);
    return known->second ? &*known->second : nullptr;
  }

  void add_fault(std::size_t file, std::size_t index, std::string message) {
    whole_.files[file].faults.push_back({json::child("/include", index), std::move(message), 0, FaultKind::shape});
  }

  const OpenFile& open_;
  const json::Schema schema_;
  Json schema_json_;  ///< null until files are merged
  WholeDescription whole_;
  std::vector<std::shared_ptr<const text::SourceFile>> sources_;
  std::vector<std::string> reading_;                      ///< paths: each includes the next
  std::map<std::string, std::optional<Included>> known_;  ///< by path
};

}  // namespace

WholeDescription::WholeDescription() = default;
WholeDescription::WholeDescription(WholeDescription&&) noexcept = default;
WholeDescription::~WholeDescription() = default;

WholeDescription read_whole(std::shared_ptr<const text::SourceFile> plant, const OpenFile& open) {
  return IncludeReader(open).read(std::move(plant));
}

}  // namespace symplant::description
