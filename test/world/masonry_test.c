/*
 * masonry_test - promises: what can stand by friction and by its shape alone stands at every number of substeps, and more
 * substeps are not worse; what comes down hardly gains energy.
 *
 * If a test here fails, run world/direct_contacts first. Then look in: direct/direct_contacts.c, contact_active_set.c, friction_cones.c, solver_selection.c,
 * gravity_preload.c (what leans), sleep.c.
 */
#include "fixture.h"
#include "direct/direct_contact.h"

#define BODIES_MOST 64
#define PI 3.14159265f

typedef struct masonry {
	cn_world *world;
	cn_body bodies[BODIES_MOST];
	cn_pose from[BODIES_MOST];
	cn_mass_data mass[BODIES_MOST];
	int32_t count;
	uint32_t random;
	float friction, x;
	float overlap;       /* of neighbouring wedges */
	cn_vec2 velocity; /* of the floor and all on it */
} masonry;

static void keep(masonry *m, cn_body body)
{
	CHECK(m->count < BODIES_MOST);
	m->from[m->count] = fixture_pose(m->world, body);
	must(cn_body_get_mass_data(m->world, body, &m->mass[m->count]), m->world, "cn_body_get_mass_data");
	if (m->velocity.x != 0.0f || m->velocity.y != 0.0f)
		fixture_set_velocity(m->world, body, m->velocity.x, m->velocity.y, 0.0f);
	m->bodies[m->count++] = body;
}

/* On a floor that moves at this velocity. */
static void begin_moving(masonry *m, int32_t solver, int32_t substeps, uint32_t seed, cn_vec2 velocity)
{
	cn_world_def def;
	cn_body ground;
	memset(m, 0, sizeof *m);
	m->velocity = velocity;
	cn_world_def_init(&def);
	def.solver = solver;
	def.substep_count = substeps;
	must(cn_world_create(&def, &m->world), NULL, "cn_world_create");
	m->random = seed * 2654435761u + 12345u;
	m->friction = fixture_random(&m->random, 0.6f, 0.9f);
	ground = fixture_floor(m->world, m->friction, 0.0f);
	if (velocity.x != 0.0f || velocity.y != 0.0f) {
		must(cn_body_set_type(m->world, ground, CN_BODY_KINEMATIC), m->world, "cn_body_set_type");
		fixture_set_velocity(m->world, ground, velocity.x, velocity.y, 1e-6f); /* as rounding leaves it where a pose is the target */
	}
}

static void begin(masonry *m, int32_t solver, int32_t substeps, uint32_t seed)
{
	cn_vec2 still = { 0.0f, 0.0f };
	begin_moving(m, solver, substeps, seed, still);
}

static void wedge(masonry *m, float inner, float outer, float from, float to)
{
	float x = 0.5f * (inner + outer) * cosf(0.5f * (from + to)), y = 0.5f * (inner + outer) * sinf(0.5f * (from + to));
	cn_body body = fixture_body(m->world, CN_BODY_DYNAMIC, m->x + x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, m->friction, 0.0f);
	cn_polygon p;
	cn_shape shape;
	int32_t k;
	memset(&p, 0, sizeof p);
	p.count = 4;
	for (k = 0; k < 4; ++k) {
		float more = m->overlap / (inner + outer), angle = k < 2 ? from - more : to + more, radius = k == 0 || k == 3 ? inner : outer;
		p.points_m[k].x = radius * cosf(angle) - x;
		p.points_m[k].y = radius * sinf(angle) - y;
	}
	must(cn_shape_create_polygon(m->world, &def, &p, &shape), m->world, "cn_shape_create_polygon");
	keep(m, body);
}

