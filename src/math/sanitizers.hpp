#pragma once

// Which sanitizer instruments what is compiled: gcc and clang say it each in its own way.
#if defined(__SANITIZE_ADDRESS__)
#define RIGID_BODY_SIM_ADDRESS_SANITIZER
#elif defined(__SANITIZE_THREAD__)
#define RIGID_BODY_SIM_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGID_BODY_SIM_ADDRESS_SANITIZER
#elif __has_feature(thread_sanitizer)
#define RIGID_BODY_SIM_THREAD_SANITIZER
#endif
#endif
