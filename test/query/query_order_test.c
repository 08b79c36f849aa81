/*
 * query_order_test - promise: what queries answer, and in which order, does not depend on the broadphase.
 */
#include "queries.h"

/* ------------------------------------------------------------------ order of visits */

/* A broadphase that finds the same boxes in another order. */
static void backward_query(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context)
{
	int32_t id;
	(void)broadphase;
	for (id = w->proxy_used - 1; id >= 0; --id)
		if ((cni_proxy_at(w, id)->flags & CNI_PROXY_ALIVE) && cni_aabb_overlap(&cni_proxy_at(w, id)->fat, box) && visit(context, id, 1.0f) == 0.0f)
			return;
}

static void backward_ray(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context)
{
	int32_t id;
	float limit = 1.0f;
	(void)broadphase;
	(void)origin;
	(void)translation;
	for (id = w->proxy_used - 1; id >= 0 && limit > 0.0f; --id)
		if (cni_proxy_at(w, id)->flags & CNI_PROXY_ALIVE)
			limit = visit(context, id, limit);
}

/* Also where many answers are equal: shapes on top of each other. */
static void t_answers_do_not_depend_on_the_broadphase(void)
{
	cni_broadphase_ops backward;
	const cni_broadphase_ops *forward;
	int32_t k, different = 0;
	random_world(500u, 0.0f);
	for (k = 0; k < 60; ++k)
		fixture_box(w, CN_BODY_STATIC, (float)(k / 5), 0.0f, 0.0f, 0.5f, 0.5f, 0.5f, 0.0f);
	shuffle_bodies(0.0f);
	forward = w->broadphase_ops;
	backward = *forward;
	backward.query = backward_query;
	backward.ray = backward_ray;
	for (k = 0; k < TEST_SAMPLES(1500); ++k) {
		cn_ray ray = random_ray(0.0f);
		cn_polygon polygon = random_region(0.0f, 1 + below(3));
		cn_query_filter filter = random_filter();
		static answers a, b;
		if (k % 3 == 0) {
			ray.origin_m.x = (float)below(12);
			ray.origin_m.y = (float)(below(3) - 1) * 2.0f;
			ray.translation_m.x = 0.0f;
			ray.translation_m.y = -2.0f * ray.origin_m.y;
		}
		answer(&a, &ray, &polygon, &filter);
		w->broadphase_ops = &backward;
		answer(&b, &ray, &polygon, &filter);
		w->broadphase_ops = forward;
		different += !same(&a, &b, sizeof a);
	}
	CHECK_LE("different answers", different, 0, "");
	cn_world_destroy(w);
}

static uint64_t fnv(uint64_t hash, const void *bytes, size_t count)
{
	size_t k;
	for (k = 0; k < count; ++k)
		hash = (hash ^ ((const uint8_t *)bytes)[k]) * 1099511628211ull;
	return hash;
}

/* Everything that a session of stepping, moving and asking is told. */
static uint64_t session(int32_t with_broadphase)
{
	static answers a;
	uint64_t hash = 14695981039346656037ull;
	int32_t round, k;
	broadphase_kind = with_broadphase;
	random_world(700u, 0.0f);
	for (round = 0; round < 3; ++round) {
		for (k = 0; k < 200; ++k) {
			cn_ray ray = random_ray(0.0f);
			cn_polygon polygon = random_region(0.0f, 1 + below(3));
			cn_query_filter filter = random_filter();
			answer(&a, &ray, &polygon, &filter);
			hash = fnv(hash, &a, sizeof a);
		}
		shuffle_bodies(0.0f);
		fixture_step(w, round);
	}
	cn_world_destroy(w);
	broadphase_kind = CN_BROADPHASE_SWEEP;
	return hash;
}

static void t_sweep_and_tree_tell_the_same(void)
{
	uint64_t sweep = session(CN_BROADPHASE_SWEEP), tree = session(CN_BROADPHASE_TREE);
	printf("  hashes of all answers %016llx and %016llx\n", (unsigned long long)sweep, (unsigned long long)tree);
	CHECK(sweep == tree);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_answers_do_not_depend_on_the_broadphase);
	RUN(t_sweep_and_tree_tell_the_same);
	return test_end();
}
