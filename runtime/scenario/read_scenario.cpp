// Reads a scenario file against a plant.
#include "symplant/scenario/read_scenario.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"
#include "symplant/scenario/step_reader.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/pattern.hpp"

namespace symplant::scenario {
namespace {

using Json = nlohmann::json;

constexpr const char* kVersionKey = "symplant-scenario";

/// The fault of a file that is not a scenario of this version; empty for a scenario.
std::optional<json::Fault> another_file(const Json& root) {
  if (!root.is_object()) return std::nullopt;
  if (const auto version = root.find(kVersionKey); version != root.end()) {
    if (!version->is_number_integer() || *version == 1) return std::nullopt;
    return json::Fault{json::child("", kVersionKey),
                       "this scenario has version " + version->dump() + " of the format, this symplant reads version 1",
                       0, false};
  }
  if (!root.contains("symplant")) return std::nullopt;
  return json::Fault{json::child("", "symplant"),
                     "this is a plant description, not a scenario; give it as the plant to run", 0, true};
}

std::vector<json::Fault> shape_faults(const Json& root) {
  if (auto other = another_file(root)) return {std::move(*other)};
  return json::Schema(scenario_schema()).check(root);
}

constexpr std::size_t kDeepestRepeats = 8;

/// Reads the steps of a scenario and of the files that it includes.
class FileReader {
 public:
  FileReader(const trace::PlantNames& names, const std::vector<bool>& carried, const OpenFile& open)
      : names_(names), reader_(names, carried), open_(open) {
    scenario_.files.emplace_back();
  }

  ReadScenario run(std::string_view text) {
    read_file("", text);
    if (result_.faults.empty()) {
      std::stable_sort(scenario_.repeats.begin(), scenario_.repeats.end(), [](const Repeat& a, const Repeat& b) {
        return a.end != b.end ? a.end < b.end : a.begin > b.begin;
      });
      result_.scenario = std::move(scenario_);
    }
    return std::move(result_);
  }

 private:
  /// One file. Its steps are added with the index of the file in Scenario::files.
  void read_file(const std::string& path, std::string_view text) {
    FileFaults found{path, path.empty() ? std::string() : std::string(text), {}};
    json::Document document = json::parse(text);
    found.faults = std::move(document.faults);
    if (document.root != nullptr) {
      const Json& root = *document.root;
      std::vector<json::Fault> faults = shape_faults(root);
      if (root.is_object() && root.contains("steps") && root["steps"].is_array() && !another_file(root)) {
        const std::size_t first = scenario_.steps.size();
        const std::uint32_t before = std::exchange(file_, static_cast<std::uint32_t>(scenario_.files.size() - 1));
        std::vector<json::Fault> of_including = std::exchange(reader_.faults, {});
        std::vector<std::string> indexes = std::exchange(pointers_, {});
        if (path.empty() && faults.empty() && root.contains("exercise")) read_exercise(root["exercise"]);
        read_steps(root["steps"], "/steps", broken_steps(faults));
        std::move(reader_.faults.begin(), reader_.faults.end(), std::back_inserter(faults));
        find_lines(text, first);
        reader_.faults = std::move(of_including);
        pointers_ = std::move(indexes);
        file_ = before;
      }
      for (json::Placed& placed : json::locate(text, faults)) found.faults.push_back(std::move(placed));
    }
    if (found.faults.empty()) return;
    std::stable_sort(found.faults.begin(), found.faults.end(),
                     [](const json::Placed& a, const json::Placed& b) { return a.span.begin < b.span.begin; });
    result_.faults.push_back(std::move(found));
  }

  /// The indexes of steps that do not match the schema and cannot be read.
  static std::set<std::size_t> broken_steps(std::span<const json::Fault> faults) {
    std::set<std::size_t> broken;
    for (const json::Fault& fault : faults) {
      constexpr std::string_view kSteps = "/steps/";
      if (!fault.pointer.starts_with(kSteps)) continue;
      std::size_t step = 0;
      const char* const begin = fault.pointer.data() + kSteps.size();
      if (std::from_chars(begin, fault.pointer.data() + fault.pointer.size(), step).ec == std::errc())
        broken.insert(step);
    }
    return broken;
  }

  void read_steps(const Json& steps, const std::string& pointer, const std::set<std::size_t>& broken) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (!broken.contains(i)) read_step(steps[i], json::child(pointer, i));
    }
  }

  void read_exercise(const Json& value) {
    Exercise exercise{value["title"].get<std::string>(), value.value("text", "")};
    if (const auto score = value.find("score"); score != value.end()) {
      exercise.for_expectation = score->value("expect", std::int64_t{0});
      exercise.for_violation = score->value("requirement violated", std::int64_t{0});
      if (const auto within = score->find("within"); within != score->end()) {
        exercise.for_time = (*within)["points"].get<std::int64_t>();
        exercise.within = reader_.read_duration((*within)["time"], "/exercise/score/within/time").value_or(0);
      }
    }
    if (const auto allow = value.find("allow"); allow != value.end()) {
      exercise.allow = allow->get<std::vector<std::string>>();
      check_allowed(*exercise.allow);
    }
    exercise.shows_score = value.value("show_score", false);
    scenario_.exercise = std::move(exercise);
  }

