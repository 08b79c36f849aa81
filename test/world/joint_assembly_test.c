/*
 * test/world/joint_assembly_test.c - many bodies on revolute joints and rods: chains, a grid, a bridge, ragdolls, and
 * what flies freely. Anchors stay together, reactions carry what hangs below, momentum is kept, no energy comes in.
 *
 * If a test here fails, look first in: joints/joint_solve.c, joint_blocks.c, then rattle.c and component_fate.c (which
 * of them are exact).
 */
#include "joints.h"
#include "scenes/build.h"

static void chain_of_10_carries_what_hangs_below(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[10];
	cn_joint joints[10];
	double worst = 0.0, link_weight;
	int32_t k;
	make_chain(world, 10, 0.0f, -1.0f, links, joints);
	link_weight = (double)mass_of(world, links[0]).mass_kg * GRAVITY;
	fixture_step(world, 300);
	for (k = 0; k < 10; ++k) {
		double exact = link_weight * (double)(10 - k), force = (double)joint_force(world, joints[k]).y;
		printf("  link %d: %.5f N, exact %.5f N\n", (int)k, force, exact);
		worst = greater(worst, fabs(force - exact) / exact);
	}
	CHECK_LE("relative error of the reactions", worst, ROUNDING, "");
	cn_world_destroy(world);
}

static void hanging_chain_of_20_does_not_stretch(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[20];
	cn_joint joints[20];
	double worst = 0.0, stretch = 0.0;
	cn_vec2 end;
	int32_t k;
	make_chain(world, 20, 0.0f, -1.0f, links, joints);
	for (k = 0; k < 3600; ++k) {
		fixture_step(world, 1);
		must(cn_body_get_world_point(world, links[19], 0.25f, 0.0f, &end), world, "cn_body_get_world_point");
		stretch = hypot((double)end.x, (double)end.y) - 10.0;
		worst = greater(worst, stretch);
	}
	CHECK_LE("stretch of 10 m after 60 s", stretch, ROUNDING, "m");
	CHECK_LE("most stretch since the chain was let go", worst, ROUNDING, "m");
	CHECK_LE("sideways drift", fabs((double)end.x), ROUNDING, "m");
	cn_world_destroy(world);
}

static void swinging_chain_of_20_stays_together(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[20];
	cn_joint joints[20];
	double worst = 0.0, late = 0.0, most = -1e9, least = 1e9, energy0;
	totals t;
	int32_t k;
	make_chain(world, 20, 1.0f, 0.0f, links, joints);
	t = totals_of(world, links, 20);
	energy0 = t.kinetic + t.potential;
	for (k = 0; k < 3600; ++k) {
		double error;
		fixture_step(world, 1);
		error = worst_joint_error(world);
		worst = greater(worst, error);
		late = k >= 3000 ? fmax(late, error) : late;
		t = totals_of(world, links, 20);
		most = greater(most, t.kinetic + t.potential - energy0);
		least = fmin(least, t.kinetic + t.potential - energy0);
	}
	/* Depth: 20 links of 0.06 kg... falling 5 m on average. */
	printf("  energy %+.2e of its depth at least, %+.2e at most against the start; error in the last 10 s %.6f m\n", least / (20.0 * 0.06 * GRAVITY * 5.0), most / (20.0 * 0.06 * GRAVITY * 5.0), late);
	CHECK_LE("greatest distance between anchors", worst, 0.035, "m");
	CHECK_LE("energy gained / depth", most / (20.0 * 0.06 * GRAVITY * 5.0), 2.0 * ROUNDING, "");
	cn_world_destroy(world);
}

