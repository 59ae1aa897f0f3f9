// Adds the commands to the option tree. Each command has a source file.
#pragma once

#include <string_view>

#include "app/context.hpp"

namespace CLI {
class App;
}

namespace symplant::app {

void add_campaign(CLI::App& app, Context& context);
void add_check(CLI::App& app, Context& context);
void add_explain(CLI::App& app, Context& context);
void add_rules(CLI::App& app, Context& context);
void add_generate(CLI::App& app, Context& context);
void add_infer(CLI::App& app, Context& context);
void add_naming(CLI::App& app, Context& context);
void add_init(CLI::App& app, Context& context);
void add_model(CLI::App& app, Context& context);
void add_map(CLI::App& app, Context& context);
void add_doctor(CLI::App& app, Context& context);
void add_convert(CLI::App& app, Context& context);
void add_diff(CLI::App& app, Context& context);
void add_compare(CLI::App& app, Context& context);
void add_learn(CLI::App& app, Context& context);
void add_test(CLI::App& app, Context& context);
void add_watch(CLI::App& app, Context& context);
void add_run(CLI::App& app, Context& context);
/// Call if the command line cannot be parsed. For the command `run`, it writes the result files of a failed run.
void fail_run(const CLI::App& app, std::string_view error, const Context& context);
void add_program(CLI::App& app, Context& context);
void add_record(CLI::App& app, Context& context);
void add_show(CLI::App& app, Context& context);
void add_schema(CLI::App& app, Context& context);
void add_completion(CLI::App& app, Context& context);
void add_man(CLI::App& app, Context& context);

}  // namespace symplant::app
