/*
 * test/linear/sparse_plan_test.c - plans of the direct solver of coupled constraints: little fill, form, limits and budget,
 * plans that are kept, memory.
 *
 * If a test here fails, look in linear/sparse_components.c, sparse_order.c, sparse_plan.c.
 */
#include "sparse_systems.h"

/* ---- fill, form, limits ---- */

static int32_t are_neighbours(const problem *p, int32_t k, int32_t l)
{
	int32_t s, t;
	for (s = 0; s < 2; ++s)
		for (t = 0; t < 2; ++t) {
			int32_t body = s ? p->links[k].ib : p->links[k].ia;
			if (body == (t ? p->links[l].ib : p->links[l].ia) && (p->bodies[body].inv_mass > 0.0f || p->bodies[body].inv_inertia > 0.0f))
				return 1;
		}
	return 0;
}

static int32_t pairs_of(const problem *p)
{
	int32_t k, l, pairs = 0;
	for (k = 0; k < p->link_count; ++k)
		for (l = 0; l < k; ++l)
			pairs += are_neighbours(p, k, l);
	return pairs;
}

static int32_t fill_of(const char *name, problem *p)
{
	int32_t pairs = pairs_of(p), fill;
	if (!plan(p)) {
		test_fail(__FILE__, __LINE__, "no plan");
		return -1;
	}
	fill = p->sparse.block_count - pairs;
	if (name != NULL)
		printf("  %s: %d neighbouring pairs, %d blocks\n", name, (int)pairs, (int)p->sparse.block_count);
	end(p);
	return fill;
}

static void t_simple_trees_make_no_fill(void)
{
	problem *p = begin(1, 0.0);
	int32_t k, hub;
	add_chain(p, 0, 150, 2);
	CHECK(fill_of("chain", p) == 0);
	p = begin(1, 0.0);
	add_bridge(p, 150, 2);
	CHECK(fill_of("bridge", p) == 0);
	p = begin(1, 0.0);
	add_star(p, 40, 2);
	CHECK(fill_of("star", p) == 0);
	p = begin(1, 0.0);
	hub = add_star(p, 5, 2);
	for (k = 1; k <= 5; ++k)
		add_chain(p, hub + k, 4, 2);
	CHECK(fill_of("hub with arms of five", p) == 0);
}

/* The order of least degree may begin between two hubs: some blocks then come in. */
static void t_random_trees_make_little(void)
{
	int32_t pairs = 0, fill = 0, filled = 0;
	uint32_t seed;
	for (seed = 1; seed <= 200; ++seed) {
		problem *p = begin(seed, 0.0);
		int32_t more;
		add_tree(p, 20 + (int32_t)(seed % 100), 2);
		pairs += pairs_of(p);
		more = fill_of(NULL, p);
		CHECK(more >= 0);
		fill += more;
		filled += more > 0;
	}
	printf("  200 random trees: %d pairs, %d blocks more, in %d trees\n", (int)pairs, (int)fill, (int)filled);
	CHECK_LE("blocks that are fill / pairs", (double)fill / (double)pairs, 0.01, "");
}

/* Positions belong to one component each, blocks lead upwards, every body is listed once. */
static void t_plans_are_well_formed(void)
{
	problem *p = begin(9, 0.0);
	static int32_t seen[BODIES_MOST];
	int32_t c, k, e, movable = 0;
	add_chain(p, 0, 10, 2);
	add_grid(p, 4, 1);
	add_tree(p, 15, 0);
	add_chain(p, 0, 5, 3);
	for (k = 1; k < p->body_count; ++k)
		movable += p->bodies[k].inv_mass > 0.0f;
	REQUIRE(plan(p));
	CHECK(p->sparse.component_count == 4);
	CHECK(p->sparse.body_count == movable);
	memset(seen, 0, sizeof seen);
	for (k = 0; k < p->sparse.body_count; ++k)
		CHECK(++seen[p->sparse.bodies[k]] == 1);
	for (c = 0; c < p->sparse.component_count; ++c) {
		const cni_component *at = &p->sparse.components[c];
		CHECK(at->begin == (c == 0 ? 0 : p->sparse.components[c - 1].end));
		CHECK(at->loops == (c == 1));
		for (k = at->begin; k < at->end; ++k)
			for (e = p->sparse.first[k]; e < p->sparse.first[k + 1]; ++e)
				CHECK(p->sparse.below[e] > k && p->sparse.below[e] < at->end && (e == p->sparse.first[k] || p->sparse.below[e] > p->sparse.below[e - 1]));
	}
	CHECK(p->sparse.components[p->sparse.component_count - 1].end == p->link_count);
	CHECK(p->sparse.components[0].width == 2 && p->sparse.components[3].width == 3);
	end(p);
}

