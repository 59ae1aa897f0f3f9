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
  return {[scene](base::TextSink& sink) {
    std::string_view frame = page_frame();
    sink.put(up_to(frame, "@title@"));
    sink.put(diag::markup_text(scene.plant.name));
    sink.put(up_to(frame, "@style@"));
    sink.put(page_style());
    sink.put(up_to(frame, "@data@"));
    html_data(scene, sink);
    sink.put(up_to(frame, "@script@"));
    sink.put(page_script());
    sink.put(frame);
  }};
}

}  // namespace symplant::view
