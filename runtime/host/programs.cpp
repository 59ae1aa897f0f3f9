// Selects and opens the PLC programs of a run.
#include "symplant/host/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/words.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using trace::seconds;

std::optional<std::uint32_t> controller_named(const tables::PlantTables& tables, std::string_view name) {
  const auto names = tables::split_names(tables.controller_names);
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (tables::equal_ignoring_case(names[i], name)) return i;
  }
  return std::nullopt;
}

std::string controller_name(const tables::PlantTables& tables, std::uint32_t controller) {
  const auto names = tables::split_names(tables.controller_names);
  return controller < names.size() ? std::string(names[controller]) : std::string();
}

/// `PLC1=cell.so`, or `cell.so` if the plant has one controller; a text is the error.
std::variant<ProgramChoice, std::string> parse(const std::string& text, const tables::PlantTables& tables) {
  const auto names = tables::split_names(tables.controller_names);
  const std::size_t equals = text.find('=');
  if (equals != text.npos) {
    if (const auto controller = controller_named(tables, text.substr(0, equals))) {
      return ProgramChoice{text.substr(equals + 1), {.controller = *controller}};
    }
  }
  if (names.size() <= 1) return ProgramChoice{text, {}};
  std::string known;
  for (const std::string_view name : names) known += fmt::format("{}`{}`", known.empty() ? "" : ", ", name);
  return fmt::format("`--program {}` does not name its controller: write `--program {}={}`; the controllers are {}",
                     text, names.front(), equals == text.npos ? text : text.substr(equals + 1), known);
}

bool has_link(const RunOptions& options, const tables::PlantTables& tables, std::uint32_t controller) {
  return std::any_of(options.links.begin(), options.links.end(), [&](const std::string& text) {
    const std::string named = link::parse_request(text).controller;
    return named.empty() || controller_named(tables, named) == controller;
  });
}

std::variant<ProgramChoices, std::string> own_programs(const PlantProgram& program, const RunOptions& options) {
  ProgramChoices choices;
  for (const DefaultProgram& own : program.programs) {
    const auto controller =
        own.controller.empty() ? std::optional<std::uint32_t>(0) : controller_named(program.tables, own.controller);
    if (!controller) return fmt::format("the plant has no controller `{}` for its program", own.controller);
    if (has_link(options, program.tables, *controller)) continue;
    ProgramChoice choice{std::string(own.file), {.controller = *controller, .on_loss = own.on_loss}};
    if (own.period != 0) choice.options.period = own.period;
    if (own.delay != 0) choice.options.delay = own.delay;
    for (const std::string_view pattern : own.ignore) choice.options.ignore.emplace_back(pattern);
    choices.push_back(std::move(choice));
  }
  return choices;
}

}  // namespace

std::variant<ProgramChoices, std::string> programs_of(const PlantProgram& program, const RunOptions& options) {
  auto own = own_programs(program, options);
  auto* const described = std::get_if<ProgramChoices>(&own);
  if (described == nullptr) return own;
  ProgramChoices choices;
  for (const std::string& text : options.programs) {
    auto parsed = parse(text, program.tables);
    if (auto* const error = std::get_if<std::string>(&parsed)) return std::move(*error);
    auto choice = std::get<ProgramChoice>(std::move(parsed));
    // What the plant says of the program of this controller holds for another file, too.
    for (const ProgramChoice& other : *described) {
      if (other.options.controller == choice.options.controller) choice.options = other.options;
    }
    choices.push_back(std::move(choice));
  }
  if (options.programs.empty()) choices = std::move(*described);
  std::set<std::uint32_t> controllers;
  for (ProgramChoice& choice : choices) {
    if (!controllers.insert(choice.options.controller).second) {
      const std::string name = controller_name(program.tables, choice.options.controller);
      return fmt::format("{} has two programs: remove one of them",
                         name.empty() ? "the controller" : "the controller `" + name + "`");
    }
    if (options.scan) choice.options.period = options.scan;
    if (options.scan_delay) choice.options.delay = options.scan_delay;
  }
  // So that the order of the command line does not show.
  std::sort(choices.begin(), choices.end(),
            [](const ProgramChoice& a, const ProgramChoice& b) { return a.options.controller < b.options.controller; });
  return choices;
}

std::vector<bool> controllers_of(const ProgramChoices& programs) {
  std::vector<bool> controllers;
  for (const ProgramChoice& choice : programs) {
    controllers.resize(std::max<std::size_t>(controllers.size(), choice.options.controller + 1));
    controllers[choice.options.controller] = true;
  }
  return controllers;
}

