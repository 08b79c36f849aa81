/*
 * examples/demo/draw_group.c - which island, or solver tier, a body belongs to. The library reports a body of each awake island
 * (cn_world_get_islands); the others are found from it over touching contacts and joints.
 */
#include "demo/draw_paint.h"
#include <stdlib.h>

/* Bodies to be looked at. */
typedef struct reach {
	painter *p;
	int32_t group;
	cn_body *stack;
	int32_t count;
} reach;

static void visit(reach *r, cn_body body)
{
	int32_t type = CN_BODY_STATIC;
	if (cn_body_get_type(r->p->world, body, &type) != CN_OK || type != CN_BODY_DYNAMIC || r->p->groups[DRAW_SLOT(body)] >= 0)
		return;
	r->p->groups[DRAW_SLOT(body)] = r->group;
	r->stack[r->count++] = body;
}

static int32_t visit_contacts(reach *r, cn_body body)
{
	int32_t count = 0;
	if (cn_body_get_contacts(r->p->world, body, NULL, 0, &count) != CN_OK || count == 0)
		return 1;
	cn_contact_event *contacts = (cn_contact_event *)malloc((size_t)count * sizeof *contacts);
	if (contacts == NULL)
		return 0;
	cn_body_get_contacts(r->p->world, body, contacts, count, &count);
	for (int32_t i = 0; i < count; ++i) {
		if (contacts[i].kind == CN_EVENT_STAY)
			visit(r, contacts[i].body_a == body ? contacts[i].body_b : contacts[i].body_a);
	}
	free(contacts);
	return 1;
}

static int32_t visit_joints(reach *r, cn_body body)
{
	int32_t count = 0;
	if (cn_body_get_joints(r->p->world, body, NULL, 0, &count) != CN_OK || count == 0)
		return 1;
	cn_joint *joints = (cn_joint *)malloc((size_t)count * sizeof *joints);
	if (joints == NULL)
		return 0;
	cn_body_get_joints(r->p->world, body, joints, count, &count);
	for (int32_t i = 0; i < count; ++i) {
		cn_body a = 0, b = 0;
		if (cn_joint_get_bodies(r->p->world, joints[i], &a, &b) == CN_OK)
			visit(r, a == body ? b : a);
	}
	free(joints);
	return 1;
}

static int32_t fill(painter *p, const cn_island_report *islands, int32_t count, cn_body *stack)
{
	int32_t good = 1;
	for (int32_t i = 0; i < count && good; ++i) {
		reach r = {p, p->show & DRAW_SHOW_TIERS ? islands[i].tier : i, stack, 0};
		visit(&r, islands[i].body);
		while (r.count > 0 && good) {
			cn_body body = r.stack[--r.count];
			good = visit_contacts(&r, body) && visit_joints(&r, body);
		}
	}
	return good;
}

/* One more than the greatest slot. */
static int32_t slot_count(const cn_body *bodies, int32_t count)
{
	uint32_t most = 0;
	for (int32_t i = 0; i < count; ++i)
		most = DRAW_SLOT(bodies[i]) > most ? DRAW_SLOT(bodies[i]) : most;
	return (int32_t)most + 1;
}

int32_t draw_find_groups(painter *p)
{
	int32_t count = 0, bodies = 0;
	cn_world_get_bodies(p->world, NULL, 0, &bodies);
	cn_world_get_islands(p->world, NULL, 0, &count);
	cn_island_report *islands = (cn_island_report *)malloc((size_t)(count + 1) * sizeof *islands);
	cn_body *stack = (cn_body *)malloc((size_t)(bodies + 1) * sizeof *stack);
	int32_t good = islands != NULL && stack != NULL;
	if (good) {
		cn_world_get_bodies(p->world, stack, bodies, &bodies);
		const int32_t slots = slot_count(stack, bodies);
		p->groups = (int32_t *)malloc((size_t)slots * sizeof *p->groups);
		for (int32_t i = 0; i < slots && p->groups != NULL; ++i)
			p->groups[i] = -1;
		cn_world_get_islands(p->world, islands, count, &count);
		good = p->groups != NULL && fill(p, islands, count, stack);
	}
	free(islands);
	free(stack);
	return good;
}
