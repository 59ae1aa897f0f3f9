// The file of `--baseline` and `--write-baseline`.
#include "app/baseline_file.hpp"

#include <fmt/format.h>

#include "app/options.hpp"
#include "diag/text.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {

bool BaselineFile::open() {
  if (path_.empty()) return true;
  exists_ = context_.files.exists(path_);
  if (!exists_ && writes_) {
    baseline_.emplace();
    return true;
  }
  auto bytes = context_.files.read(path_);
  if (!bytes) {
    context_.err << "error: " << diag::visible(bytes.error().message)
                 << (exists_ ? "\n" : "; write the first baseline with `--write-baseline`\n");
    context_.exit_code = host::kBadInput;
    return false;
  }
  auto baseline = findings::Baseline::read(std::make_shared<text::SourceFile>(path_, std::move(*bytes)));
  if (!baseline) {
    context_.err << diag::render_text(baseline.error().all(), {.colour = context_.colour_err});
    context_.exit_code = host::kBadInput;
    return false;
  }
  baseline_ = std::move(*baseline);
  return true;
}

void BaselineFile::close(diag::Diagnostics& findings, const std::vector<std::string>& inputs) {
  if (!baseline_) return;
  if (!writes_) {
    baseline_->report_stale(findings);
    return;
  }
  const std::size_t size = baseline_->size();
  if (!write_result(context_, path_, base::whole(baseline_->text()), inputs)) return;
  context_.err << fmt::format("{}: {} finding{} {}\n", diag::visible(path_), size, size == 1 ? "" : "s",
                              exists_ ? "kept; to add new ones, delete the file first" : "written");
}

}  // namespace symplant::app
