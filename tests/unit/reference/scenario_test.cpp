// Scenarios on the reference, sentence by sentence of docs/plant-description.md.
#include "support/reference/scenario.hpp"

#include <deque>

#include "bench.hpp"

namespace symplant::test {
namespace {

using reference::ScenarioStep;
using When = ScenarioStep::When;

/// A cylinder that takes 1 s, steps given in milliseconds.
class Scene {
 public:
  explicit Scene(std::optional<tables::Time> until = {}) : player_(bench.analysed.model(), bench.plant, until, 1000) {}

  Scene& set(When when, tables::Time milliseconds, const std::string& symbol, bool on = true) {
    ScenarioStep step = at(when, milliseconds);
    step.set = {{bench.symbol(symbol), on ? 1 : 0}};
    player_.play(step);
    return *this;
  }
  Scene& expect(When when, tables::Time milliseconds, const std::string& symbol, bool on) {
    ScenarioStep step = at(when, milliseconds);
    step.expects = true;
    step.expect = {{bench.symbol(symbol), on ? 1 : 0}};
    player_.play(step);
    return *this;
  }
  Scene& wait(const std::string& state, std::optional<tables::Time> within = {}) {
    ScenarioStep step;
    step.when = When::wait;
    step.time = within;
    condition::Tree& tree = trees_.emplace_back();
    tree.kind = condition::Tree::Kind::atom;
    tree.atom.of = bench.index("CYL");
    tree.atom.state = bench.state_index("CYL", state);
    step.wait = &tree;
    player_.play(step);
    return *this;
  }
  /// "1 held at 5, 2 failed at 7, 3 never" of the steps that expect or wait, then the changes.
  std::string end() {
    player_.end();
    std::string text;
    for (const reference::Verdict& verdict : player_.verdicts()) {
      text += std::to_string(verdict.step + 1);
      text += !verdict.reached ? " never" : verdict.held ? " held" : " failed";
      if (verdict.reached) text += " at " + std::to_string(verdict.time / kMs);
      text += ", ";
    }
    return text + bench.changes();
  }

  Bench bench{{"CYL_O_ADV", "CYL_O_RET", "CYL_I_RET*", "CYL_I_ADV"}};

 private:
  static ScenarioStep at(When when, tables::Time milliseconds) {
    ScenarioStep step;
    step.when = when;
    step.time = milliseconds * kMs;
    return step;
  }

  std::deque<condition::Tree> trees_;
  reference::ScenarioPlayer player_;
};

TEST_CASE("A scenario ends with the instant of its last step") {
  CHECK(Scene().set(When::at, 500, "CYL_O_ADV").end() == "0:CYL_I_RET=1 500:CYL_O_ADV=1 500:CYL_I_RET=0");
}

TEST_CASE("An expectation reads the images after its own step and earlier steps of its time") {
  Scene scene;
  scene.set(When::at, 500, "CYL_O_ADV").expect(When::plus, 0, "CYL_I_RET", false);
  scene.set(When::plus, 0, "CYL_O_ADV", false).expect(When::plus, 0, "CYL_O_ADV", true);
  CHECK(scene.end() == "2 held at 500, 4 failed at 500, 0:CYL_I_RET=1 500:CYL_O_ADV=1 500:CYL_I_RET=0 500:CYL_O_ADV=0");
}

TEST_CASE("A wait is met at the last instant of its time, and later steps count from there") {
  Scene met;
  met.set(When::at, 0, "CYL_O_ADV").wait("ADV", 1000 * kMs).expect(When::plus, 0, "CYL_I_ADV", true);
  CHECK(met.end() == "2 held at 1000, 3 held at 1000, 0:CYL_O_ADV=1 1000:CYL_I_ADV=1");
  Scene missed;
  missed.set(When::at, 0, "CYL_O_ADV").wait("ADV", 1000 * kMs - 1).expect(When::plus, 10, "CYL_I_ADV", true);
  CHECK(missed.end() == "2 failed at 999, 3 held at 1009, 0:CYL_O_ADV=1 1000:CYL_I_ADV=1");
}

TEST_CASE("A wait without `within` waits ten seconds, one that holds already is met at once") {
  CHECK(Scene().wait("ADV").end() == "1 failed at 10000, 0:CYL_I_RET=1");
  CHECK(Scene().wait("RET").end() == "1 held at 0, 0:CYL_I_RET=1");
}

TEST_CASE("An `at` that is past because of a wait acts at once") {
  Scene scene;
  scene.set(When::at, 0, "CYL_O_ADV").wait("ADV").set(When::at, 300, "CYL_O_RET");
  CHECK(scene.end() == "2 held at 1000, 0:CYL_O_ADV=1 1000:CYL_I_ADV=1 1000:CYL_O_RET=1");
}

TEST_CASE("A step after `--until` has failed, a step due at that time belongs to the run") {
  Scene scene(1000 * kMs);
  scene.set(When::at, 0, "CYL_O_ADV").expect(When::at, 1000, "CYL_I_ADV", true);
  scene.expect(When::at, 1001, "CYL_I_ADV", true).wait("RET");
  CHECK(scene.end() == "2 held at 1000, 3 never, 4 never, 0:CYL_O_ADV=1 1000:CYL_I_ADV=1");
  Scene waiting(400 * kMs);
  CHECK(waiting.set(When::at, 0, "CYL_O_ADV").wait("ADV").end() == "2 never, 0:CYL_O_ADV=1");
}

}  // namespace
}  // namespace symplant::test
