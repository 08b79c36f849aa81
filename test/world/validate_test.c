/*
 * test/world/validate_test.c - cn_world_validate, by which other tests judge worlds, sees it when one number of a table is wrong, and names it.
 *
 * Each break changes one field of a valid world (or a record of the broadphase), and undoes it.
 */
#include "model/world.h"
#include "broadphase/sweep.h"
#include "broadphase/tree.h"
#include "fixture.h"

static int32_t breaks;

static void expect_broken(int line, const cn_world *world, const char *what, const char *name)
{
	char text[160] = "";
	cn_result result = cn_world_validate(world, text, (int32_t)sizeof text);
	++breaks;
	if (result == CN_ERROR_INTERNAL && strncmp(text, "broken invariant: ", 18) == 0 && strstr(text, name) != NULL)
		return;
	printf("  %s: result %d, \"%s\" instead of \"%s\"\n", what, (int)result, text, name);
	test_fail(__FILE__, line, "a broken invariant must be named");
}

/* The field gets another value for one validation. */
#define BREAK(T, field, value, name) do { T kept_ = (field); (field) = (value); expect_broken(__LINE__, world, #field, name); (field) = kept_; } while (0)
#define OFF_BY_ONE(field, name) do { ++(field); expect_broken(__LINE__, world, #field, name); (field) -= 2; expect_broken(__LINE__, world, #field, name); ++(field); } while (0)

