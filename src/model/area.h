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
	cn_area_def def;       /* struct_size is 0, and so is a pull_distance_m of CN_DEFAULT */
} cni_area;

/* The order of the list. */
static inline int32_t cni_area_is_before(const cni_area *a, const cni_area *b)
{
	return a->def.priority < b->def.priority || (a->def.priority == b->def.priority && a->shape < b->shape);
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
