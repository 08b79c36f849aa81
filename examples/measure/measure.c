/*
 * examples/measure/measure.c - errors, displacement and order statistics through the public API.
 */
#include "measure/measure.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------ lists */

/* Every body, to be freed; NULL when there is no memory. */
static cn_body *list_bodies(const cn_world *world, int32_t *out_count)
{
	*out_count = 0;
	cn_world_get_bodies(world, NULL, 0, out_count);
	cn_body *bodies = (cn_body *)malloc((size_t)(*out_count + 1) * sizeof *bodies);
	if (bodies != NULL)
		cn_world_get_bodies(world, bodies, *out_count, out_count);
	return bodies;
}

static int32_t is_dynamic(const cn_world *world, cn_body body)
{
	int32_t type = CN_BODY_STATIC;
	return cn_body_get_type(world, body, &type) == CN_OK && type == CN_BODY_DYNAMIC;
}

/* ------------------------------------------------------------------ errors */

static int32_t measure_contacts(measure_worst *worst, const cn_contact_event *contacts, int32_t count)
{
	int32_t points = 0;
	for (int32_t i = 0; i < count; ++i) {
		for (int32_t k = 0; k < contacts[i].manifold.point_count; ++k) {
			float depth = -contacts[i].manifold.points[k].separation_m;
			worst->penetration_m = depth > worst->penetration_m ? depth : worst->penetration_m;
		}
		points += contacts[i].manifold.point_count;
	}
	return points;
}

typedef struct contact_list {
	cn_contact_event *items;
	int32_t capacity;
} contact_list;

static int32_t grow_contacts(contact_list *list, int32_t count)
{
	if (count <= list->capacity)
		return 1;
	cn_contact_event *items = (cn_contact_event *)realloc(list->items, (size_t)count * sizeof *items);
	if (items == NULL)
		return 0;
	list->items = items;
	list->capacity = count;
	return 1;
}

/* Every contact touches a dynamic body, so the others' lists need no look. keep: NULL, or the contacts that count. */
typedef int32_t keep_fn(cn_contact_event *contacts, int32_t count, const cn_world *world, float speed_mps);
static void measure_penetration(measure_worst *worst, const cn_world *world, keep_fn *keep, float speed_mps)
{
	contact_list list = {NULL, 0};
	int32_t body_count, count = 0;
	cn_body *bodies = list_bodies(world, &body_count);
	if (bodies == NULL) {
		worst->failed = 1;
		return;
	}
	for (int32_t i = 0; i < body_count; ++i) {
		if (!is_dynamic(world, bodies[i]))
			continue;
		cn_body_get_contacts(world, bodies[i], NULL, 0, &count);
		if (!grow_contacts(&list, count)) {
			worst->failed = 1;
			break;
		}
		cn_body_get_contacts(world, bodies[i], list.items, list.capacity, &count);
		if (keep != NULL)
			count = keep(list.items, count, world, speed_mps);
		worst->points += measure_contacts(worst, list.items, count);
	}
	free(list.items);
	free(bodies);
}

static void measure_joints(measure_worst *worst, const cn_world *world)
{
	int32_t count = 0;
	cn_world_get_joints(world, NULL, 0, &count);
	cn_joint *joints = (cn_joint *)malloc((size_t)(count + 1) * sizeof *joints);
	if (joints == NULL) {
		worst->failed = 1;
		return;
	}
	cn_world_get_joints(world, joints, count, &count);
	for (int32_t i = 0; i < count; ++i) {
		float m = 0.0f, rad = 0.0f;
		cn_joint_get_error(world, joints[i], &m, &rad);
		worst->joint_m = m > worst->joint_m ? m : worst->joint_m;
		worst->joint_rad = rad > worst->joint_rad ? rad : worst->joint_rad;
	}
	free(joints);
}

void measure_errors(measure_worst *worst, const cn_world *world)
{
	measure_penetration(worst, world, NULL, 0.0f);
	measure_joints(worst, world);
}

static int32_t is_slow(const cn_world *world, cn_body body, float speed_mps)
{
	cn_velocity v = {{0.0f, 0.0f}, 0.0f};
	cn_body_get_velocity(world, body, &v);
	return hypotf(v.linear_mps.x, v.linear_mps.y) < speed_mps && fabsf(v.angular_radps) < speed_mps;
}

