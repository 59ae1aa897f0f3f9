// Fills templates: a text with keys and lists becomes a text.
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

/// The values for a template. All decisions are made, and every text is encoded for its context.
struct View {
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<View>> lists;
  std::map<std::string, RowSource> rows = {};  ///< texts too large to keep in memory; none of them empty
};

struct Template {
  std::string_view name;  ///< the file that it generates: "types_gen.hpp"
  std::string_view text;
};

/// The built-in templates.
std::span<const Template> embedded_templates();

struct TemplateError {
  std::size_t line = 0;
  std::string message;
};

/// Fills a template (mustache: keys, lists, comments). A key that is not in kKeys for this template is an error.
/// The returned text may be read as long as the row sources are valid.
base::Result<base::TextSource, TemplateError> render(const Template& text, const View& view);

}  // namespace symplant::emit
