// A model as one page for a browser: the built-in frame, style and script, and the model as data.
#include "view/html.hpp"

#include <string_view>

#include "base/frame.hpp"
#include "diag/encode.hpp"
#include "view/html_data.hpp"

namespace symplant::view {

// The texts of generator/view/page, embedded in the tool.
std::string_view page_frame();
std::string_view page_style();
std::string_view page_script();

View html_view(const Scene& scene) {
  return {[scene](base::TextSink& sink) {
    base::put_framed(page_frame(),
                     {{"@title@", base::whole(diag::markup_text(scene.plant.name))},
                      {"@style@", [](base::TextSink& out) { out.put(page_style()); }},
                      {"@data@", [&](base::TextSink& out) { html_data(scene, out); }},
                      {"@script@", [](base::TextSink& out) { out.put(page_script()); }}},
                     sink);
  }};
}

}  // namespace symplant::view