/* A half circle of wedges, even or not, its thickness 0.15 to 0.25 of its radius: 0.11 would just stand. */
static void arch(masonry *m, int32_t uneven)
{
	int32_t count = (int32_t)fixture_random(&m->random, 9.0f, 41.0f), k;
	float size = fixture_random(&m->random, 1.0f, 5.0f), outer = size * fixture_random(&m->random, 1.15f, 1.25f), parts[48], all = 0.0f, from = 0.0f;
	for (k = 0; k < count; ++k)
		all += parts[k] = uneven ? fixture_random(&m->random, 0.6f, 1.4f) : 1.0f;
	for (k = 0; k < count; ++k) {
		float to = k + 1 < count ? from + PI * parts[k] / all : PI;
		wedge(m, size, outer, from, to);
		from = to;
	}
}

static void discs(masonry *m, int32_t base)
{
	float radius = fixture_random(&m->random, 0.2f, 0.6f);
	int32_t row, k;
	for (row = 0; row < base; ++row)
		for (k = 0; k < base - row; ++k)
			keep(m, fixture_circle(m->world, CN_BODY_DYNAMIC, radius * (float)(2 * k - (base - row - 1)), radius * (1.0f + (float)row * sqrtf(3.0f)), radius, m->friction, 0.0f));
}

static void box(masonry *m, float x, float y, float half_x, float half_y)
{
	keep(m, fixture_box(m->world, CN_BODY_DYNAMIC, x, y, 0.0f, half_x, half_y, m->friction, 0.0f));
}

/* Running bond, half bricks at the ends of every other course, and a heavy brick on top. */
static void wall(masonry *m)
{
	int32_t courses = (int32_t)fixture_random(&m->random, 3.0f, 5.0f), length = (int32_t)fixture_random(&m->random, 7.0f, 11.0f), i, k;
	cn_mass_data heavy;
	for (i = 0; i < courses; ++i) {
		float y = 0.25f + 0.5f * (float)i, end = 0.5f * (float)length - 0.25f;
		for (k = 0; k < length - (i & 1); ++k)
			box(m, (float)k - 0.5f * (float)(length - 1 - (i & 1)), y, 0.5f, 0.25f);
		if (i & 1) {
			box(m, -end, y, 0.25f, 0.25f);
			box(m, end, y, 0.25f, 0.25f);
		}
	}
	box(m, 0.0f, 0.25f + 0.5f * (float)courses, 0.5f, 0.25f);
	heavy = m->mass[m->count - 1];
	heavy.mass_kg *= fixture_random(&m->random, 20.0f, 60.0f);
	must(cn_body_set_mass_data(m->world, m->bodies[m->count - 1], &heavy), m->world, "cn_body_set_mass_data");
}

/* Each box is moved to one side by 0.4 to 0.6 of the distance with which the tower would just stand. */
static void tower(masonry *m)
{
	int32_t boxes = (int32_t)fixture_random(&m->random, 10.0f, 18.0f), k;
	float half_x = fixture_random(&m->random, 0.4f, 0.7f), half_y = fixture_random(&m->random, 0.15f, 0.35f), share = fixture_random(&m->random, 0.4f, 0.6f), x = 0.0f;
	for (k = 0; k < boxes; ++k) {
		box(m, x, half_y * (2.0f * (float)k + 1.0f), half_x, half_y);
		x += share * half_x / (float)(boxes - k);
	}
}

/* How far some body is from where it was made, or would be carried in this time. */
static double moved(const masonry *m, double time_s)
{
	double dx = time_s * (double)m->velocity.x, dy = time_s * (double)m->velocity.y, most = 0.0;
	int32_t k;
	for (k = 0; k < m->count; ++k) {
		cn_pose p = fixture_pose(m->world, m->bodies[k]);
		double way = hypot((double)(p.position_m.x - m->from[k].position_m.x) - dx, (double)(p.position_m.y - m->from[k].position_m.y) - dy);
		most = way > most ? way : most;
	}
	return most;
}

static double energy(const masonry *m)
{
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < m->count; ++k) {
		cn_pose p = fixture_pose(m->world, m->bodies[k]);
		cn_velocity v = fixture_velocity(m->world, m->bodies[k]);
		double speed_sq = (double)(v.linear_mps.x * v.linear_mps.x + v.linear_mps.y * v.linear_mps.y), turn_sq = (double)(v.angular_radps * v.angular_radps);
		sum += (double)m->mass[k].mass_kg * (0.5 * speed_sq + 10.0 * (double)p.position_m.y) + 0.5 * (double)m->mass[k].inertia_kgm2 * turn_sq;
	}
	return sum;
}

