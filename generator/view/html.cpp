// A model as one page for a browser: the built-in frame, style and script, and the model as data.
#include "view/html.hpp"

#include <string_view>

#include "diag/encode.hpp"
#include "view/html_data.hpp"

namespace symplant::view {

// The texts of generator/view/page, embedded in the tool.
std::string_view page_frame();
std::string_view page_style();
std::string_view page_script();

namespace {

/// Removes the text up to a mark, and the mark, from `text`. Returns the text before the mark.
std::string_view up_to(std::string_view& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  const std::string_view before = text.substr(0, at);
  text.remove_prefix(at + mark.size());
  return before;
}

}  // namespace

View html_view(const Scene& scene) {
  std::string_view frame = page_frame();
  std::string page(up_to(frame, "@title@"));
  page += diag::markup_text(scene.plant.name);
  page.append(up_to(frame, "@style@")).append(page_style());
  page.append(up_to(frame, "@data@")).append(html_data(scene));
  page.append(up_to(frame, "@script@")).append(page_script()).append(frame);
  return {std::move(page)};
}

}  // namespace symplant::view
