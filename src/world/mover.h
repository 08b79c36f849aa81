/*
 * world/mover.h - what the planes of a mover (mover_plane.c) give to the mover itself (mover.c, mover_ground.c).
 */
#ifndef CNI_WORLD_MOVER_H
#define CNI_WORLD_MOVER_H

#include "world/query.h"

/* Planes of a mover that are looked at, those of least separation. */
#define CNI_MOVER_PLANES_MAX 16

typedef struct cni_planes {
	cn_plane at[CNI_MOVER_PLANES_MAX];
	int32_t count;
	int32_t reserved;
} cni_planes;

/* A shape to collide: region for where it is, solid with the same points from the region's origin. */
void cni_planes_find(const cni_sight *sight, const cni_region *region, const cni_solid *solid, float margin, cn_plane *out, int32_t capacity, int32_t *out_count);
/* As cn_mover_solve. */
cni_vec2 cni_planes_solve(cn_plane *planes, int32_t count, cni_vec2 wanted, float *out_overlap);
/* The velocity nearest to v that leads into none of the surfaces, which themselves move at speeds[i] along their normals. */
cni_vec2 cni_planes_clip(const cn_plane *planes, const float *speeds, int32_t count, cni_vec2 v);
/* Of the body's material at a point in the world. */
cni_vec2 cni_mover_velocity_at(const cn_world *world, cn_body body, cni_vec2 point);

/* ---- one move, while it goes on */

typedef struct cni_move {
	cn_world *world;
	const cn_mover_def *def;
	cn_mover *mover;
	cni_sight sight;
	cni_region full, core;   /* core: a little smaller, so that what is touched along the way does not stop a cast */
	cni_solid solid;
	cni_vec2 offset;         /* of the regions' origin from the mover's position */
	cni_vec2 up, right;
	float walkable;          /* cosine of the slope limit */
	float margin;            /* surfaces so near are touched */
	float skin;              /* how much smaller the core is */
	float dt;
	cni_planes planes;       /* of the last cni_move_touch */
} cni_move;

/* Puts the mover there. */
void cni_move_place(cni_move *m, cni_vec2 position);
/* Finds the planes that it touches. */
void cni_move_touch(cni_move *m);
/* Moves it by a translation, or as far as what is in the way lets it slide. */
void cni_move_slide(cni_move *m, cni_vec2 translation);
/* Without a velocity into steep planes, horizontally: what is too steep to walk on is a wall. */
cni_vec2 cni_move_block_steep(const cni_move *m, cni_vec2 v);

/* mover_ground.c. All set or clear the mover's ground. */
void cni_ground_none(cni_move *m);
/* Among the planes touched, the one that can best be stood on, unless the mover leaves it at velocity v. */
int32_t cni_ground_of_planes(cni_move *m, cni_vec2 v);
/* Looks for ground within the snap distance below, and goes down to it. */
int32_t cni_ground_snap(cni_move *m);
/* From start a step up and then a way along `right`, which sliding took only for `progress` of it. */
int32_t cni_ground_step(cni_move *m, cni_vec2 start, float way, float progress);

#endif
