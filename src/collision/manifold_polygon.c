/*
 * collision/manifold_polygon.c - pairs of polygons, capsules and edges: names their skeletons and
 * leaves the rest to the kernel in manifold_faces.c. Two crossing segments' Minkowski difference is a
 * parallelogram whose sides are their faces, so the kernel is exact for segments as well.
 */
#include "collision/manifold_faces.h"
#include "collision/manifold_table.h"

void cni_collide_polygons(const cni_manifold_input *in, cni_manifold_cache *cache, cni_manifold *out)
{
	cni_faces a = cni_faces_of(in->a);
	cni_faces b = cni_faces_of(in->b);
	cni_faces_collide(&a, &b, in, cache, out);
}
