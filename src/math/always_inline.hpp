#pragma once

// What is compiled for wide lanes must be called where there are such lanes and nowhere else: all
// between the dispatch and the processor is inlined, at every level of optimisation.
#define RIGID_BODY_SIM_INLINE inline __attribute__((always_inline))
