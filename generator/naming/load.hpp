// Loads a naming rule with its links, from a file, a ready profile or a value of plant.json.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/file_system.hpp"
#include "diag/diagnostic.hpp"
#include "name/compiled_naming.hpp"
#include "text/source_file.hpp"

namespace symplant::naming {

/// What names a naming rule.
struct NamingReference {
  std::string file;         ///< the path of a naming.json, or `@` and the name of a profile
  std::string inline_text;  ///< without `file`: the rule as JSON, a value in the file at `where`
  std::string folder;       ///< the folder that paths are relative to; empty: the current one
  diag::Location where;     ///< of the reference; without a source: an option of the command line
  std::string pointer;      ///< of the value of `inline_text`, such as "/naming"

  bool empty() const { return file.empty() && inline_text.empty(); }
};

/// A naming rule and where its parts are, for findings.
struct LoadedNaming {
  std::shared_ptr<const name::CompiledNaming> rule;
  std::string shown;                                     ///< for messages: its file, `@PROFILE` or the plant.json
  std::shared_ptr<const text::SourceFile> source;        ///< the text with the rule
  std::string pointer;                                   ///< of the rule in `source`; empty: the whole text is the rule
  std::shared_ptr<const text::SourceFile> links_source;  ///< null: the links are in `source`
  std::vector<text::Span> link_rows;                     ///< one for each link; empty without `links_source`
  std::vector<std::string> files;                        ///< the read files, plant.json not included

  /// The location of a value of the rule, such as "/rules/0". One pass over the text.
  diag::Location location(const std::string& value) const;
  /// The location of the link at an index of Naming::links.
  diag::Location link_location(std::size_t link) const;
};

/// The profile `strict`, which applies where no rule is given: LINE_PROC_DEV_I|O_TASK (Park, Wang and Park, "Symbol
/// naming rules for plant model generation in the PLC simulation"). Compiled once; thread-safe.
const std::shared_ptr<const name::CompiledNaming>& strict_naming();

/// Null if a finding of severity error was added. O(text).
std::shared_ptr<const LoadedNaming> load_naming(const NamingReference& reference, const base::FileSystem& files,
                                                diag::Diagnostics& diagnostics);

}  // namespace symplant::naming