static const int32_t substeps_tried[] = { 2, 3, 4, 8, 16 };
#define TRIED ((int32_t)(sizeof substeps_tried / sizeof *substeps_tried))

enum { EVEN_ARCH = 0, UNEVEN_ARCH = 1, WALL = -1, TOWER = -2 };

/* kind: one of these, or a pyramid with so many rows of discs. */
static double stand(int32_t kind, int32_t solver, int32_t substeps, uint32_t seed, float vx, float vy)
{
	masonry m;
	cn_vec2 velocity;
	double most = 0.0;
	int32_t k;
	velocity.x = vx;
	velocity.y = vy;
	begin_moving(&m, solver, substeps, seed, velocity);
	if (kind == WALL)
		wall(&m);
	else if (kind == TOWER)
		tower(&m);
	else if (kind <= UNEVEN_ARCH)
		arch(&m, kind);
	else
		discs(&m, kind);
	for (k = 0; k < 120; ++k) {
		double now;
		fixture_step(m.world, 1);
		now = moved(&m, (double)(k + 1) / 60.0);
		most = now > most ? now : most;
	}
	CHECK(fixture_is_valid(m.world));
	cn_world_destroy(m.world);
	return most;
}

static void stands_at_all_substeps(const char *name, int32_t kind, uint32_t seeds, double bound)
{
	int32_t solver, k;
	for (solver = 0; solver < 2; ++solver) {
		double worst = 0.0;
		for (k = 0; k < TRIED; ++k) {
			uint32_t seed;
			for (seed = 1; seed <= seeds; ++seed) {
				double now = stand(kind, solver ? CN_SOLVER_DIRECT : CN_SOLVER_AUTO, substeps_tried[k], seed, 0.0f, 0.0f);
				if (now > bound)
					printf("  seed %u, %d substeps: %.6f m\n", (unsigned)seed, (int)substeps_tried[k], now);
				worst = now > worst ? now : worst;
			}
		}
		printf("  %s, %s, 2 to 16 substeps\n", name, solver ? "CN_SOLVER_DIRECT" : "CN_SOLVER_AUTO");
		CHECK_LE("farthest that something moved in 2 s", worst, bound, "m");
	}
}

static void t_arches_stand_at_any_substeps(void)
{
	stands_at_all_substeps("even arches", EVEN_ARCH, 6, 1e-3);
	stands_at_all_substeps("uneven arches", UNEVEN_ARCH, 6, 1e-3);
}

static void t_pyramids_of_discs_stand_at_any_substeps(void)
{
	stands_at_all_substeps("6 discs", 3, 6, 1e-4);
	stands_at_all_substeps("10 discs", 4, 6, 1e-3);
}

/* The load of a wall's top has more than one way down: the impulses are not unique. */
static void t_loaded_walls_stand_at_any_substeps(void)
{
	stands_at_all_substeps("walls", WALL, 6, 1e-3);
}

/* Fluctuations of the soft solver lift the side that bears less: by up to 8 mm at the top in some seconds. */
static void t_leaning_towers_stand_at_any_substeps(void)
{
	stands_at_all_substeps("towers", TOWER, 6, 2e-3);
}

/* What stands on fixed ground stands on a lift, and on a cart: quiet is what is at rest in the frame of what carries it. */
static void t_all_stand_on_what_carries_them(void)
{
	static const int32_t kinds[] = { EVEN_ARCH, UNEVEN_ARCH, WALL, TOWER, 4 };
	static const float ways[][2] = { { 0.1f, 0.0f }, { 0.0f, 0.03f }, { 0.0f, 3.0f }, { -5.0f, 1.0f } };
	double worst = 0.0;
	uint32_t k;
	for (k = 0; k < 5u * 4u * TEST_MANY(3u); ++k) {
		int32_t kind = kinds[k % 5u], way = (int32_t)(k / 5u % 4u);
		double now = stand(kind, CN_SOLVER_AUTO, 4, k / 20u + 1u, ways[way][0], ways[way][1]);
		if (now > 2e-3)
			printf("  kind %d, carried at %.1f, %.1f m/s: %.6f m\n", (int)kind, (double)ways[way][0], (double)ways[way][1], now);
		worst = now > worst ? now : worst;
	}
	CHECK_LE("farthest that something moved on its carrier in 2 s", worst, 2e-3, "m");
}

