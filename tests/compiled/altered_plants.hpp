// Copies of the compiled cell, each with one changed text (CMakeLists.txt lists the changes).
#pragma once

#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::test {

std::vector<const tables::PlantTables*> altered_rows();     ///< changed in a row of tables_gen.cpp
std::vector<const tables::PlantTables*> altered_classes();  ///< changed in a function of a class

}  // namespace symplant::test
