/*
 * test/world/read_time_test.c - reading back 10,000 moving bodies: all poses, poses by handle, moved bodies, one getter after another,
 * beside memcpy of as many poses.
 *
 * Times are printed and have no bounds, as other programs disturb them. test/work.sh runs the functions one by one under valgrind and
 * bounds the instructions they execute per body.
 *
 * If a test here fails, look first in: world/read.c, base/handles.h.
 */
#include "fixture.h"

#include <string.h>
#include <time.h>

#define BODIES 10000
#define ROUNDS 100

static cn_world *w;
static cn_body bodies[BODIES];
static cn_pose poses[BODIES], copy[BODIES];
static double sum;

static void all(void) { must(cn_world_read_poses(w, NULL, BODIES, poses), w, "cn_world_read_poses"); }
static void listed(void) { must(cn_world_read_poses(w, bodies, BODIES, poses), w, "cn_world_read_poses"); }
static void unread(void) { sum += 1.0; }
static void copied(void) { memcpy(copy, poses, sizeof copy); }

static void each(void)
{
	int32_t k;
	for (k = 0; k < BODIES; ++k)
		must(cn_body_get_pose(w, bodies[k], &poses[k]), w, "cn_body_get_pose");
}

static void moved(void)
{
	const cn_body_moved *list;
	int32_t count;
	must(cn_world_moved(w, &list, &count), w, "cn_world_moved");
	CHECK(count == BODIES);
	sum += (double)list[count - 1].pose.position_m.x;
}

/* A new world in which the boxes fly through a step per round, and are read after each; only the reading is timed. */
static void measure(const char *name, void (*read)(void), int32_t steps)
{
	clock_t spent = 0;
	int32_t k;
	w = fixture_world(0.0f, 0);
	for (k = 0; k < BODIES; ++k) {
		bodies[k] = fixture_box(w, CN_BODY_DYNAMIC, 2.0f * (float)(k % 100), 2.0f * (float)(k / 100), 0.1f, 0.5f, 0.5f, 0.5f, 0.0f);
		must(cn_body_set_velocity(w, bodies[k], 1.0f, 0.0f, 1.0f), w, "cn_body_set_velocity");
	}
	fixture_step(w, 1);
	(void)fixture_pose(w, bodies[0]); /* from now on reading is prepared */
	fixture_step(w, 1);
	for (k = 0; k < ROUNDS && read != NULL; ++k) {
		clock_t start;
		fixture_step(w, steps);
		start = clock();
		read();
		spent += clock() - start;
		sum += (double)poses[k].position_m.x + (double)copy[k].sine;
	}
	CHECK(sum == sum);
	printf("  %s: %.2f ns a body\n", name, 1e9 * (double)spent / (double)CLOCKS_PER_SEC / (double)ROUNDS / (double)BODIES);
	cn_world_destroy(w);
}

static void nothing_read(void) { measure("nothing", NULL, 0); }
static void all_read(void) { measure("all poses", all, 0); }
static void listed_read(void) { measure("poses by handle", listed, 0); }
static void each_read(void) { measure("a getter each", each, 0); }
static void copied_read(void) { measure("memcpy of poses", copied, 0); }
/* The list is built once a step, so this steps in each round; unread_stepped is the same without the list. */
static void moved_read(void) { measure("moved bodies", moved, 1); }
static void unread_stepped(void) { measure("steps alone", unread, 1); }

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(nothing_read);
	RUN(copied_read);
	RUN(all_read);
	RUN(listed_read);
	RUN(each_read);
	RUN(unread_stepped);
	RUN(moved_read);
	return test_end();
}