/* Stones that overlap by 12 mm are pushed apart, and most arches stand; with soft contacts alone half of them fall. */
static void t_arches_whose_stones_overlap_stand(void)
{
	int32_t fallen = 0, k;
	uint32_t seed;
	for (seed = 1; seed <= TEST_MANY(24); ++seed) {
		masonry m;
		int32_t low = 0;
		begin(&m, CN_SOLVER_AUTO, 4, seed);
		m.overlap = 0.012f;
		arch(&m, (int32_t)(seed & 1u));
		fixture_step(m.world, 240);
		for (k = 0; k < m.count; ++k)
			low |= fixture_pose(m.world, m.bodies[k]).position_m.y < m.from[k].position_m.y - 0.1f;
		fallen += low;
		cn_world_destroy(m.world);
	}
	CHECK_LE("share of arches that fall", fallen / (double)TEST_MANY(24), 4.0 / 24.0, "");
}

/* More on its key than it can bear: it comes down, and nothing is thrown up. */
static void t_an_arch_that_falls_gains_no_energy(void)
{
	double worst = 0.0;
	uint32_t seed;
	for (seed = 1; seed <= 6; ++seed) {
		masonry m;
		double start, most = -1e9;
		int32_t k;
		begin(&m, CN_SOLVER_AUTO, 4, seed);
		arch(&m, (int32_t)(seed & 1u));
		for (k = 0; k < 2; ++k) {
			float top = m.from[m.count / 2].position_m.y;
			cn_body box = fixture_box(m.world, CN_BODY_DYNAMIC, 0.0f, 1.3f * top + 0.5f * (float)k, 0.0f, 0.25f, 0.25f, m.friction, 0.0f);
			cn_mass_data heavy;
			must(cn_body_get_mass_data(m.world, box, &heavy), m.world, "cn_body_get_mass_data");
			heavy.mass_kg *= 20.0f;
			heavy.inertia_kgm2 *= 20.0f;
			must(cn_body_set_mass_data(m.world, box, &heavy), m.world, "cn_body_set_mass_data");
			keep(&m, box);
		}
		start = energy(&m);
		for (k = 0; k < 120; ++k) {
			fixture_step(m.world, 1);
			most = energy(&m) - start > most ? energy(&m) - start : most;
		}
		worst = most / start > worst ? most / start : worst;
		cn_world_destroy(m.world);
	}
	CHECK_LE("energy gained / start", worst, 1e-3, "");
}

/* Boxes of the weight of a few wedges are let fall on its key by 2 cm: it rocks, and stands. */
static double stand_struck(int32_t substeps, uint32_t seed)
{
	masonry m;
	double most;
	int32_t k, wedges;
	begin(&m, CN_SOLVER_AUTO, substeps, seed);
	arch(&m, (int32_t)(seed & 1u));
	wedges = m.count;
	for (k = 0; k < 2; ++k) {
		float top = m.from[wedges / 2].position_m.y, half = 0.06f * top;
		(void)fixture_box(m.world, CN_BODY_DYNAMIC, 0.0f, 1.12f * top + (2.2f * (float)k + 1.0f) * half + 0.02f, 0.0f, half, half, m.friction, 0.0f);
	}
	fixture_step(m.world, 180);
	most = moved(&m, 0.0);
	cn_world_destroy(m.world);
	return most;
}

