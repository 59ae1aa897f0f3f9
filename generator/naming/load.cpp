// Loads a naming rule with its links.
#include "naming/load.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "description/description_rules.hpp"
#include "description/faults.hpp"
#include "naming/links_file.hpp"
#include "naming/naming_file.hpp"
#include "naming/profiles.hpp"
#include "naming/rules.hpp"
#include "naming/rules/naming_contradiction.hpp"
#include "naming/rules/naming_schema.hpp"
#include "read/loading.hpp"
#include "read/rules/cannot_read_file.hpp"
#include "symplant/json/location.hpp"

namespace symplant::naming {
namespace {

namespace fs = std::filesystem;

using description::DescriptionFault;
using description::FaultKind;

const diag::RuleInfo& rule_of_fault(FaultKind kind) {
  return kind == FaultKind::shape ? kNamingSchema : kNamingContradiction;
}

class NamingLoader {
 public:
  NamingLoader(const NamingReference& reference, const base::FileSystem& files, diag::Diagnostics& diagnostics)
      : reference_(reference), files_(files), diagnostics_(diagnostics), errors_(errors()) {}

  std::shared_ptr<const LoadedNaming> load() {
    NamingReading reading = read();
    if (!reading.naming) return nullptr;
    if (!reading.links_file.empty()) read_links(reading);
    std::vector<name::NamingFault> faults;
    loaded_.rule = name::CompiledNaming::compile(std::move(*reading.naming), faults);
    if (has_shape(reading)) report(faults);  // else a fault may be only the consequence of another
    if (errors() != errors_ || loaded_.rule == nullptr) return nullptr;
    return std::make_shared<const LoadedNaming>(std::move(loaded_));
  }

 private:
  /// Whether the rule fits its format.
  static bool has_shape(const NamingReading& reading) {
    return reading.syntax.empty() &&
           std::none_of(reading.faults.begin(), reading.faults.end(),
                        [](const DescriptionFault& fault) { return fault.kind == FaultKind::shape; });
  }

  std::size_t errors() const { return diagnostics_.count(diag::Severity::error); }

  /// Reads the rule and reports its faults.
  NamingReading read() {
    NamingReading reading;
    if (reference_.file.empty()) {
      loaded_.source = reference_.where.source;
      loaded_.shown = loaded_.source->path();
      loaded_.pointer = reference_.pointer;
      reading = read_inline_naming(reference_.inline_text, reference_.pointer);
    } else if (reference_.file.starts_with('@')) {
      const Profile* profile = find_profile(reference_.file);
      if (profile == nullptr) {
        diagnostics_.add(kNamingContradiction, no_such_profile(reference_.file), reference_.where);
        return reading;
      }
      loaded_.shown = reference_.file;
      loaded_.source = std::make_shared<text::SourceFile>(reference_.file, std::string(profile->text()));
      reading = read_naming(loaded_.source->text());
    } else {
      loaded_.shown = reference_.file;
      loaded_.source = read_file(reference_.file, "save it as UTF-8");
      if (loaded_.source == nullptr) return reading;
      reading = read_naming(loaded_.source->text());
    }
    description::add_findings(loaded_.source, reading.syntax, diagnostics_, kNamingSchema);
    description::add_findings(loaded_.source, reading.faults, diagnostics_, &rule_of_fault);
    return reading;
  }

  /// The text of a file; null if it cannot be read.
  std::shared_ptr<const text::SourceFile> read_file(const std::string& file, std::string_view remedy) {
    const std::string path = (fs::path(reference_.folder) / file).lexically_normal().generic_string();
    auto bytes = files_.read(path);
    if (!bytes) {
      diagnostics_.add(read::kCannotReadFile, bytes.error().message, read::whole_file(path));
      return nullptr;
    }
    auto text = read::decode_file(path, std::move(*bytes), diagnostics_, remedy);
    if (!text) return nullptr;
    loaded_.files.push_back(path);
    return std::make_shared<text::SourceFile>(path, std::move(text->text));
  }

  void read_links(NamingReading& reading) {
    fs::path folder;
    if (!reference_.file.empty()) folder = fs::path(reference_.file).parent_path();
    loaded_.links_source = read_file((folder / reading.links_file).generic_string(), "save it as CSV in UTF-8");
    if (loaded_.links_source == nullptr) return;
    LinksFile file = read_links_file(loaded_.links_source, diagnostics_);
    reading.naming->links = std::move(file.links);
    loaded_.link_rows = std::move(file.rows);
  }

  void report(std::vector<name::NamingFault>& faults) {
    std::vector<DescriptionFault> described;
    described.reserve(faults.size());
    for (name::NamingFault& fault : faults) {
      described.push_back({loaded_.pointer + fault.pointer, std::move(fault.message), fault.column});
    }
    description::add_findings(loaded_.source, described, diagnostics_, &rule_of_fault);
  }

  const NamingReference& reference_;
  const base::FileSystem& files_;
  diag::Diagnostics& diagnostics_;
  std::size_t errors_;
  LoadedNaming loaded_;
};

}  // namespace

diag::Location LoadedNaming::location(const std::string& value) const {
  const json::Fault wanted{pointer + value, {}, 0, false};
  const json::Span span = json::spans(source->text(), {&wanted, 1}).front();
  return {source, {span.begin, span.end}};
}

diag::Location LoadedNaming::link_location(std::size_t link) const {
  if (links_source != nullptr) return {links_source, link_rows[link]};
  return location("/links/" + std::to_string(link));
}

const std::shared_ptr<const name::CompiledNaming>& strict_naming() {
  static const std::shared_ptr<const name::CompiledNaming> strict = [] {
    NamingReading reading = read_naming(find_profile("strict")->text());
    std::vector<name::NamingFault> faults;
    return name::CompiledNaming::compile(std::move(*reading.naming), faults);
  }();
  return strict;
}

std::shared_ptr<const LoadedNaming> load_naming(const NamingReference& reference, const base::FileSystem& files,
                                                diag::Diagnostics& diagnostics) {
  return NamingLoader(reference, files, diagnostics).load();
}

}  // namespace symplant::naming
