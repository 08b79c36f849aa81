/*
 * query/mover.h - shared by the files of the character mover: planes and sliding (mover_plane.c), ground and the move (mover.c).
 */
#ifndef CNI_WORLD_MOVER_H
#define CNI_WORLD_MOVER_H

#include "query/query.h"

/* Planes of a mover that are looked at, those of least separation. */
#define CNI_MOVER_PLANES_MAX 16

typedef struct cni_planes {
	cn_plane at[CNI_MOVER_PLANES_MAX];
	int32_t count;
} cni_planes;

/* Velocity nearest to v that leads into none of the surfaces, which move at speeds[i] along their normals. */
cni_vec2 cni_planes_clip(const cn_plane *planes, const float *speeds, int32_t count, cni_vec2 v);
/* Velocity of the body's material at a world point. */
cni_vec2 cni_mover_velocity_at(const cn_world *world, cn_body body, cni_vec2 point);

/* ---- state of one move */

typedef struct cni_move {
	cn_world *world;
	const cn_mover_def *def;
	cn_mover *mover;
	cni_sight sight;
	cni_region full, core;   /* core: slightly smaller, so that touched surfaces do not stop a cast */
	cni_solid solid;
	cni_vec2 offset;         /* of the regions' origin from the mover's position */
	cni_vec2 up, right;
	float walkable;          /* cosine of the slope limit */
	float margin;            /* surfaces within it are touched */
	float skin;              /* distance between the surfaces of full and core */
	float dt;
	cni_planes planes;       /* that it touches, when it last slid */
} cni_move;

/* Sets the mover's position. */
void cni_move_place(cni_move *m, cni_vec2 position);
/* Moves the mover by a translation, or as far as it can slide along the surfaces in the way. */
void cni_move_slide(cni_move *m, cni_vec2 translation);
/* Removes the horizontal velocity into steep planes: a surface too steep to walk on is a wall. */
cni_vec2 cni_move_block_steep(const cni_move *m, cni_vec2 v);

#endif
