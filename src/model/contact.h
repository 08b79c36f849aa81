/*
 * model/contact.h - contacts: pairs of proxies with overlapping fat boxes, and the blocks of lanes for touching pairs.
 *
 * A contact's record has a stable index. The place of its manifold depends on its state:
 *
 *   apart     slot = index in the apart list     record only; CNI_NONE while neither body is awake
 *   touching  slot = block * 16 + lane           a lane of a block of its colour, kept across steps
 *   asleep    slot = index in the sleep store    both bodies asleep (or one asleep, one static); CNI_SLEEP_IN_BLOCKS: as touching
 *
 * Blocks are 16 lanes of 24 rows. The narrowphase writes lanes in place and the solver reads them directly: there is no prepare
 * and no store stage. Within a colour no dynamic body appears twice. A freed lane is filled by the colour's last lane, so that
 * colours stay dense.
 *
 *   colours   0 .. 22   both bodies dynamic
 *            23 .. 30   lane body b static or kinematic: it is read but never written
 *            31         overflow: solved lane by lane in order (bodies with too many contacts)
 *
 * Lane body a is always dynamic. When it is the contact's body b, CNI_CONTACT_FLIPPED is set and the lane's normal is the
 * opposite of the contact's.
 *
 * A lane (units: metres, seconds, kilograms; n normal from lane a to lane b, t = (ny, -nx), r from the centre of mass to the
 * contact point, all at the beginning of the step; arms use the true normal, nx and ny may lag behind it: CNI_NORMAL_LAG):
 *   at = ra.t, d = ra - rb, dt = d.t (so rb.t = at - dt)
 *   s0 separation, nm = 1 / (n K n), jn accumulated normal impulse, load its slow mean
 *   fa, fb arms of the friction point along n from the two centres; tm = 1 / (t K t) there, jt accumulated
 *   friction impulse along t on body b
 *   a round corner alone on a face: normal, at and dt are those of the middle of the step, so that rolling gains no energy
 *   (rolling_advance); the second point's an is its radius, else 0, and at the arm on its body when the anchor was taken
 *   an = qa.n, dn = an - qb.n for the points qa, qb that turn with the bodies: the contact point less the
 *   shapes' radii, so that a rolling circle keeps its separation
 *
 * Beside each block are the anchors of its lanes: the poses of the bodies when the manifold was last computed. While they have
 * moved little against each other since, manifold reuse (narrowphase/manifold_reuse.c) updates the lane from there, and the
 * narrowphase skips the contact.
 */
#ifndef CNI_MODEL_CONTACT_H
#define CNI_MODEL_CONTACT_H

#include "collision/manifold.h"
#include "model/body.h"

/* Bits of a block's lanes, where a record is not one of files of earlier versions; numbers and bits of a listed block: words are an instruction
   less where they are read. */
#ifdef CN_SMALL_BLOCKS /* no lane is unused; the same bits, without vectors */
#define CNI_LANES 1
typedef uint8_t cni_lane_bits;
typedef uint16_t cni_listed_number, cni_listed_bits;
#else
#define CNI_LANES 16
typedef uint16_t cni_lane_bits;
typedef int32_t cni_listed_number;
typedef uint32_t cni_listed_bits;
#endif
/* Blocks of 16 lanes in a row of a colour: early rest takes them in and out of the passes together, at any size of blocks. */
#define CNI_BLOCKS_A_GROUP (16 / CNI_LANES)
#define CNI_COLOR_STATIC 23
#define CNI_COLOR_OVERFLOW 31
#define CNI_COLORS 32
/* Blocks of one lane have room for every touching contact: those that sleep keep theirs, in a list of its own. Else a block has lanes
   of several contacts, and rows of those that sleep move to an array. */
#define CNI_SLEEP_IN_BLOCKS (CNI_LANES == 1)
#define CNI_COLOR_ASLEEP 32
#define CNI_COLOR_LISTS (CNI_COLORS + 2 * CNI_SLEEP_IN_BLOCKS) /* even, so that the world has no padding */

typedef struct cni_contact_row {
	float at[CNI_LANES], an[CNI_LANES], s0[CNI_LANES], nm[CNI_LANES], jn[CNI_LANES], load[CNI_LANES];
} cni_contact_row;

