/*
 * test/broadphase/broadphase_threads_test.c - a broadphase shared among workers: every update reports and loses the same
 * pairs as with one worker, whatever moves and whichever memory fails.
 *
 * broadphase_scenes.h shows that one worker finds the right pairs. Worlds here are large enough to be shared.
 */
#include "base/hooks.h"
#include "broadphase/broadphase.h"
#include "test.h"

#define BOXES 3000
#define STEPS 36
#define SIDE_M 80.0f

static const int32_t worker_counts[] = { 2, 3, 8 };
#define WORKER_COUNTS ((int32_t)(sizeof worker_counts / sizeof *worker_counts))

static const struct { const cni_broadphase_ops *ops; const char *name; } kinds[] = { { &cni_broadphase_sweep, "sweep" }, { &cni_broadphase_tree, "tree" } };
#define KINDS 2

typedef struct crowd {
	hooks persistent, scratch;  /* memory that fails separately */
	cni_memory memory, arena_memory, table_memory;
	cni_arena arena;
	cni_table proxies;
	cni_team *team;
	const cni_broadphase_ops *ops;
	cni_broadphase *broadphase;
	cni_broadphase_pairs pairs;
	uint32_t random;
	uint8_t alive[BOXES];
} crowd;

static cni_proxy *proxy_at(const crowd *c, int32_t id) { return (cni_proxy *)cni_table_at(&c->proxies, id); }

static float between(crowd *c, float low, float high)
{
	return low + (high - low) * (float)(random_next(&c->random) >> 8) / 16777216.0f;
}

/* A square of about a metre; now and then a long box, which lies in another level. */
static cni_aabb box_in(crowd *c, float side)
{
	float x = between(c, -side, side), y = between(c, -side, side);
	float width = between(c, 0.5f, 1.0f) * (random_next(&c->random) % 100u == 0 ? 20.0f : 1.0f);
	cni_aabb box;
	box.x0 = x;
	box.y0 = y;
	box.x1 = x + width;
	box.y1 = y + 0.8f;
	return box;
}

/* Only reads, because several workers call it at once. */
static int32_t filter(const void *context, int32_t a, int32_t b)
{
	(void)context;
	return a != b && (a + b) % 7 != 0;
}

static void crowd_add(crowd *c, int32_t id)
{
	cni_proxy *p = proxy_at(c, id);
	p->fat = box_in(c, SIDE_M);
	p->flags = CNI_PROXY_ALIVE | (id % 9 == 4 ? (uint32_t)CNI_PROXY_STATIC : 0u);
	c->alive[id] = 1;
	c->ops->add(c->broadphase, id);
}

static void crowd_open(crowd *c, const cni_broadphase_ops *ops, int32_t workers)
{
	cni_broadphase_context context;
	int32_t id;
	memset(c, 0, sizeof *c);
	c->ops = ops;
	c->random = 77u;
	hooks_init(&c->persistent, &c->memory);
	hooks_init(&c->scratch, &c->arena_memory);
	cni_memory_init_hooks(&c->table_memory, NULL, NULL, NULL);
	cni_arena_init(&c->arena, &c->arena_memory);
	cni_table_init(&c->proxies, (int32_t)sizeof(cni_proxy), 6);
	cni_array_init(&c->pairs.list, (int32_t)sizeof(cni_pair));
	if (cni_team_possible(workers, NULL))
		c->team = cni_team_create(&c->table_memory, workers, NULL, NULL, NULL);
	memset(&context, 0, sizeof context);
	context.memory = &c->memory;
	context.arena = &c->arena;
	context.proxies = &c->proxies;
	context.team = (cni_team *const *)&c->team;
	if (!cni_table_reserve(&c->proxies, &c->table_memory, BOXES) || (c->broadphase = ops->create(&context, BOXES)) == NULL)
		abort();
	for (id = 0; id < BOXES; ++id)
		crowd_add(c, id);
}

