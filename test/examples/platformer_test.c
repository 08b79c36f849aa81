/*
 * test/examples/platformer_test.c - examples/platformer.c does what it shows: a stair, a slope, a crate, a moving platform and a one-way
 * platform, in so few lines.
 */
#define main platformer_main
#include "platformer.c"
#undef main
#include "test.h"
#include <stdlib.h>

typedef struct seen {
	double stair, slope, one_way;     /* heights where it stood */
	double lift_worst;                /* off its place on the platform from frame to frame, standing */
	int lift_frames, reached;
	cn_pose crate;
} seen;

static seen run(void)
{
	cn_world_def wd;
	cn_world *world = NULL;
	cn_body lift, crate;
	cn_pose lift_at = { { 0.0f, 0.0f }, 1.0f, 0.0f };
	hero h;
	seen s = { 0.0, 0.0, 0.0, 0.0, 0, 0, { { 0.0f, 0.0f }, 1.0f, 0.0f } };
	cn_world_def_init(&wd);
	if (cn_world_create(&wd, &world) != CN_OK)
		return s;
	level_make(world, &lift, &crate);
	hero_init(&h, (cn_vec2){ 0.0f, 1.0f });
	for (int step = 0; step < 1200 && h.mover.position_m.x < 50.0f; ++step) {
		cn_vec2 was = h.mover.position_m, lift_was = lift_at.position_m;
		keys k;
		cn_body_set_velocity(world, lift, step / 264 % 2 ? -2.0f : 2.0f, 0.0f, 0.0f);
		cn_world_step(world, DT);
		cn_body_get_pose(world, lift, &lift_at);
		k = play(&h, lift_at.position_m.x);
		hero_update(world, &h, k);
		double x = (double)h.mover.position_m.x, y = (double)h.mover.position_m.y - 0.8;
		if (x > 4.5 && x < 5.5)
			s.stair = greater(s.stair, y);
		if (x > 18.5 && x < 23.5)
			s.slope = greater(s.slope, y);
		if (x > 42.0 && x < 44.0 && h.mover.flags & CN_MOVER_ON_GROUND)
			s.one_way = greater(s.one_way, y);
		if (h.mover.ground_body == lift && k.run == 0.0f && h.mover.velocity_mps.x == 0.0f && ++s.lift_frames > 1)
			s.lift_worst = greater(s.lift_worst, fabs((double)(h.mover.position_m.x - was.x - lift_at.position_m.x + lift_was.x)));
	}
	cn_body_get_pose(world, crate, &s.crate);
	s.reached = h.mover.position_m.x >= 50.0f;
	cn_world_destroy(world);
	return s;
}

static void t_the_character_reaches_the_end(void)
{
	seen s = run();
	CHECK(s.reached);
	CHECK_LE("error of the height on the stair", fabs(s.stair - 0.5), 1e-3, "m");
	CHECK_LE("error of the height above the slope", fabs(s.slope - 2.0), 1e-3, "m");
	CHECK_LE("error of the height on the one-way platform", fabs(s.one_way - 3.5), 1e-3, "m");
	CHECK_GE("frames standing on the moving platform", s.lift_frames, 120, "");
	CHECK_LE("off its place there from frame to frame", s.lift_worst, 1e-3, "m");
	CHECK_GE("the crate was pushed to", (double)s.crate.position_m.x, 24.0, "m");
	CHECK_LE("and fell down to", (double)s.crate.position_m.y, -1.0, "m");
}

static char picture_path[512];

static void t_the_program_runs_and_draws(void)
{
	char *arguments[3];
	char name[] = "platformer";
	uint8_t head[8] = { 0 };
	FILE *f;
	arguments[0] = name;
	arguments[1] = picture_path;
	arguments[2] = NULL;
	CHECK(platformer_main(1, arguments) == 0);
	CHECK(platformer_main(2, arguments) == 0);
	f = fopen(picture_path, "rb");
	REQUIRE(f != NULL);
	CHECK(fread(head, 1, 8, f) == 8 && memcmp(head, "\x89PNG\r\n\x1a\n", 8) == 0);
	fclose(f);
	remove(picture_path);
}

/* The whole within 150 lines, the character within 100. */
static void t_it_is_short(void)
{
	static char line[512];
	int lines = 0, character = 0;
	FILE *f = fopen("examples/platformer.c", "r");
	REQUIRE(f != NULL);
	while (fgets(line, (int)sizeof line, f) != NULL) {
		++lines;
		if (strncmp(line, "static cn_body block(", 21) == 0)
			character = lines - 1;
	}
	fclose(f);
	CHECK_LE("lines", lines, 149, "");
	CHECK_LE("lines up to the end of the character", character, 100, "");
	CHECK_GE("lines up to the end of the character", character, 10, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	snprintf(picture_path, sizeof picture_path, "%s.png", argv[0]);
	RUN(t_the_character_reaches_the_end);
	RUN(t_the_program_runs_and_draws);
	RUN(t_it_is_short);
	return test_end();
}
