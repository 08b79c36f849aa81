/*
 * collision/manifold_table.c - which function makes the manifold of a pair of shape types.
 */
#include "collision/manifold_table.h"

#define TYPES 5

static cni_manifold_fn *const functions[TYPES][TYPES] = {
	/* b:  circle               capsule                     polygon                      edge                      chain */
	{ cni_collide_circles, cni_collide_circle_segment, cni_collide_circle_polygon, cni_collide_circle_segment, cni_collide_circle_chain },
	{ NULL, cni_collide_polygons, cni_collide_polygons, cni_collide_polygons, cni_collide_faces_chain },
	{ NULL, NULL, cni_collide_polygons, cni_collide_polygons, cni_collide_faces_chain },
	{ NULL, NULL, NULL, cni_collide_polygons, NULL },
	{ NULL, NULL, NULL, NULL, NULL },
};

cni_manifold_fn *cni_manifold_function(int32_t type_a, int32_t type_b)
{
	CNI_ASSERT(type_a >= 0 && type_a <= type_b && type_b < TYPES);
	return functions[type_a][type_b];
}
