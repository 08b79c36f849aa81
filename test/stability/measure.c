/*
 * test/stability/measure.c - what scenes measure, from poses, velocities and anchors that the public interface gives.
 */
#include "scene.h"

#include <math.h>
#include <string.h>

#define CONTACTS_MAX 64

double scene_greater(double a, double b) { return b > a || b != b ? b : a; }

scene_motion scene_read(const scene_run *run, int32_t item)
{
	cn_body body = run->items[item].body;
	cn_velocity velocity;
	cn_mass_data mass;
	cn_vec2 center;
	cn_pose pose;
	scene_motion motion;
	memset(&motion, 0, sizeof motion);
	if (cn_body_get_pose(run->world, body, &pose) != CN_OK || cn_body_get_center(run->world, body, &center) != CN_OK
		|| cn_body_get_velocity(run->world, body, &velocity) != CN_OK || cn_body_get_mass_data(run->world, body, &mass) != CN_OK) {
		motion.x = motion.y = motion.vx = motion.vy = (double)NAN;
		return motion;
	}
	motion.x = (double)center.x - run->far_m;
	motion.y = (double)center.y;
	motion.angle = atan2((double)pose.sine, (double)pose.cosine);
	motion.vx = (double)velocity.linear_mps.x;
	motion.vy = (double)velocity.linear_mps.y;
	motion.w = (double)velocity.angular_radps;
	motion.mass = (double)mass.mass_kg;
	motion.inertia = (double)mass.inertia_kgm2;
	return motion;
}

double scene_energy(const scene_run *run)
{
	double sum = 0.0, gravity = scene_value(run, "gravity");
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		sum += 0.5 * m.mass * (m.vx * m.vx + m.vy * m.vy) + 0.5 * m.inertia * m.w * m.w + m.mass * gravity * m.y;
	}
	return sum;
}

scene_momentum scene_momentum_read(const scene_run *run)
{
	scene_momentum sum = { 0.0, 0.0, 0.0 };
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		sum.x += m.mass * m.vx;
		sum.y += m.mass * m.vy;
		sum.angular += m.mass * (m.x * m.vy - m.y * m.vx) + m.inertia * m.w;
	}
	return sum;
}

double scene_anchor_error(const scene_run *run)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < run->joint_count; ++k) {
		cn_vec2 a, b;
		if (cn_joint_get_anchors(run->world, run->joints[k], &a, &b) != CN_OK)
			return (double)NAN;
		worst = scene_greater(worst, hypot((double)b.x - (double)a.x, (double)b.y - (double)a.y));
	}
	return worst;
}

double scene_displacement(const scene_run *run)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		worst = scene_greater(worst, hypot(m.x - run->items[k].x, m.y - run->items[k].y));
	}
	return worst;
}

double scene_speed_max(const scene_run *run)
{
	double worst = 0.0;
	int32_t k;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		worst = scene_greater(worst, hypot(m.vx, m.vy));
	}
	return worst;
}

int32_t scene_broken_count(const scene_run *run)
{
	int32_t k, broken = 0;
	for (k = 0; k < run->item_count; ++k) {
		scene_motion m = scene_read(run, k);
		double sum = m.x + m.y + m.angle + m.vx + m.vy + m.w;
		broken += !(fabs(sum) < 1e30);
	}
	return broken;
}

/* ---- overlap of boxes ---- */

typedef struct oriented_box {
	double x, y, c, s, half[2];
} oriented_box;

static oriented_box box_read(const scene_run *run, const scene_item *item)
{
	oriented_box box = { 0.0, 0.0, 1.0, 0.0, { 0.0, 0.0 } };
	cn_pose pose;
	if (cn_body_get_pose(run->world, item->body, &pose) != CN_OK)
		return box;
	box.x = (double)pose.position_m.x;
	box.y = (double)pose.position_m.y;
	box.c = (double)pose.cosine;
	box.s = (double)pose.sine;
	box.half[0] = item->half_x;
	box.half[1] = item->half_y;
	return box;
}

/* Overlap along one axis, negative when apart. */
static double overlap_along(const oriented_box *a, const oriented_box *b, double nx, double ny)
{
	double reach = fabs(nx * a->c + ny * a->s) * a->half[0] + fabs(ny * a->c - nx * a->s) * a->half[1];
	reach += fabs(nx * b->c + ny * b->s) * b->half[0] + fabs(ny * b->c - nx * b->s) * b->half[1];
	return reach - fabs(nx * (b->x - a->x) + ny * (b->y - a->y));
}

static double box_overlap(const oriented_box *a, const oriented_box *b)
{
	double least = overlap_along(a, b, a->c, a->s);
	least = fmin(least, overlap_along(a, b, -a->s, a->c));
	least = fmin(least, overlap_along(a, b, b->c, b->s));
	return fmin(least, overlap_along(a, b, -b->s, b->c));
}

/* The other box of a contact of item near; each pair of items once, from its first body. */
static const scene_item *find_partner(const scene_run *run, const cn_contact_event *contact, int32_t near)
{
	cn_body mine = run->items[near].body, body = contact->body_a == mine ? contact->body_b : contact->body_a;
	int32_t k;
	for (k = 0; k < run->ground_count; ++k)
		if (run->ground[k].body == body)
			return &run->ground[k];
	if (contact->body_a != mine)
		return NULL;
	/* Neighbours in a structure are mostly neighbours in the list. */
	for (k = 0; k < run->item_count; ++k) {
		int32_t at = (near + k) % run->item_count;
		if (run->items[at].body == body)
			return run->items[at].half_x > 0.0 ? &run->items[at] : NULL;
	}
	return NULL;
}

double scene_penetration(const scene_run *run)
{
	cn_contact_event contacts[CONTACTS_MAX];
	double deepest = 0.0;
	int32_t k, c, count;
	for (k = 0; k < run->item_count; ++k) {
		const scene_item *item = &run->items[k];
		oriented_box mine;
		if (item->half_x <= 0.0 || cn_body_get_contacts(run->world, item->body, contacts, CONTACTS_MAX, &count) != CN_OK)
			continue;
		mine = box_read(run, item);
		for (c = 0; c < count && c < CONTACTS_MAX; ++c) {
			const scene_item *other = find_partner(run, &contacts[c], k);
			if (other != NULL) {
				oriented_box theirs = box_read(run, other);
				deepest = scene_greater(deepest, box_overlap(&mine, &theirs));
			}
		}
	}
	return deepest;
}