typedef struct cni_contact_block {
	int32_t ia[CNI_LANES], ib[CNI_LANES]; /* dense body indices */
	float nx[CNI_LANES], ny[CNI_LANES];
	float static_friction[CNI_LANES], dynamic_friction[CNI_LANES];
	float dn[CNI_LANES], dt[CNI_LANES];
	float fa[CNI_LANES], fb[CNI_LANES], tm[CNI_LANES], jt[CNI_LANES];
	cni_contact_row p[2];
} cni_contact_block;

enum {
	CNI_BLOCK_RESTITUTION = 1u << 0, /* some lane has restitution */
	CNI_BLOCK_BOUNCES = 1u << 4,     /* ... above CNI_BOUNCE_DELAY_RESTITUTION: below, the passes of the solver need not know it */
	CNI_BLOCK_RESTED = 1u << 2,      /* its lanes took one substep in the last step: step/early_rest.c */
	CNI_BLOCK_SUMS = 1u << 3,        /* some contact reports STAY or HIT: see cni_block_sums */
	CNI_BLOCK_EXTRA = 1u << 1        /* some lane has rolling resistance, a conveyor or a locked axis: see cni_block_extra */
};

/*
 * A lane's state when its manifold was written, for lanes with a bit in info.anchored. The normal is at rest in the frame of lane body a,
 * or of b where info.of_b has a bit; if lane body b is static (ib is 0), in the world's frame.
 */
typedef struct cni_block_anchor {
	union {
		float nx[CNI_LANES];    /* normal in the frame of its body */
		int32_t body[CNI_LANES]; /* ib is 0: record of lane body b */
	} x;
	float ny[CNI_LANES];
	float dt[CNI_LANES];        /* lane's dt */
	float c[CNI_LANES], s[CNI_LANES]; /* rotation of b relative to a; of a lane without the bit that began to touch in the last step:
	                                     its normal and friction impulse in that step */
	union {
		float less[2][CNI_LANES]; /* separation of each point less (centre b - centre a).n */
		struct {
			float gap[CNI_LANES];      /* along the normal between the two anchors when the lane was written: how far ahead the
			                              predicted contact was */
			float approach[CNI_LANES]; /* m/s along the normal when it began to touch */
		} fresh;                      /* of a lane without the bit */
	} of;
} cni_block_anchor;

/* Rows of a block as one array: row r of a lane is rows[r * CNI_LANES + lane]. */
#define CNI_ROWS_OF(record) ((int32_t)(sizeof(record) / (CNI_LANES * sizeof(float))))

/* Extra rows, which few contacts need, beside the block of the same index. */
typedef struct cni_block_extra {
	float tangent_speed[CNI_LANES];  /* target slip along t; the first four rows stay with a contact that sleeps */
	float rolling[CNI_LANES];        /* lever arm in metres */
	float rolling_mass[CNI_LANES];   /* 1 / (sum of inverse inertias) */
	float rolling_impulse[CNI_LANES];
	float lock_ax[CNI_LANES], lock_ay[CNI_LANES]; /* 1: lane body a is locked along x (y), else 0 */
	float lock_bx[CNI_LANES], lock_by[CNI_LANES];
} cni_block_extra;

/* The bits with that of a lane set to `on`, 0 or 1. */
static inline uint32_t cni_bits_with(uint32_t bits, uint32_t lane, uint32_t on) { return (bits & ~(1u << lane)) | on << lane; }

/* Data of a block that most passes do not need. */
typedef struct cni_block_info {
	int32_t contact[CNI_LANES];      /* CNI_NONE: padding */
	float restitution[CNI_LANES];
	int32_t prev, next;              /* blocks of the colour, or of the free list */
	int16_t color;
	uint16_t flags;                  /* CNI_BLOCK_ */
	uint32_t fresh_step;             /* step + 1 of a lane's last begin of touching */
	uint16_t fresh;                  /* ... lanes that began then, as bits; the solver clears lanes with an impulse, substep by substep */
	uint16_t anchored;               /* bits of lanes with an anchor; of those: */
	cni_lane_bits of_b;              /* ... the normal is that of a face of lane body b; without a face, both shapes are circles */
	cni_lane_bits face;              /* ... corners or circles of one body touch a face of the other */
	cni_lane_bits points_of_b;       /* ... the points are corners or circles of lane body b */
	cni_lane_bits again;             /* bits of marked lanes: CNI_PASS_AGAIN */
	int32_t sums;                    /* index of its cni_block_sums, or CNI_NONE; within a step, where world.sums is not NULL */
} cni_block_info;