/* The benchmark's joint_grid: 10,000 balls on 19,794 pins (1,600 in a slow build), seven of them held. As stiff as 16 substeps make it. */
static void grid_of_10000_bodies_keeps_its_anchors(void)
{
	const int32_t steps = TEST_FORM(60, 24, 2);
	enum { SIDE = TEST_FORM(100, 100, 40) };
	static cn_body balls[SIDE][SIDE];
	cn_world *world = fixture_world(-10.0f, 0);
	double worst = 0.0;
	int32_t i, k;
	must(cn_world_set_substep_count(world, 16), world, "cn_world_set_substep_count");
	for (k = 0; k < SIDE; ++k)
		for (i = 0; i < SIDE; ++i) {
			int32_t held = i == 0 && k >= SIDE / 2 - 3 && k <= SIDE / 2 + 3;
			balls[k][i] = fixture_circle(world, held ? CN_BODY_STATIC : CN_BODY_DYNAMIC, (float)k, -(float)i, 0.4f, 0.6f, 0.0f);
			if (i > 0)
				hinge(world, balls[k][i - 1], at(0.0f, -0.5f), balls[k][i], at(0.0f, 0.5f));
			if (k > 0 && !(held && k > SIDE / 2 - 3))
				hinge(world, balls[k - 1][i], at(0.5f, 0.0f), balls[k][i], at(-0.5f, 0.0f));
		}
	for (k = 0; k < steps; ++k) {
		fixture_step(world, 1);
		worst = greater(worst, worst_joint_error(world));
	}
	CHECK_LE("greatest distance between anchors", worst, 0.06, "m"); /* a net this large is soft: 0.58 m at 4 substeps, as in Box2D */
	cn_world_destroy(world);
}

