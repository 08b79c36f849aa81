/*
 * model/area.h - areas: sensor shapes with their own gravity, damping and medium. The list is empty in most worlds.
 *
 * The list is sorted by priority, then by shape: this is the order in which areas act on a body. The bodies in an area are those whose
 * contacts with its shape have CNI_CONTACT_SENSING, so areas need no search of their own.
 */
#ifndef CNI_MODEL_AREA_H
#define CNI_MODEL_AREA_H

#include "base/maths.h"

typedef struct cni_area {
	int32_t shape;
	int32_t priority;
	uint32_t flags;        /* CN_AREA_* */
	cni_vec2 gravity;
	cni_vec2 center;       /* of the pull, in the frame of the sensor's body */
	float pull, pull_distance;
	float linear_damping, angular_damping;
	float density, drag, lift;
	cni_vec2 flow;
} cni_area;

/* The order of the list. */
static inline int32_t cni_area_is_before(const cni_area *a, const cni_area *b)
{
	return a->priority < b->priority || (a->priority == b->priority && a->shape < b->shape);
}
/* The area of a shape, NULL: it has none. O(areas). */
cni_area *cni_area_of_shape(const cn_world *world, int32_t shape);
/* Adds or replaces the area of its shape. 0: no memory; nothing changes. */
int32_t cni_area_set(cn_world *world, const cni_area *area);
/* Removes the area of a shape, if it has one. */
void cni_area_remove(cn_world *world, int32_t shape);
/* Wakes the bodies in the shape of an area. O(contacts of its body). */
void cni_area_wake(cn_world *world, int32_t shape);
/* Wakes the bodies in areas that move. */
void cni_areas_wake_moving(cn_world *world);
/* After a body entered or left a sensor: wakes it, if the sensor is an area. */
void cni_area_visited(cn_world *world, int32_t contact);

#endif
