/*
 * collision/toi.h - time of impact: when two shapes that move and turn during a step first come within a
 * distance of each other.
 *
 *     cni_toi_input in = { &ga, &gb, child_a, child_b, path_a, path_b, target, tolerance };
 *     cni_toi_result hit = cni_toi(&in);
 *     if (hit.state == CNI_TOI_HIT) ... both bodies at hit.fraction do not overlap yet
 *
 * Up to the fraction that is returned, whatever the state, the surfaces are known to be at least target
 * apart (except for OVERLAPPED, and for a pair that starts projection than that).
 */
#ifndef CNI_COLLISION_TOI_H
#define CNI_COLLISION_TOI_H

#include "geometry/shape.h"

/* How a body moves from fraction 0 to 1: its centre of mass in a straight line, turning evenly. */
typedef struct cni_path {
	cni_vec2 start, end;    /* of the centre of mass; only differences between the two bodies matter, so
	                           subtract a common point near both when far from the origin */
	cni_rot q;              /* at the start */
	float turn;             /* radians to the end, counter-clockwise positive; may be several turns */
	cni_vec2 local_center;  /* of mass, in the body's frame */
} cni_path;

/* Maps the body's frame to the world at a fraction. */
cni_transform cni_path_at(const cni_path *path, float fraction);

enum {
	CNI_TOI_SEPARATED = 0, /* never projection than target; fraction is 1 */
	CNI_TOI_HIT = 1,       /* at fraction they are between target and target + tolerance apart (nearer if they
	                          started nearer: fraction is 0 then) */
	CNI_TOI_OVERLAPPED = 2,/* the skeletons overlap at the start; fraction is 0 */
	CNI_TOI_FAILED = 3     /* out of iterations at fraction: free until then, unknown after */
};

typedef struct cni_toi_input {
	const cni_geometry *a;
	const cni_geometry *b;
	int32_t child_a;       /* edge of a chain, else 0 */
	int32_t child_b;
	cni_path path_a;
	cni_path path_b;
	float target;          /* metres between the surfaces at which they count as hit. May be negative down to
	                          minus the sum of the radii: rounded shapes may overlap. Skeletons never get nearer
	                          than the tolerance. */
	float tolerance;       /* metres, > 0; raised to what floats can tell at the sizes involved */
} cni_toi_input;

typedef struct cni_toi_result {
	int32_t state;         /* CNI_TOI_* */
	float fraction;        /* [0, 1] */
	float distance;        /* of the surfaces at fraction; HIT only */
	cni_vec2 normal;       /* unit, from a to b, in the world; HIT only */
	cni_vec2 point;        /* between the closest points, in the coordinates of the paths; HIT only */
	int32_t iterations;    /* distance computations */
} cni_toi_result;

/* A chain's edge stops only what comes from its front: with the other shape's centroid behind it at the start
   or at the hit the answer is SEPARATED. */
cni_toi_result cni_toi(const cni_toi_input *in);

#endif
