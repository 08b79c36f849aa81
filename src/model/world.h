/*
 * model/world.h - cn_world: all tables of a world and their owners. All code below the public API uses indices into these
 * tables.
 */
#ifndef CNI_MODEL_WORLD_H
#define CNI_MODEL_WORLD_H

#include "base/ablation.h"
#include "base/arena.h"
#include "base/handles.h"
#include "model/area.h"
#include "model/body.h"
#include "model/contact.h"
#include "model/event.h"
#include "model/island.h"
#include "model/joint.h"
#include "broadphase/proxy.h"
#include "model/shape.h"
#include "broadphase/broadphase.h"

#define CNI_ERROR_TEXT_BYTES (CNI_HAS_MESSAGES ? 192 : 8)
#define CNI_ESTIMATED_MOST 32

/* Items in a page of each table, as powers of two: small first pages keep an empty world small. */
#ifdef CN_SMALL_BLOCKS
enum { CNI_PAGE_BODIES = 2, CNI_PAGE_READBACK = 3, CNI_PAGE_SHAPES = 2, CNI_PAGE_PROXIES = 2, CNI_PAGE_CONTACTS = 3, CNI_PAGE_BLOCKS = 4, CNI_PAGE_JOINTS = 2, CNI_PAGE_ISLANDS = 2 };
#else
enum { CNI_PAGE_BODIES = 4, CNI_PAGE_READBACK = 5, CNI_PAGE_SHAPES = 5, CNI_PAGE_PROXIES = 5, CNI_PAGE_CONTACTS = 6, CNI_PAGE_BLOCKS = 2, CNI_PAGE_JOINTS = 5, CNI_PAGE_ISLANDS = 4 };
#endif

/* Numbers of the world definition with defaults and the length unit resolved. */
typedef struct cni_settings {
	cn_vec2 gravity;
	float length_unit;
	int32_t solver;
	int32_t broadphase;
	int32_t substeps;
	uint32_t flags;
	float restitution_threshold;
	float push_speed_max;
	float linear_speed_max;
	float angular_speed_max;
	float sleep_speed;
	float sleep_delay;
	float hit_speed;        /* slower blows are not reported */
	float slop;             /* 0.005 length units: lengths below it do not matter */
	float thickness_least;  /* 0.0005 length units: of shapes, and between their points. See CNI_THICKNESS_LEAST */
	float box_margin;       /* 0.1 length units: of fat boxes */
	float contact_margin;   /* 4 slops: speculative distance of slow contacts */
	float accuracy;         /* smaller errors are acceptable */
	int32_t work_budget;    /* limit of direct solving in a step, 0: no limit */
} cni_settings;

/* Which new pairs may already have a contact. */
enum {
	CNI_PAIRS_MARKED = 1, /* pairs of bodies with CNI_BODY_AGAIN: woken, moved, or filters changed */
	CNI_PAIRS_ALL = 3,    /* all pairs: memory was short for a new contact, or for the end of one */
	CNI_PAIRS_CROWDED = 4, /* some proxies have CNI_PROXY_CROWDED: some of their pairs have no contact yet ... */
	CNI_PAIRS_CROWDED_FIXED = 8 /* ... also pairs with fixed bodies */
};

struct cn_world {
	/* memory of everything below */
	cni_memory memory;
	cni_arena arena;
	cni_blocks blocks;
	cni_team *team;              /* workers of a step, NULL: the calling thread alone */
	uint64_t user_data;

	cni_settings settings;
	uint16_t locked;             /* > 0 while callbacks run */
	uint16_t overridden;         /* 1: a body or joint has had its own solver */
	uint32_t step_count;
	float step_dt;               /* length of the current or last step */
	float mean_dt;               /* mean length of the steps so far; 0: none */
	float longest_dt;            /* longest step of late */
	int32_t event_capacity;      /* of a fixed block: contacts that may report events */

