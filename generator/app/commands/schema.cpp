// symplant schema: prints the JSON Schema of a format.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <ostream>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "description/plant_schema.hpp"
#include "naming/naming_file.hpp"
#include "suite/suite.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/scenario/read_scenario.hpp"
#include "view/model_json.hpp"

namespace symplant::app {
namespace {

struct Schema {
  std::string_view format;
  std::string_view (*text)();
};
constexpr std::array kSchemas{
    Schema{"plant", &description::plant_schema}, Schema{"scenario", &scenario::scenario_schema},
    Schema{"naming", &naming::naming_schema},    Schema{"model", &view::model_schema},
    Schema{"suite", &suite::suite_schema},
};

/// "plant, scenario, naming, model or suite".
std::string formats_text() {
  std::string text;
  for (std::size_t i = 0; i < kSchemas.size(); ++i) {
    text.append(i == 0 ? "" : i + 1 < kSchemas.size() ? ", " : " or ").append(kSchemas[i].format);
  }
  return text;
}

}  // namespace

void add_schema(CLI::App& app, Context& context) {
  struct Options {
    std::string format;
    std::string output;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of a format, for editors");
  command->add_option("FORMAT", options->format, formats_text())->required();
  command->add_option("-o,--output", options->output, "write it to this file")->type_name("FILE");
  command->footer("Examples:\n  symplant schema plant\n  symplant schema plant -o plant.schema.json");
  command->callback([options, &context] {
    const auto* const found = std::find_if(kSchemas.begin(), kSchemas.end(),
                                           [&](const Schema& schema) { return schema.format == options->format; });
    if (found == kSchemas.end()) {
      context.err << "error: `" << options->format << "` is not a format with a schema: write " << formats_text()
                  << "\n";
      context.exit_code = host::kBadInput;
    } else {
      write_result(context, options->output, base::whole(std::string(found->text())), {});
    }
  });
}

}  // namespace symplant::app