/* Impulses of a block's lanes over a step, while the step runs: contacts/impulse_sums.c. */
typedef struct cni_block_sums {
	float normal[CNI_LANES], friction[CNI_LANES]; /* over the substeps so far */
	float closing[2][CNI_LANES];                  /* closing speed of each point when the substep began */
	float approach[CNI_LANES];                    /* greatest closing speed of a blow */
	uint32_t hits;                                /* bits of lanes whose contacts report HIT */
	uint32_t struck;                              /* bits: the point of that blow, 0 or 1 */
	int32_t block;
	int32_t reserved;
} cni_block_sums;

typedef struct cni_color {
	int32_t first, last;   /* blocks */
	int32_t lanes;         /* contacts in it; all blocks except the last are full */
	int32_t listed;        /* first of its blocks in world.block_list; within a step */
	int32_t listed_count;  /* its blocks in the list */
} cni_color;

/* A block in the list of a step's passes: colours in order, a colour's blocks in order. */
typedef struct cni_listed_block {
	cni_contact_block *rows;
	cni_block_extra *extra;  /* NULL: no lane needs it */
	cni_block_info *info;
	cni_listed_bits fresh;   /* lanes that began to touch in this step, as bits */
	cni_listed_number begin, lanes; /* the passes solve lanes begin .. lanes - 1; as listed, all lanes in use */
	cni_listed_number kind;  /* CNI_CONTACTS_ of model/solve.h */
} cni_listed_block;

/* A touching contact at rest: the rows of its lane, without ia and ib. */
#define CNI_SLEEP_ROWS 22
#define CNI_SLEEP_EXTRA_ROWS 4
typedef struct cni_sleep_lane {
	float rows[CNI_SLEEP_ROWS];
	float restitution;
	float extra[CNI_SLEEP_EXTRA_ROWS]; /* the first rows of cni_block_extra */
	int32_t contact;
} cni_sleep_lane;
/* Has it a conveyor or rolling resistance, of its shapes or of the user's callback? Then it needs extra rows when it wakes. */
static inline int32_t cni_sleep_lane_needs_extra(const cni_sleep_lane *s) { return s->extra[0] != 0.0f || s->extra[1] > 0.0f; }

/* Without events the bits of their contacts are 0, so that the compiler drops what they lead to. */
enum {
	CNI_CONTACT_TOUCHING = 1u << 0,
	CNI_CONTACT_FLIPPED = 1u << 1,
	CNI_CONTACT_ASLEEP = 1u << 2,       /* slot is in the sleep store */
	CNI_CONTACT_LINKED = 1u << 3,       /* links two dynamic bodies' islands */
	CNI_CONTACT_ENTER_OWED = CNI_HAS_EVENTS << 4,   /* its event is deferred: no memory yet */
	CNI_CONTACT_CREATED_OWED = CNI_HAS_EVENTS << 5,
	CNI_CONTACT_ENTERED = 1u << 6,      /* began to touch (or to report it) in the last step, or woke since: no STAY */
	CNI_CONTACT_REFRESH = 1u << 7,      /* material changed: must be rewritten in the lane */
	CNI_CONTACT_SENSOR = CNI_HAS_EVENTS << 8,       /* one shape is a sensor: overlap is reported, nothing is solved */
	CNI_CONTACT_SENSING = CNI_HAS_EVENTS << 9,      /* ... and they overlap */
	CNI_CONTACT_ONE_WAY = 1u << 10,     /* one shape is a one-way platform */
	CNI_CONTACT_PASSING = 1u << 11,     /* ... that the other shape is passing through */
	CNI_CONTACT_PRE_SOLVE = CNI_HAS_EVENTS << 12,   /* the user's callback sees it before solving */
	CNI_CONTACT_MUTE = CNI_HAS_EVENTS << 13,        /* a sensor that reports nothing: a fixed block has no room for it */
	CNI_CONTACT_STATIC = 1u << 14,      /* one body is static */
	CNI_CONTACT_EVENTS_SHIFT = 16       /* bits 16..21: the CN_EVENT_ kinds that it reports */
};

typedef struct cni_contact {
	int32_t proxy[2];        /* of shape a and b: type a <= type b */
	int32_t body[2];
	uint32_t flags;
	int32_t slot;            /* of a free record the next one; the fields up to here are read for pairs that are apart */
	int32_t next[2], prev[2]; /* keys in the bodies' lists */
	uint16_t id[2];          /* feature ids of the lane's points, 0: none */
	cni_manifold_cache cache;
} cni_contact;