/* Moves the contacts between slow bodies to the front; their number. */
static int32_t keep_slow(cn_contact_event *contacts, int32_t count, const cn_world *world, float speed_mps)
{
	int32_t kept = 0;
	for (int32_t i = 0; i < count; ++i) {
		if (is_slow(world, contacts[i].body_a, speed_mps) && is_slow(world, contacts[i].body_b, speed_mps))
			contacts[kept++] = contacts[i];
	}
	return kept;
}

float measure_rest_overlap(const cn_world *world, float speed_mps, int32_t *out_count)
{
	measure_worst worst = {0};
	measure_penetration(&worst, world, keep_slow, speed_mps);
	*out_count = worst.failed ? 0 : worst.points;
	return worst.penetration_m;
}

/* ------------------------------------------------------------------ places */

int32_t measure_start_open(measure_start *start, const cn_world *world)
{
	start->bodies = list_bodies(world, &start->count);
	start->poses = (cn_pose *)malloc((size_t)(start->count + 1) * sizeof *start->poses);
	if (start->bodies == NULL || start->poses == NULL) {
		measure_start_close(start);
		return 0;
	}
	return start->count == 0 || cn_world_read_poses(world, start->bodies, start->count, start->poses) == CN_OK;
}

float measure_displacement(const measure_start *start, const cn_world *world)
{
	float worst = 0.0f;
	for (int32_t i = 0; i < start->count; ++i) {
		cn_pose now;
		if (!is_dynamic(world, start->bodies[i]) || cn_body_get_pose(world, start->bodies[i], &now) != CN_OK)
			continue;
		float distance = hypotf(now.position_m.x - start->poses[i].position_m.x, now.position_m.y - start->poses[i].position_m.y);
		worst = distance > worst ? distance : worst;
	}
	return worst;
}

void measure_start_close(measure_start *start)
{
	free(start->bodies);
	free(start->poses);
	memset(start, 0, sizeof *start);
}

int32_t measure_bodies_left(const cn_world *world, const cn_aabb *box_m)
{
	int32_t count, left = 0;
	cn_body *bodies = list_bodies(world, &count);
	if (bodies == NULL)
		return -1;
	for (int32_t i = 0; i < count; ++i) {
		cn_vec2 p;
		if (!is_dynamic(world, bodies[i]) || cn_body_get_center(world, bodies[i], &p) != CN_OK)
			continue;
		left += !(p.x >= box_m->lower_m.x && p.x <= box_m->upper_m.x && p.y >= box_m->lower_m.y && p.y <= box_m->upper_m.y);
	}
	free(bodies);
	return left;
}

int32_t measure_bodies_asleep(const cn_world *world)
{
	int32_t count, asleep = 0;
	cn_body *bodies = list_bodies(world, &count);
	if (bodies == NULL)
		return -1;
	for (int32_t i = 0; i < count; ++i) {
		uint32_t flags = 0;
		cn_body_get_flags(world, bodies[i], &flags);
		asleep += is_dynamic(world, bodies[i]) && !(flags & CN_BODY_AWAKE);
	}
	free(bodies);
	return asleep;
}

/* ------------------------------------------------------------------ times */

int32_t measure_times_open(measure_times *times, int32_t capacity)
{
	times->count = 0;
	times->capacity = capacity;
	times->ms = (double *)malloc((size_t)(capacity + 1) * sizeof *times->ms);
	return times->ms != NULL;
}

void measure_times_add(measure_times *times, double seconds)
{
	if (times->count < times->capacity)
		times->ms[times->count++] = 1000.0 * seconds;
}

static int compare_doubles(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

void measure_times_sort(measure_times *times) { qsort(times->ms, (size_t)times->count, sizeof *times->ms, compare_doubles); }

double measure_times_at(const measure_times *times, double share)
{
	if (times->count == 0)
		return 0.0;
	return times->ms[(int32_t)(share * (double)(times->count - 1) + 0.5)];
}

void measure_times_close(measure_times *times)
{
	free(times->ms);
	times->ms = NULL;
}

/* Stays a function, whatever is inlined: its name is looked for. */
#ifdef __GNUC__
__attribute__((noinline))
#endif
cn_result measure_step(cn_world *world, float dt_s) { return cn_world_step(world, dt_s); }