  /// The names of all that a trainee could operate.
  std::vector<std::string> operable_names() const {
    const tables::PlantTables& tables = names_.tables();
    std::vector<std::string> all;
    for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) all.emplace_back(names_.symbol(i));
    for (std::uint32_t i = 0; i < tables.units.size(); ++i) all.emplace_back(names_.unit(i));
    for (std::uint32_t i = 0; i < tables.values.outputs; ++i) all.push_back(names_.output(i));
    for (std::uint32_t i = 0; i < tables.material.locations(); ++i) all.emplace_back(names_.location(i));
    return all;
  }

  /// A name or pattern of `allow` that matches nothing is a mistake.
  void check_allowed(const std::vector<std::string>& patterns) {
    const std::vector<std::string> names = operable_names();
    for (std::size_t i = 0; i < patterns.size(); ++i) {
      const std::string& pattern = patterns[i];
      tables::NearestName nearest(pattern);
      const bool any = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        nearest.offer(name);
        return tables::matches_pattern(name, pattern);
      });
      if (any) continue;
      std::string message = "`" + pattern + "` matches no symbol, device, value, track or place";
      if (!nearest.name().empty()) message += "; did you mean `" + std::string(nearest.name()) + "`?";
      add(json::child("/exercise/allow", i), std::move(message));
    }
  }

  void read_restore(const Json& step, const std::string& pointer) {
    const std::string at = json::child(pointer, "restore");
    if (step.size() > 1) {
      add(pointer, "`restore` is a step without other keys; write them as the next step");
    } else if (!scenario_.steps.empty() || depth_ != 0 || !including_.empty() || !scenario_.restore.empty()) {
      add(at, "a run starts from one snapshot; write `restore` as the first step of the scenario", true);
    } else {
      scenario_.restore = step["restore"].get<std::string>();
    }
  }

  void read_step(const Json& step, const std::string& pointer) {
    const bool repeats = step.contains("repeat") || step.contains("steps");
    if (step.contains("restore")) {
      read_restore(step, pointer);
    } else if (!repeats && !step.contains("include")) {
      scenario_.steps.push_back(reader_.read(step, pointer));
      scenario_.steps.back().file = file_;
      pointers_.push_back(pointer);
    } else if (alone(step, pointer, repeats)) {
      repeats ? read_repeat(step, pointer) : include(step["include"].get<std::string>(), pointer);
    }
  }

  /// False, and a fault, if a repeat or an include has further keys, or a repeat lacks one of its two.
  bool alone(const Json& step, const std::string& pointer, bool repeats) {
    for (const auto& [key, value] : step.items()) {
      if (repeats ? key == "repeat" || key == "steps" : key == "include") continue;
      add(json::child(pointer, key),
          "`" + key + "` is not allowed next to `" + (repeats ? "repeat" : "include") +
              "`; write it as a step before or after",
          true);
      return false;
    }
    if (!repeats) return true;
    for (const char* key : {"repeat", "steps"}) {
      if (step.contains(key)) continue;
      add(pointer, std::string("a repeat needs `repeat`, the number of turns, and `steps`; add `") + key + "`");
      return false;
    }
    return true;
  }

  void read_repeat(const Json& step, const std::string& pointer) {
    if (depth_ == kDeepestRepeats) {
      add(json::child(pointer, "repeat"), "this is the ninth repeat within another; nest at most 8", true);
      return;
    }
    const auto turns = step["repeat"].get<std::uint32_t>();
    const auto begin = static_cast<std::uint32_t>(scenario_.steps.size());
    ++depth_;
    reader_.begin_repeat();
    read_steps(step["steps"], json::child(pointer, "steps"), {});
    reader_.end_repeat(turns);
    --depth_;
    const auto end = static_cast<std::uint32_t>(scenario_.steps.size());
    if (end != begin) scenario_.repeats.push_back({begin, end, turns});
  }

  void include(const std::string& name, const std::string& pointer) {
    const std::string at = json::child(pointer, "include");
    const std::filesystem::path folder =
        std::filesystem::path(including_.empty() ? "" : including_.back()).parent_path();
    const std::string path = (folder / name).lexically_normal().generic_string();
    if (std::find(including_.begin(), including_.end(), path) != including_.end()) {
      add(at, "`" + name + "` includes itself; remove one of the includes");
      return;
    }
    const OpenedFile opened =
        open_ ? open_(path) : OpenedFile{std::nullopt, "a scenario without a file cannot include others"};
    if (!opened.text) {
      add(at, "cannot read `" + name + "`: " + opened.error);
      return;
    }
    scenario_.files.push_back(path);
    including_.push_back(path);
    read_file(path, *opened.text);
    including_.pop_back();
  }

  void add(const std::string& pointer, std::string message, bool at_key = false) {
    reader_.faults.push_back({pointer, std::move(message), 0, at_key});
  }

  /// Sets the lines of this file's steps, from `first` on: locates them as faults, in one pass over the text.
  void find_lines(std::string_view text, std::size_t first) {
    std::vector<json::Fault> indexes(pointers_.size());
    for (std::size_t i = 0; i < indexes.size(); ++i) indexes[i].pointer = pointers_[i];
    const std::vector<json::Span> spans = json::spans(text, indexes);
    std::size_t line = 1;
    std::size_t at = 0;
    std::size_t step = first;
    for (const json::Span& span : spans) {
      const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
      const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::max(at, span.begin));
      line += static_cast<std::size_t>(std::count(begin, end, '\n'));
      at = std::max(at, span.begin);
      while (scenario_.steps[step].file != file_) ++step;  // of a file included before
      scenario_.steps[step++].line = line;
    }
  }

  const trace::PlantNames& names_;
  StepReader reader_;
  const OpenFile& open_;
  Scenario scenario_;
  ReadScenario result_;
  std::vector<std::string> pointers_;   ///< of this file's steps
  std::vector<std::string> including_;  ///< the paths of the files that are being read
  std::uint32_t file_ = 0;              ///< that is being read
  std::size_t depth_ = 0;               ///< of repeats
};

}  // namespace

ReadScenario read_scenario(std::string_view text, const trace::PlantNames& names, const std::vector<bool>& carried,
                           const OpenFile& open) {
  return FileReader(names, carried, open).run(text);
}

}  // namespace symplant::scenario
