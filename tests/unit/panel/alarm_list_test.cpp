// The list of alarms by itself: states, shelving, the horn, limits.
#include "symplant/panel/alarm/alarm_list.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;
using panel::Alarm;
using panel::AlarmList;
using tables::AlarmPriority;

Alarm alarm_named(const std::string& name, AlarmPriority priority = AlarmPriority::high) {
  Alarm alarm{name, name, "text of " + name};
  alarm.priority = priority;
  return alarm;
}

Json whole(const AlarmList& list) {
  std::string json;
  list.put_all(json);
  return Json::parse(json);
}

Json changes(AlarmList& list) {
  std::string json;
  list.put_changes(json);
  list.forget_changes();
  return Json::parse(json);
}

/// The state of an alarm; empty: it is not in the list.
std::string state(const AlarmList& list, const std::string& name) {
  const Json all = whole(list);
  for (const Json& entry : all.at("list")) {
    if (entry.at("name") == name) return entry.at("state");
  }
  return "";
}

TEST_CASE("An alarm that goes stays until it is acknowledged, and one that is acknowledged until it goes") {
  AlarmList list;
  list.come(alarm_named("a"), 10, true);
  list.come(alarm_named("b"), 20, true);
  CHECK(state(list, "a") == "active");
  CHECK(list.acknowledge("a", 30));
  CHECK(state(list, "a") == "acknowledged");
  list.go("b", 40);
  CHECK(state(list, "b") == "gone");
  list.go("a", 50);
  CHECK(list.acknowledge("b", 60));
  CHECK(list.size() == 0);
  CHECK(list.on().empty());
}

TEST_CASE("An alarm that comes again is unacknowledged, and counted") {
  AlarmList list;
  list.come(alarm_named("a"), 10, true);
  list.acknowledge("a", 20);
  list.come(alarm_named("a"), 30, true);
  CHECK(state(list, "a") == "active");
  list.go("a", 40);
  list.come(alarm_named("a"), 50, true);
  const Json entry = whole(list).at("list").at(0);
  CHECK(entry == Json::parse(R"({"name":"a","state":"active","on":true,"priority":"high","source":"finding","of":"a",
    "text":"text of a","station":null,"came":50,"went":null,"count":3,"until":null})"));
}

TEST_CASE("What has no end is gone at once") {
  AlarmList list;
  list.come(alarm_named("a"), 10, false);
  CHECK(state(list, "a") == "gone");
  CHECK(whole(list).at("list").at(0).at("went") == 10);
  CHECK(list.on().empty());
}

TEST_CASE("A shelved alarm that is on comes back unacknowledged after its time, and one that is off leaves") {
  AlarmList list;
  list.come(alarm_named("on"), 0, true);
  list.come(alarm_named("off"), 0, true);
  list.acknowledge("on", 1);
  CHECK(list.shelve("on", 100, 10));
  CHECK(list.shelve("off", 100, 10));
  list.go("off", 20);
  CHECK(state(list, "off") == "shelved");
  CHECK(whole(list).at("list").at(0).at("until") == 100);
  list.advance_to(99);
  CHECK(state(list, "on") == "shelved");
  list.advance_to(100);
  CHECK(state(list, "on") == "active");
  CHECK(state(list, "off") == "");
}

TEST_CASE("Each shelving ends at its own time, and can be ended before") {
  AlarmList list;
  for (const char* const name : {"a", "b", "c"}) list.come(alarm_named(name), 0, true);
  list.shelve("a", 30, 0);
  list.shelve("b", 20, 0);
  list.shelve("c", 40, 0);
  CHECK(list.unshelve("c"));
  CHECK_FALSE(list.unshelve("c"));
  CHECK(state(list, "c") == "active");
  list.advance_to(20);
  CHECK(state(list, "b") == "active");
  CHECK(state(list, "a") == "shelved");
  list.advance_to(30);
  CHECK(state(list, "a") == "active");
}

TEST_CASE("Acknowledging all leaves out what is shelved") {
  AlarmList list;
  list.come(alarm_named("a"), 0, true);
  list.come(alarm_named("b"), 0, false);
  list.come(alarm_named("c"), 0, true);
  list.shelve("c", 10, 0);
  list.acknowledge_all(5);
  CHECK(state(list, "a") == "acknowledged");
  CHECK(state(list, "b") == "");
  list.advance_to(10);
  CHECK(state(list, "c") == "active");
}

TEST_CASE("The horn is on for what is urgent, neither acknowledged nor shelved, until it is silenced") {
  AlarmList list;
  list.come(alarm_named("low", AlarmPriority::low), 0, true);
  list.come(alarm_named("medium", AlarmPriority::medium), 0, true);
  CHECK_FALSE(list.horn());
  list.come(alarm_named("a"), 0, true);
  CHECK(list.horn());
  changes(list);
  list.silence();
  CHECK_FALSE(list.horn());
  CHECK(list.has_changes());
  list.come(alarm_named("b"), 1, true);
  CHECK(list.horn());
  list.shelve("b", 10, 1);
  CHECK_FALSE(list.horn());
  list.advance_to(10);
  CHECK(list.horn());
  list.go("b", 11);
  CHECK(list.horn());
  list.acknowledge("b", 12);
  CHECK_FALSE(list.horn());
}