static void bridge_of_50_links_carries(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[50], loads[6];
	double worst = 0.0, late = 0.0;
	int32_t k, on = 0;
	for (k = 0; k < 50; ++k) {
		cn_shape_def shape;
		links[k] = fixture_body(world, CN_BODY_DYNAMIC, -12.25f + 0.5f * (float)k, 0.0f, 0.0f);
		shape = fixture_shape_def(links[k], 0.6f, 0.0f);
		shape.density_kgpm2 = 20.0f;
		fixture_box_shape(world, &shape, 0.25f, 0.125f);
		hinge(world, k == 0 ? 0 : links[k - 1], k == 0 ? at(-12.5f, 0.0f) : at(0.25f, 0.0f), links[k], at(-0.25f, 0.0f));
	}
	hinge(world, links[49], at(0.25f, 0.0f), 0, at(12.5f, 0.0f));
	for (k = 0; k < 6; ++k)
		loads[k] = fixture_box(world, CN_BODY_DYNAMIC, -5.0f + 2.0f * (float)k, 2.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	for (k = 0; k < 1200; ++k) {
		double error;
		fixture_step(world, 1);
		error = worst_joint_error(world);
		worst = greater(worst, error);
		late = k >= 600 ? fmax(late, error) : late;
	}
	for (k = 0; k < 6; ++k)
		on += (double)fixture_pose(world, loads[k]).position_m.y > -6.0;
	printf("  %d of 6 loads are on the bridge\n", (int)on);
	CHECK(on == 6);
	/* 131 kg on a nearly straight bridge: links pull with tens of times their weight at first. */
	CHECK_LE("greatest distance between anchors", worst, 0.1, "m");
	CHECK_LE("greatest distance between anchors in the last 10 s", late, 0.02, "m");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static double worst_error_over(scene_run *run, int32_t from, int32_t to)
{
	double worst = 0.0;
	for (; run->step_index < from; )
		must(scene_step(run), run->world, "scene_step");
	for (; run->step_index < to; ) {
		must(scene_step(run), run->world, "scene_step");
		worst = greater(worst, worst_joint_error(run->world));
	}
	return worst;
}

static void ragdoll_run(float height, double bound)
{
	scene_run run;
	cn_body bones[SCENE_RAGDOLL_BODIES];
	must(scene_open(&run, scene_find("memory_empty"), NULL), NULL, "scene_open");
	fixture_floor(run.world, 0.6f, 0.0f);
	scene_ragdoll(&run, 0.0f, height, -1, bones);
	printf("  dropped from %.1f m\n", (double)height);
	CHECK_LE("greatest distance between anchors in the fall", worst_error_over(&run, 0, 240), bound, "m");
	CHECK_LE("lying on the ground", worst_error_over(&run, 240, 480), 1.5 * SOLVED, "m"); /* contacts are solved last */
	CHECK(fixture_is_valid(run.world));
	scene_close(&run);
}

/* A stop travels one joint a substep through the bones, so it tears them by up to 2 v h: 53 mm from 2 m. */
static void ragdoll_on_the_ground_stays_together(void)
{
	ragdoll_run(0.0f, 0.02);
	ragdoll_run(0.2f, 0.02);
	ragdoll_run(2.0f, 0.053);
}

/* Limbs of 60 g under several ragdolls that come down at 10 m/s and more: joints give way and close again. */
static void ragdolls_in_a_heap_come_together_again(void)
{
	scene_run run;
	must(scene_open(&run, scene_find("ragdolls"), NULL), NULL, "scene_open");
	CHECK_LE("greatest distance between anchors while they fall", worst_error_over(&run, 0, 360), 0.15, "m");
	CHECK_LE("in the last 2 s", worst_error_over(&run, 360, 480), 3e-3, "m");
	scene_close(&run);
}

/* ---- free assemblies ---- */

/* A chain, a ring and a spring-loaded tree of bodies in free flight. */
static int32_t make_assembly(cn_world *world, int32_t kind, cn_body *bodies, uint32_t seed)
{
	int32_t k, count = kind == 0 ? 2 : 8;
	for (k = 0; k < count; ++k) {
		float r = kind == 0 ? 0.3f : fixture_random(&seed, 0.1f, 0.3f);
		cn_shape_def shape;
		bodies[k] = fixture_body(world, CN_BODY_DYNAMIC, kind == 2 ? (float)cos(PI * k / 4.0) * 2.0f : (float)k, kind == 2 ? (float)sin(PI * k / 4.0) * 2.0f : 0.0f, 0.0f);
		shape = fixture_shape_def(bodies[k], 0.6f, 0.0f);
		shape.filter.group = -1;
		fixture_box_shape(world, &shape, r, 0.7f * r);
	}
	for (k = 0; k + 1 < count + (kind == 2); ++k) {
		cn_pose a = fixture_pose(world, bodies[k]), b = fixture_pose(world, bodies[(k + 1) % count]);
		float hx = 0.5f * (b.position_m.x - a.position_m.x), hy = 0.5f * (b.position_m.y - a.position_m.y);
		if (kind == 3) {
			cn_distance_def def = distance_def(bodies[k / 2], at(0.0f, 0.0f), bodies[k + 1], at(0.0f, 0.0f), (float)(k + 1 - k / 2));
			make_distance(world, &def);
		} else {
			hinge(world, bodies[k], at(hx, hy), bodies[(k + 1) % count], at(-hx, -hy));
		}
	}
	return count;
}

/*
 * Momentum changes by rounding only: velocities are summed up some 7,000 times in 10 s, a random walk of
 * half units in the last place that comes to a few 1e-6. Energy is compared with that after one second: at first
 * the joints are torn open by velocities that do not fit, and close again.
 */
static void assembly_run(int32_t kind, const char *name)
{
	cn_world *world = fixture_world(0.0f, 0);
	cn_body bodies[8];
	uint32_t seed = 77u + (uint32_t)kind;
	int32_t count = make_assembly(world, kind, bodies, 2463534242u), k;
	totals start, now;
	double most = 0.0, drift_1 = 0.0, drift = 0.0, spin_drift = 0.0, settled = 0.0;
	for (k = 0; k < count; ++k) {
		float vx = fixture_random(&seed, -3.0f, 3.0f), vy = fixture_random(&seed, -3.0f, 3.0f), w = fixture_random(&seed, -5.0f, 5.0f);
		fixture_set_velocity(world, bodies[k], vx, vy, w);
	}
	start = now = totals_of(world, bodies, count);
	for (k = 1; k <= 600; ++k) {
		fixture_step(world, 1);
		now = totals_of(world, bodies, count);
		drift = greater(drift, hypot(now.px - start.px, now.py - start.py) / start.momentum_scale);
		spin_drift = greater(spin_drift, fabs(now.spin - start.spin) / start.spin_scale);
		if (k <= 60) {
			settled = now.kinetic;
			drift_1 = drift;
			CHECK(now.kinetic <= start.kinetic);
		}
		most = greater(most, k < 60 ? 0.0 : now.kinetic / settled);
	}
	printf("  %s: energy %.4f J, %.4f after 1 s, %.4f after 10 s\n", name, start.kinetic, settled, now.kinetic);
	CHECK_LE("most energy / that after 1 s", most, 1.002, "");
	CHECK_LE("change of momentum in 1 s / sum of momenta", drift_1, 2e-6, "");
	CHECK_LE("change of momentum in 10 s / sum of momenta", drift, 1e-5, "");
	CHECK_LE("change of angular momentum in 10 s / its parts", spin_drift, 2.0 * SOLVED, "");
	CHECK_LE("distance between anchors at the end", worst_joint_error(world), ROUNDING, "m");
	cn_world_destroy(world);
}

static void free_assemblies_keep_momentum_and_gain_no_energy(void)
{
	assembly_run(0, "two bars");
	assembly_run(1, "chain of 8");
	assembly_run(2, "ring of 8");
	assembly_run(3, "tree of rods");
}

/* Greatest speed in so many steps of points that are arm metres from a body's centre, m/s. */
static double fastest_over(cn_world *world, const cn_body *bodies, int32_t count, double arm, int32_t steps)
{
	double fastest = 0.0;
	int32_t step, k;
	for (step = 0; step < steps; ++step) {
		fixture_step(world, 1);
		for (k = 0; k < count; ++k) {
			cn_velocity v = fixture_velocity(world, bodies[k]);
			fastest = greater(fastest, hypot((double)v.linear_mps.x, (double)v.linear_mps.y) + arm * fabs((double)v.angular_radps));
		}
	}
	return fastest;
}

/* Puts links of a hanging chain up to `way` metres away along either axis, three times. Returns the greatest speed, and in *left the widest joint
   at the end. friction_Nm > 0: of its pins, so that it is not for RATTLE. */
static double put_chain_speed(int32_t solver, int32_t substeps, uint32_t random, float way, float friction_Nm, double *left)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[12];
	cn_joint joints[12];
	double fastest = 0.0;
	int32_t step, k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	make_chain(world, 12, 0.0f, -1.0f, links, joints);
	for (k = 0; k < 12 && friction_Nm > 0.0f; ++k) {
		must(cn_joint_set_motor(world, joints[k], 0.0f, friction_Nm), world, "cn_joint_set_motor");
		must(cn_joint_set_flags(world, joints[k], CN_JOINT_MOTOR), world, "cn_joint_set_flags");
	}
	for (step = 0; step < 360; ++step) {
		if (step == 10 || step == 70 || step == 130) {
			cn_body put = links[(int32_t)fixture_random(&random, 0.0f, 11.9f)];
			cn_pose pose = fixture_pose(world, put);
			float x = pose.position_m.x + fixture_random(&random, -way, way), y = pose.position_m.y + fixture_random(&random, -way, way);
			must(cn_body_set_pose(world, put, x, y, 0.0f), world, "cn_body_set_pose");
		}
		fastest = greater(fastest, fastest_over(world, links, 12, 0.0, 1));
	}
	*left = worst_joint_error(world);
	cn_world_destroy(world);
	return fastest;
}

static void parts_close(int32_t solver, int32_t substeps, float way, float friction_Nm, double speed_most)
{
	double fastest = 0.0, left = 0.0;
	int32_t seed;
	for (seed = 0; seed < TEST_MANY(10); ++seed) {
		double one;
		fastest = greater(fastest, put_chain_speed(solver, substeps, 11u + (uint32_t)seed, way, friction_Nm, &one));
		left = greater(left, one);
	}
	CHECK_LE("greatest speed", fastest, speed_most, "m/s");
	CHECK_LE("greatest distance between anchors at the end", left, 0.1, "m");
}

/* A soft joint closes at 20 m/s at most; what hangs on it adds its own speed. Joints that are less far apart than they see are exact. */
static void parts_that_are_put_away_close_at_a_bounded_speed(void)
{
	int32_t solver;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver) {
		parts_close(solver, 4, 5.0f, 0.0f, 50.0);
		parts_close(solver, 32, 0.15f, 0.0f, 15.0);
		parts_close(solver, 32, 0.15f, 0.01f, 20.0);
	}
}

