// Delta debugging of scenarios; plants shrink as in tests/property.
#include "property/files/shrink_files.hpp"

#include <algorithm>
#include <utility>

#include "property/shrink.hpp"

namespace symplant::property::files {
namespace {

constexpr int kMostRuns = 1500;  ///< runs of the tool on one plant

class Shrinker {
 public:
  Shrinker(FileCase it, const std::function<bool(const FileCase&)>& disagrees)
      : best_(std::move(it)), disagrees_(disagrees) {}

  FileCase run() {
    steps();
    manner();
    plant();
    steps();
    actions();
    manner();
    plant();
    return std::move(best_);
  }

 private:
  bool keep(FileCase candidate) {
    if (!disagrees_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }
  template <class Edit>
  bool edited(Edit&& edit) {
    FileCase candidate = best_;
    edit(candidate);
    return keep(std::move(candidate));
  }

  void steps() {
    remove_pieces(
        best_, [](FileCase & it) -> auto& { return it.steps; },
        [&](FileCase candidate) { return keep(std::move(candidate)); });
  }

  void actions() {
    for (std::size_t i = 0; i < best_.steps.size(); ++i) {
      const auto each = [&](auto of) {
        remove_pieces(
            best_, [&](FileCase & it) -> auto& { return of(it.steps[i]); },
            [&](FileCase candidate) { return keep(std::move(candidate)); });
      };
      each([](Step & step) -> auto& { return step.set; });
      each([](Step & step) -> auto& { return step.states; });
      each([](Step & step) -> auto& { return step.put; });
      each([](Step & step) -> auto& { return step.take; });
      each([](Step & step) -> auto& { return step.force; });
      each([](Step & step) -> auto& { return step.release; });
      each([](Step & step) -> auto& { return step.stop; });
      each([](Step & step) -> auto& { return step.start; });
      each([](Step & step) -> auto& { return step.expect; });
    }
  }

  void manner() {
    if (best_.until) edited([](FileCase& it) { it.until.reset(); });
    if (best_.seed != 0) edited([](FileCase& it) { it.seed = 0; });
    if (best_.style.decorated) edited([](FileCase& it) { it.style.decorated = false; });
    if (best_.style.patterns) edited([](FileCase& it) { it.style.patterns = false; });
  }

  void plant() {
    const auto still = [&](const Case& candidate) {
      FileCase it = best_;
      it.plant = candidate.plant;
      return disagrees_(it);
    };
    best_.plant = property::shrink({best_.plant, {}}, still, kMostRuns).plant;
  }

  FileCase best_;
  const std::function<bool(const FileCase&)>& disagrees_;
};

}  // namespace

FileCase shrink(FileCase it, const std::function<bool(const FileCase&)>& disagrees) {
  return Shrinker(std::move(it), disagrees).run();
}

}  // namespace symplant::property::files