/* Reserves memory for extra more contacts: records and apart list (lanes are reserved when they begin to touch). */
cn_result cni_contact_reserve(cn_world *world, int32_t extra);
/* Reserves memory for the ends of the events of so many contacts. 0: no memory. */
int32_t cni_contact_reserve_reports(cn_world *world, int32_t count);
/* Does a contact with these flags report events? */
static inline int32_t cni_contact_reports(uint32_t flags)
{
	return CNI_HAS_EVENTS && ((flags & (CNI_CONTACT_SENSOR | CNI_CONTACT_MUTE)) == CNI_CONTACT_SENSOR || flags >> CNI_CONTACT_EVENTS_SHIFT != 0);
}
/* ... an event of this kind? */
static inline int32_t cni_contact_reports_kind(const cni_contact *c, int32_t kind)
{
	return CNI_HAS_EVENTS && (c->flags >> CNI_CONTACT_EVENTS_SHIFT & 1u << kind) != 0;
}
/* Record of an existing contact between two proxies, or CNI_NONE. O(contacts of the body with fewer). */
int32_t cni_contact_find(const cn_world *world, int32_t proxy_a, int32_t proxy_b);
/* Keys of the contacts of a shape, in the list of its body. CNI_NONE: none, or no body. O(contacts of the body) for all. */
int32_t cni_contact_first_of_shape(const cn_world *world, int32_t shape);
int32_t cni_contact_next_of_shape(const cn_world *world, int32_t key, int32_t shape);
/* After cni_contact_reserve it cannot fail. Logs CREATED. */
void cni_contact_create(cn_world *world, int32_t proxy_a, int32_t proxy_b);

/* Reserves memory in the pending event logs for the end of `contacts` contacts between steps. */
cn_result cni_contact_reserve_end(cn_world *world, int32_t contacts);
/* Ends touching (logs LEAVE), logs DESTROYED, frees the record. In a step it returns 0 and keeps the contact if there is no memory for
   the logs; after cni_contact_reserve_end it always returns 1. */
int32_t cni_contact_destroy(cn_world *world, int32_t contact);
/* Destroys all contacts of a body or a shape, and wakes the bodies that touched it. After cni_contact_reserve_end. */
void cni_contact_destroy_of_body(cn_world *world, int32_t body);
void cni_contact_destroy_of_shape(cn_world *world, int32_t shape);

/* How a contact's shapes touch. */
typedef struct cni_touch_result {
	cni_manifold manifold;
	cni_vec2 gap;    /* from a's contact point to b's at present, where the contact is still ahead; in a's frame */
	float radius[2]; /* of the shapes */
} cni_touch_result;

/* The contact begins to touch: takes a lane, joins islands (waking the sleeping side), logs ENTER. 0: no memory for a lane; the contact
   stays apart. */
int32_t cni_contact_begin(cn_world *world, int32_t contact, const cni_touch_result *touch);
/* Stops touching: frees the lane, counts the islands' loss, logs LEAVE. 0: no memory for the log; the contact then keeps an empty lane. */
int32_t cni_contact_end(cn_world *world, int32_t contact);
/* Sets the CN_EVENT_ kinds that the contact reports. After cni_contact_reserve_end. */
void cni_contact_set_events(cn_world *world, int32_t contact, uint32_t mask);
/* Predicted distance to the contact when its lane was written, along the normal, metres; 0 unless the bodies are fast. */
float cni_contact_gap(const cn_world *world, const cni_contact *c);
/* The anchor of a lane that is not anchored, whose c, s and of.fresh are free for other use; NULL: anchored, or no lane. */
cni_block_anchor *cni_contact_free_anchor(const cn_world *world, const cni_contact *c);
/* May these two proxies make a contact, by the library's rules? Reads only. (cni_pair_filter_fn; context is the world) */
int32_t cni_contact_possible(const void *context, int32_t proxy_a, int32_t proxy_b);
/* ... by the user's filter, which runs in the calling thread. (cni_pair_filter_fn too) */
int32_t cni_contact_user_allows(const void *context, int32_t proxy_a, int32_t proxy_b);
/* ... by both. */
int32_t cni_contact_allowed(const cn_world *world, int32_t proxy_a, int32_t proxy_b);
/* Logs a contact's deferred event if there is memory now. In a step. */
void cni_contact_send_deferred_events(cn_world *world, int32_t contact, uint32_t owed, int32_t kind);
/* Sets whether a sensor pair overlaps, and logs the change. 0: no memory for the log; nothing changes. */
int32_t cni_contact_update_sensor(cn_world *world, int32_t contact, int32_t overlaps);
/* Writes a manifold to the contact's lane, keeping the impulses of points with equal ids. a, b: the contact's bodies. */
void cni_contact_write(cn_world *world, cni_contact *c, const cni_body *a, const cni_body *b, const cni_touch_result *touch);
/* Writes an empty manifold: the lane stays without effect. */
void cni_contact_write_empty(cn_world *world, int32_t contact);