/* A disc that slides along x by a point 0.3 m from its centre: on a line in space, in a slot or on a suspension of the world. */
static cn_body make_slider(cn_world *world, int32_t kind, double turn)
{
	cn_body disc = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.42f, 0.6f, 0.0f);
	cn_vec2 anchor = at((float)(0.3 * cos(turn)), (float)(0.3 * sin(turn)));
	cn_line_constraint_def line;
	cn_constraint constraint;
	cn_groove_def groove;
	cn_wheel_def wheel;
	cn_line_constraint_def_init(&line);
	cn_groove_def_init(&groove);
	cn_wheel_def_init(&wheel);
	line.body = disc;
	line.anchor_m = line.origin_m = anchor;
	connect(&groove.base, 0, at(anchor.x - 30.0f, anchor.y), disc, anchor);
	groove.end_m = at(anchor.x + 30.0f, anchor.y);
	connect(&wheel.base, 0, anchor, disc, anchor);
	wheel.axis = at(1.0f, 0.0f);
	if (kind == 0)
		must(cn_constraint_create_line(world, &line, &constraint), world, "cn_constraint_create_line");
	else if (kind == 1)
		make_groove(world, &groove);
	else
		make_wheel(world, &wheel);
	return disc;
}

static double put_slider_speed(int32_t kind, double turn, int32_t solver, int32_t substeps, float way)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body disc = make_slider(world, kind, turn);
	double fastest;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	fixture_step(world, 10);
	must(cn_body_set_pose(world, disc, fixture_pose(world, disc).position_m.x, way, 0.0f), world, "cn_body_set_pose");
	fastest = fastest_over(world, &disc, 1, 0.0, 60);
	cn_world_destroy(world);
	return fastest;
}

