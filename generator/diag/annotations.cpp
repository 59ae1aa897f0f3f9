// Findings as annotations of build servers.
#include "diag/annotations.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "diag/fingerprint.hpp"
#include "diag/importance.hpp"
#include "diag/visible_text.hpp"

namespace symplant::diag {
namespace {

std::string_view without_folder(std::string_view path, std::string_view folder) {
  if (path.starts_with("./")) path.remove_prefix(2);
  const bool inside = !folder.empty() && path.size() > folder.size() && path.starts_with(folder) &&
                      (folder.back() == '/' || path[folder.size()] == '/');
  if (!inside) return path;
  return path.substr(folder.size() + (folder.back() == '/' ? 0 : 1));
}

/// The data of a workflow command, or with `property` a property's value.
std::string command_text(std::string_view text, bool property) {
  std::string escaped;
  for (const char c : visible(text)) {
    if (c == '%') {
      escaped += "%25";
    } else if (c == '\r') {
      escaped += "%0D";
    } else if (c == '\n') {
      escaped += "%0A";
    } else if (c == ':' && property) {
      escaped += "%3A";
    } else if (c == ',' && property) {
      escaped += "%2C";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string_view github_level(Severity severity) {
  return severity == Severity::note ? "notice" : severity_name(severity);
}

std::string title(const RuleInfo& rule) { return std::string(rule.id) + " " + std::string(rule.slug); }

class GithubRenderer {
 public:
  explicit GithubRenderer(std::string_view folder) : folder_(folder) {}

  void add(const Diagnostic& finding) {
    const auto level = static_cast<std::size_t>(finding.severity);
    // The last notice counts the rest.
    const std::size_t most = kMostGithubAnnotations - (finding.severity == Severity::note ? 1 : 0);
    if (shown_[level] == most) {
      ++left_[level];
      return;
    }
    ++shown_[level];
    text_.append("::").append(github_level(finding.severity)).append(" ");
    if (finding.location.source) {
      const text::SourceFile& file = *finding.location.source;
      text_ += "file=" + command_text(without_folder(file.path(), folder_), true) + ",";
      if (!file.text().empty()) {
        const text::Position position = file.position(finding.location.span.begin);
        text_ += "line=" + std::to_string(position.line) + ",col=" + std::to_string(position.column) + ",";
      }
    }
    text_ += "title=" + command_text(title(*finding.rule), true) + "::" + command_text(finding.message, false) + "\n";
  }

  std::string take() {
    std::string rest;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
      const std::size_t left = left_[static_cast<std::size_t>(severity)];
      if (left == 0) continue;
      rest.append(rest.empty() ? "" : ", ").append(std::to_string(left)).append(" more ");
      rest.append(severity_name(severity)).append(left == 1 ? "" : "s");
    }
    if (!rest.empty()) text_ += "::notice title=symplant check::" + rest + ": run symplant check --verbose\n";
    return std::move(text_);
  }

 private:
  std::string_view folder_;
  std::array<std::size_t, 3> shown_{};
  std::array<std::size_t, 3> left_{};
  std::string text_;
};

std::string_view gitlab_severity(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "critical";
    case Severity::warning:
      return "major";
    case Severity::note:
      break;
  }
  return "info";
}

}  // namespace

std::string render_github(std::span<const Report> reports, std::string_view folder) {
  GithubRenderer renderer(folder);
  for (const Report& report : reports) {
    for (const Diagnostic* finding : by_importance(report.findings.all())) renderer.add(*finding);
  }
  return renderer.take();
}

std::string render_gitlab(std::span<const Report> reports, std::string_view folder) {
  Fingerprints fingerprints;
  std::string text = "[";
  for (const Report& report : reports) {
    for (const Diagnostic& finding : report.findings.all()) {
      const text::SourceFile* file = finding.location.source.get();
      const std::string path(without_folder(file == nullptr ? std::string_view(report.plant) : file->path(), folder));
      const bool has_line = file != nullptr && !file->text().empty();
      const std::size_t line = has_line ? file->position(finding.location.span.begin).line : 1;
      const nlohmann::ordered_json issue{{"description", visible(finding.message)},
                                         {"check_name", title(*finding.rule)},
                                         {"fingerprint", fingerprints.next(finding, path)},
                                         {"severity", gitlab_severity(finding.severity)},
                                         {"location", {{"path", path}, {"lines", {{"begin", line}}}}}};
      text += text.size() == 1 ? "\n  " : ",\n  ";
      text += issue.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }
  }
  return text += text.size() == 1 ? "]\n" : "\n]\n";
}

}  // namespace symplant::diag
