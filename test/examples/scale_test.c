/*
 * test/examples/scale_test.c - the scenes of `make bench-scale` have as many bodies as they are asked for, in an area
 * that grows with them, and do what their names say: a field moves everywhere, piles stand.
 */
#include "bench/scale_scenes.h"
#include "measure/measure.h"
#include "test.h"
#include <math.h>
#include <stdlib.h>

typedef void describe_fn(scene *out, int32_t bodies);

typedef struct census {
	int32_t dynamic, moving; /* faster than 5 cm/s */
	int32_t bodies, left;    /* of any type; outside of the scene's bounds */
} census;

static census take_census(const scene_run *run)
{
	census c = {0, 0, 0, measure_bodies_left(run->world, &run->scene->bounds_m)};
	cn_world_get_bodies(run->world, NULL, 0, &c.bodies);
	cn_body *bodies = (cn_body *)malloc((size_t)c.bodies * sizeof *bodies);
	if (bodies != NULL)
		cn_world_get_bodies(run->world, bodies, c.bodies, &c.bodies);
	for (int32_t i = 0; bodies != NULL && i < c.bodies; ++i) {
		int32_t type = CN_BODY_STATIC;
		cn_velocity v;
		cn_body_get_type(run->world, bodies[i], &type);
		if (type != CN_BODY_DYNAMIC || cn_body_get_velocity(run->world, bodies[i], &v) != CN_OK)
			continue;
		++c.dynamic;
		c.moving += hypot((double)v.linear_mps.x, (double)v.linear_mps.y) > 0.05;
	}
	free(bodies);
	return c;
}

static double area_m2(const scene *s)
{
	return (double)(s->bounds_m.upper_m.x - s->bounds_m.lower_m.x) * (double)(s->bounds_m.upper_m.y - s->bounds_m.lower_m.y);
}

/* The part of the last cell that stays empty, and that of the last row, are less of a larger world. */
static void check_size(describe_fn *describe, int32_t bodies, int32_t others, double area_of_body_m2)
{
	scene which;
	scene_run run;
	describe(&which, bodies);
	REQUIRE(scene_open(&run, &which, NULL) == CN_OK);
	census c = take_census(&run);
	printf("  %s of %d: %d dynamic of %d\n", which.name, bodies, c.dynamic, c.bodies);
	CHECK(c.dynamic == bodies && c.bodies == bodies + others);
	CHECK(c.left == 0);
	CHECK_LE("area of a body beside that of a full cell", fabs(area_m2(&which) / bodies / area_of_body_m2 - 1.0), bodies < 10000 ? 0.2 : 0.05, "");
	scene_close(&run);
}

static void t_as_many_bodies_as_asked_for_at_one_density(void)
{
	check_size(scale_field, 42, 2, 1.0);
	check_size(scale_field, 1000, 25, 1.0); /* 24 paddles */
	check_size(scale_field, 30000, 716, 1.0);
	check_size(scale_piles, 1000, 1, 2.2);
	check_size(scale_piles, 30000, 1, 2.2);
}

static census census_after(describe_fn *describe, int32_t steps, float *displacement_m)
{
	scene which;
	scene_run run;
	measure_start start;
	census c = {0, 0, 0, 0};
	describe(&which, 1000);
	if (scene_open(&run, &which, NULL) != CN_OK || !measure_start_open(&start, run.world)) {
		test_fail(__FILE__, __LINE__, "the scene can be made");
		return c;
	}
	while (run.step_index < steps && scene_step(&run) == CN_OK) {
	}
	CHECK(run.result == CN_OK);
	*displacement_m = measure_displacement(&start, run.world);
	c = take_census(&run);
	measure_start_close(&start);
	scene_close(&run);
	return c;
}

static void t_a_field_moves_everywhere(void)
{
	float displacement_m = 0.0f;
	census c = census_after(scale_field, 90, &displacement_m);
	CHECK(c.dynamic == 1000 && c.left == 0);
	CHECK_LE("share that hardly moves", 1.0 - c.moving / 1000.0, 0.2, "");
}

static void t_piles_stand(void)
{
	float displacement_m = 1.0f;
	census c = census_after(scale_piles, 40, &displacement_m);
	CHECK(c.dynamic == 1000);
	CHECK_LE("displacement", (double)displacement_m, 0.001, "m");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_as_many_bodies_as_asked_for_at_one_density);
	RUN(t_a_field_moves_everywhere);
	RUN(t_piles_stand);
	return test_end();
}
