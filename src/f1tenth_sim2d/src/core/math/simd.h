#pragma once

/// Compiles a function for several vector units; the best one of the processor is chosen when the library is loaded.
///
/// All of them give the same bits: such functions treat all elements alike, by additions, multiplications, divisions,
/// comparisons and integer operations, whose results IEEE 754 fixes and which -ffp-contract=off keeps from being
/// fused. Sums over elements, which a vector unit would do in another order, have no place here.
#if defined(F1TENTH_VECTORIZED)
// A test compiles the functions for one vector unit after the other.
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// The clone is chosen before the sanitizer's own library is ready.
#define F1TENTH_VECTORIZED
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define F1TENTH_VECTORIZED __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define F1TENTH_VECTORIZED
#endif