static void sliders_that_are_put_away_close_at_a_bounded_speed(void)
{
	static const char *names[3] = { "line", "groove", "wheel" };
	int32_t kind, solver, substeps, turn;
	for (kind = 0; kind < 3; ++kind)
		for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver)
			for (substeps = 4; substeps <= 32; substeps += 28) {
				double fastest = 0.0;
				for (turn = 0; turn < 8; ++turn) {
					fastest = greater(fastest, put_slider_speed(kind, 0.25 * PI * (double)turn, solver, substeps, 0.24f));
					fastest = greater(fastest, put_slider_speed(kind, 0.25 * PI * (double)turn, solver, substeps, 3.0f));
				}
				printf("  %s, %s, %d substeps\n", names[kind], solver == CN_SOLVER_AUTO ? "auto" : "soft", (int)substeps);
				CHECK_LE("greatest speed", fastest, 30.0, "m/s");
			}
}

enum { TURNED_WELDS, TURNED_SLIDES, TURNED_GEARS, TURNED_LIMITS, LIMITS_CHANGED, TURNED_KINDS };

static cn_joint join_turned(cn_world *world, int32_t kind, cn_body a, cn_body b)
{
	cn_fixed_def weld;
	cn_prismatic_def slide;
	cn_revolute_def pin;
	cn_gear_def gear;
	cn_vec2 end = at(a != 0 ? 0.5f : 0.0f, 0.0f);
	cn_joint joint;
	cn_fixed_def_init(&weld);
	cn_prismatic_def_init(&slide);
	cn_revolute_def_init(&pin);
	cn_gear_def_init(&gear);
	connect(&weld.base, a, end, b, at(-0.5f, 0.0f));
	connect(&slide.base, a, end, b, at(-0.5f, 0.0f));
	connect(&pin.base, a, end, b, at(-0.5f, 0.0f));
	slide.axis = at(1.0f, 0.0f);
	slide.base.flags |= CN_JOINT_LIMIT;
	slide.lower_m = -0.1f;
	slide.upper_m = 0.1f;
	if (kind == TURNED_LIMITS || kind == LIMITS_CHANGED) {
		pin.base.flags |= CN_JOINT_LIMIT;
		pin.lower_angle_rad = -0.2f;
		pin.upper_angle_rad = 0.2f;
	}
	gear.base.body_a = a;
	gear.base.body_b = b;
	gear.ratio = -1.0f;
	if (kind == TURNED_WELDS)
		return make_fixed(world, &weld);
	if (kind == TURNED_SLIDES)
		return make_prismatic(world, &slide);
	joint = make_revolute(world, &pin);
	if (kind == TURNED_GEARS && a != 0)
		make_gear(world, &gear);
	return joint;
}