/* Its slot is a lane: not one of the apart list or of the sleep store. */
static inline int32_t cni_contact_has_lane(const cni_contact *c)
{
	return (c->flags & (CNI_CONTACT_TOUCHING | CNI_CONTACT_ASLEEP)) == CNI_CONTACT_TOUCHING;
}
/* Scales what the lane's next substep begins with. */
static inline void cni_block_scale_impulses(cni_contact_block *block, int32_t lane, float part)
{
	block->p[0].jn[lane] *= part;
	block->p[1].jn[lane] *= part;
	block->jt[lane] *= part;
}
/* Invalidates the lane's anchor: the next step computes the manifold even without motion. */
void cni_contact_invalidate(cn_world *world, int32_t contact);
/* ... of all contacts of a body, after its centre of mass changed. */
void cni_contacts_invalidate_body(cn_world *world, const cni_body *b);
/* Updates a body's lanes after its dense index changed. */
void cni_contact_fix_body(cn_world *world, int32_t body);
/* Frees a contact's place in the sleep store. */
void cni_contact_sleep_lane_free(cn_world *world, cni_contact *c);
/* Moves a touching contact between its lane and the sleep store. */
void cni_contact_lane_to_sleep(cn_world *world, int32_t contact);
void cni_contact_sleep_to_lane(cn_world *world, int32_t contact);
/* Sets CNI_BODY_AT_STATIC on a body in contact with a static one. */
static inline void cni_contact_mark_static(cni_body *a, cni_body *b)
{
	if (a->awake == 0)
		cni_body_mark_static(b);
	if (b->awake == 0)
		cni_body_mark_static(a);
}
/* The apart list holds contacts that do not touch and have an awake body: the narrowphase visits them in each step. No effect if the
   contact is already in (or out), or touches. */
void cni_contact_enter_apart_list(cn_world *world, int32_t contact);
void cni_contact_leave_apart_list(cn_world *world, int32_t contact);

/* Marks the block of a touching contact that reports STAY or HIT: the next step sums its impulses. */
void cni_contact_mark_sums(cn_world *world, const cni_contact *c);

/* Adds to the impulses of the ENTER event of a contact that began to touch in this step; nothing for other contacts. */
void cni_contact_add_enter_impulses(cn_world *world, const cni_contact *c, float normal, float friction);
/* The public description of a contact; with a manifold if it touches. kind is copied. */
void cni_contact_describe(const cn_world *world, int32_t contact, int32_t kind, cn_contact_event *out);

/* ---- lanes of blocks: model/lane.c ---- */

/* Upper bound of the blocks that so many contacts fill: full ones, and a partial block of each colour. */
int32_t cni_lane_blocks_for(int32_t lanes);
/* Reserves memory for `lanes` touching contacts, awake or asleep, in any colours. 0: no memory. */
int32_t cni_lane_reserve(cn_world *world, int32_t lanes);
/* Are few of the allocated blocks in use? Then a loop over all in memory order costs more than one over the lists. */
int32_t cni_blocks_are_few(const cn_world *world);
/* Reserves extra rows for every block; 0: no memory. */
int32_t cni_lane_reserve_extra(cn_world *world);
/* Chooses a colour for the contact, marks its bodies and takes a lane; the rows are zero except for the body indices. Memory must be
   reserved. */
void cni_lane_take(cn_world *world, int32_t contact);
/* Takes a lane for a contact that sleeps, with CNI_SLEEP_IN_BLOCKS; all rows are zero. */
void cni_lane_take_asleep(cn_world *world, int32_t contact);
/* Frees the contact's lane and fills it with the colour's last one. */
void cni_lane_free(cn_world *world, int32_t contact);
/* Marks that the slot's contact began to touch in this step. */
void cni_lane_set_fresh(cn_world *world, int32_t slot);
/* Removes the anchor of the slot's lane; gap and approach speed become 0. */
void cni_lane_invalidate(cn_world *world, int32_t slot);
/* Sets the lane's body indices from the bodies. */
void cni_lane_set_bodies(cn_world *world, const cni_contact *c);

#endif
