#pragma once

// What is compiled for an instruction set of its own, to be called where the processor has it.
// clang 14 spills wide registers to a stack that it has not aligned for them, unless it is told to
#if defined(__clang__)
#define RIGID_BODY_SIM_TARGET(name) __attribute__((target(name), force_align_arg_pointer))
#else
#define RIGID_BODY_SIM_TARGET(name) __attribute__((target(name)))
#endif

// A lambda that is inlined, as RIGID_BODY_SIM_INLINE is for functions.
#define RIGID_BODY_SIM_INLINE_LAMBDA __attribute__((always_inline))
