// The options of a panel.
#pragma once

#include <string>

#include "symplant/tables/time.hpp"

namespace symplant::panel {

/// Where and how a panel serves.
struct PanelOptions {
  std::string address = "127.0.0.1:8137";         ///< HOST:PORT, :PORT or PORT
  bool view_only = false;                         ///< no acts
  bool trainees = false;                          ///< also links for trainees and viewers
  std::string token_file = {};                    ///< empty: fresh tokens for each start
  std::string files = {};                         ///< the folder of snapshots, sessions and pictures; empty: none
  tables::Time backtrack = 60 * tables::kSecond;  ///< plant time between two backtracks; 0: none
  int patience = 10;                              ///< for a request to arrive, for an answer to be read, s
};

}  // namespace symplant::panel