std::string link_beside_program(const ProgramChoices& programs, const LinkChoices& links,
                                const tables::PlantTables& tables) {
  for (const ProgramChoice& choice : programs) {
    for (const link::LinkChoice& link : links) {
      if (link.controller != choice.options.controller && link.controller != link::kAllControllers) continue;
      const std::string name = controller_name(tables, choice.options.controller);
      return fmt::format("{} has the program `{}` and the link `{}`: remove one of them",
                         name.empty() ? "the controller" : "the controller `" + name + "`", choice.file, link.url);
    }
  }
  return {};
}

int open_programs(const ProgramChoices& choices, const trace::PlantNames& names, Programs& programs,
                  std::ostream& err) {
  int code = kGood;
  std::set<std::filesystem::path> open;
  for (const ProgramChoice& choice : choices) {
    std::error_code unknown;
    const auto file = std::filesystem::canonical(choice.file, unknown);
    auto opened = program::Library::open(choice.file, !unknown && !open.insert(file).second);
    if (const auto* const error = std::get_if<program::LoadError>(&opened)) {
      err << "error: " << error->message << "\n";
      code = std::max(code, error->environment ? kEnvironment : kBadInput);
      continue;
    }
    OpenProgram one{choice, std::get<std::unique_ptr<program::Library>>(std::move(opened)), {}, {}, {}};
    const symplant_program& program = one.loaded->program();
    one.times = program::times_of(program, choice.options);
    one.binding = program::bind(program, names, choice.options.controller, choice.options.ignore);
    one.digest = program::file_digest(choice.file);
    std::vector<std::string> errors = one.binding.errors;
    if (!one.times.error.empty()) errors.push_back(one.times.error);
    for (const std::string& error : errors) {
      err << fmt::format("error: program `{}`: {}\n", shown(choice.file), shown(error));
      code = std::max<int>(code, kBadInput);
    }
    programs.push_back(std::move(one));
  }
  return code;
}

void add_written(const Programs& programs, const tables::PlantTables& tables, std::vector<bool>& carried) {
  for (const OpenProgram& one : programs) {
    const std::vector<bool> written = program::written_symbols(one.loaded->program(), one.binding, tables);
    for (std::size_t i = 0; i < written.size(); ++i) {
      if (written[i]) carried[i] = true;
    }
  }
}

std::vector<trace::PlantNames::Program> named_programs(const Programs& programs, const tables::PlantTables& tables) {
  std::vector<trace::PlantNames::Program> named;
  for (const OpenProgram& one : programs) {
    named.push_back({one.loaded->program().name, one.choice.options.controller, one.digest, one.times.period,
                     one.times.delay, program::written_symbols(one.loaded->program(), one.binding, tables)});
  }
  return named;
}

std::string program_lines(std::span<const OpenProgram> programs, const tables::PlantTables& tables) {
  std::string text;
  for (const OpenProgram& one : programs) {
    const symplant_program& program = one.loaded->program();
    const auto bound = [&](bool writes) {
      std::size_t count = 0;
      for (std::uint32_t i = 0; i < program.count; ++i) {
        count += (program.variables[i].writes != 0) == writes && one.binding.symbols[i] != tables::kNone
                     ? std::size_t{1}
                     : 0;
      }
      return count;
    };
    const std::string controller = controller_name(tables, one.choice.options.controller);
    text += fmt::format("program `{}` ({}{}): reads {} and writes {}, a scan every {}{}{}\n", shown(program.name),
                        controller.empty() ? "" : shown(controller) + "=", shown(one.choice.file),
                        plural(bound(false), "event"), plural(bound(true), "operation"), seconds(one.times.period),
                        one.times.delay == one.times.period ? "" : ", its outputs after " + seconds(one.times.delay),
                        one.binding.unwritten == 0
                            ? ""
                            : fmt::format("; {} it does not write", plural(one.binding.unwritten, "operation")));
  }
  return text;
}

std::string refused_with_programs(const RunOptions& options, bool restores) {
  if (!options.save.empty()) return "`--save` is not possible with a program, whose state cannot be saved: remove it";
  if (!options.resume.empty()) return "`--resume` is not possible with a program, whose state was not saved: remove it";
  if (restores)
    return "a scenario that begins with `restore` is not possible with a program, whose state was not saved";
  if (options.rt_check)
    return "`--rt-check` is not possible with a program, which may use heap and system calls: remove it";
  return {};
}

}  // namespace symplant::host
