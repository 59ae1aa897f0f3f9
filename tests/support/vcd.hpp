// A small reader of VCD files, for tests: names by their scopes, values over time.
#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace symplant::test {

struct Vcd {
  struct Variable {
    std::string type;
    int width = 0;
  };
  std::map<std::string, Variable> variables;  ///< by scopes and name, separated by dots
  std::vector<std::string> changes;  ///< "500000000 excell.EXLINE.MB.AGV.EXLINE_MB_AGV=P1->P2", in the file's order
  std::map<std::string, std::string> values;  ///< at the end
  std::string initial;                        ///< $dumpvars: "name=value", separated by blanks
  std::string timescale;
  std::string last_time;
  std::string fault;  ///< empty if the file is valid
};

class VcdReader {
 public:
  explicit VcdReader(const std::string& text) : in_(text) {
    std::string word;
    while (vcd_.fault.empty() && in_ >> word) take(word);
    if (!scopes_.empty()) vcd_.fault = "a scope is open at the end";
  }
  const Vcd& result() const { return vcd_; }

 private:
  std::string until_end() {
    std::string text;
    std::string word;
    while (in_ >> word && word != "$end") text += (text.empty() ? "" : " ") + word;
    if (word != "$end") vcd_.fault = "no $end";
    return text;
  }
  void take(const std::string& word) {
    if (word == "$scope") {
      scopes_.push_back(until_end().substr(7));  // after "module "
    } else if (word == "$upscope") {
      until_end();
      scopes_.empty() ? void(vcd_.fault = "no scope to leave") : scopes_.pop_back();
    } else if (word == "$var") {
      declare(until_end());
    } else if (word == "$timescale") {
      vcd_.timescale = until_end();
    } else if (word == "$dumpvars") {
      dumping_ = true;
    } else if (word == "$end") {
      dumping_ = false;
    } else if (word.front() == '$') {
      until_end();
    } else if (word.front() == '#') {
      if (!vcd_.last_time.empty() && std::stoll(word.substr(1)) < std::stoll(vcd_.last_time))
        vcd_.fault = "back in time";
      vcd_.last_time = word.substr(1);
    } else {
      change(word);
    }
  }
  void declare(const std::string& text) {
    std::istringstream parts(text);
    std::string type;
    std::string id;
    std::string name;
    int width = 0;
    parts >> type >> width >> id >> name;
    std::string path;
    for (const std::string& scope : scopes_) path += scope + ".";
    vcd_.variables[path + name] = {type, width};
    if (!names_.emplace(id, path + name).second) vcd_.fault = "two variables of one identifier";
  }
  void change(const std::string& word) {
    const bool scalar = word.front() == '0' || word.front() == '1';
    std::string id = word.substr(1);
    const std::string value = scalar ? word.substr(0, 1) : word.substr(1);
    if (!scalar) in_ >> id;
    const auto name = names_.find(id);
    if (name == names_.end()) {
      vcd_.fault = "a value of no variable: " + word;
      return;
    }
    vcd_.values[name->second] = value;
    if (dumping_) {
      vcd_.initial += (vcd_.initial.empty() ? "" : " ") + name->second + "=" + value;
    } else {
      vcd_.changes.push_back(vcd_.last_time + " " + name->second + "=" + value);
    }
  }

  std::istringstream in_;
  std::vector<std::string> scopes_;
  std::map<std::string, std::string> names_;
  bool dumping_ = false;
  Vcd vcd_;
};

inline Vcd read_vcd(const std::string& text) { return VcdReader(text).result(); }

}  // namespace symplant::test