	/* bodies */
	cni_handles body_handles;
	cni_table bodies;            /* cni_body */
	cni_table readback;          /* cn_body_moved by body slot: see cni_readback_at */
	int32_t readback_kept;       /* 1: it has all bodies */
	uint32_t readback_asked;     /* step count + 1 when it was last asked for, 0: never */
	int32_t movable_count;       /* bodies that are not static: required capacity of the dense arrays */
	int32_t awake_count;         /* entries of the dense arrays, the dummy included: >= 1 */
	cni_array motion;            /* cni_motion */
	cni_array start;             /* cni_velocity_start */
	cni_array external;          /* cni_external */
	cni_array awake_id;          /* int32_t */
	int32_t *awake_islands;      /* island numbers by dense index, within a step: scratch of the arena. NULL outside, without islands,
	                                without memory */
	int32_t *step_islands;       /* records of the numbered islands, scratch of the arena; NULL: record index = number */
	int32_t step_island_count;   /* count of island numbers, within a step */
	int32_t masses_estimated;    /* bodies of the list below */
	cn_body estimated[CNI_ESTIMATED_MOST]; /* whose mass is a sum to which shapes were added: cni_body_shapes_changed */
	cni_array kicked;            /* cn_body whose velocity was set since the last step: CNI_BODY_KICKED */

	/* variable time: empty until cn_world_update is used */
	cni_array previous;          /* cni_previous by body slot */
	float fixed_step;            /* seconds */
	float time_owed;             /* seconds */
	int32_t steps_max;
	int32_t reserved_time;

	/* shapes and proxies */
	cni_handles shape_handles;
	cni_table shapes;            /* cni_shape */
	cni_table proxies;           /* cni_proxy */
	int32_t proxy_used;          /* ids allocated so far */
	int32_t proxy_free;          /* first free id, linked by cni_proxy.shape */
	int32_t proxy_count;
	int32_t proxy_free_count;
	const cni_broadphase_ops *broadphase_ops;
	cni_broadphase *broadphase;
	cni_broadphase_pairs pairs;
	int32_t pairs_may_repeat;    /* 0 or CNI_PAIRS_ */
	int32_t seams_changed;       /* 1: static shapes were added, removed, moved or changed since the last step ... */
	cni_aabb seams_box;          /* ... within this box: see narrowphase/static_seams.c */

	cni_array areas;             /* cni_area, sorted */

	/* contacts */
	int32_t contact_used;
	int32_t contact_free;        /* linked by cni_contact.slot */
	int32_t contact_count;
	int32_t contacts_reporting;  /* that report events */
	int32_t vertex_capacity;     /* of a fixed block: all shapes with at most so many vertices take the same memory; else 0 */
	int32_t touching_count;      /* lanes and sleep lanes */
	cni_table contacts;          /* cni_contact */
	cni_array apart;             /* int32_t: awake contacts that do not touch; count of the list, capacity for all contacts */
	cni_table blocks_hot;        /* cni_contact_block */
	cni_table blocks_info;       /* cni_block_info */
	cni_table blocks_anchor;     /* cni_block_anchor */
	cni_table blocks_extra;      /* cni_block_extra, reserved only once some contact needs one */
	int32_t block_used;
	int32_t block_free;
	cni_color colors[CNI_COLOR_LISTS];
	cni_array block_list;        /* cni_listed_block: scratch of a step, capacity for every block */
	cni_array sleep_lanes;       /* cni_sleep_lane; empty with CNI_SLEEP_IN_BLOCKS */
	cni_block_sums *sums;        /* within a step: scratch of the arena, see contacts/impulse_sums.c. NULL: no contact needs them */
	int32_t sums_count;
	int32_t sums_active;         /* 1: some contact reports impulses in this step */