/* Some are driven apart by the blow whatever the number of substeps. An island that may not be solved while it rocks loses 60. */
static void t_arches_that_are_struck_stand(void)
{
	int32_t k, fallen = 0;
	for (k = 0; k < TRIED; ++k) {
		uint32_t seed;
		for (seed = 1; seed <= TEST_MANY(20); ++seed)
			fallen += stand_struck(substeps_tried[k], seed) > 0.05;
	}
	CHECK_LE("share of arches that fall at 5 numbers of substeps", fallen / (double)(TRIED * TEST_MANY(20)), 0.08, "");
}

/* ---- the work of a step ---- */

/* Like arches that a box falls on, all at the same time. Returns the most work of contact systems in a step. */
static int32_t most_work(int32_t arches, int32_t *solved)
{
	masonry m;
	int32_t most = 0, k;
	begin(&m, CN_SOLVER_AUTO, 4, 1);
	for (k = 0; k < arches; ++k) {
		float top;
		m.count = 0;
		m.random = 5u * 2654435761u;
		m.x = 12.0f * (float)(k - arches / 2);
		arch(&m, 0);
		top = m.from[m.count / 2].position_m.y;
		(void)fixture_box(m.world, CN_BODY_DYNAMIC, m.x, 1.25f * top, 0.0f, 0.06f * top, 0.06f * top, m.friction, 0.0f);
	}
	for (k = *solved = 0; k < 180; ++k) {
		fixture_step(m.world, 1);
		most = m.world->cone_work + m.world->set_work > most ? m.world->cone_work + m.world->set_work : most;
		*solved += m.world->cone_work > 0;
	}
	cn_world_destroy(m.world);
	return most;
}

/* Without a limit, 16 arches would take 16 times the work of one. Each may take a few solutions when nothing is left. */
static void t_systems_share_the_work_of_a_step(void)
{
	int32_t solved, one = most_work(1, &solved), all;
	CHECK_GE("work of one arch", one, CNI_ATTEMPT_WORK / 20, "blocks");
	all = most_work(16, &solved);
	CHECK_LE("work of 16 arches in a step", all, 2 * CNI_ATTEMPT_WORK, "blocks");
	CHECK_GE("steps with interior points", solved, 5, "");
}

/* A plate that presses 76 boxes to where they have no room. Each has a dozen contacts, a factorization takes 3 ms, and no impulses fit. */
static void t_a_crushed_heap_takes_bounded_work(void)
{
	masonry m;
	cn_body plate;
	int32_t most = 0, k;
	begin(&m, CN_SOLVER_DIRECT, 4, 1);
	for (k = 0; k < 76; ++k)
		(void)fixture_box(m.world, CN_BODY_DYNAMIC, (float)(k % 8) - 3.5f, 0.5f + (float)(k / 8), 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	plate = fixture_box(m.world, CN_BODY_KINEMATIC, 0.0f, 11.0f, 0.0f, 6.0f, 1.0f, 0.5f, 0.0f);
	fixture_set_velocity(m.world, plate, 0.0f, -8.0f, 0.0f);
	for (k = 0; k < TEST_FORM(50, 14, 8); ++k) {
		int32_t work;
		fixture_step(m.world, 1);
		work = m.world->cone_work + m.world->set_work;
		most = work > most ? work : most;
	}
	CHECK_GE("most work in a step", most, CNI_ATTEMPT_WORK_DIRECT / 4, "blocks");
	CHECK_LE("most work in a step", most, 2 * CNI_ATTEMPT_WORK_DIRECT, "blocks");
	cn_world_destroy(m.world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_arches_stand_at_any_substeps);
	RUN(t_pyramids_of_discs_stand_at_any_substeps);
	RUN(t_loaded_walls_stand_at_any_substeps);
	RUN(t_leaning_towers_stand_at_any_substeps);
	RUN(t_all_stand_on_what_carries_them);
	RUN(t_an_arch_that_falls_gains_no_energy);
	RUN(t_arches_whose_stones_overlap_stand);
	RUN(t_arches_that_are_struck_stand);
	RUN(t_systems_share_the_work_of_a_step);
	RUN(t_a_crushed_heap_takes_bounded_work);
	return test_end();
}
