/*
 * test/world/joint_spring_test.c - springs of revolute and distance joints against the law of the damped spring: period,
 * decay, sag under a load, and that they hold whatever their frequency.
 *
 * If a test here fails, look first in: step/solve_make.c (what a spring is in a substep), joints/joint_type.c.
 */
#include "joints.h"

/*
 * Free motion on a spring, sampled once a frame, obeys x2 = T x1 - D x0 with D = e^(-2 zeta w H) and
 * T = 2 e^(-zeta w H) cos(wd H). T and D by least squares over the samples give frequency and decay rate.
 */
typedef struct spring_fit {
	double yy, yz, zz, yx, zx; /* y = x1, z = -x0 */
	double eg, gg;             /* of critical_add */
} spring_fit;

static void fit_add(spring_fit *f, double x0, double x1, double x2)
{
	f->yy += x1 * x1;
	f->yz -= x1 * x0;
	f->zz += x0 * x0;
	f->yx += x1 * x2;
	f->zx -= x0 * x2;
}

static void fit_solve(const spring_fit *f, double *trace, double *det)
{
	double d = f->yy * f->zz - f->yz * f->yz;
	*trace = (f->yx * f->zz - f->zx * f->yz) / d;
	*det = (f->yy * f->zx - f->yz * f->yx) / d;
}

/* T = 2 z, D = z^2 with the double eigenvalue z: one unknown, near its exact value. */
static void critical_add(spring_fit *f, double z, double x0, double x1, double x2)
{
	double e = x2 - 2.0 * z * x1 + z * z * x0, g = 2.0 * z * x0 - 2.0 * x1;
	f->eg += e * g;
	f->gg += g * g;
}

/* Steps a joint whose spring was pulled by 1 and let go, and compares frequency and decay with the law. */
static void spring_check(cn_world *world, cn_joint joint, double rest, double hertz, double zeta, const char *what)
{
	int32_t critical = zeta == 1.0; /* gone in a few frames: one substep a step, and every one is a sample */
	double w = 2.0 * PI * hertz, frame = critical ? 0.25 * (double)FRAME_S : (double)FRAME_S, x[3] = { 0.0, 0.0, 0.0 }, trace, det, first = 0.0, last = 0.0;
	double slow = w * (zeta - sqrt(fmax(zeta * zeta - 1.0, 0.0))), settle = 0.1 / hertz;
	spring_fit fit = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
	int32_t skipped = critical ? 14 : 4; /* the spring's force comes up in the first substeps */
	int32_t samples = 0, first_at = 0, last_at = 0, k, steps = (int32_t)(20.0 / hertz / frame) + 8;
	if (critical)
		must(cn_world_set_substep_count(world, 1), world, "cn_world_set_substep_count");
	for (k = 0; k < steps; ++k) {
		x[0] = x[1];
		x[1] = x[2];
		x[2] = joint_position(world, joint) - rest;
		if (zeta > 0.0 && fabs(x[2]) < (critical ? 1e-5 : 1e-3))
			break;
		if (k >= skipped) {
			++samples;
			fit_add(&fit, x[0], x[1], x[2]);
			critical_add(&fit, exp(-w * frame), x[0], x[1], x[2]);
		}
		if (zeta > 1.0 && (double)k * frame >= settle) {
			if (first_at == 0) {
				first_at = k;
				first = x[2];
			}
			last_at = k;
			last = x[2];
		}
		must(cn_world_step(world, (float)frame), world, "cn_world_step");
	}
	if (zeta > 1.0) { /* the quick root is gone after a moment: what is left decays by the slow one */
		double rate = log(first / last) / ((double)(last_at - first_at) * frame);
		printf("  %s %4.1f Hz, damping ratio %.1f: decay %.5f /s, exact %.5f /s\n", what, hertz, zeta, rate, slow);
		CHECK_LE("relative error of the decay", fabs(rate - slow) / slow, 1e-3, "");
		return;
	}
	fit_solve(&fit, &trace, &det);
	if (critical) {
		double rate = w - log(1.0 - fit.eg / fit.gg / exp(-w * frame)) / frame;
		printf("  %s %4.1f Hz, damping ratio %.1f: decay %.5f /s, exact %.5f /s, from %d samples\n", what, hertz, zeta, rate, w, (int)samples);
		CHECK_LE("relative error of the decay", fabs(rate - w) / w, 1e-3, "");
	} else {
		double turn = acos(fmin(fmax(0.5 * trace / sqrt(det), -1.0), 1.0)) / frame, turn_exact = w * sqrt(1.0 - zeta * zeta), rate = -0.5 * log(det) / frame;
		printf("  %s %4.1f Hz, damping ratio %.1f: period %.6f s, exact %.6f s; decay %.5f /s, exact %.5f /s\n", what, hertz, zeta,
		       2.0 * PI / turn, 2.0 * PI / turn_exact, rate, zeta * w);
		CHECK_LE("relative error of the period", fabs(turn - turn_exact) / turn_exact, 2.0 * SOLVED, "");
		CHECK_LE("error of the decay / frequency", fabs(rate - zeta * w) / w, 1e-3, "");
	}
}