	/* joints and constraints */
	cni_handles joint_handles;
	int32_t constraint_count;    /* of the live joint records */
	int32_t stressed_joints;     /* joints beyond a break threshold in this step, not yet handled */
	cni_table joints;            /* cni_joint */
	cni_array awake_joints;      /* int32_t */
	cni_array joint_work;        /* cni_joint_constraint of joints/joint_constraint.h, one per awake joint */
	cni_array joint_blocks;      /* cni_joint_block of joints/joint_pass.h; capacity for every joint in any colours */
	int32_t joint_blocks_of[CNI_JOINT_COLORS]; /* blocks of each colour, in a step */
	cni_lanes_kept joint_lanes;  /* lanes that the next step may reuse */
	int32_t joint_plain_first;   /* joint constraints that are solved by rows, linked by next_plain; CNI_NONE */
	uint32_t joints_soft_step;   /* some joints are soft until this step: direct/rattle.c */

	/* islands */
	cni_table islands;           /* cni_island */
	int32_t island_used;
	int32_t island_free;
	int32_t island_count;
	uint32_t split_step;         /* no island is split before this step */

	uint16_t projects;           /* 1: the last step projected overlaps of some island: step/overlap_projection.c */
	uint16_t settled;            /* 1: at the end of the last step some body had been slow for the sleep delay */
	int32_t piles_new;           /* 1: in this step a contact got its first load */
	int32_t piles_unheld;        /* 1: in the last step the gravity preload of some island failed */
	int32_t solvers_asked;       /* 1: in the last step some awake island had a body or joint with its own solver */
	cni_array direct_islands;    /* int32_t: directly solved islands, see direct/solver_selection.c */
	int32_t direct_work;         /* work planned in the last step, substeps included; 0: nothing was solved directly */
	int32_t direct_failed;       /* 1: direct solving ran out of memory */
	int32_t cone_work;           /* work of direct/friction_cones.c in this step, and ... */
	int32_t set_work;            /* ... of direct/contact_active_set.c, and of failed attempts of direct/rattle.c: direct/direct_contact.h */
	cni_array direct_plans[2];   /* of linear/sparse_plan.c, kept while nothing changes: the first plan of a step, and the plan without
	                                refused islands */

	cn_filter_fn *filter;        /* the user's callbacks, NULL: none */
	void *filter_user;
	cn_pre_solve_fn *pre_solve;
	void *pre_solve_user;
	cn_material_mix_fn *material_mix;
	void *material_mix_user;

	cni_events events;
	uint32_t warnings;
	int32_t pairs_not_added;
	int32_t events_not_reported;
	cn_profile profile;
	uint32_t bodies_stopped;     /* in this step, as their motion was not finite; workers add to it */

	char error[CNI_ERROR_TEXT_BYTES];
};

/* ---- records by index ---- */

/*
 * CN_SOLVER_SOFT and CN_SOLVER_AUTO: between bodies that hardly turn, the normal along which a lane of two points pushes stays as it is until the true
 * one, which turns with them, has turned by more than this from it, in radians.
 *
 * Soft contacts give way, so a stack leans, and forces along turned normals push it farther: like a column it buckles under
 * its own weight (Greenhill, 1881). With two contact points half a size from the middle, each a spring of nm w^2, that is when
 * n^3 > 0.8 w^2 size / gravity: more than 22 boxes of 1 m at w = 2 pi 60 Hz. Stiffer contacts do not come to rest in one
 * sweep: pyramids fall. With normals that lag the weights act along the stack as it was, and it stays.
 *
 * Fallen in 60 s of 100 random stacks (5 to 60 boxes) and of 100 heavy tops (1:2 to 1:50): 71 and 54 without a lag, 12 and 12 with
 * 0.01, 7 and 8 with 0.03, 7 and 4 with 0.1, as with 0.2. What turns faster than CNI_NORMAL_LAG_SPIN does so by itself, and has the true
 * normal. CN_SOLVER_AUTO solves directly what leans, but not what moves, bounces or finds no set of contacts: such towers sway more and
 * more with loads along true normals.
 */