static void crowd_close(crowd *c)
{
	c->ops->destroy(c->broadphase);
	cni_array_deinit(&c->pairs.list, &c->memory);
	cni_arena_deinit(&c->arena);
	cni_table_deinit(&c->proxies, &c->table_memory);
	cni_team_destroy(c->team, &c->table_memory);
	CHECK(c->memory.bytes_in_use == 0 && c->arena_memory.bytes_in_use == 0);
	CHECK(c->persistent.wrong_frees == 0 && c->scratch.wrong_frees == 0);
}

static void crowd_move(crowd *c, int32_t id, cni_aabb box)
{
	cni_proxy_set_fat(proxy_at(c, id), &box);
	c->ops->move(c->broadphase, id);
}

static void crowd_jitter(crowd *c, int32_t id)
{
	cni_aabb box = proxy_at(c, id)->fat;
	float x = between(c, -0.4f, 0.4f), y = between(c, -0.4f, 0.4f);
	box.x0 += x;
	box.x1 += x;
	box.y0 += y;
	box.y1 += y;
	crowd_move(c, id, box);
}

static void crowd_churn(crowd *c, int32_t id)
{
	if (!c->alive[id]) {
		crowd_add(c, id);
		return;
	}
	c->ops->remove(c->broadphase, id);
	proxy_at(c, id)->flags = 0;
	c->alive[id] = 0;
}

/* In cyclic order: all boxes move a little; a third jumps elsewhere; few move, so that most search as single entries; many
   gather in one spot, with far more pairs than a job's range holds; some are made and removed. */
static void crowd_change(crowd *c, int32_t step)
{
	int32_t id;
	for (id = 0; id < BOXES; ++id) {
		uint32_t dice = random_next(&c->random);
		if (step % 6 == 4 && dice % 8u == 0)
			crowd_churn(c, id);
		if (!c->alive[id])
			continue;
		if (step % 6 == 0 || (step % 6 == 2 && dice % 12u == 0))
			crowd_jitter(c, id);
		else if (step % 6 == 1 && dice % 3u == 0)
			crowd_move(c, id, box_in(c, SIDE_M));
		else if ((step % 6 == 3 && dice % 6u == 0) || (step % 6 == 5 && dice % 200u == 0))
			crowd_move(c, id, box_in(c, 4.0f));
		else if (dice % 500u == 1)
			c->ops->touch(c->broadphase, id);
	}
}

typedef struct outcome {
	uint64_t digest;  /* of the pairs of each step and the number of lost pairs */
	int64_t pairs, lost;
	int32_t invalid;
} outcome;

static void digest_add(outcome *o, uint64_t word) { o->digest = (o->digest ^ word) * 0x100000001B3u; }

static void crowd_update(crowd *c, outcome *o)
{
	const cni_pair *list;
	int32_t k, id;
	c->ops->settle(c->broadphase);
	c->ops->update(c->broadphase, filter, NULL, &c->pairs);
	list = (const cni_pair *)c->pairs.list.data;
	for (k = 0; k < c->pairs.list.count; ++k)
		digest_add(o, (uint64_t)(uint32_t)list[k].a << 32 | (uint32_t)list[k].b);
	for (id = 0; id < BOXES; ++id)
		if (c->alive[id] && (proxy_at(c, id)->flags & CNI_PROXY_MOVED)) /* its pairs are searched again */
			digest_add(o, (uint64_t)id);
	digest_add(o, (uint64_t)c->pairs.pairs_lost);
	o->pairs += c->pairs.list.count;
	o->lost += c->pairs.pairs_lost;
	o->invalid += !cni_broadphase_holds(c->ops, c->broadphase);
	c->scratch.fail_at = 0; /* the end of a step grows the arena */
	cni_arena_reset(&c->arena);
}

/* Periods in steps with which persistent memory and scratch fail. 0: never. */
typedef struct failing {
	int32_t persistent_every, scratch_every;
} failing;