static const double spring_hertz[] = { 1.0, 2.0, 5.0, 10.0, 20.0 };
static const double spring_zeta[] = { 0.0, 0.1, 1.0, 3.0 };

static void revolute_spring_follows_the_law(void)
{
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_body wheel = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.7f, 0.6f, 0.0f);
			cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), wheel, at(0.0f, 0.0f));
			def.base.flags = CN_JOINT_SPRING;
			def.spring_target_rad = 1.0f;
			def.spring_hertz = (float)spring_hertz[f];
			def.spring_damping_ratio = (float)spring_zeta[z];
			spring_check(world, make_revolute(world, &def), 1.0, spring_hertz[f], spring_zeta[z], "angle");
			cn_world_destroy(world);
		}
}

/* A bar pinned at its end: the spring's frequency is that of the bar about its pin. */
static void spring_moves_a_pinned_bar_at_its_frequency(void)
{
	size_t f;
	for (f = 0; f < 5; ++f) {
		cn_world *world = fixture_world(0.0f, 0);
		cn_body bar = fixture_box(world, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.0f, 1.0f, 0.1f, 0.6f, 0.0f);
		cn_revolute_def def = revolute_def(0, at(0.0f, 0.0f), bar, at(-1.0f, 0.0f));
		def.base.flags = CN_JOINT_SPRING;
		def.spring_target_rad = 0.1f;
		def.spring_hertz = (float)spring_hertz[f];
		def.spring_damping_ratio = 0.1f;
		spring_check(world, make_revolute(world, &def), 0.1, spring_hertz[f], 0.1, "bar");
		cn_world_destroy(world);
	}
}

static void distance_spring_follows_the_law(void)
{
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(0.0f, 0);
			cn_body a = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.2f, 0.6f, 0.0f);
			cn_body b = fixture_circle(world, CN_BODY_DYNAMIC, 3.0f, 0.0f, 0.4f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(a, at(0.0f, 0.0f), b, at(0.0f, 0.0f), 2.0f);
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = (float)spring_hertz[f];
			def.spring_damping_ratio = (float)spring_zeta[z];
			spring_check(world, make_distance(world, &def), 2.0, spring_hertz[f], spring_zeta[z], "length");
			cn_world_destroy(world);
		}
}

/* A weight on a spring comes to rest at g / w^2 below the spring's length. */
static void loaded_spring_sags_as_hooke_says(void)
{
	static const double hertz[] = { 1.0, 2.0, 5.0, 10.0, 20.0 }, zeta[] = { 0.1, 0.7, 1.0, 3.0 };
	size_t f, z;
	for (f = 0; f < 5; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(-10.0f, 0);
			double w = 2.0 * PI * hertz[f], exact = GRAVITY / (w * w), sag;
			cn_body weight = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, (float)(-1.0 - exact), 0.3f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(0, at(0.0f, 0.0f), weight, at(0.0f, 0.0f), 1.0f);
			cn_joint joint;
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = (float)hertz[f];
			def.spring_damping_ratio = (float)zeta[z];
			joint = make_distance(world, &def);
			fixture_step(world, 1200);
			sag = joint_position(world, joint) - 1.0;
			printf("  %4.1f Hz, damping ratio %.1f: sag %.6f m, exact %.6f m\n", hertz[f], zeta[z], sag, exact);
			/* Light damping at 10 Hz and more keeps its motion exact and gives up a little of this. */
			CHECK_LE("relative error of the sag", fabs(sag - exact) / exact, zeta[z] < 0.5 && hertz[f] > 5.0 ? 0.03 : 2.0 * SOLVED, "");
			cn_world_destroy(world);
		}
}

