// Detects the thread sanitizer, with which the guard cannot work.
//
// The sanitizer replaces the same functions as the guard, delivers signals late, and reports two threads that use one
// file descriptor as a race.
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

/// The sanitizer ignores the reads of this thread during the lifetime; without the sanitizer it has no effect.
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
  UnwatchedReads() {}   // NOLINT(modernize-use-equals-default): a trivial class would give unused-variable warnings
  ~UnwatchedReads() {}  // NOLINT(modernize-use-equals-default)
  UnwatchedReads(const UnwatchedReads&) = delete;
  UnwatchedReads& operator=(const UnwatchedReads&) = delete;
};

#endif

}  // namespace symplant::exec::guard
