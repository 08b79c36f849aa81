/*
 * collision/manifold_table.c - the table of manifold functions by pair of shape types.
 */
#include "collision/manifold_faces.h"

#define TYPES 5

/* The linker drops functions of types that the build is without. */
#if CNI_HAS_CIRCLES
#define ROUND(function) function
#else
#define ROUND(function) NULL
#endif
#if CNI_HAS_CHAINS
#define CHAIN(function) function
#else
#define CHAIN(function) NULL
#endif

static cni_manifold_fn *const functions[TYPES][TYPES] = {
	/* b: circle, capsule, polygon, edge, chain */
	{ ROUND(cni_collide_circle_round), ROUND(cni_collide_circle_round), ROUND(cni_collide_circle_polygon), ROUND(cni_collide_circle_round), ROUND(CHAIN(cni_collide_circle_chain)) },
	{ NULL, cni_collide_polygons, cni_collide_polygons, cni_collide_polygons, CHAIN(cni_collide_faces_chain) },
	{ NULL, NULL, cni_collide_polygons, cni_collide_polygons, CHAIN(cni_collide_faces_chain) },
	{ NULL, NULL, NULL, cni_collide_polygons, NULL },
	{ NULL, NULL, NULL, NULL, NULL },
};

cni_manifold_fn *cni_manifold_function(int32_t type_a, int32_t type_b)
{
	CNI_ASSERT(type_a >= 0 && type_a <= type_b && type_b < TYPES);
	return functions[type_a][type_b];
}