/* Whether a chain of 6 bodies that is linked in one of these ways is said to have loops. */
static int32_t chain_has_loops(int32_t from_the_world, int32_t to_the_world, int32_t ring)
{
	problem *p = begin(11, 0.0);
	int32_t first = add_body(p), loops;
	add_chain(p, first, 5, 2);
	if (from_the_world)
		add_link(p, 0, first, 2);
	if (to_the_world)
		add_link(p, first + 5, 0, 2);
	if (ring)
		add_link(p, first + 5, first, 2);
	if (!plan(p) || p->sparse.component_count != 1) {
		end(p);
		return CNI_NONE;
	}
	loops = p->sparse.components[0].loops;
	end(p);
	return loops;
}

/* A ring that nothing holds has as many links as bodies, like a chain that hangs from the world. */
static void t_loops_are_told_from_trees(void)
{
	CHECK(chain_has_loops(0, 0, 0) == 0);
	CHECK(chain_has_loops(1, 0, 0) == 0);
	CHECK(chain_has_loops(1, 1, 0) == 1);
	CHECK(chain_has_loops(0, 0, 1) == 1);
	CHECK(chain_has_loops(1, 0, 1) == 1);
}

static int32_t planned_in(const problem *p, int32_t begin_at, int32_t end_at)
{
	int32_t k, count = 0;
	for (k = begin_at; k < end_at; ++k)
		count += p->planned[k];
	return count;
}

/* A grid whose own limit is too low, between two chains that are within theirs. */
static void t_beyond_the_limit_is_refused_alone(void)
{
	problem *p = begin(2, 0.0);
	int32_t from, to, k;
	add_chain(p, 0, 10, 2);
	from = p->link_count;
	add_grid(p, 7, 1);
	to = p->link_count;
	add_chain(p, 0, 10, 2);
	for (k = 0; k < p->link_count; ++k)
		p->links[k].work_most = 6;
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 20 && p->sparse.component_count == 2);
	CHECK(planned_in(p, 0, from) == 10 && planned_in(p, from, to) == 0 && planned_in(p, to, p->link_count) == 10);
	solve(p, 0.0f);
	for (k = 0; k < p->sparse.node_count; ++k)
		CHECK(isfinite(p->sparse.nodes[k].x[0]) && (p->sparse.nodes[k].owner < 1000 + from || p->sparse.nodes[k].owner >= 1000 + to));
	end(p);
	/* One link that may cost more speaks for its component. */
	p = begin(2, 0.0);
	add_grid(p, 7, 1);
	for (k = 0; k < p->link_count; ++k)
		p->links[k].work_most = 6;
	p->links[17].work_most = 1000;
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == p->link_count);
	end(p);
}

