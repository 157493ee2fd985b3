#pragma once
// The inline namespace in which all formulas and numbers are compiled, named by instruction set and register size. A
// program built for one instruction set may so link a library built for another: the same template is then two, each
// with its own calling convention for vectors, and no linker takes one for the other. Both give the same bits.

#if defined(__FAST_MATH__)
#error "refraster's formulas need IEEE arithmetic: compile without -ffast-math (and with -ffp-contract=off)"
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define REFRASTER_KIT_REGISTERS avx512dq_64
#elif defined(__AVX512F__)
#define REFRASTER_KIT_REGISTERS avx512f_64
#elif defined(__AVX2__)
#define REFRASTER_KIT_REGISTERS avx2_32
#elif defined(__AVX__)
#define REFRASTER_KIT_REGISTERS avx_16
#elif defined(__SSE4_1__)
#define REFRASTER_KIT_REGISTERS sse41_16
#elif defined(__aarch64__)
#define REFRASTER_KIT_REGISTERS neon_16
#else
#define REFRASTER_KIT_REGISTERS plain_16
#endif
#if defined(__FMA__) || defined(__aarch64__)
#define REFRASTER_KIT_FMA _fma
#else
#define REFRASTER_KIT_FMA
#endif
#if defined(__F16C__)
#define REFRASTER_KIT_HALF _f16c
#else
#define REFRASTER_KIT_HALF
#endif

#define REFRASTER_KIT_JOIN(a, b, c) kit_##a##b##c
#define REFRASTER_KIT_JOINED(a, b, c) REFRASTER_KIT_JOIN(a, b, c)
#define REFRASTER_KIT REFRASTER_KIT_JOINED(REFRASTER_KIT_REGISTERS, REFRASTER_KIT_FMA, REFRASTER_KIT_HALF)
