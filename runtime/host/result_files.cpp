// The result files of a run. A failed run never leaves a result file of an earlier run.
#include "symplant/host/result_files.hpp"

#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <streambuf>
#include <system_error>
#include <utility>

#include "symplant/host/exit_codes.hpp"
#include "symplant/host/files_apart.hpp"
#include "symplant/trace/junit_xml.hpp"
#include "symplant/trace/utilization_text.hpp"

namespace symplant::host {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBeginning = 512;    ///< bytes of a file in which its kind shows
constexpr std::size_t kMostErrors = 2000;  ///< bytes of messages in a JUnit file

bool is_regular(const std::string& path) {
  std::error_code unknown;
  return !is_standard_output(path) && fs::is_regular_file(path, unknown);
}

bool is_result(const fs::path& path, std::string_view mark) {
  std::array<char, kBeginning> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const std::string_view text(bytes.data(), static_cast<std::size_t>(file.gcount()));
  return text.empty() || text.find(mark) != std::string_view::npos;
}

/// If it has the mark of its kind; every file has an empty mark. Also through a link, which stays. A folder that
/// permits no removal may permit an empty file.
void remove_result(const std::string& path, std::string_view mark) {
  if (!is_regular(path)) return;
  std::error_code error;
  const fs::path file = fs::canonical(path, error);
  if (error || !is_result(file, mark)) return;
  if (!fs::remove(file, error)) fs::resize_file(file, 0, error);
}

/// Passes everything to the buffer of a stream, and keeps the lines that report an error.
class KeptErrors final : public std::streambuf {
 public:
  explicit KeptErrors(std::ostream& stream) : stream_(stream), to_(stream.rdbuf(this)) {}
  KeptErrors(const KeptErrors&) = delete;
  KeptErrors& operator=(const KeptErrors&) = delete;
  ~KeptErrors() override { stream_.rdbuf(to_); }

  /// The errors so far, one a line.
  std::string text() const { return errors_; }

 private:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    keep(traits_type::to_char_type(c));
    return to_->sputc(traits_type::to_char_type(c));
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    for (const char c : std::string_view(text, static_cast<std::size_t>(size))) keep(c);
    return to_->sputn(text, size);
  }
  int sync() override { return to_->pubsync(); }

  /// Without the colors of a terminal.
  void keep(char c) {
    if (colors_ || c == '\x1B') {
      colors_ = c != 'm';
      return;
    }
    if (c != '\n') {
      if (line_.size() < kMostErrors) line_ += c;
      return;
    }
    if (line_.find("error: ") != std::string::npos && errors_.size() + line_.size() < kMostErrors) {
      errors_ += (errors_.empty() ? "" : "\n") + line_;
    }
    line_.clear();
  }

  std::ostream& stream_;
  std::streambuf* to_;
  std::string line_;     ///< the present one
  bool colors_ = false;  ///< within a color
  std::string errors_;
};

std::string failed_suite(std::string_view plant, std::string_view error) {
  trace::TestCase failed{"run", 0, {}, {}};
  failed.error = error.empty() ? "the run failed, see its messages" : error;
  return trace::junit_xml(plant, {&failed, 1}, 0);
}

bool check_open(const trace::OutputFile& file, std::ostream& err) {
  if (file.error().empty()) return true;
  err << "error: " << file.error() << "\n";
  return false;
}

}  // namespace

ResultFiles::ResultFiles(const RunOptions& options, std::ostream& out) : options_(options), out_(out) {
  remove_results();
}

void ResultFiles::remove_results() const {
  remove_result(options_.junit, replaces_ ? "" : "<testsuite");
  remove_result(options_.findings, replaces_ ? "" : "\"finding\":");
  const bool table = options_.stats.ends_with(".csv");
  remove_result(options_.stats, replaces_ ? "" : table ? trace::kUtilizationHead : "\"symplant-stats\":");
}

void ResultFiles::replace_unless_among(std::span<const std::string_view> inputs) {
  std::ostringstream unheard;
  replaces_ = files_are_apart(options_, inputs, unheard);
}

trace::OutputFile ResultFiles::file(const char* what, const std::string& path) const {
  return is_standard_output(path) ? trace::OutputFile(what, out_) : trace::OutputFile(what, path);
}

bool ResultFiles::open(std::string_view plant, std::ostream& err) {
  bool well = true;
  if (!options_.junit.empty()) {
    junit_.emplace(file("JUnit file", options_.junit));
    if (is_regular(options_.junit)) put_junit(failed_suite(plant, "the run has not ended"));
    well = check_open(*junit_, err);
  }
  if (!options_.stats.empty()) well = check_open(stats_.emplace(file("statistics", options_.stats)), err) && well;
  return well;
}

/// Instead of what a regular file has; a pipe stays open, since its reader would leave.
void ResultFiles::put_junit(std::string_view text) {
  if (is_regular(options_.junit)) junit_.emplace(file("JUnit file", options_.junit));
  junit_->put(text);
  junit_->flush();
}

std::string ResultFiles::write_stats(std::string_view text) {
  if (!stats_) return "";
  stats_->put(text);
  stats_->flush();
  return stats_->error();
}

std::string ResultFiles::write_junit(std::string_view text) {
  written_ = true;
  if (!junit_) return "";
  put_junit(text);
  return junit_->error();
}

void ResultFiles::fail(std::string_view plant, std::string_view error) {
  if (written_) return;
  stats_.reset();
  if (is_regular(options_.junit)) junit_.reset();  // it is made again; a pipe stays open
  remove_results();
  if (options_.junit.empty()) return;
  std::error_code unknown;
  const bool is_free = is_standard_output(options_.junit) || !fs::exists(options_.junit, unknown);
  if (!junit_ && is_free) junit_.emplace(file("JUnit file", options_.junit));
  if (junit_) put_junit(failed_suite(plant, error));
}

int with_results(const RunOptions& options, std::string_view plant, std::ostream& out, std::ostream& err,
                 const std::function<int(ResultFiles&)>& body) {
  ResultFiles files(options, out);
  KeptErrors errors(err);
  int code = kEnvironment;
  try {
    code = body(files);
  } catch (const std::exception& error) {  // out of memory, for example
    err << "error: " << error.what() << "\n";
  }
  if (code == kBadInput || code == kEnvironment) files.fail(plant, errors.text());
  return code;
}

void fail_unread_run(const RunOptions& options, std::span<const std::string_view> inputs, std::string_view plant,
                     std::string_view error, std::ostream& out) {
  ResultFiles files(options, out);
  files.replace_unless_among(inputs);
  files.fail(plant, error);
}

}  // namespace symplant::host