static void turn_about_end(cn_world *world, cn_body part, double turn)
{
	cn_pose pose = fixture_pose(world, part);
	double x = (double)pose.position_m.x - 0.5 * (double)pose.cosine, y = (double)pose.position_m.y - 0.5 * (double)pose.sine;
	double angle = atan2((double)pose.sine, (double)pose.cosine) + turn;
	must(cn_body_set_pose(world, part, (float)(x + 0.5 * cos(angle)), (float)(y + 0.5 * sin(angle)), (float)angle), world, "cn_body_set_pose");
}

/* Three parts in a row, hung from the world; one of them is turned about the joint before it, or that joint gets other limits. Returns the
   greatest speed of a part's ends. */
static double turned_speed(int32_t kind, int32_t solver, int32_t substeps, int32_t which, double turn)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body parts[3];
	cn_joint joints[3];
	double fastest;
	int32_t k;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	for (k = 0; k < 3; ++k) {
		cn_shape_def shape;
		parts[k] = fixture_body(world, CN_BODY_DYNAMIC, 0.5f + (float)k, 0.0f, 0.0f);
		shape = fixture_shape_def(parts[k], 0.6f, 0.0f);
		shape.filter.group = -1;
		fixture_box_shape(world, &shape, 0.4f, 0.2f);
		joints[k] = join_turned(world, kind, k > 0 ? parts[k - 1] : 0, parts[k]);
	}
	fixture_step(world, 20);
	if (kind == LIMITS_CHANGED)
		must(cn_joint_set_limits(world, joints[which], (float)turn - 0.1f, (float)turn), world, "cn_joint_set_limits");
	else
		turn_about_end(world, parts[which], turn);
	fastest = fastest_over(world, parts, 3, 0.4, 60);
	cn_world_destroy(world);
	return fastest;
}

/* Angles close at 20 rad/s at most, as gaps do at 20 m/s. */
static void parts_that_are_turned_away_close_at_a_bounded_speed(void)
{
	static const char *names[TURNED_KINDS] = { "welds", "slides", "gears", "limits", "other limits" };
	int32_t kind, solver, substeps, k;
	for (kind = 0; kind < TURNED_KINDS; ++kind)
		for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver)
			for (substeps = 4; substeps <= 32; substeps += 28) {
				double fastest = 0.0;
				for (k = 0; k < 12; k += TEST_FORM(1, 2, 4))
					fastest = greater(fastest, turned_speed(kind, solver, substeps, k % 3, 0.1 + 0.26 * (double)k));
				printf("  %s, %s, %d substeps\n", names[kind], solver == CN_SOLVER_AUTO ? "auto" : "soft", (int)substeps);
				CHECK_LE("greatest speed", fastest, 60.0, "m/s");
			}
}

