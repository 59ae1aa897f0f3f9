// symplant compare with two sessions at the panel.
#include "app/commands/compare_sessions.hpp"

#include <array>
#include <fstream>
#include <optional>
#include <ostream>
#include <string_view>
#include <utility>

#include "app/options.hpp"
#include "compare/session.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

void reject(Context& context, const std::string& message) {
  context.err << "error: " << diag::visible(message) << "\n";
  context.exit_code = host::kBadInput;
}

std::optional<compare::Session> session_of(const std::string& path, Context& context) {
  const auto text = context.files.read(path);
  if (!text) {
    reject(context, text.error().message);
    return std::nullopt;
  }
  if (!compare::is_session(*text)) {
    reject(context, "`" + path + "` is not a session at the panel; a session is compared with a session");
    return std::nullopt;
  }
  compare::ReadSession read = compare::read_session(*text, path);
  if (!read.error.empty()) {
    reject(context, read.error);
    return std::nullopt;
  }
  return std::move(read.session);
}

}  // namespace

bool is_session_file(const std::string& path) {
  std::array<char, 256> begin{};
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), begin.size());
  return compare::is_session(std::string_view(begin.data(), static_cast<std::size_t>(file.gcount())));
}

void compare_session_files(const std::string& expert, const std::string& trainee, bool as_page,
                           const std::string& output, Context& context) {
  const auto ours = session_of(expert, context);
  if (!ours) return;
  const auto theirs = session_of(trainee, context);
  if (!theirs) return;
  const compare::SessionComparison comparison = compare::compare_sessions(*ours, *theirs);
  if (!comparison.error.empty()) return reject(context, comparison.error);
  if (!comparison.warning.empty()) context.err << "warning: " << diag::visible(comparison.warning) << "\n";
  const base::TextSource text = [&](base::TextSink& sink) {
    as_page ? compare::write_html(comparison, sink) : compare::write_text(comparison, sink);
  };
  if (!write_result(context, output, text, {expert, trainee})) return;
  if (!output.empty()) context.out << diag::visible(compare::summary(comparison)) << "\n";
}

}  // namespace symplant::app