/* Greatest speed that an impulse gives the lighter of its two bodies when the soft solver begins with it. More would crush the body from any start, and
   throw it when the impulses on both sides of it do not cancel any more. It does not depend on the substep. */
static inline float cni_soft_speed_most(const cn_world *world)
{
	return CNI_SOFT_FALL_S * cni_max(cni_length(world->settings.gravity), CNI_STANDARD_GRAVITY * world->settings.length_unit);
}

/* Square of the largest difference of two normals; negative: normals do not lag. */
static inline float cni_normal_lag_sq(const cn_world *world)
{
	return world->settings.solver <= CN_SOLVER_SOFT && CNI_ON(NORMAL_LAG) ? CNI_NORMAL_LAG * CNI_NORMAL_LAG : -1.0f;
}

static inline cni_body *cni_body_at(const cn_world *world, int32_t body) { return (cni_body *)cni_table_at_sized(&world->bodies, body, sizeof(cni_body), CNI_PAGE_BODIES); }
/* CNI_NONE, the world, is not. */
static inline int32_t cni_is_dynamic(const cn_world *world, int32_t body) { return body != CNI_NONE && cni_body_at(world, body)->type == CN_BODY_DYNAMIC; }
/*
 * Pose, user data and handle of each body as the user reads them, apart from the records, from which reading fetches two cache lines a
 * body. It is kept while poses or moved bodies are read: then body b's pose is always cni_body_pose, and fell_asleep is the number of
 * steps + 1 at the end of the step in which it last moved, or less.
 */
