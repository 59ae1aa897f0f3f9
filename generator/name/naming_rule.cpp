// The built-in naming rule.
#include "name/naming_rule.hpp"

namespace symplant::name {

const NamingRule& built_in_rule() {
  static const NamingRule rule{
      "line-process-device-direction-task",
      "LINE_PROC_DEV_I|O_TASK",
      U'_',
      {Level::line, Level::process, Level::device, Level::direction, Level::task},
      {{"I", Direction::event}, {"O", Direction::operation}},
  };
  return rule;
}

}  // namespace symplant::name
