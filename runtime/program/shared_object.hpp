// A shared object (.so) or DLL that the system loads.
#pragma once

#include <string>

namespace symplant::program {

/// Loads a file with all that it needs; null: `fault` has the reason. Both paths are absolute: Windows also looks in
/// `folder` for what it needs.
void* load_object(const std::string& path, const std::string& folder, std::string& fault);
void unload_object(void* object);
/// The address of an exported name; null: it exports none.
void* exported(void* object, const char* name);
/// Whether this process still has the file, though it was unloaded.
bool is_loaded(const std::string& path);

/// A new empty file in the folder for temporary files; empty with errno. A loaded file may be removed before it is
/// unloaded if `can_remove_loaded`.
std::string new_temporary_file();
extern const bool can_remove_loaded;

/// How to make one, for messages.
extern const char* const how_to_compile;

}  // namespace symplant::program
