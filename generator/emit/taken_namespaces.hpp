// Words that cannot be the namespace of a plant.
#pragma once

#include <string_view>

namespace symplant::emit {

/// Targets that CMake reserves, names that the generated code uses, and names that the C library declares at global
/// scope: `namespace time` would be an error in every file that includes <time.h>.
inline constexpr std::string_view kTakenNamespaces[] = {
    "std",      "symplant", "core",     "posix",    "main",      "test",       "all",           "clean",
    "install",  "package",  "help",     "CLI",      "fmt",       "edit_cache", "rebuild_cache", "abort",
    "abs",      "accept",   "access",   "acct",     "alarm",     "atof",       "atoi",          "atol",
    "basename", "bcmp",     "bcopy",    "bind",     "brk",       "bsearch",    "bzero",         "calloc",
    "ceil",     "chdir",    "chmod",    "chown",    "chroot",    "clock",      "clone",         "close",
    "confstr",  "connect",  "cos",      "creat",    "crypt",     "ctime",      "daemon",        "daylight",
    "difftime", "dirname",  "div",      "dup",      "encrypt",   "environ",    "err",           "error",
    "execl",    "execv",    "exit",     "exp",      "fabs",      "fcntl",      "fdim",          "ffs",
    "floor",    "fmod",     "fork",     "fputs",    "free",      "fseek",      "gamma",         "getchar",
    "getenv",   "getline",  "getopt",   "getpid",   "gmtime",    "htonl",      "index",         "ioctl",
    "isatty",   "j0",       "j1",       "jn",       "kill",      "labs",       "ldiv",          "link",
    "listen",   "llabs",    "locale",   "lockf",    "log",       "logb",       "lseek",         "malloc",
    "mblen",    "memchr",   "memcmp",   "memcpy",   "memmove",   "memset",     "mkdir",         "mknod",
    "mktime",   "mount",    "munmap",   "nan",      "nice",      "ntohl",      "open",          "optarg",
    "optind",   "optopt",   "pause",    "perror",   "pipe",      "poll",       "pow",           "printf",
    "psignal",  "putchar",  "puts",     "qsort",    "raise",     "rand",       "random",        "read",
    "readlink", "realloc",  "reboot",   "recv",     "remainder", "remove",     "rename",        "rewind",
    "rindex",   "rint",     "rmdir",    "round",    "sbrk",      "scalb",      "scanf",         "select",
    "send",     "setbuf",   "setenv",   "shutdown", "sigaction", "signal",     "signgam",       "sin",
    "sleep",    "socket",   "splice",   "sqrt",     "stat",      "stime",      "strcat",        "strchr",
    "strcmp",   "strcpy",   "strdup",   "strlen",   "strtok",    "swab",       "symlink",       "sync",
    "syscall",  "system",   "tan",      "tee",      "time",      "timer",      "times",         "timezone",
    "tmpfile",  "trunc",    "truncate", "tzname",   "tzset",     "umask",      "umount",        "uname",
    "ungetc",   "unlink",   "usleep",   "utime",    "vfork",     "vprintf",    "wait",          "waitpid",
    "warn",     "write",    "y0",       "y1",       "yn",
};

}  // namespace symplant::emit