TEST_CASE("Changes name what changed and what left, once") {
  AlarmList list;
  list.come(alarm_named("a"), 0, true);
  list.come(alarm_named("b"), 0, false);
  const Json first = changes(list);
  CHECK(first.at("all") == false);
  CHECK(first.at("list").size() == 2);
  CHECK_FALSE(list.has_changes());
  list.acknowledge("b", 1);
  list.acknowledge("a", 1);
  const Json second = changes(list);
  CHECK(second.at("list").size() == 1);
  CHECK(second.at("list").at(0).at("state") == "acknowledged");
  CHECK(second.at("left") == Json::parse(R"(["b"])"));
}

TEST_CASE("A full list drops the least urgent first, never a more urgent one") {
  AlarmList list;
  list.come(alarm_named("gone, high"), 0, false);
  list.come(alarm_named("low", AlarmPriority::low), 0, true);
  for (std::size_t i = 2; i < AlarmList::kMost; ++i) list.come(alarm_named("high " + std::to_string(i)), 1, true);
  CHECK(list.dropped() == 0);
  list.come(alarm_named("x", AlarmPriority::low), 2, false);
  CHECK(state(list, "x") == "");
  CHECK(list.dropped() == 1);
  list.come(alarm_named("y"), 3, true);
  CHECK(state(list, "y") == "active");
  CHECK(state(list, "gone, high") == "");
  list.come(alarm_named("z"), 4, true);
  CHECK(state(list, "low") == "");
  list.come(alarm_named("medium", AlarmPriority::medium), 5, true);
  CHECK(state(list, "medium") == "");
  CHECK(list.size() == AlarmList::kMost);
  CHECK(list.on().size() == AlarmList::kMost);
  CHECK(whole(list).at("dropped") == 4);
}

TEST_CASE("Changes that no client takes need a bounded amount of memory") {
  AlarmList list;
  for (int i = 0; i < 10'000; ++i) {
    list.come(alarm_named(std::to_string(i)), i, false);
    list.acknowledge(std::to_string(i), i);
  }
  list.come(alarm_named("a"), 0, true);
  const Json all = changes(list);
  CHECK(all.at("all") == true);
  CHECK(all.at("list").size() == 1);
  CHECK(all.at("left").empty());
}

TEST_CASE("A long text is cut between letters") {
  AlarmList list;
  Alarm alarm = alarm_named("a");
  alarm.text = "x";
  for (int i = 0; i < 1000; ++i) alarm.text += "ü";
  list.come(alarm, 0, true);
  const std::string text = whole(list).at("list").at(0).at("text");
  CHECK(text.size() <= AlarmList::kLongestText);
  CHECK(text.ends_with("ü…"));
}

TEST_CASE("Set back, the list forgets what came and what was done later") {
  AlarmList list;
  const auto none = [](const Alarm&) { return false; };
  for (const char* const name : {"went", "acknowledged", "shelved", "before"}) list.come(alarm_named(name), 10, true);
  list.acknowledge("before", 15);
  list.come(alarm_named("came"), 30, true);
  list.go("went", 30);
  list.acknowledge("acknowledged", 30);
  list.shelve("shelved", 90, 30);
  list.forget_after(20, none, none);
  CHECK(state(list, "came") == "");
  for (const char* const name : {"went", "acknowledged", "shelved"}) CHECK(state(list, name) == "active");
  CHECK(state(list, "before") == "acknowledged");
  CHECK(changes(list).at("all") == true);
  list.forget_after(-1, none, none);
  CHECK(list.size() == 0);
}

TEST_CASE("Set back, the list keeps what lasts at that time, and what came twice") {
  AlarmList list;
  const auto all = [](const Alarm&) { return true; };
  const auto none = [](const Alarm&) { return false; };
  list.come(alarm_named("twice"), 10, true);
  list.go("twice", 20);
  list.come(alarm_named("twice"), 30, true);
  list.acknowledge("twice", 31);
  list.forget_after(15, none, all);
  CHECK(state(list, "twice") == "active");
  CHECK(whole(list).at("list").at(0).at("came") == 15);
  // A link that is back stays so: no record says it again.
  list.come(alarm_named("link"), 10, true);
  list.go("link", 20);
  list.forget_after(15, all, none);
  CHECK(state(list, "link") == "gone");
}

TEST_CASE("Set back, the list keeps what does not depend on the time of the plant") {
  AlarmList list;
  list.come(alarm_named("link"), 50, true);
  list.acknowledge("link", 60);
  list.forget_after(
      -1, [](const Alarm&) { return true; }, [](const Alarm&) { return false; });
  CHECK(state(list, "link") == "acknowledged");
  CHECK(whole(list).at("list").at(0).at("came") == 0);
}

}  // namespace
}  // namespace symplant::test