/* Whatever the substep: a spring that is stiffer than it can follow must still hold. */
static void stiff_springs_hold(void)
{
	static const float hertz[] = { 60.0f, 120.0f, 240.0f, 480.0f, 1e4f, 1e6f };
	static const float zeta[] = { 0.0f, 0.1f, 1.0f, 10.0f };
	size_t f, z;
	double worst = 0.0;
	for (f = 0; f < 6; ++f)
		for (z = 0; z < 4; ++z) {
			cn_world *world = fixture_world(-10.0f, 0);
			cn_body weight = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, -1.0f, 0.3f, 0.6f, 0.0f);
			cn_distance_def def = distance_def(0, at(0.0f, 0.0f), weight, at(0.0f, 0.0f), 1.0f);
			double most = 0.0;
			cn_joint joint;
			int32_t k;
			def.base.flags = CN_JOINT_SPRING;
			def.spring_hertz = hertz[f];
			def.spring_damping_ratio = zeta[z];
			joint = make_distance(world, &def);
			for (k = 0; k < 600; ++k) {
				fixture_step(world, 1);
				most = greater(most, fabs(joint_position(world, joint) - 1.0));
			}
			if (most > 1e-3)
				printf("  %g Hz, damping ratio %g: %.6f m\n", (double)hertz[f], (double)zeta[z], most);
			worst = greater(worst, most);
			cn_world_destroy(world);
		}
	/* 2 g / w^2 at 60 Hz is 0.14 mm, one substep's fall g h^2 = 0.17 mm. */
	CHECK_LE("most stretch of a stiff spring under a weight", worst, 1e-3, "m");
}

/* ---- lattices ---- */

static void spring_add(cn_world *world, cn_body a, cn_body b, float length, float hertz, float damping)
{
	cn_distance_def def = distance_def(a, at(0.0f, 0.0f), b, at(0.0f, 0.0f), length);
	def.base.flags |= CN_JOINT_SPRING;
	def.spring_hertz = hertz;
	def.spring_damping_ratio = damping;
	(void)make_distance(world, &def);
}

/* size x size discs, joined to their neighbours along rows, columns and diagonals, fall 2 m. Returns the speed of the fastest in 5 s. */
static double lattice_speed(int32_t size, float hertz, float damping, float dt, int32_t solver)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body discs[64];
	double most = 0.0;
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < size * size; ++k) {
		int32_t x = k % size, y = k / size;
		discs[k] = fixture_circle(world, CN_BODY_DYNAMIC, 0.5f * (float)x, 2.0f + 0.5f * (float)y, 0.22f, 0.6f, 0.0f);
		if (x > 0)
			spring_add(world, discs[k - 1], discs[k], 0.5f, hertz, damping);
		if (y > 0)
			spring_add(world, discs[k - size], discs[k], 0.5f, hertz, damping);
		if (x > 0 && y > 0)
			spring_add(world, discs[k - size - 1], discs[k], 0.70710678f, hertz, damping);
		if (x < size - 1 && y > 0)
			spring_add(world, discs[k - size + 1], discs[k], 0.70710678f, hertz, damping);
	}
	for (k = 0; k < (int32_t)(5.0f / dt); ++k) {
		must(cn_world_step(world, dt), world, "cn_world_step");
		most = fmax(most, totals_of(world, discs, size * size).speed_most);
	}
	cn_world_destroy(world);
	return most;
}

/* A cloth of 16 x 8 discs on springs hangs from its upper row. Returns the speed of the fastest between 8 and 10 s, with one substep of 1/60 s. */
static double cloth_speed_at_last(float hertz, int32_t solver)
{
	enum { WIDTH = 16, HEIGHT = 8 };
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body discs[WIDTH * HEIGHT];
	double most = 0.0;
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, 1), world, "cn_world_set_substep_count");
	for (k = 0; k < WIDTH * HEIGHT; ++k) {
		discs[k] = fixture_circle(world, k < WIDTH ? CN_BODY_STATIC : CN_BODY_DYNAMIC, 0.5f * (float)(k % WIDTH), 10.0f - 0.5f * (float)(k / WIDTH), 0.1f, 0.6f, 0.0f);
		if (k % WIDTH > 0 && k >= WIDTH)
			spring_add(world, discs[k - 1], discs[k], 0.5f, hertz, 0.1f);
		if (k >= WIDTH)
			spring_add(world, discs[k - WIDTH], discs[k], 0.5f, hertz, 0.1f);
	}
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		if (k > 480)
			most = fmax(most, totals_of(world, discs + WIDTH, WIDTH * (HEIGHT - 1)).speed_most);
	}
	cn_world_destroy(world);
	return most;
}

static void cloths_of_springs_come_to_rest(void)
{
	double most = 0.0;
	int32_t k;
	for (k = 0; k < 8; ++k)
		most = fmax(most, cloth_speed_at_last(14.0f + 2.0f * (float)(k / 2), k & 1 ? CN_SOLVER_SOFT : CN_SOLVER_AUTO));
	CHECK_LE("fastest disc of a hung cloth of springs after 8 s", most, 0.5, "m/s");
}

