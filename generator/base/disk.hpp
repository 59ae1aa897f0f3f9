// The calls of the system that files need. Names of files are UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace symplant::base::disk {

enum class Kind : std::uint8_t { absent, regular, folder, other };

struct About {
  Kind kind = Kind::absent;
  std::uint64_t size = 0;    ///< bytes
  unsigned permissions = 0;  ///< those of POSIX; not used by Windows
  int fault = 0;             ///< errno, for `absent`
};

/// What a path means, behind symbolic links.
About about(const std::string& path);
About about(int file);
/// Whether there is something at the path, even a link without a target.
bool exists(const std::string& path);

/// Open a file for bytes, which a child process does not inherit. Return its descriptor; -1 with errno.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);  ///< what exists and is not a regular file
int open_new(const std::string& path);       ///< EEXIST if it exists

/// The number of bytes, at most `size`; 0: the end; -1 with errno. A signal does not end them.
std::ptrdiff_t read(int file, char* bytes, std::size_t size);
std::ptrdiff_t write(int file, const char* bytes, std::size_t size);
/// Return 0 or errno.
int rewind(int file);
int close(int file);
int set_permissions(int file, unsigned permissions);
int rename_over(const std::string& from, const std::string& to);  ///< replaces `to` at once
int rename_new(const std::string& from, const std::string& to);   ///< EEXIST if `to` exists
void remove(const std::string& path);

/// For names of temporary files.
unsigned long process_number();

}  // namespace symplant::base::disk
