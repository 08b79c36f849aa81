/*
 * geometry/medium.h - the force of a surrounding medium (water, wind) on one shape: buoyancy, drag and lift, on the part of the shape
 * within a convex region. Pure functions, no world.
 *
 * All points are relative to the body's centre of mass, in the axes of the world, so nothing is lost far from the origin. A velocity V is
 * (x, y, angular). Drag and lift are linear in the velocity at frozen coefficients: drag - resist (V - V0), where drag is the force
 * at the present velocity V0. That form can be solved implicitly: see cni_medium_solve.
 */
#ifndef CNI_GEOMETRY_MEDIUM_H
#define CNI_GEOMETRY_MEDIUM_H

#include "geometry/shape.h"

/* A convex region: all points r with normals[k] . r <= offsets[k]. count 0: everywhere. */
#define CNI_MEDIUM_PLANES 16
typedef struct cni_medium_region {
	cni_vec2 normals[CNI_MEDIUM_PLANES]; /* unit, outward */
	float offsets[CNI_MEDIUM_PLANES];
	int32_t count;
} cni_medium_region;

typedef struct cni_medium {
	cni_vec2 up;       /* unit: the direction of buoyancy */
	float buoyancy;    /* N per square metre of displaced medium */
	float drag, lift;  /* density times coefficient, kg/m^2 */
	float damping, turn_damping; /* N s/m and N m s per square metre of displaced medium */
	cni_vec2 flow;     /* its velocity */
} cni_medium;

/* Sums over the shapes of a body. */
typedef struct cni_medium_force {
	float force[3];    /* x, y, torque: buoyancy, and what else the caller adds */
	float drag[3];     /* drag and lift at the present velocity */
	float resist[3][3];
	float heave, roll; /* stiffness of buoyancy: force per rise, torque per turn */
	float heave_flow;  /* heave times the speed of the medium's surface along up */
} cni_medium_force;

/* A shape of a moving body. */
typedef struct cni_in_medium {
	const cni_geometry *geometry;
	cni_vec2 center;   /* of mass, in the body's frame */
	cni_rot q;
	cni_vec2 velocity; /* of the centre of mass */
	float spin;
} cni_in_medium;

/* Geometry in a world as a region: the half planes of a convex polygon with its radius; for circles and capsules the tangent at
   the point nearest to the centre. center: of the other body, in the geometry's frame; q: of the geometry's body. */
void cni_medium_region_make(cni_medium_region *region, const cni_geometry *g, cni_vec2 center, cni_rot q);
void cni_medium_add(cni_medium_force *sum, const cni_medium *medium, const cni_medium_region *region, const cni_in_medium *shape);
/*
 * The change of velocity in a time dt: (mass + dt resist) change = dt (force + drag), with mass a diagonal, of which 0 means infinite. Its symmetric
 * part is at least mass, so there is always a solution; in a medium of one velocity |V - flow| in the norm of mass never grows and is
 * never reversed, whatever dt, mass and speed. For drag alone the change is the exact solution of m v' = -k v^2.
 */
void cni_medium_solve(const cni_medium_force *sum, const float mass[3], float dt, float change[3]);

#endif