static void t_beyond_the_budget_is_refused(void)
{
	problem *p = begin(2, 0.0);
	int32_t work_chain, work_star;
	add_chain(p, 0, 10, 2);
	add_star(p, 12, 2);
	add_chain(p, 0, 10, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.component_count == 3);
	work_chain = p->sparse.components[0].work;
	work_star = p->sparse.components[1].work;
	CHECK(p->sparse.components[2].work == work_chain && work_star > work_chain);
	cni_sparse_discard(&p->arena, &p->sparse);
	CHECK(p->arena.entry_count == 0 && p->sparse.node_count == 0 && p->sparse.component_count == 0);
	REQUIRE(plan_within(p, 2 * work_chain));
	CHECK(planned_in(p, 0, 10) == 10 && planned_in(p, 10, 22) == 0 && planned_in(p, 22, 32) == 10);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 2 * work_chain + work_star));
	CHECK(planned_in(p, 0, 32) == 32);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 2 * work_chain + work_star - 1));
	CHECK(planned_in(p, 0, 22) == 22 && planned_in(p, 22, 32) == 0);
	cni_sparse_discard(&p->arena, &p->sparse);
	REQUIRE(plan_within(p, 0));
	CHECK(planned_in(p, 0, 32) == 0 && p->sparse.node_count == 0);
	end(p);
}

/* A body with too many joints: its neighbours would all be one another's. */
static void t_hubs_are_refused(void)
{
	problem *p = begin(4, 0.0);
	add_star(p, 64, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 64);
	end(p);
	p = begin(4, 0.0);
	add_star(p, 65, 2);
	add_chain(p, 0, 3, 2);
	REQUIRE(plan(p));
	CHECK(p->sparse.node_count == 3 && planned_in(p, 0, 65) == 0);
	end(p);
}

/* ---- kept plans ---- */

/* A plan by what is kept, and one that is made anew, over several components with and without loops. */
static int32_t kept_differs(problem *p)
{
	static problem anew;
	const cni_sparse *a = &p->sparse, *b = &anew.sparse;
	int32_t k, e, differs;
	anew = *p;
	cni_memory_init_hooks(&anew.memory, NULL, NULL, NULL);
	cni_arena_init(&anew.arena, &anew.memory);
	anew.kept = NULL;
	memset(&p->sparse, 0, sizeof p->sparse);
	memset(&anew.sparse, 0, sizeof anew.sparse);
	if (!plan(p) || !plan(&anew))
		return 1;
	differs = a->node_count != b->node_count || a->block_count != b->block_count || a->component_count != b->component_count ||
	          a->coupling_count != b->coupling_count || a->body_count != b->body_count || memcmp(p->planned, anew.planned, sizeof p->planned) != 0;
	for (k = 0; k < a->node_count && !differs; ++k) {
		differs |= memcmp(&a->nodes[k], &b->nodes[k], sizeof a->nodes[k]) != 0 || a->first[k + 1] != b->first[k + 1];
		for (e = a->first[k]; e < a->first[k + 1]; ++e)
			differs |= a->below[e] != b->below[e];
	}
	for (k = 0; k < a->component_count && !differs; ++k)
		differs |= memcmp(&a->components[k], &b->components[k], sizeof a->components[k]) != 0;
	for (k = 0; k < a->coupling_count && !differs; ++k)
		differs |= memcmp(&a->couplings[k], &b->couplings[k], sizeof a->couplings[k]) != 0;
	for (k = 0; k < a->body_count && !differs; ++k)
		differs |= a->bodies[k] != b->bodies[k];
	cni_arena_deinit(&anew.arena);
	cni_arena_reset(&p->arena);
	return differs;
}

static void t_a_kept_plan_is_used_again(void)
{
	problem *p = begin(5, 0.0);
	cni_array kept;
	const int32_t *first;
	cni_array_init(&kept, CNI_KEPT_BYTES);
	p->kept = &kept;
	add_grid(p, 5, 1);
	add_tree(p, 40, 0);
	add_bridge(p, 20, 2);
	CHECK(!kept_differs(p));
	first = p->sparse.first;
	memset(&p->sparse, 0, sizeof p->sparse);
	REQUIRE(plan(p));
	p->sparse.components[0].work = 0; /* the step's own */
	cni_arena_reset(&p->arena);
	CHECK(!kept_differs(p) && p->sparse.first == first);
	/* Whatever a plan depends on. */
	p->bodies[p->links[30].ia].inv_mass = p->bodies[p->links[30].ia].inv_inertia = 0.0f;
	CHECK(!kept_differs(p));
	p->links[12].ib = p->links[70].ib;
	CHECK(!kept_differs(p));
	p->links[50].owner = 7;
	CHECK(!kept_differs(p));
	p->links[50].rows = 3;
	CHECK(!kept_differs(p));
	for (p->link_count = 80; p->link_count > 0; p->link_count -= 7)
		CHECK(!kept_differs(p) && !kept_differs(p));
	p->link_count = 60;
	memset(&p->sparse, 0, sizeof p->sparse);
	REQUIRE(plan_within(p, 100));
	CHECK(planned_in(p, 0, 60) < 60);
	cni_arena_reset(&p->arena);
	CHECK(!kept_differs(p));
	cni_array_deinit(&kept, &p->memory);
	end(p);
}

