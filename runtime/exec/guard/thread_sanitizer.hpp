// Whether this is compiled for the thread sanitizer, which puts functions of its own in the guard's places and hands
// signals on later.
#pragma once

namespace symplant::exec::guard {

#if defined(__SANITIZE_THREAD__)
inline constexpr bool kBesideThreadSanitizer = true;
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
inline constexpr bool kBesideThreadSanitizer = true;
#else
inline constexpr bool kBesideThreadSanitizer = false;
#endif
#else
inline constexpr bool kBesideThreadSanitizer = false;
#endif

}  // namespace symplant::exec::guard
