/*
 * examples/scenes/list.c - every scene by name. The benchmark's are described exactly where they are
 * made, so that other engines can be given the same work; the demo's are sized for pictures.
 */
#include "scenes/build.h"
#include <string.h>

#define EARTH {0.0f, -10.0f}
#define VIEW(x0, y0, x1, y1) {{x0, y0}, {x1, y1}}

static const scene scenes[] = {
	/* shown */
	{"pyramid", "A pyramid of 465 boxes: it stands, and falls asleep", scene_create_pyramid, NULL, 360, 30,
		SCENE_DEMO | SCENE_STANDS | SCENE_SLEEP, EARTH, VIEW(-24.0f, -2.0f, 24.0f, 31.0f), VIEW(-32.0f, -4.0f, 32.0f, 40.0f)},
	{"tumbler_1000", "1,000 boxes in a drum that turns", scene_create_small_tumbler, NULL, 450, 1000, SCENE_DEMO, EARTH,
		VIEW(-16.0f, -6.0f, 16.0f, 26.0f), VIEW(-16.0f, -6.0f, 16.0f, 26.0f)},
	{"bridge", "A bridge of 200 links, and what it carries", scene_create_bridge, NULL, 480, 200, SCENE_DEMO | SCENE_SLEEP, EARTH,
		VIEW(-50.0f, -7.0f, 50.0f, 24.0f), VIEW(-60.0f, -40.0f, 60.0f, 60.0f)},
	{"mixer", "300 mixed shapes in a ring with a driven arm", scene_create_mixer, NULL, 450, 300, SCENE_DEMO, EARTH,
		VIEW(-12.0f, -10.8f, 12.0f, 10.8f), VIEW(-11.0f, -11.0f, 11.0f, 11.0f)},
	{"car", "A car with two driven wheels on one smooth chain", scene_create_car, NULL, 600, 0, SCENE_DEMO, EARTH,
		VIEW(-12.0f, -4.5f, 12.0f, 6.5f), VIEW(-25.0f, -10.0f, 185.0f, 50.0f)},
	{"ragdolls", "36 ragdolls fall into a valley", scene_create_ragdolls, scene_step_ragdolls, 480, 36, SCENE_DEMO | SCENE_SLEEP, EARTH,
		VIEW(-7.5f, -0.6f, 7.5f, 6.6f), VIEW(-8.0f, -2.0f, 8.0f, 40.0f)},
	{"dominoes", "A ball, 40 dominoes and the edge of a table", scene_create_dominoes, NULL, 600, 40, SCENE_DEMO | SCENE_SLEEP, EARTH,
		VIEW(-20.0f, -4.8f, 20.0f, 4.0f), VIEW(-25.0f, -5.0f, 25.0f, 40.0f)},
	{"falling_hinges", "Hinged boxes topple: the scene of the golden hashes", scene_create_hinges, NULL, 480, 30,
		SCENE_DEMO | SCENE_SLEEP, EARTH, VIEW(-10.0f, -1.5f, 18.0f, 16.0f), VIEW(-32.0f, -3.0f, 32.0f, 40.0f)},
	{"machines", "One exhibit for every kind of joint", scene_create_machines, scene_step_machines, 600, 0, SCENE_DEMO | SCENE_SLEEP, EARTH,
		VIEW(-9.3f, -0.4f, 9.3f, 10.8f), VIEW(-14.0f, -4.0f, 14.0f, 20.0f)},
	{"constraints", "Breaking, constraints on one body, belts, rolling, one-way shelves, a sensor", scene_create_constraints,
		scene_step_constraints, 600, 0, SCENE_DEMO | SCENE_SLEEP, EARTH, VIEW(-11.6f, -0.4f, 11.6f, 7.2f), VIEW(-14.0f, -4.0f, 14.0f, 20.0f)},

	/* timed */
	{"large_pyramid", "5,050 boxes in one pyramid", scene_create_large_pyramid, NULL, 500, 100, SCENE_BENCH | SCENE_STANDS, EARTH,
		VIEW(-60.0f, -2.0f, 60.0f, 102.0f), VIEW(-100.0f, -4.0f, 100.0f, 140.0f)},
	{"many_pyramids", "400 pyramids of 55 boxes", scene_create_many_pyramids, NULL, 200, 20, SCENE_BENCH | SCENE_STANDS, EARTH,
		VIEW(-112.0f, -2.0f, 112.0f, 222.0f), VIEW(-115.0f, -5.0f, 115.0f, 260.0f)},
	{"joint_grid", "10,000 circles on 19,794 revolute joints", scene_create_joint_grid, NULL, 500, 100, SCENE_BENCH, EARTH,
		VIEW(-30.0f, -130.0f, 130.0f, 30.0f), VIEW(-200.0f, -400.0f, 300.0f, 200.0f)},
	{"tumbler", "2,025 boxes in a drum that turns", scene_create_tumbler, NULL, 750, 45, SCENE_BENCH, EARTH,
		VIEW(-16.0f, -6.0f, 16.0f, 26.0f), VIEW(-16.0f, -6.0f, 16.0f, 26.0f)},
	{"spinner", "6,076 mixed shapes in a chain of 360 edges with a driven arm", scene_create_spinner, NULL, 500, 6076,
		SCENE_BENCH | SCENE_SLEEP, EARTH, VIEW(-42.0f, -10.0f, 42.0f, 74.0f), VIEW(-41.0f, -9.0f, 41.0f, 73.0f)},
	{"smash", "A brick at 40 m/s into 9,600 sleeping boxes", scene_create_smash, NULL, 300, 120, SCENE_BENCH | SCENE_SLEEP, {0.0f, 0.0f},
		VIEW(-30.0f, -40.0f, 110.0f, 40.0f), VIEW(-1000.0f, -1000.0f, 1000.0f, 1000.0f)},
	{"rain", "Up to 1,000 ragdolls over five floors", scene_create_rain, scene_step_rain, 1000, 0, SCENE_BENCH | SCENE_SLEEP, EARTH,
		VIEW(-130.0f, -5.0f, 130.0f, 230.0f), VIEW(-126.0f, -2.0f, 126.0f, 300.0f)},
	{"junkyard", "2,000 circles, capsules, boxes, pentagons and hexagons in a pit", scene_create_junkyard, NULL, 400, 2000, SCENE_BENCH, EARTH,
		VIEW(-24.0f, -2.0f, 24.0f, 40.0f), VIEW(-23.0f, -1.0f, 23.0f, 80.0f)},
	{"compounds", "800 bodies of three to seven shapes in a pit", scene_create_compounds, NULL, 400, 800, SCENE_BENCH, EARTH,
		VIEW(-24.0f, -2.0f, 24.0f, 46.0f), VIEW(-23.0f, -1.0f, 23.0f, 80.0f)},
	{"workshop", "100 machines, each alone: bridges, pendulums, jibs, carts, swings", scene_create_workshop, NULL, 400, 100, SCENE_BENCH, EARTH,
		VIEW(-15.0f, -2.0f, 285.0f, 242.0f), VIEW(-200.0f, -2000.0f, 500.0f, 300.0f)},
	{"small_10", "10 mixed bodies in a bowl", scene_create_bowl, NULL, 600, 10, SCENE_BENCH, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},
	{"small_50", "50 mixed bodies in a bowl", scene_create_bowl, NULL, 600, 50, SCENE_BENCH, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},
	{"small_200", "200 mixed bodies in a bowl", scene_create_bowl, NULL, 600, 200, SCENE_BENCH, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},
	{"small_10_sleep", "10 mixed bodies in a bowl, sleeping on", scene_create_bowl, NULL, 600, 10, SCENE_BENCH | SCENE_SLEEP, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},
	{"small_50_sleep", "50 mixed bodies in a bowl, sleeping on", scene_create_bowl, NULL, 600, 50, SCENE_BENCH | SCENE_SLEEP, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},
	{"small_200_sleep", "200 mixed bodies in a bowl, sleeping on", scene_create_bowl, NULL, 600, 200, SCENE_BENCH | SCENE_SLEEP, EARTH,
		VIEW(-7.0f, -1.0f, 7.0f, 13.0f), VIEW(-6.0f, -1.0f, 6.0f, 60.0f)},

	/* memory: after one step */
	{"memory_empty", "Nothing", scene_create_empty, NULL, 1, 0, 0, EARTH, VIEW(-1.0f, -1.0f, 1.0f, 1.0f), VIEW(-1.0f, -1.0f, 1.0f, 1.0f)},
	{"memory_lone_box", "1,000 boxes far apart", scene_create_lone_boxes, NULL, 1, 1000, 0, EARTH,
		VIEW(-10.0f, -10.0f, 410.0f, 260.0f), VIEW(-10.0f, -10.0f, 410.0f, 260.0f)},
	{"memory_pyramid", "5,050 boxes in one pyramid", scene_create_large_pyramid, NULL, 1, 100, 0, EARTH,
		VIEW(-60.0f, -2.0f, 60.0f, 102.0f), VIEW(-100.0f, -4.0f, 100.0f, 140.0f)},
};

int32_t scene_count(void) { return (int32_t)(sizeof scenes / sizeof scenes[0]); }
const scene *scene_at(int32_t index) { return index >= 0 && index < scene_count() ? &scenes[index] : NULL; }

const scene *scene_find(const char *name)
{
	for (int32_t i = 0; i < scene_count(); ++i) {
		if (strcmp(scenes[i].name, name) == 0)
			return &scenes[i];
	}
	return NULL;
}