/* ---- memory ---- */

static void *aligned_block(void)
{
	static uint8_t room[4 * 1024 * 1024];
	return room + (64 - (uintptr_t)room % 64) % 64;
}

/* Every size of a block that nothing can be added to, from too small to enough. */
static void t_too_little_memory_is_survived(void)
{
	static problem at;
	uint64_t bytes, needed;
	int32_t refused = 0, done = 0;
	problem *p = begin(6, 0.0);
	add_grid(p, 6, 2);
	needed = bytes_promised(p);
	memcpy(&at, p, sizeof at);
	end(p);
	REQUIRE(needed + 8192 < 4 * 1024 * 1024);
	for (bytes = 64; bytes < needed + 4096; bytes += done > 0 ? needed / 40 / 64 * 64 : 256) {
		int32_t good;
		cni_memory_init_block(&at.memory, aligned_block(), bytes);
		cni_arena_init(&at.arena, &at.memory);
		memset(&at.sparse, 0, sizeof at.sparse);
		memset(at.planned, 7, sizeof at.planned);
		good = plan(&at);
		CHECK(good || (at.arena.entry_count == 0 && at.arena.in_use == 0 && at.memory.bytes_in_use == 0));
		CHECK(good || (planned_in(&at, 0, at.link_count) == 0 && at.sparse.component_count == 0));
		CHECK(!good || (at.sparse.node_count == at.link_count && planned_in(&at, 0, at.link_count) == at.link_count));
		CHECK(good || done == 0);
		refused += !good;
		done += good;
		cni_arena_deinit(&at.arena);
	}
	printf("  %d sizes too small, %d large enough\n", (int)refused, (int)done);
	CHECK(refused > 100 && done > 0);
}

/* In an arena of just as many bytes as promised nothing falls back. */
static void t_scratch_is_what_was_promised(void)
{
	static void (*const make[])(problem *) = { make_tree, make_chain, make_bridge, make_star, make_grid, make_soft_grid, make_parallel, make_hindered };
	double most = 0.0;
	size_t m;
	int32_t each;
	for (m = 0; m < sizeof make / sizeof *make; ++m)
		for (each = 3; each <= 3000; each *= 10) {
			problem *p = begin(7, 0.0);
			uint64_t bytes;
			int32_t k;
			make[m](p);
			for (k = 0; k < p->link_count; ++k)
				p->links[k].work_most = each;
			bytes = bytes_promised(p);
			REQUIRE(cni_arena_reserve(&p->arena, bytes));
			REQUIRE(plan(p));
			CHECK(p->arena.fallbacks == 0);
			most = greater(most, (double)p->arena.high_water / (double)bytes);
			end(p);
		}
	CHECK_LE("scratch used / cni_sparse_bytes", most, 1.0, "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_simple_trees_make_no_fill);
	RUN(t_random_trees_make_little);
	RUN(t_plans_are_well_formed);
	RUN(t_loops_are_told_from_trees);
	RUN(t_beyond_the_limit_is_refused_alone);
	RUN(t_beyond_the_budget_is_refused);
	RUN(t_hubs_are_refused);
	RUN(t_a_kept_plan_is_used_again);
	RUN(t_too_little_memory_is_survived);
	RUN(t_scratch_is_what_was_promised);
	return test_end();
}