/* Waves of a lattice are several times as fast as the spring of one body; it falls at 6.3 m/s. */
static void lattices_of_springs_gain_no_energy(void)
{
	static const float hertz[] = { 5.0f, 12.0f, 20.0f, 26.0f, 40.0f, 60.0f, 200.0f }, damping[] = { 0.0f, 0.1f, 0.3f, 1.0f };
	double most = 0.0;
	int32_t k;
	for (k = 0; k < 7 * 4 * 2 * 2; k += TEST_FORM(1, 3, 9)) {
		float dt = k / 28 % 2 ? 1.0f / 30.0f : 1.0f / 60.0f;
		double speed = lattice_speed(k / 56 ? 7 : 4, hertz[k % 7], damping[k / 7 % 4], dt, k & 1 ? CN_SOLVER_SOFT : CN_SOLVER_AUTO);
		if (speed > 15.0)
			printf("  %.0f Hz, damping %.1f, %.3f s: %.1f m/s\n", (double)hertz[k % 7], (double)damping[k / 7 % 4], (double)dt, speed);
		most = fmax(most, speed);
	}
	CHECK_LE("fastest disc of a lattice of springs", most, 15.0, "m/s");
}

static void heavy_up(cn_world *world, cn_body body, float scale)
{
	cn_mass_data mass;
	must(cn_body_get_mass_data(world, body, &mass), world, "cn_body_get_mass_data");
	mass.mass_kg *= scale;
	mass.inertia_kgm2 *= scale;
	must(cn_body_set_mass_data(world, body, &mass), world, "cn_body_set_mass_data");
}

/* Ten discs in a row, of up to ten times the mass of the lightest, swing from a pin. Their joints are pins and welds; a third has a stiffness. Returns
   the speed of the fastest in 10 s. */
static double stiff_row_speed(uint32_t seed, float hertz, float damping, int32_t solver)
{
	enum { COUNT = 10 };
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body discs[COUNT];
	double most = 0.0;
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	for (k = 0; k < COUNT; ++k) {
		int32_t stiff = k > 0 && fixture_random(&seed, 0.0f, 3.0f) < 1.0f, weld = k > 0 && fixture_random(&seed, 0.0f, 2.0f) < 1.0f;
		cn_body before = k > 0 ? discs[k - 1] : 0;
		cn_vec2 end = at(k > 0 ? 0.25f : 0.0f, 0.0f), begin = at(-0.25f, 0.0f);
		cn_revolute_def pin;
		cn_fixed_def fixed;
		discs[k] = fixture_circle(world, CN_BODY_DYNAMIC, 0.25f + 0.5f * (float)k, 0.0f, 0.2f, 0.6f, 0.0f);
		heavy_up(world, discs[k], fixture_random(&seed, 1.0f, 10.0f));
		pin = revolute_def(before, end, discs[k], begin);
		cn_fixed_def_init(&fixed);
		connect(&fixed.base, before, end, discs[k], begin);
		if (stiff) {
			pin.base.stiffness_hertz = fixed.base.stiffness_hertz = hertz;
			pin.base.stiffness_damping_ratio = fixed.base.stiffness_damping_ratio = damping;
		}
		(void)(weld ? make_fixed(world, &fixed) : make_revolute(world, &pin));
	}
	for (k = 0; k < 600; ++k) {
		fixture_step(world, 1);
		most = fmax(most, totals_of(world, discs, COUNT).speed_most);
	}
	cn_world_destroy(world);
	return most;
}

static void joints_with_a_stiffness_gain_no_energy(void)
{
	static const float hertz[] = { 30.0f, 60.0f, 100.0f, 1e4f }, damping[] = { 0.0f, 0.3f, 2.0f };
	double most = 0.0;
	int32_t k;
	for (k = 0; k < 4 * 3 * 2 * TEST_MANY(4); ++k) {
		double speed = stiff_row_speed(1u + (uint32_t)(k / 24), hertz[k % 4], damping[k / 4 % 3], k / 12 & 1 ? CN_SOLVER_SOFT : CN_SOLVER_AUTO);
		if (speed > 40.0)
			printf("  %u %.0f Hz, damping %.1f, solver %d: %.1f m/s\n", (unsigned)(k / 24), (double)hertz[k % 4], (double)damping[k / 4 % 3], k / 12 & 1, speed);
		most = fmax(most, speed);
	}
	CHECK_LE("fastest disc of a row", most, 40.0, "m/s");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(revolute_spring_follows_the_law);
	RUN(spring_moves_a_pinned_bar_at_its_frequency);
	RUN(distance_spring_follows_the_law);
	RUN(loaded_spring_sags_as_hooke_says);
	RUN(stiff_springs_hold);
	RUN(lattices_of_springs_gain_no_energy);
	RUN(joints_with_a_stiffness_gain_no_energy);
	RUN(cloths_of_springs_come_to_rest);
	return test_end();
}