/* A pin of a hanging chain bears next to nothing, or is a spring, for so many steps, and is then as strong as the others. */
static double strong_again_speed(int32_t solver, int32_t substeps, int32_t soft, int32_t steps)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[12];
	cn_joint joints[12];
	cn_joint_base strong, weak;
	double fastest;
	must(cn_world_set_solver(world, solver), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	make_chain(world, 12, 0.0f, -1.0f, links, joints);
	must(cn_joint_get_base(world, joints[5], &strong), world, "cn_joint_get_base");
	weak = strong;
	if (soft)
		weak.stiffness_hertz = 0.2f;
	else
		weak.force_max_N = 0.01f;
	must(cn_joint_set_base(world, joints[5], &weak), world, "cn_joint_set_base");
	fixture_step(world, steps);
	must(cn_joint_set_base(world, joints[5], &strong), world, "cn_joint_set_base");
	fastest = fastest_over(world, links, 12, 0.0, 60);
	cn_world_destroy(world);
	return fastest;
}

static void joints_that_are_strong_again_close_at_a_bounded_speed(void)
{
	int32_t solver, soft, substeps, steps;
	for (solver = CN_SOLVER_AUTO; solver <= CN_SOLVER_SOFT; ++solver)
		for (substeps = 4; substeps <= 32; substeps += 28) {
			double fastest = 0.0;
			for (soft = 0; soft < 2; ++soft)
				for (steps = 10; steps <= 40; steps += 10)
					fastest = greater(fastest, strong_again_speed(solver, substeps, soft, steps));
			CHECK_LE("greatest speed", fastest, 10.0, "m/s");
		}
}

/* A chain with a load that soft constraints stretch as it falls, and that is exact from one step to the next. Returns how much faster than the
   load its links get while they close. */
static double stretched_chain_speed(int32_t count, float load_density, int32_t substeps)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body links[21];
	cn_joint joints[20];
	cn_shape_def shape;
	double opened, fastest, load;
	must(cn_world_set_solver(world, CN_SOLVER_SOFT), world, "cn_world_set_solver");
	must(cn_world_set_substep_count(world, substeps), world, "cn_world_set_substep_count");
	make_chain(world, count, 1.0f, 0.0f, links, joints);
	links[count] = fixture_body(world, CN_BODY_DYNAMIC, 0.5f * (float)count + 0.25f, 0.0f, 0.0f);
	shape = fixture_shape_def(links[count], 0.6f, 0.0f);
	shape.density_kgpm2 = load_density;
	fixture_box_shape(world, &shape, 0.25f, 0.25f);
	hinge(world, links[count - 1], at(0.25f, 0.0f), links[count], at(-0.25f, 0.0f));
	fixture_step(world, 60);
	opened = worst_joint_error(world);
	must(cn_world_set_solver(world, CN_SOLVER_AUTO), world, "cn_world_set_solver");
	fastest = fastest_over(world, links, count, 0.0, 20);
	load = fastest_over(world, links + count, 1, 0.0, 1);
	cn_world_destroy(world);
	return opened < 0.2 ? fastest - load : 0.0; /* wider gaps stay soft */
}

static void stretched_chains_close_at_a_bounded_speed(void)
{
	int32_t links, substeps;
	float load;
	double most = 0.0;
	for (substeps = 2; substeps <= 8; substeps *= 2)
		for (links = 4; links <= 20; links += 4)
			for (load = 10.0f; load < 400.0f; load *= 1.7f)
				most = greater(most, stretched_chain_speed(links, load, substeps));
	CHECK_LE("faster than the load by", most, 22.0, "m/s");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(chain_of_10_carries_what_hangs_below);
	RUN(hanging_chain_of_20_does_not_stretch);
	RUN(swinging_chain_of_20_stays_together);
	RUN(grid_of_10000_bodies_keeps_its_anchors);
	RUN(bridge_of_50_links_carries);
	RUN(ragdoll_on_the_ground_stays_together);
	RUN(ragdolls_in_a_heap_come_together_again);
	RUN(free_assemblies_keep_momentum_and_gain_no_energy);
	RUN(parts_that_are_put_away_close_at_a_bounded_speed);
	RUN(sliders_that_are_put_away_close_at_a_bounded_speed);
	RUN(parts_that_are_turned_away_close_at_a_bounded_speed);
	RUN(joints_that_are_strong_again_close_at_a_bounded_speed);
	RUN(stretched_chains_close_at_a_bounded_speed);
	return test_end();
}
