// Prints JSON in different styles; its meaning is always the same.
#include "property/files/json_printer.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

namespace symplant::property::files {
namespace {

class Printer {
 public:
  Printer(bool decorated, Dice dice, long& comments) : decorated_(decorated), dice_(dice), comments_(comments) {}

  void value(const nlohmann::json& it) {
    if (it.is_object()) return object(it);
    if (it.is_array()) return array(it);
    if (it.is_string()) return string(it.get_ref<const std::string&>());
    text += it.dump();
  }

  std::string text;

 private:
  void object(const nlohmann::json& it) {
    std::vector<std::string> keys;
    const auto order = it.find(kOrder);
    for (const auto& member : it.items()) {
      if (order == it.end()) keys.push_back(member.key());
    }
    if (order != it.end()) keys = order->get<std::vector<std::string>>();
    if (order == it.end() && decorated_) dice_.shuffle(keys);
    text += "{";
    ++depth_;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      gap();
      string(keys[i]);
      if (decorated_ && dice_.percent(3)) text += " ";
      text += ":";
      if (decorated_ && dice_.percent(2)) comment();
      text += " ";
      value(it[keys[i]]);
      if (i + 1 < keys.size()) text += ",";
    }
    --depth_;
    gap();
    text += "}";
  }

  void array(const nlohmann::json& it) {
    text += "[";
    ++depth_;
    for (std::size_t i = 0; i < it.size(); ++i) {
      if (it[i].is_structured() || decorated_) gap();
      value(it[i]);
      if (i + 1 < it.size()) text += ", ";
    }
    --depth_;
    if (decorated_) gap();
    text += "]";
  }

  void string(const std::string& it) {
    if (!decorated_ || !dice_.percent(2)) {
      text += nlohmann::json(it).dump();
      return;
    }
    text += '"';
    for (const char c : it) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04X", static_cast<unsigned>(static_cast<unsigned char>(c)));
      text += escaped;  // plant descriptions are ASCII
    }
    text += '"';
  }

  void gap() {
    if (decorated_ && dice_.percent(20)) {
      text += dice_.percent(50) ? " " : "";
      return;
    }
    if (decorated_ && dice_.percent(4)) comment();
    text += decorated_ && dice_.percent(5) ? "\r\n" : "\n";
    text.append(decorated_ && dice_.percent(5) ? dice_.below(9) : 2 * depth_,
                decorated_ && dice_.percent(3) ? '\t' : ' ');
  }

  void comment() {
    static const std::vector<std::string> kComments = {" // not \"this\": 1\n", " /* { */ ", " /**/ ",
                                                       " /* two\nlines */ ", " // */ [\n"};
    text += dice_.pick(kComments);
    ++comments_;
  }

  bool decorated_;
  Dice dice_;
  long& comments_;
  std::size_t depth_ = 0;
};

}  // namespace

std::string print_json(const nlohmann::json& value, bool decorated, Dice dice, long& comments) {
  Printer printer(decorated, dice, comments);
  printer.value(value);
  return std::move(printer.text) + "\n";
}

}  // namespace symplant::property::files
