/*
 * collision/manifold_table.h - declares the manifold functions of the table in manifold_table.c.
 */
#ifndef CNI_COLLISION_MANIFOLD_TABLE_H
#define CNI_COLLISION_MANIFOLD_TABLE_H

#include "collision/manifold.h"

/* manifold_round.c */
cni_manifold_fn cni_collide_circles;
cni_manifold_fn cni_collide_circle_segment; /* capsules, edges */
cni_manifold_fn cni_collide_circle_polygon;
/* manifold_faces.c: polygons, capsules, edges */
cni_manifold_fn cni_collide_polygons;
/* manifold_chain.c */
cni_manifold_fn cni_collide_circle_chain;
cni_manifold_fn cni_collide_faces_chain; /* capsules, polygons */

#endif
