// The files of the page, which the program carries.
#pragma once

#include <span>
#include <string_view>

namespace symplant::panel {

struct PageFile {
  std::string_view name;
  std::string_view text;
};

/// All files of the page; index.html is that for `/`.
std::span<const PageFile> page_files();

/// The description of the interface for tools, as OpenAPI.
std::string_view openapi();

}  // namespace symplant::panel
