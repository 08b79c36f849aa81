/*
 * base/config.h - included first by all of src/: strict float semantics, invariant checks, compiler attributes.
 *
 * The same input gives the same bits: contraction into fused multiply-add is off, and the build fails on targets that
 * compute float expressions in a wider type.
 */
#ifndef CNI_BASE_CONFIG_H
#define CNI_BASE_CONFIG_H

#include <float.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__TINYC__) && !defined(FLT_EVAL_METHOD) && defined(__x86_64__)
#define FLT_EVAL_METHOD 0 /* tcc computes floats by SSE here, and its float.h does not say so */
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
/* gcc 12 fuses pairs of products into multiply-add/subtract when it auto-vectorises, even with contraction off. */
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize", "no-tree-loop-vectorize")
#endif

#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "Cairn needs float expressions evaluated in float: use -msse2 -mfpmath=sse on i386, -fexcess-precision=fast on s390x"
#endif
#ifdef __FAST_MATH__
#error "Cairn must not be compiled with -ffast-math: results would depend on the compiler"
#endif

/* Parts that a small build leaves out. The condition is a constant, so the compiler drops the calls and the linker what they called. */
#ifdef CN_NO_DIRECT /* direct/, linear/, gravity preload: CN_SOLVER_AUTO is then the soft solver */
#define CNI_HAS_DIRECT 0
#else
#define CNI_HAS_DIRECT 1
#endif
#ifdef CN_NO_SEQUENTIAL /* step/sequential.c */
#define CNI_HAS_SEQUENTIAL 0
#else
#define CNI_HAS_SEQUENTIAL 1
#endif
#ifdef CN_NO_SWEEP /* broadphase/sweep*.c: CN_BROADPHASE_SWEEP is then the tree */
#define CNI_HAS_SWEEP 0
#else
#define CNI_HAS_SWEEP 1
#endif
#ifdef CN_NO_TREE /* broadphase/broadphase_tree.c; cn_tree needs tree*.c only where it is called */
#define CNI_HAS_TREE 0
#else
#define CNI_HAS_TREE 1
#endif
#ifdef CN_NO_JOINTS /* joints between bodies; constraints of one body are joints too */
#define CNI_HAS_JOINTS 0
#else
#define CNI_HAS_JOINTS 1
#endif
#ifdef CN_NO_CONTINUOUS /* narrowphase/continuous.c: the flag CN_WORLD_CONTINUOUS is refused */
#define CNI_HAS_CONTINUOUS 0
#else
#define CNI_HAS_CONTINUOUS 1
#endif
#ifdef CN_NO_AREAS /* step/areas.c, model/area*.c: sensors that are areas */
#define CNI_HAS_AREAS 0
#else
#define CNI_HAS_AREAS 1
#endif
#ifdef CN_NO_EVENTS /* contact and sensor events, pre-solve callbacks: shapes that ask for them are refused */
#define CNI_HAS_EVENTS 0
#else
#define CNI_HAS_EVENTS 1
#endif
#ifdef CN_NO_RESTITUTION /* contacts/restitution.c: materials with restitution are refused */
#define CNI_HAS_RESTITUTION 0
#else
#define CNI_HAS_RESTITUTION 1
#endif
#ifdef CN_NO_CHAINS /* collision/manifold_chain.c; the creation of chains is refused */
#define CNI_HAS_CHAINS 0
#else
#define CNI_HAS_CHAINS 1
#endif
#ifdef CN_NO_CIRCLES /* collision/manifold_round.c; the creation of circles is refused. Capsules are polygons of two points */
#define CNI_HAS_CIRCLES 0
#else
#define CNI_HAS_CIRCLES 1
#endif
#ifdef CN_NO_MESSAGES /* sentences about errors: cn_world_error_text is empty */
#define CNI_HAS_MESSAGES 0
#else
#define CNI_HAS_MESSAGES 1
#endif
#ifdef CN_NO_CLOCK /* CN_WORLD_PROFILE measures nothing */
#define CNI_HAS_CLOCK 0
#else
#define CNI_HAS_CLOCK 1
#endif
#if !CNI_HAS_SWEEP && !CNI_HAS_TREE
#error "CN_NO_SWEEP and CN_NO_TREE: a world needs one broadphase"
#endif

/* Checks the library's own invariants, never user input. Active in debug and test builds only. */
#ifdef CNI_DEBUG
#include <stdio.h>
#include <stdlib.h>
#define CNI_ASSERT(condition) \
	((condition) ? (void)0 : (void)(fprintf(stderr, "%s:%d: invariant broken: %s\n", __FILE__, __LINE__, #condition), abort()))
#else
#define CNI_ASSERT(condition) ((void)0)
#endif

/* For kernels that are written once and specialised by inlining with constant arguments. */
#if defined(__OPTIMIZE_SIZE__) /* one copy of each kernel instead: the same bits, half the code */
#define CNI_INLINE static inline
#elif defined(__GNUC__)
#define CNI_INLINE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define CNI_INLINE static __forceinline
#else
#define CNI_INLINE static inline
#endif

/* Before a member or variable from which vectors are loaded: its alignment. Empty where there are no vectors. */
#if defined(__GNUC__)
#define CNI_ALIGNED(bytes) __attribute__((aligned(bytes)))
#else
#define CNI_ALIGNED(bytes)
#endif

/* Hint that memory is read soon; changes no result. Small builds are for processors without a cache. Functions that only prefetch are forced
   inline: compilers take them for functions without effect, and drop their calls. */
#if defined(__GNUC__) && !defined(CN_SMALL_BLOCKS)
#define CNI_PREFETCH(address) __builtin_prefetch(address)
#else
#define CNI_PREFETCH(address) ((void)(address))
#endif

/* The index of no item. */
#define CNI_NONE (-1)

#endif
