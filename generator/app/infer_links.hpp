// The file of links that symplant infer writes.
#pragma once

#include <string>
#include <vector>

#include "infer/report.hpp"

namespace symplant::app {

/// CSV that naming::read_links_file() reads: the links, and rows to fill in as comments.
std::string infer_links_text(const std::vector<name::NamedLink>& links, const std::vector<infer::OpenLink>& open);

}  // namespace symplant::app
