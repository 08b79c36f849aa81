/*
 * test/world/flight_test.c - nothing that flies is changed by what happens on the ground.
 *
 * If a test here fails, look in whatever changes the velocities of an island as a whole: src/direct/direct_contacts.c,
 * rattle_energy.c.
 */
#include "joints.h"

/* Half sizes: a plank on a post, a light box at one end, heavy boxes that land on the other, one after the other. The box leaves the
   plank, and while it flies the next blow comes. Returns the largest change of its speed in a step beyond free fall, m/s, over all
   steps in which nothing touches it; *out_apex: how high it gets. */
static double thrown(float ratio, double *out_apex)
{
	cn_world *world = fixture_world(-(float)GRAVITY, 0);
	cn_body plank, box;
	double worst = 0.0;
	int32_t step, k;
	fixture_floor(world, 0.6f, 0.0f);
	plank = fixture_box(world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.0f, 3.0f, 0.1f, 0.6f, 0.0f);
	hinge(world, 0, at(0.0f, 1.0f), plank, at(0.0f, 0.0f));
	box = fixture_box(world, CN_BODY_DYNAMIC, -2.7f, 1.35f, 0.0f, 0.25f, 0.25f, 0.6f, 0.0f);
	for (k = 0; k < 3; ++k) {
		cn_shape_def def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 2.6f, 2.5f + 4.0f * (float)k, 0.0f), 0.6f, 0.0f);
		def.density_kgpm2 = ratio * 0.25f;
		fixture_box_shape(world, &def, 0.35f, 0.35f);
	}
	*out_apex = 0.0;
	for (step = 0; step < 240; ++step) {
		cn_velocity before = fixture_velocity(world, box), after;
		cn_contact_event contacts[8];
		int32_t count = 0, later = 0;
		must(cn_body_get_contacts(world, box, contacts, 8, &count), world, "cn_body_get_contacts");
		fixture_step(world, 1);
		must(cn_body_get_contacts(world, box, contacts, 8, &later), world, "cn_body_get_contacts");
		after = fixture_velocity(world, box);
		*out_apex = fmax(*out_apex, (double)fixture_pose(world, box).position_m.y);
		if (count == 0 && later == 0)
			worst = fmax(worst, hypot((double)(after.linear_mps.x - before.linear_mps.x), (double)(after.linear_mps.y - before.linear_mps.y) + GRAVITY / 60.0));
	}
	cn_world_destroy(world);
	return worst;
}

static void what_a_see_saw_throws_flies_freely(void)
{
	static const float ratios[] = { 10.0f, 100.0f, 500.0f };
	size_t k;
	for (k = 0; k < 3; ++k) {
		double apex, worst = thrown(ratios[k], &apex);
		printf("  1:%.0f: apex %.2f m\n", (double)ratios[k], apex);
		CHECK_LE("change of speed in flight beyond free fall", worst, 1e-5, "m/s");
		CHECK_GE("apex", apex, 2.0, "m"); /* it flies */
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(what_a_see_saw_throws_flies_freely);
	return test_end();
}
