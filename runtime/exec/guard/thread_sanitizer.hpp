// Whether this is compiled for the thread sanitizer, which puts functions of its own in the guard's places, hands
// signals on later, and takes two threads that know one file by its number for a race.
#pragma once

#if defined(__SANITIZE_THREAD__)
#define SYMPLANT_BESIDE_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SYMPLANT_BESIDE_THREAD_SANITIZER 1
#endif
#endif

#ifdef SYMPLANT_BESIDE_THREAD_SANITIZER
extern "C" void AnnotateIgnoreReadsBegin(const char* file, int line);
extern "C" void AnnotateIgnoreReadsEnd(const char* file, int line);
#endif

namespace symplant::exec::guard {

#ifdef SYMPLANT_BESIDE_THREAD_SANITIZER

inline constexpr bool kBesideThreadSanitizer = true;

/// While it lives the sanitizer overlooks what this thread reads; without a sanitizer it is nothing.
class UnwatchedReads {
 public:
  UnwatchedReads() { AnnotateIgnoreReadsBegin(__FILE__, __LINE__); }
  ~UnwatchedReads() { AnnotateIgnoreReadsEnd(__FILE__, __LINE__); }
  UnwatchedReads(const UnwatchedReads&) = delete;
  UnwatchedReads& operator=(const UnwatchedReads&) = delete;
};

#else

inline constexpr bool kBesideThreadSanitizer = false;

class UnwatchedReads {
 public:
  UnwatchedReads() {}   // NOLINT(modernize-use-equals-default): one that does nothing would be an unused variable
  ~UnwatchedReads() {}  // NOLINT(modernize-use-equals-default)
  UnwatchedReads(const UnwatchedReads&) = delete;
  UnwatchedReads& operator=(const UnwatchedReads&) = delete;
};

#endif

}  // namespace symplant::exec::guard
