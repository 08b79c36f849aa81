/*
 * geometry/manifold_table.h - the pair functions that the table in manifold_table.c lists.
 */
#ifndef CNI_GEOMETRY_MANIFOLD_TABLE_H
#define CNI_GEOMETRY_MANIFOLD_TABLE_H

#include "geometry/manifold.h"

/* manifold_round.c */
cni_manifold_fn cni_collide_circles;
cni_manifold_fn cni_collide_circle_capsule;
cni_manifold_fn cni_collide_circle_polygon;
cni_manifold_fn cni_collide_circle_edge;
/* manifold_polygon.c */
cni_manifold_fn cni_collide_capsules;
cni_manifold_fn cni_collide_capsule_polygon;
cni_manifold_fn cni_collide_capsule_edge;
cni_manifold_fn cni_collide_polygons;
cni_manifold_fn cni_collide_polygon_edge;
cni_manifold_fn cni_collide_edges;
/* manifold_chain.c */
cni_manifold_fn cni_collide_circle_chain;
cni_manifold_fn cni_collide_capsule_chain;
cni_manifold_fn cni_collide_polygon_chain;

#endif