static inline cn_body_moved *cni_readback_at(const cn_world *world, int32_t body) { return (cn_body_moved *)cni_table_at_sized(&world->readback, body, sizeof(cn_body_moved), CNI_PAGE_READBACK); }
/* 1: the readback may be read. Else the records; the next step will begin to keep it. Readers may be several threads. */
static inline int32_t cni_readback_ask(const cn_world *world)
{
	uint32_t *asked = (uint32_t *)&world->readback_asked;
	if (cni_atomic_peek(asked) != world->step_count + 1u)
		cni_atomic_put(asked, world->step_count + 1u);
	return world->readback_kept;
}
/* Writes the readback of a body from its record, if it is kept. */
void cni_readback_store(cn_world *world, int32_t body);
static inline cni_shape *cni_shape_at(const cn_world *world, int32_t shape) { return (cni_shape *)cni_table_at_sized(&world->shapes, shape, sizeof(cni_shape), CNI_PAGE_SHAPES); }
static inline cni_joint *cni_joint_at(const cn_world *world, int32_t joint) { return (cni_joint *)cni_table_at_sized(&world->joints, joint, sizeof(cni_joint), CNI_PAGE_JOINTS); }
static inline cni_island *cni_island_at(const cn_world *world, int32_t island) { return (cni_island *)cni_table_at_sized(&world->islands, island, sizeof(cni_island), CNI_PAGE_ISLANDS); }
/* Reserves records for the next extra links of islands; 0: no memory. */
static inline int32_t cni_island_reserve(cn_world *world, int32_t extra)
{
	return cni_table_reserve(&world->islands, &world->memory, cni_max_i(world->island_used, world->island_count + extra));
}
static inline cni_contact *cni_contact_at(const cn_world *world, int32_t contact) { return (cni_contact *)cni_table_at_sized(&world->contacts, contact, sizeof(cni_contact), CNI_PAGE_CONTACTS); }
static inline cni_contact *cni_contact_of_key(const cn_world *world, int32_t key) { return cni_contact_at(world, key >> 1); }
static inline cni_contact_block *cni_block_at(const cn_world *world, int32_t block) { return (cni_contact_block *)cni_table_at_sized(&world->blocks_hot, block, sizeof(cni_contact_block), CNI_PAGE_BLOCKS); }
static inline cni_block_info *cni_block_info_at(const cn_world *world, int32_t block) { return (cni_block_info *)cni_table_at_sized(&world->blocks_info, block, sizeof(cni_block_info), CNI_PAGE_BLOCKS); }
static inline cni_block_anchor *cni_block_anchor_at(const cn_world *world, int32_t block) { return (cni_block_anchor *)cni_table_at_sized(&world->blocks_anchor, block, sizeof(cni_block_anchor), CNI_PAGE_BLOCKS); }
static inline const cni_listed_block *cni_listed_blocks(const cn_world *world, int32_t color) { return world->block_list.data == NULL ? NULL : (const cni_listed_block *)world->block_list.data + world->colors[color].listed; }
/* NULL if no contact has needed one so far. */
static inline cni_block_extra *cni_block_extra_at(const cn_world *world, int32_t block)
{
	return block < cni_table_capacity(&world->blocks_extra) ? (cni_block_extra *)cni_table_at_sized(&world->blocks_extra, block, sizeof(cni_block_extra), CNI_PAGE_BLOCKS) : NULL;
}
/* NULL: the block has no sums. */
static inline cni_block_sums *cni_block_sums_at(const cn_world *world, int32_t block)
{
	int32_t sums = world->sums == NULL ? CNI_NONE : cni_block_info_at(world, block)->sums;
	return sums == CNI_NONE ? NULL : world->sums + sums;
}
/* A constant in builds without them. */
static inline int32_t cni_has_areas(const cn_world *world) { return CNI_HAS_AREAS && world->areas.count > 0; }
static inline cni_area *cni_areas(const cn_world *world) { return (cni_area *)world->areas.data; }
static inline cni_proxy *cni_proxy_at(const cn_world *world, int32_t proxy) { return (cni_proxy *)cni_table_at_sized(&world->proxies, proxy, sizeof(cni_proxy), CNI_PAGE_PROXIES); }
static inline cni_motion *cni_motions(const cn_world *world) { return (cni_motion *)world->motion.data; }
/* Resets the dummy, which stands for all static bodies. Overflow can move it: zero inverse mass times an infinite impulse is not 0. */
static inline void cni_dummy_stand(const cn_world *world)
{
	const cni_motion still = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	cni_motions(world)[0] = still;
}
static inline cni_velocity_start *cni_starts(const cn_world *world) { return (cni_velocity_start *)world->start.data; }
static inline cni_external *cni_externals(const cn_world *world) { return (cni_external *)world->external.data; }
static inline int32_t *cni_awake_ids(const cn_world *world) { return (int32_t *)world->awake_id.data; }
/* Runs independent items on the world's workers: cni_team_for. Outside of cni_team_run it may have to wake them, some microseconds, so
   min_range should be 10 us of work there, and 1 us within. */
static inline void cni_parallel_for(const cn_world *world, int32_t item_count, int32_t min_range, cni_range_fn *fn, void *context)
{
	cni_team_for(world->team, item_count, min_range, fn, context);
}
/* Scratch of the frame arena. NULL: no memory, with a warning. */
static inline void *cni_scratch_push(cn_world *world, uint64_t bytes)
{
	void *scratch = cni_arena_push(&world->arena, bytes);
	world->warnings |= scratch == NULL ? (uint32_t)CN_WARNING_FRAME_MEMORY : 0u;
	return scratch;
}
/*
 * Island number in this step of an awake body, from its dense index: below step_island_count, or CNI_NONE (no island, or not
 * dynamic). If few of many islands are awake, they are renumbered, so that the others cost a step nothing.
 */
static inline int32_t cni_awake_island_number(const cn_world *world, int32_t index)
{
	if (world->awake_islands != NULL)
		return world->awake_islands[index];
	return index == 0 || world->island_count == 0 ? CNI_NONE : cni_body_at(world, cni_awake_ids(world)[index])->island;
}
/* ... its island record. */
static inline int32_t cni_awake_island(const cn_world *world, int32_t index)
{
	int32_t number = cni_awake_island_number(world, index);
	return number == CNI_NONE || world->step_islands == NULL ? number : world->step_islands[number];
}

#endif