/* The list has room for a few pairs and cannot grow. */
static void list_fails(crowd *c)
{
	cni_array_deinit(&c->pairs.list, &c->memory);
	cni_array_init(&c->pairs.list, (int32_t)sizeof(cni_pair));
	if (!cni_array_reserve_exact(&c->pairs.list, &c->memory, 200))
		abort();
	c->persistent.fail_after = 1;
	c->persistent.fail_at = c->persistent.calls + 1;
}

/* One of the first allocations of scratch fails; in some steps all later ones fail as well. */
static void scratch_fails(crowd *c, int32_t step)
{
	cni_arena_deinit(&c->arena);
	cni_arena_init(&c->arena, &c->arena_memory);
	c->scratch.fail_after = step / 2 % 2;
	c->scratch.fail_at = c->scratch.calls + 1 + step / 4 % 5;
}

static outcome crowd_run(const cni_broadphase_ops *ops, int32_t workers, failing fails)
{
	static crowd c;
	outcome o;
	int32_t step;
	memset(&o, 0, sizeof o);
	crowd_open(&c, ops, workers);
	for (step = 0; step < STEPS; ++step) {
		if (fails.persistent_every > 0 && step % fails.persistent_every == 1)
			list_fails(&c);
		if (fails.scratch_every > 0 && step % fails.scratch_every == 1)
			scratch_fails(&c, step);
		crowd_update(&c, &o);
		c.persistent.fail_at = 0;
		crowd_change(&c, step);
	}
	crowd_close(&c);
	return o;
}

static void check_same(const char *what, int32_t workers, const outcome *o, const outcome *alone)
{
	printf("  %s, %d workers: %016llx, %lld pairs, %lld lost; alone %016llx\n", what, (int)workers, (unsigned long long)o->digest, (long long)o->pairs,
	       (long long)o->lost, (unsigned long long)alone->digest);
	CHECK(o->digest == alone->digest && o->pairs == alone->pairs && o->lost == alone->lost);
	CHECK(o->invalid == 0);
}

static void check_workers(failing fails, int32_t kind, const outcome *alone)
{
	int32_t w;
	for (w = 0; w < WORKER_COUNTS; ++w) {
		outcome o = crowd_run(kinds[kind].ops, worker_counts[w], fails);
		check_same(kinds[kind].name, worker_counts[w], &o, alone);
	}
}

static void pairs_do_not_know_their_workers(void)
{
	failing never = { 0, 0 };
	int32_t kind;
	outcome alone[KINDS];
	for (kind = 0; kind < KINDS; ++kind) {
		alone[kind] = crowd_run(kinds[kind].ops, 1, never);
		CHECK(alone[kind].invalid == 0 && alone[kind].lost == 0 && alone[kind].pairs > 10000);
		check_workers(never, kind, &alone[kind]);
	}
	CHECK(alone[0].digest == alone[1].digest);
}

static void nor_where_the_list_finds_no_memory(void)
{
	failing list = { 4, 0 };
	int32_t kind;
	for (kind = 0; kind < KINDS; ++kind) {
		outcome alone = crowd_run(kinds[kind].ops, 1, list);
		CHECK(alone.invalid == 0 && alone.lost > 1000);
		check_workers(list, kind, &alone);
	}
}

static void nor_where_there_is_no_scratch(void)
{
	failing never = { 0, 0 }, scratch = { 0, 2 };
	int32_t kind;
	for (kind = 0; kind < KINDS; ++kind) {
		outcome alone = crowd_run(kinds[kind].ops, 1, never), poor = crowd_run(kinds[kind].ops, 1, scratch);
		check_same(kinds[kind].name, 1, &poor, &alone);
		check_workers(scratch, kind, &alone);
	}
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(pairs_do_not_know_their_workers);
	RUN(nor_where_the_list_finds_no_memory);
	RUN(nor_where_there_is_no_scratch);
	return test_end();
}
