/*
 * query_filter_test - promise: a query that starts in contact says how deep and which way out, and does not meet what it only
 * touches and leaves; it sees what its filter lets it see: without a body and what is joined to it, without what the user's callback
 * skips, one-way shapes from above; and a stop cuts the results off in their own order.
 */
#include "queries.h"

/* ------------------------------------------------------------------ in contact */

static cn_ray_hit cast(const cn_polygon *p, float dx, float dy, uint32_t flags)
{
	cn_query_filter filter;
	cn_ray_hit hit;
	cn_query_filter_init(&filter);
	filter.flags = flags;
	must(cn_world_cast_shape(w, p, dx, dy, &filter, &hit), w, "cast_shape");
	return hit;
}

static cn_ray_hit ray_from(float x, float y, float dx, float dy)
{
	cn_ray ray = { { 0.0f, 0.0f }, { 0.0f, 0.0f } };
	cn_ray_hit hit;
	ray.origin_m.x = x;
	ray.origin_m.y = y;
	ray.translation_m.x = dx;
	ray.translation_m.y = dy;
	must(cn_world_cast_ray(w, &ray, NULL, &hit), w, "cast_ray");
	return hit;
}

/* A ball, a capsule and a box on a floor, at heights from outside to deep. */
static void t_casts_in_contact(void)
{
	static const float depths[5] = { 0.0f, 1e-4f, 4e-3f, 0.1f, 0.4f };
	int32_t d, shape;
	double worst = 0.0;
	w = fixture_world(0.0f, 1);
	fixture_floor(w, 0.5f, 0.0f);
	for (shape = 0; shape < 3; ++shape)
		for (d = 0; d < 5; ++d) {
			int touches = depths[d] < 0.005f;
			cn_polygon p = { 1, 0.5f, { { 1.0f, 0.5f }, { 2.0f, 0.5f } } };
			cn_ray_hit hit;
			int32_t k;
			p.count = 1 + (shape > 0);
			if (shape == 2)
				must(cn_polygon_make_box(0.5f, 0.5f, 1.0f, 0.5f, 0.0f, 0.0f, &p), NULL, "box");
			for (k = 0; k < p.count; ++k)
				p.points_m[k].y -= depths[d];
			hit = cast(&p, 0.3f, -1.0f, 0); /* farther in */
			CHECK(hit.shape != 0 && hit.fraction == 0.0f && hit.normal.y == 1.0f && hit.normal.x == 0.0f);
			worst = greater(worst, fabs((double)(hit.depth_m - depths[d])));
			worst = greater(worst, fabs((double)hit.point_m.y));
			hit = cast(&p, 0.0f, 0.0f, 0); /* nowhere: what is there */
			CHECK(hit.shape != 0 && hit.fraction == 0.0f && hit.normal.y == 1.0f);
			CHECK((cast(&p, 0.0f, 3.0f, 0).shape == 0) == touches);  /* away */
			CHECK((cast(&p, 3.0f, 0.0f, 0).shape == 0) == touches);  /* along */
			CHECK((cast(&p, -3.0f, 0.1f, 0).shape == 0) == touches);
			CHECK(cast(&p, 0.0f, 3.0f, CN_QUERY_LEAVING).shape == 0 && cast(&p, 3.0f, 0.0f, CN_QUERY_LEAVING).shape == 0);
			CHECK(cast(&p, 0.0f, -3.0f, CN_QUERY_LEAVING).shape != 0);
			hit = ray_from(1.0f, -depths[d], 0.3f, 1.0f);
			CHECK((hit.shape == 0) == touches && (touches || (hit.normal.y == 1.0f && hit.fraction == 0.0f)));
			hit = ray_from(1.0f, -depths[d], 0.3f, -1.0f);
			CHECK(hit.shape != 0 && hit.normal.y == 1.0f && hit.fraction == 0.0f);
			worst = greater(worst, fabs((double)(hit.depth_m - depths[d])));
		}
	CHECK_LE("error of depths and points", worst, 1e-6, "m");
	cn_world_destroy(w);
}

