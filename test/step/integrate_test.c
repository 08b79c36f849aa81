/*
 * test/step/integrate_test.c - the loops over bodies of a substep (step/integrate.c): kernels do with vectors what the plain
 * code does with one body, to the bit, whatever flags bodies side by side have. So do those that take
 * poses at the end of the step (step/finalize.c).
 *
 * If a width differs look in step/integrate_kernel.h, for poses in step/finalize_kernel.h; if a flag does, at its masks there.
 */
#include "step/stages.h"
#include "base/cpu.h"
#include "step/integrate_pass.h"
#include "world/fixture.h"

#include <string.h>

#define BODIES 61 /* odd: one is left over */
#define ROUNDS 200

/* xorshift32 (Marsaglia, 2003) */
static uint32_t random_state = 7u;
static uint32_t random_bits(void)
{
	random_state ^= random_state << 13;
	random_state ^= random_state >> 17;
	random_state ^= random_state << 5;
	return random_state;
}

static float pick(float lower, float upper)
{
	return lower + (upper - lower) * (float)(random_bits() >> 8) / 16777216.0f;
}

/* Zeros of both signs among them. */
static float pick_some(float most)
{
	uint32_t which = random_bits() % 8u;
	return which == 0 ? 0.0f : which == 1 ? -0.0f : pick(-most, most);
}

typedef struct state {
	cni_motion motions[BODIES + 1];
	cni_velocity_start starts[BODIES + 1];
	cni_external drives[BODIES + 1];
} state;

static state drawn, plain, wide;

/* flags: those that bodies may have. Responses are of the size of what gravity gives, so that some are corrected. */
static void draw(uint32_t flags)
{
	int32_t k;
	memset(&drawn, 0, sizeof drawn);
	for (k = 1; k <= BODIES; ++k) {
		cni_motion *m = &drawn.motions[k];
		cni_velocity_start *s = &drawn.starts[k];
		cni_external *d = &drawn.drives[k];
		m->vx = pick_some(2.0f);
		m->vy = pick_some(2.0f);
		m->w = pick_some(5.0f);
		m->dpx = pick_some(0.1f);
		m->dpy = pick_some(0.1f);
		m->theta = pick_some(0.1f);
		m->inv_mass = pick(0.0f, 3.0f);
		m->inv_inertia = pick(0.0f, 3.0f);
		s->vx = m->vx + pick_some(random_bits() % 32u == 0 ? 8.0f : 0.2f);
		s->vy = m->vy + pick_some(random_bits() % 32u == 0 ? 8.0f : 0.2f);
		s->w = m->w + pick_some(0.2f);
		s->jumped = random_bits() % 4u == 0 ? 1.0f : 0.0f;
		d->ax = pick_some(20.0f);
		d->ay = pick_some(20.0f);
		d->alpha = pick_some(20.0f);
		d->flags = random_bits() % 3u == 0 ? random_bits() & flags : 0u;
	}
}

static void put(cn_world *world, const state *s)
{
	memcpy(cni_motions(world), s->motions, sizeof s->motions);
	memcpy(cni_starts(world), s->starts, sizeof s->starts);
	memcpy(cni_externals(world), s->drives, sizeof s->drives);
}

static void get(const cn_world *world, state *s)
{
	memcpy(s->motions, cni_motions(world), sizeof s->motions);
	memcpy(s->starts, cni_starts(world), sizeof s->starts);
	memcpy(s->drives, cni_externals(world), sizeof s->drives);
}

enum { VELOCITIES_FIRST, VELOCITIES, POSITIONS, FINISH, LOOPS };

static void run(cn_world *world, const cni_body_kernel *kernel, int32_t loop, state *out)
{
	cni_solve s = cni_solve_make(world, FRAME_S, world->settings.substeps);
	s.body_kernel = kernel;
	put(world, &drawn);
	if (loop == VELOCITIES_FIRST)
		cni_integrate_velocities(world, &s, 0);
	else if (loop == VELOCITIES)
		cni_integrate_velocities(world, &s, 1);
	else if (loop == POSITIONS)
		cni_integrate_positions(world, &s);
	else
		cni_integrate_finish(world, &s);
	get(world, out);
}