/* A pile that rests, another that is awake, a box that flies just above it, jointed boxes, a kinematic body. */
static cn_world *busy_world(int32_t broadphase)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_revolute_def pin;
	cn_line_constraint_def line;
	cn_constraint constraint;
	cn_joint joint;
	int32_t k;
	cn_world_def_init(&def);
	def.broadphase = broadphase;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	fixture_floor(world, 0.6f, 0.0f);
	for (k = 0; k < 4; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, -8.0f, 0.5f + (float)k, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	fixture_step(world, 200);
	for (k = 0; k < 8; ++k)
		fixture_box(world, CN_BODY_DYNAMIC, 0.1f * (float)k, 0.4f + 0.8f * (float)k, 0.0f, 0.4f, 0.4f, 0.6f, 0.0f);
	fixture_set_velocity(world, fixture_box(world, CN_BODY_KINEMATIC, 9.0f, 3.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f), 0.1f, 0.0f, 1.0f);
	cn_revolute_def_init(&pin);
	pin.base.body_a = fixture_box(world, CN_BODY_DYNAMIC, 20.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	pin.base.body_b = fixture_box(world, CN_BODY_DYNAMIC, 21.0f, 5.0f, 0.0f, 0.5f, 0.5f, 0.6f, 0.0f);
	pin.base.anchor_a_m.x = 0.5f;
	pin.base.anchor_b_m.x = -0.5f;
	must(cn_joint_create_revolute(world, &pin, &joint), world, "cn_joint_create_revolute");
	cn_line_constraint_def_init(&line);
	line.body = pin.base.body_b;
	must(cn_constraint_create_line(world, &line, &constraint), world, "cn_constraint_create_line");
	fixture_step(world, 10);
	fixture_box(world, CN_BODY_DYNAMIC, 0.8f, 6.84f, 0.0f, 0.4f, 0.4f, 0.6f, 0.0f);
	fixture_step(world, 1);
	CHECK(fixture_is_valid(world));
	return world;
}

/* The first body of a type that is asleep or not. */
static int32_t body_of(const cn_world *world, int32_t type, int32_t awake)
{
	int32_t k;
	for (k = 0; k < cni_handles_used(&world->body_handles); ++k)
		if (cni_handles_alive(&world->body_handles, k) && cni_body_at(world, k)->type == type && (cni_body_at(world, k)->awake != 0) == awake)
			return k;
	return CNI_NONE;
}

static int32_t contact_with(const cn_world *world, uint32_t mask, uint32_t flags)
{
	int32_t k;
	for (k = 0; k < world->contact_used; ++k)
		if (cni_contact_at(world, k)->body[0] != CNI_NONE && (cni_contact_at(world, k)->flags & mask) == flags)
			return k;
	return CNI_NONE;
}

static void bodies_are_checked(void)
{
	cn_world *world = busy_world(CN_BROADPHASE_SWEEP);
	int32_t moving = body_of(world, CN_BODY_DYNAMIC, 1), resting = body_of(world, CN_BODY_DYNAMIC, 0), joined = 0;
	cni_body *b, *asleep;
	cni_motion *m;
	REQUIRE(moving != CNI_NONE && resting != CNI_NONE);
	b = cni_body_at(world, moving);
	asleep = cni_body_at(world, resting);
	m = cni_motions(world) + b->awake;
	BREAK(float, b->cx, NAN, "finite pose");
	BREAK(float, b->q.s, INFINITY, "finite pose");
	BREAK(uint32_t, b->flags, b->flags | CNI_BODY_MARK, "scratch mark");
	BREAK(int32_t, b->awake, b->awake + 1, "dense index");
	BREAK(int32_t, b->awake, world->awake_count, "dense index");
	BREAK(uint32_t, b->flags, b->flags & ~(uint32_t)CN_BODY_ENABLED, "awake body may move");
	BREAK(float, m->vx, NAN, "finite velocity");
	BREAK(float, m->w, INFINITY, "finite velocity");
	BREAK(float, b->vx, b->vx + 1.0f, "velocity in the record");
	BREAK(float, asleep->vy, 1.0f, "still body");
	BREAK(float, m->dpy, 1.0f, "no change left over");
	BREAK(float, m->theta, 1.0f, "no change left over");
	BREAK(int32_t, cni_awake_ids(world)[b->awake], resting, "dense index");
	BREAK(int32_t, asleep->awake, 1, "dense index");
	REQUIRE(asleep->island != CNI_NONE);
	BREAK(int32_t, asleep->island, b->island != CNI_NONE ? b->island : 0, "island");
	OFF_BY_ONE(world->movable_count, "count of movable bodies");
	OFF_BY_ONE(b->contact_count, "contact count of body");
	OFF_BY_ONE(b->lanes, "lane count of body");
	BREAK(uint32_t, b->colors, b->colors ^ 1u << 5, "colours of body");
	BREAK(int32_t, b->contact_first, CNI_NONE, "contact count of body");
	BREAK(int32_t, asleep->contact_first, b->contact_first, "contact list of body");
	BREAK(int32_t, asleep->shape_first, b->shape_first, "shape list of body");
	BREAK(int32_t, asleep->shape_first, CNI_NONE, "shapes in lists");
	BREAK(int32_t, cni_shape_at(world, b->shape_first)->prev, CNI_NONE, "last shape");
	BREAK(int32_t, cni_contact_of_key(world, b->contact_first)->prev[b->contact_first & 1], b->contact_first, "contact list of body");
	while (cni_body_at(world, joined)->joint_first == CNI_NONE)
		++joined;
	BREAK(int32_t, asleep->joint_first, cni_body_at(world, joined)->joint_first, "joint list of body");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void contacts_are_checked(void)
{
	cn_world *world = busy_world(CN_BROADPHASE_SWEEP);
	int32_t lane = contact_with(world, CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP | CNI_CONTACT_LINKED, CNI_CONTACT_TOUCHING | CNI_CONTACT_LINKED);
	int32_t sleeper = contact_with(world, CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP, CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP);
	int32_t apart = contact_with(world, CNI_CONTACT_TOUCHING, 0), block;
	cni_contact *c;
	REQUIRE(lane != CNI_NONE && sleeper != CNI_NONE && apart != CNI_NONE);
	c = cni_contact_at(world, lane);
	block = c->slot / CNI_LANES;
	BREAK(uint32_t, c->flags, c->flags & ~(uint32_t)CNI_CONTACT_LINKED, "link of contact");
	BREAK(int32_t, cni_block_info_at(world, block)->contact[c->slot % CNI_LANES], apart, "lane of contact");
	BREAK(int32_t, cni_block_at(world, block)->ia[c->slot % CNI_LANES], 0, "bodies in the lane");
	BREAK(int32_t, cni_block_at(world, block)->ib[c->slot % CNI_LANES], 0, "bodies in the lane");
	BREAK(int32_t, cni_contact_at(world, apart)->slot, world->apart.count, "apart list");
	BREAK(int32_t, cni_contact_at(world, sleeper)->slot, CNI_SLEEP_IN_BLOCKS ? c->slot : world->sleep_lanes.count, "sleep lane");
	OFF_BY_ONE(world->contact_count, "count of contacts");
	OFF_BY_ONE(world->touching_count, "count of touching contacts");
	OFF_BY_ONE(world->colors[0].lanes, "lanes in colours");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void islands_and_joints_are_checked(void)
{
	cn_world *world = busy_world(CN_BROADPHASE_SWEEP);
	cni_island *island;
	cni_joint *joint;
	int32_t k = 0;
	while (cni_island_at(world, k)->first == CNI_NONE)
		++k;
	island = cni_island_at(world, k);
	OFF_BY_ONE(world->island_count, "count of islands");
	OFF_BY_ONE(island->count, "size of island");
	BREAK(int32_t, island->last, island->first, "size of island");
	BREAK(int32_t, island->awake, island->awake == 0 ? 1 : 0, "island sleeps as one");
	BREAK(int32_t, cni_body_at(world, island->first)->island, CNI_NONE, "island");
	for (k = 0; !cni_joint_at(world, k)->linked; ++k)
		;
	joint = cni_joint_at(world, k);
	OFF_BY_ONE(world->constraint_count, "count of constraints");
	BREAK(int32_t, ((int32_t *)world->awake_joints.data)[joint->awake], k + 1, "awake list of joint");
	BREAK(uint16_t, joint->linked, !joint->linked, "link of joint");
	for (k = 0; !cni_joint_is_constraint(cni_joint_at(world, k)->type); ++k)
		;
	BREAK(uint16_t, cni_joint_at(world, k)->linked, 1, "link of joint"); /* which has one body: no other is looked at */
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

/* Boxes and marks that both broadphases share. */
static void boxes_are_checked(int32_t broadphase)
{
	cn_world *world = busy_world(broadphase);
	int32_t moving = body_of(world, CN_BODY_DYNAMIC, 1), resting = body_of(world, CN_BODY_DYNAMIC, 0);
	cni_proxy *fat = cni_proxy_at(world, cni_shape_proxy(world, cni_shape_at(world, cni_body_at(world, moving)->shape_first), 0));
	cni_proxy *still = cni_proxy_at(world, cni_shape_proxy(world, cni_shape_at(world, cni_body_at(world, resting)->shape_first), 0));
	BREAK(int32_t, fat->shape, fat->shape + 1, "proxy of shape");
	BREAK(uint32_t, fat->flags, fat->flags ^ CNI_PROXY_STATIC, "static mark of proxy");
	BREAK(float, still->fat.x0, still->fat.x0 - 1.0f, "broadphase");
	BREAK(float, still->fat.y1, still->fat.y1 + 1.0f, "broadphase");
	if (broadphase == CN_BROADPHASE_TREE) { /* the sweep has its own list of what moved */
		BREAK(uint32_t, still->flags, still->flags ^ CNI_PROXY_MOVED, "broadphase");
		BREAK(uint32_t, still->flags, still->flags | CNI_PROXY_AGAIN | CNI_PROXY_MOVED, "broadphase");
	}
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void boxes_of_the_sweep_are_checked(void) { boxes_are_checked(CN_BROADPHASE_SWEEP); }
static void boxes_of_the_tree_are_checked(void) { boxes_are_checked(CN_BROADPHASE_TREE); }

static void tiles_are_checked(void)
{
	cn_world *world = busy_world(CN_BROADPHASE_SWEEP);
	cni_sweep *sweep = (cni_sweep *)(void *)world->broadphase;
	cni_sweep_tile *tile = (cni_sweep_tile *)sweep->tiles.data;
	while (tile->level == CNI_SWEEP_FREE || tile->count < 2)
		++tile;
	OFF_BY_ONE(tile->count, "broadphase");
	OFF_BY_ONE(tile->tx, "broadphase");
	BREAK(uint8_t, tile->dense, 1, "broadphase");
	BREAK(int32_t, tile->touched, 1, "broadphase");
	BREAK(float, tile->reach, 0.0f, "broadphase");
	BREAK(float, tile->bounds.x1, tile->bounds.x0, "broadphase");
	OFF_BY_ONE(sweep->tile_count, "broadphase");
	OFF_BY_ONE(sweep->count, "broadphase");
	OFF_BY_ONE(sweep->loose_count, "broadphase");
	OFF_BY_ONE(sweep->moved_count, "broadphase");
	BREAK(uint32_t, sweep->level_mask, 0u, "broadphase");
	BREAK(int32_t, sweep->levels[tile->level].tx1, sweep->levels[tile->level].tx0 - 1, "broadphase");
	OFF_BY_ONE(sweep->levels[tile->level].entries, "broadphase");
	CHECK(fixture_is_valid(world));
	cn_world_destroy(world);
}

static void bulk_insert(cni_tree *tree, cni_memory *memory, int32_t count)
{
	int32_t k;
	cni_tree_init(tree);
	REQUIRE(cni_tree_reserve(tree, memory, count, 1));
	for (k = 0; k < count; ++k) {
		cni_aabb box;
		box.x0 = (float)(k * 7 % 31);
		box.y0 = (float)(k * 5 % 17);
		box.x1 = box.x0 + 1.5f;
		box.y1 = box.y0 + 1.5f;
		cni_tree_insert(tree, k, &box);
	}
}

static void expect_seen(int line, const cni_tree *tree, const char *what)
{
	++breaks;
	if (!cni_tree_validate(tree))
		return;
	printf("  %s is not seen\n", what);
	test_fail(__FILE__, line, "a broken tree must be seen");
}

#define TREE_BREAK(T, field, value) do { T kept_ = (field); (field) = (value); expect_seen(__LINE__, &tree, #field); (field) = kept_; } while (0)

static void nodes_of_a_tree_are_checked(void)
{
	cni_memory memory;
	cni_tree tree;
	cni_tree_node *nodes, *n;
	int32_t k;
	cni_memory_init_hooks(&memory, NULL, NULL, NULL);
	bulk_insert(&tree, &memory, 40);
	CHECK(cni_tree_validate(&tree));
	nodes = (cni_tree_node *)tree.nodes.data;
	for (k = 1; k < tree.nodes.count && !(nodes[k].child[0] > 0 && nodes[k].child[1] < 0); ++k)
		;
	REQUIRE(k < tree.nodes.count);
	n = &nodes[k];
	TREE_BREAK(int32_t, tree.count, 39);
	TREE_BREAK(int32_t, tree.count, 41);
	TREE_BREAK(int32_t, tree.stale, 1);
	TREE_BREAK(int32_t, n->child[0], CNI_TREE_EMPTY);
	TREE_BREAK(int32_t, n->child[0], tree.nodes.count);
	TREE_BREAK(int32_t, n->child[0], ~0);
	TREE_BREAK(int32_t, n->child[1], ~1000);
	TREE_BREAK(int32_t, n->parent, n->parent ^ 1);
	TREE_BREAK(float, n->box[0].x1, n->box[0].x1 + 1.0f);
	TREE_BREAK(uint8_t, n->height[0], (uint8_t)(n->height[0] + 1));
	TREE_BREAK(uint8_t, n->height[1], 1);
	TREE_BREAK(uint8_t, n->marks[1], 0);
	TREE_BREAK(uint8_t, n->marks[0], 0);
	TREE_BREAK(int32_t, ((int32_t *)tree.places.data)[5], CNI_NONE);
	CHECK(cni_tree_validate(&tree));
	cni_tree_deinit(&tree, &memory);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(bodies_are_checked);
	RUN(contacts_are_checked);
	RUN(islands_and_joints_are_checked);
	RUN(boxes_of_the_sweep_are_checked);
	RUN(boxes_of_the_tree_are_checked);
	RUN(tiles_are_checked);
	RUN(nodes_of_a_tree_are_checked);
	return test_end();
}