/* What leads away from one shape may meet the next. */
static void t_leaving_one_meets_the_next(void)
{
	cn_polygon ball = { 1, 0.5f, { { 0.0f, 0.5f } } };
	cn_body ceiling;
	w = fixture_world(0.0f, 1);
	fixture_floor(w, 0.5f, 0.0f);
	ceiling = fixture_box(w, CN_BODY_STATIC, 0.0f, 4.0f, 0.0f, 5.0f, 1.0f, 0.5f, 0.0f);
	CHECK(cast(&ball, 0.0f, 4.0f, 0).body == ceiling && cast(&ball, 0.0f, 4.0f, 0).fraction == 0.5f);
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ ignored bodies */

static int32_t overlaps_all(const cn_query_filter *filter)
{
	cn_aabb box = { { -100.0f, -100.0f }, { 100.0f, 100.0f } };
	int32_t count;
	must(cn_world_overlap_aabb(w, &box, filter, NULL, 0, &count), w, "overlap");
	return count;
}

static void t_ignored_bodies_are_not_seen(void)
{
	cn_body chain[5];
	cn_revolute_def rd;
	cn_query_filter filter;
	cn_ray ray = { { -5.0f, 0.0f }, { 20.0f, 0.0f } };
	cn_ray_hit hit;
	cn_closest closest;
	cn_joint joints[4];
	int32_t k;
	w = fixture_world(0.0f, 1);
	cn_query_filter_init(&filter);
	for (k = 0; k < 5; ++k)
		chain[k] = fixture_circle(w, CN_BODY_DYNAMIC, (float)k, 0.0f, 0.4f, 0.5f, 0.0f);
	cn_revolute_def_init(&rd);
	for (k = 0; k < 4; ++k) { /* the sides of a joint in either order */
		rd.base.body_a = chain[k % 2 ? k : k + 1];
		rd.base.body_b = chain[k % 2 ? k + 1 : k];
		must(cn_joint_create_revolute(w, &rd, &joints[k]), w, "joint");
	}
	CHECK(overlaps_all(&filter) == 5);
	filter.ignored_body = chain[1];
	CHECK(overlaps_all(&filter) == 4);
	must(cn_world_closest_point(w, 1.0f, 0.0f, 5.0f, &filter, &closest), w, "closest");
	CHECK(closest.body == chain[0] || closest.body == chain[2]);
	filter.flags = CN_QUERY_IGNORE_JOINED;
	CHECK(overlaps_all(&filter) == 2);
	must(cn_world_cast_ray(w, &ray, &filter, &hit), w, "ray");
	CHECK(hit.body == chain[3]);
	filter.ignored_body = chain[0];
	must(cn_world_cast_ray(w, &ray, &filter, &hit), w, "ray");
	CHECK(hit.body == chain[2]);
	must(cn_joint_destroy(w, joints[0]), w, "destroy");
	must(cn_world_cast_ray(w, &ray, &filter, &hit), w, "ray");
	CHECK(hit.body == chain[1]);
	must(cn_body_destroy(w, chain[0]), w, "destroy");
	CHECK(cn_world_cast_ray(w, &ray, &filter, &hit) == CN_ERROR_HANDLE);
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ the user's say */

/* Every third shape is skipped, every seventh stops. */
typedef struct say { int32_t calls, stops; } say;
static int32_t say_of(cn_shape shape) { return (shape & 0xFFFFFu) % 3 == 0 ? CN_QUERY_SKIP : (shape & 0xFFFFFu) % 7 == 0 ? CN_QUERY_STOP : CN_QUERY_TAKE; }
static int32_t say_fn(const cn_world *world, const cn_ray_hit *hit, void *user)
{
	say *s = (say *)user;
	cn_body body;
	++s->calls;
	s->stops += say_of(hit->shape) == CN_QUERY_STOP;
	CHECK(cn_shape_get_body(world, hit->shape, &body) == CN_OK && body == hit->body);
	return say_of(hit->shape);
}

/* As the callback does, from a full list. */
static int32_t cut_hits(const cn_ray_hit *all, int32_t count, cn_ray_hit *out)
{
	int32_t k, kept = 0;
	for (k = 0; k < count; ++k) {
		if (say_of(all[k].shape) == CN_QUERY_SKIP)
			continue;
		out[kept++] = all[k];
		if (say_of(all[k].shape) == CN_QUERY_STOP)
			break;
	}
	return kept;
}

static int32_t cut_shapes(const cn_shape *all, int32_t count, cn_shape *out)
{
	int32_t k, kept = 0;
	for (k = 0; k < count; ++k) {
		if (say_of(all[k]) == CN_QUERY_SKIP)
			continue;
		out[kept++] = all[k];
		if (say_of(all[k]) == CN_QUERY_STOP)
			break;
	}
	return kept;
}

static void t_the_callback_skips_and_stops(void)
{
	static cn_ray_hit all[256], cut[256], found[256];
	static cn_shape shapes[SHAPES_MAX], cut_list[SHAPES_MAX], list[SHAPES_MAX];
	say s = { 0, 0 };
	int32_t k, count, expected, wrong = 0, round, any;
	for (round = 0; round < 2; ++round) {
		broadphase_kind = round ? CN_BROADPHASE_TREE : CN_BROADPHASE_SWEEP;
		random_world(900u, 0.0f);
		for (k = 0; k < 300; ++k) {
			cn_ray ray = random_ray(0.0f);
			cn_polygon polygon = random_region(0.0f, 1 + below(3));
			cn_query_filter plain, asked;
			cn_ray_hit hit, moved, free_moved;
			cn_query_filter_init(&plain);
			asked = plain;
			asked.visit = say_fn;
			asked.user = &s;
			must(cn_world_cast_ray_all(w, &ray, &plain, all, 256, &count), w, "all");
			expected = cut_hits(all, count, cut);
			must(cn_world_cast_ray_all(w, &ray, &asked, found, 256, &count), w, "all");
			wrong += count != expected || !same(found, cut, (size_t)count * sizeof *cut);
			must(cn_world_cast_ray_all(w, &ray, &asked, found, 2, &count), w, "all");
			wrong += count != expected || !same(found, cut, (size_t)(count < 2 ? count : 2) * sizeof *cut);
			must(cn_world_cast_ray(w, &ray, &asked, &hit), w, "nearest");
			wrong += expected > 0 ? !same(&hit, cut, sizeof hit) : hit.shape != 0;
			must(cn_world_cast_ray_any(w, &ray, &asked, &any), w, "any");
			wrong += any != (expected > 0);
			must(cn_world_overlap_polygon(w, &polygon, &plain, shapes, SHAPES_MAX, &count), w, "overlap");
			expected = cut_shapes(shapes, count, cut_list);
			must(cn_world_overlap_polygon(w, &polygon, &asked, list, SHAPES_MAX, &count), w, "overlap");
			wrong += count != expected || !same(list, cut_list, (size_t)count * sizeof *list);
			must(cn_world_cast_shape(w, &polygon, ray.translation_m.x, ray.translation_m.y, &asked, &moved), w, "cast_shape");
			must(cn_world_cast_shape(w, &polygon, ray.translation_m.x, ray.translation_m.y, &plain, &free_moved), w, "cast_shape");
			wrong += moved.shape != 0 && say_of(moved.shape) == CN_QUERY_SKIP;
			wrong += moved.fraction < free_moved.fraction;
			wrong += free_moved.shape != 0 && say_of(free_moved.shape) != CN_QUERY_SKIP && !same(&moved, &free_moved, sizeof moved);
		}
		cn_world_destroy(w);
	}
	broadphase_kind = CN_BROADPHASE_SWEEP;
	printf("  asked %d times, %d stops\n", (int)s.calls, (int)s.stops);
	CHECK_GE("stops", s.stops, 100, "");
	CHECK_LE("wrong answers", wrong, 0, "");
}

static int32_t skip_all(const cn_world *world, const cn_ray_hit *hit, void *user)
{
	(void)hit;
	/* The world is locked for calls that would change it. */
	*(cn_result *)user = cn_world_set_gravity((cn_world *)(uintptr_t)world, 0.0f, 0.0f);
	return CN_QUERY_SKIP;
}

static void t_explosions_ask_too(void)
{
	cn_explosion_def blast;
	cn_result inside = CN_OK;
	cn_body ball;
	w = fixture_world(0.0f, 1);
	ball = fixture_circle(w, CN_BODY_DYNAMIC, 1.0f, 0.0f, 0.5f, 0.5f, 0.0f);
	cn_explosion_def_init(&blast);
	blast.radius_m = 3.0f;
	blast.impulse_Nspm = 1.0f;
	blast.filter.visit = skip_all;
	blast.filter.user = &inside;
	must(cn_world_explode(w, &blast), w, "explode");
	CHECK(fixture_velocity(w, ball).linear_mps.x == 0.0f && inside == CN_ERROR_LOCKED);
	blast.filter.visit = NULL;
	must(cn_world_explode(w, &blast), w, "explode");
	CHECK(fixture_velocity(w, ball).linear_mps.x > 0.5f);
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ one-way shapes */

static void t_one_way_shapes_are_met_from_above(void)
{
	cn_polygon ball = { 1, 0.5f, { { 0.0f, 3.0f } } };
	cn_body body;
	cn_shape_def sd;
	cn_query_filter filter;
	cn_closest closest;
	int32_t turned;
	for (turned = 0; turned < 2; ++turned) {
		/* Turned by half a circle, its upper side is below. */
		w = fixture_world(0.0f, 1);
		body = fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, turned ? 3.14159265f : 0.0f);
		sd = fixture_shape_def(body, 0.5f, 0.0f);
		sd.flags = CN_SHAPE_ONE_WAY;
		fixture_box_shape(w, &sd, 2.0f, 0.5f);
		ball.points_m[0].y = 3.0f;
		CHECK((cast(&ball, 0.0f, -6.0f, CN_QUERY_ONE_WAY).body == body) == !turned);
		CHECK(cast(&ball, 0.0f, -6.0f, 0).body == body);
		ball.points_m[0].y = -3.0f;
		CHECK((cast(&ball, 0.0f, 6.0f, CN_QUERY_ONE_WAY).body == body) == turned);
		ball.points_m[0].y = 0.2f; /* in it */
		CHECK(cast(&ball, 0.0f, -6.0f, CN_QUERY_ONE_WAY).shape == 0);
		ball.points_m[0].y = turned ? -0.999f : 0.999f; /* as good as on it */
		CHECK(cast(&ball, 0.0f, turned ? 1.0f : -1.0f, CN_QUERY_ONE_WAY).body == body);
		ball.points_m[0].y = 0.0f;
		ball.points_m[0].x = -5.0f;
		CHECK(cast(&ball, 10.0f, 0.0f, CN_QUERY_ONE_WAY).shape == 0);
		ball.points_m[0].x = 0.0f;
		cn_query_filter_init(&filter);
		filter.flags = CN_QUERY_ONE_WAY;
		CHECK(overlaps_all(&filter) == 0 && overlaps_all(NULL) == 1);
		must(cn_world_closest_point(w, 0.0f, 1.0f, 5.0f, &filter, &closest), w, "closest");
		CHECK(closest.shape == 0);
		cn_world_destroy(w);
	}
}

/* ------------------------------------------------------------------ contacts and visitors of a shape */

static void t_contacts_of_a_shape(void)
{
	cn_shape_def sd;
	cn_body body;
	cn_shape left, right, shapes[2];
	cn_contact_event all[16], some[16];
	int32_t count, n, k, sum = 0;
	w = fixture_world(-10.0f, 0);
	fixture_floor(w, 0.5f, 0.0f);
	body = fixture_body(w, CN_BODY_DYNAMIC, 0.0f, 0.49f, 0.0f);
	sd = fixture_shape_def(body, 0.5f, 0.0f);
	sd.offset_m.x = -1.0f;
	left = fixture_box_shape(w, &sd, 0.5f, 0.5f);
	sd.offset_m.x = 1.0f;
	right = fixture_box_shape(w, &sd, 0.5f, 0.5f);
	fixture_box(w, CN_BODY_DYNAMIC, -1.0f, 1.45f, 0.0f, 0.4f, 0.5f, 0.5f, 0.0f);
	fixture_step(w, 10);
	shapes[0] = left;
	shapes[1] = right;
	must(cn_body_get_contacts(w, body, all, 16, &count), w, "body");
	for (k = 0; k < 2; ++k) {
		must(cn_shape_get_contacts(w, shapes[k], some, 16, &n), w, "shape");
		CHECK(n == 2 - k && some[0].kind == CN_EVENT_STAY && some[0].manifold.point_count == 2);
		CHECK(some[0].shape_a == shapes[k] || some[0].shape_b == shapes[k]);
		sum += n;
		must(cn_shape_get_contacts(w, shapes[k], NULL, 0, &n), w, "count");
		CHECK(n == 2 - k);
	}
	CHECK(sum == count);
	must(cn_shape_detach(w, left), w, "detach");
	must(cn_shape_get_contacts(w, left, some, 16, &n), w, "detached");
	CHECK(n == 0);
	cn_world_destroy(w);
}

/* Who is in a sensor is who entered and has not left, by the events, of boxes and of chains. */
static void t_visitors_of_a_sensor(void)
{
	cn_shape_def sd;
	cn_shape sensors[2], visitors[32];
	cn_vec2 points[6] = { { -3.0f, 0.5f }, { -1.0f, 0.0f }, { 0.0f, 0.3f }, { 1.0f, 0.0f }, { 2.0f, 0.2f }, { 3.0f, 0.0f } };
	cn_chain chain = { points, 6, 0 };
	const cn_sensor_event *events;
	int32_t inside[2][64] = { { 0 } }, step, k, n, s, wrong = 0, most = 0;
	w = fixture_world(-3.0f, 0);
	sd = fixture_shape_def(fixture_body(w, CN_BODY_STATIC, 0.0f, 0.0f, 0.0f), 0.5f, 0.0f);
	sd.flags = CN_SHAPE_SENSOR;
	sensors[0] = fixture_box_shape(w, &sd, 2.0f, 1.0f);
	must(cn_shape_create_chain(w, &sd, &chain, &sensors[1]), w, "chain");
	for (k = 0; k < 24; ++k)
		fixture_circle(w, CN_BODY_DYNAMIC, -3.0f + 0.25f * (float)k, 1.5f + 0.3f * (float)(k % 5), 0.35f, 0.5f, 0.0f);
	for (step = 0; step < 200; ++step) {
		fixture_step(w, 1);
		must(cn_world_sensor_events(w, &events, &n), w, "events");
		for (k = 0; k < n; ++k)
			inside[events[k].sensor == sensors[1]][events[k].visitor & 63u] += events[k].kind == CN_EVENT_ENTER ? 1 : -1;
		for (s = 0; s < 2; ++s) {
			int32_t listed = 0;
			must(cn_shape_get_visitors(w, sensors[s], visitors, 32, &n), w, "visitors");
			most = n > most ? n : most;
			for (k = 0; k < n; ++k)
				wrong += inside[s][visitors[k] & 63u] <= 0;
			for (k = 0; k < 64; ++k)
				listed += inside[s][k] > 0;
			wrong += listed != n;
		}
	}
	CHECK_LE("wrong visitors", wrong, 0, "");
	CHECK_GE("most visitors at once", most, 6, "");
	cn_world_destroy(w);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_casts_in_contact);
	RUN(t_leaving_one_meets_the_next);
	RUN(t_ignored_bodies_are_not_seen);
	RUN(t_the_callback_skips_and_stops);
	RUN(t_explosions_ask_too);
	RUN(t_one_way_shapes_are_met_from_above);
	RUN(t_contacts_of_a_shape);
	RUN(t_visitors_of_a_sensor);
	return test_end();
}