/* The dummy is row 0. */
static cn_world *world_of_bodies(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	int32_t k;
	for (k = 0; k < BODIES; ++k) {
		cn_body body = fixture_box(world, CN_BODY_DYNAMIC, 3.0f * (float)k, 0.0f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
		must(cn_body_set_damping(world, body, 0.1f * (float)(k % 5), 0.2f * (float)(k % 3)), world, "cn_body_set_damping");
	}
	CHECK(world->awake_count == BODIES + 1);
	return world;
}

static void same_bits(cn_world *world, const cni_body_kernel *kernel, const char *name)
{
	static const uint32_t flags[] = { 0, CNI_EXTERNAL_FREE | CNI_EXTERNAL_FINISHED, CNI_EXTERNAL_DAMPED, CNI_EXTERNAL_LOCK_X | CNI_EXTERNAL_LOCK_Y, CNI_EXTERNAL_JOINTED | CNI_EXTERNAL_TOUCHED, 127u };
	int32_t round, loop, kind, differ = 0, moved = 0;
	for (round = 0; round < ROUNDS; ++round)
		for (kind = 0; kind < (int32_t)(sizeof flags / sizeof flags[0]); ++kind) {
			draw(flags[kind]);
			for (loop = 0; loop < LOOPS; ++loop) {
				run(world, NULL, loop, &plain);
				run(world, kernel, loop, &wide);
				differ += memcmp(&plain, &wide, sizeof plain) != 0;
				moved += memcmp(&plain, &drawn, sizeof plain) != 0;
			}
		}
	printf("  %s: runs that changed something %d of %d\n", name, (int)moved, ROUNDS * 6 * LOOPS);
	CHECK(moved > ROUNDS * 6 * LOOPS * 9 / 10);
	CHECK_LE("runs that differ from the plain code", differ, 0, "");
	put(world, &drawn);
}

static void kernels_have_the_bits_of_the_plain_code(void)
{
	cn_world *world = world_of_bodies();
#if CNI_HAS_WIDE_4
	same_bits(world, &cni_body_kernel_4, "width 4");
#endif
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		same_bits(world, &cni_body_kernel_8, "width 8");
#endif
	same_bits(world, cni_body_kernel_choose(), "as chosen");
	cn_world_destroy(world);
}

/* Speeds and turns as they are at the end of a step: some bodies are slow, some held, some pushed, some too fast, some turn far. */
static void draw_ends(void)
{
	int32_t k;
	draw(127u);
	for (k = 1; k <= BODIES; ++k) {
		cni_motion *m = &drawn.motions[k];
		cni_velocity_start *s = &drawn.starts[k];
		uint32_t which = random_bits() % 64u;
		float scale = which < 32u ? 0.005f : 1.0f;
		m->vx *= scale;
		m->vy *= scale;
		m->w *= scale;
		if (which < 16u) { /* what the drive gave is gone */
			s->vx = m->vx + FRAME_S / 4.0f * drawn.drives[k].ax;
			s->vy = m->vy + FRAME_S / 4.0f * drawn.drives[k].ay;
		}
		if (which % 4u != 0) { /* moved by its velocity; the others are pushed too */
			m->dpx = FRAME_S * m->vx + pick(-2e-4f, 2e-4f);
			m->dpy = FRAME_S * m->vy + pick(-2e-4f, 2e-4f);
			m->theta = FRAME_S * m->w + pick(-2e-4f, 2e-4f);
		}
		if (which == 62u)
			m->theta = pick(-4.0f, 4.0f);
		if (which == 63u)
			m->vx = 1e6f;
	}
}

/* What a body itself may say about its rest, the same in both worlds. */
static void vary_bodies(cn_world *worlds[2])
{
	int32_t k, w;
	for (k = 1; k <= BODIES; ++k) {
		uint32_t which = random_bits() % 32u;
		for (w = 0; w < 2; ++w) {
			cni_body *b = cni_body_at(worlds[w], cni_awake_ids(worlds[w])[k]);
			b->sleep_speed = which == 0 ? 1.0f : (float)CN_DEFAULT;
			b->type = which == 1 ? CN_BODY_KINEMATIC : CN_BODY_DYNAMIC;
			b->flags = which == 2 ? b->flags & ~(uint32_t)CN_BODY_SLEEP : b->flags | (uint32_t)CN_BODY_SLEEP;
		}
	}
}

static int32_t bodies_differ(cn_world *worlds[2])
{
	int32_t k, differ = 0;
	for (k = 1; k <= BODIES; ++k)
		differ += memcmp(cni_body_at(worlds[0], cni_awake_ids(worlds[0])[k]), cni_body_at(worlds[1], cni_awake_ids(worlds[1])[k]), sizeof(cni_body)) != 0;
	return differ;
}

/* Two worlds that take the same steps' ends, one with a kernel: boxes move, and the next round goes on from there. */
static void same_ends(const cni_body_kernel *kernel, const char *name)
{
	cn_world *worlds[2] = { world_of_bodies(), world_of_bodies() };
	cni_solve s = cni_solve_make(worlds[0], FRAME_S, worlds[0]->settings.substeps);
	int32_t round, differ = 0, rested = 0, resting = 0, k;
	for (round = 0; round < ROUNDS; ++round) {
		draw_ends();
		vary_bodies(worlds);
		put(worlds[0], &drawn);
		put(worlds[1], &drawn);
		s.body_kernel = NULL;
		rested = cni_stage_finalize(worlds[0], &s);
		s.body_kernel = kernel;
		differ += cni_stage_finalize(worlds[1], &s) != rested;
		get(worlds[0], &plain);
		get(worlds[1], &wide);
		differ += memcmp(&plain, &wide, sizeof plain) != 0;
		differ += bodies_differ(worlds);
		for (k = 1; k <= BODIES; ++k)
			resting += cni_body_at(worlds[0], cni_awake_ids(worlds[0])[k])->sleep_time > 0.0f;
	}
	printf("  %s: %d bodies of %d rested\n", name, (int)resting, ROUNDS * BODIES);
	CHECK(resting > ROUNDS * BODIES / 20 && resting < ROUNDS * BODIES / 2);
	CHECK_LE("bodies and rounds that differ from the plain code", differ, 0, "");
	cn_world_destroy(worlds[0]);
	cn_world_destroy(worlds[1]);
}

static void poses_have_the_bits_of_the_plain_code(void)
{
#if CNI_HAS_WIDE_4
	same_ends(&cni_body_kernel_4, "width 4");
#endif
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		same_ends(&cni_body_kernel_8, "width 8");
#endif
	same_ends(cni_body_kernel_choose(), "as chosen");
}

int main(void)
{
	RUN(kernels_have_the_bits_of_the_plain_code);
	RUN(poses_have_the_bits_of_the_plain_code);
	return test_end();
}
