// Text with keys and lists into text.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "base/text_source.hpp"
#include "emit/row_writer.hpp"

namespace symplant::emit {

/// What a template is filled with: every decision taken, every text encoded for where it goes.
struct View {
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<View>> lists;
  std::map<std::string, RowSource> rows = {};  ///< texts too large to be held; none of them empty
};

struct Template {
  std::string_view name;  ///< the file that it makes: "types_gen.hpp"
  std::string_view text;
};

/// The tool's own.
std::span<const Template> embedded_templates();

struct TemplateError {
  std::size_t line = 0;
  std::string message;
};

/// Fills in a template (mustache: keys, lists, comments). A key that is not in kKeys for this template is an error.
/// The text may be asked for as long as the rows' sources can be.
base::Result<base::TextSource, TemplateError> render(const Template& text, const View& view);

}  // namespace symplant::emit
