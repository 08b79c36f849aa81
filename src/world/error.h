/*
 * world/error.h - the beginning of every public function: refuses a NULL or locked world, checks arguments, and writes
 * one sentence about the first error.
 *
 * A public function reads like this:
 *
 *     cni_call call = cni_enter(world, __func__);
 *     cni_body *b = cni_check_body(&call, "body", body);
 *     cni_check_at_least(&call, "scale", scale, 0.0f);
 *     if (call.result != CN_OK)
 *         return call.result;
 *     ...
 *
 * Checks record the first failure only and do nothing after it, so a function may call them in sequence.
 * Functions that take a const world call cni_enter_const: they may run on several threads and return the
 * code without a sentence. The sentence in world->error stays until the next failing call.
 */
#ifndef CNI_WORLD_ERROR_H
#define CNI_WORLD_ERROR_H

#include <string.h>

#include "model/world.h"

/* Coordinates up to this many length units are accepted. */
#define CNI_POSITION_MAX_UNITS 1e6f
/* All public shape flags. */
#define CNI_SHAPE_FLAGS ((uint32_t)CN_SHAPE_ONE_WAY | (CNI_HAS_EVENTS ? (uint32_t)(CN_SHAPE_SENSOR | CN_SHAPE_SENSOR_SEEN | CN_SHAPE_PRE_SOLVE) : 0u))
/* The events that a shape may ask for. */
#define CNI_EVENT_MASK (CNI_HAS_EVENTS ? (1u << CN_EVENT_KINDS) - 1u : 0u)
/* All public flags of areas. */
#define CNI_AREA_FLAGS ((uint32_t)CN_AREA_REPLACE)
/*
 * Least thickness of a shape, in length units: a tenth of the slop, which is also the distance that manifolds take for none
 * (CNI_TOUCH_PER_SLOP). Rounding leaves room below: contacts are computed in the frame of a body, where coordinates of shapes
 * of a length unit are off by 6e-8 and differences of rotated ones by some 3e-7, a 1,600th of that.
 */
#define CNI_THICKNESS_LEAST 0.0005f
#define CNI_CONSTRAINT_BUDGET_MAX 1000000000
/* Angles up to this many radians are accepted. */
#define CNI_ANGLE_MAX_RAD 1e4f

/* ---- text: appends to a fixed buffer, always zero-terminated, truncated when full */

typedef struct cni_text {
	char *out;        /* may be NULL when capacity is 0 */
	int32_t capacity; /* bytes, the terminating zero included */
	int32_t used;
} cni_text;

cni_text cni_text_begin(char *out, int32_t capacity);
void cni_text_string(cni_text *text, const char *string);
void cni_text_int(cni_text *text, int64_t value);
/* Six significant digits, "nan", "inf", "-inf". */
void cni_text_float(cni_text *text, float value);

/* ---- calls */

typedef struct cni_call {
	const cn_world *world; /* NULL for a refused world and for functions without a world */
	char *sentence;        /* CNI_ERROR_TEXT_BYTES, or NULL in calls that take a const world */
	const char *function;
	cn_result result;
} cni_call;

cni_call cni_enter(cn_world *world, const char *function);
cni_call cni_enter_const(const cn_world *world);
/* For functions without a world. */
cni_call cni_enter_free(void);

/* Records the failure "function: what". Returns the call's result. */
cn_result cni_refuse(cni_call *call, cn_result result, const char *what);
/* The caller's own check: refuses unless good. */
static inline void cni_check(cni_call *call, int32_t good, cn_result result, const char *otherwise)
{
	if (!good)
		cni_refuse(call, result, otherwise);
}
/* Records "function: field value; must ..." after the caller's own check of a value failed. */
cn_result cni_refuse_float(cni_call *call, const char *field, float value, const char *must);
cn_result cni_refuse_int(cni_call *call, const char *field, int64_t value, const char *must);
/* Records the complaint of a geometry check, NULL for none. That points are closer than CNI_THICKNESS_LEAST has their distance, and the
   greatest length unit that accepts them. */
void cni_check_complaint(cni_call *call, const char *complaint, const cn_vec2 *points, int32_t count, int32_t closed);
/* Records the result of a reserve function of model/: CN_OK, CN_ERROR_MEMORY or CN_ERROR_CAPACITY. */
void cni_check_reserved(cni_call *call, cn_result result, const char *things);

/* Reserves memory for the events of ending all contacts of a body (CNI_NONE: none), unless the call has failed. */
void cni_check_ends_of(cni_call *call, cn_world *world, int32_t body);

void cni_check_pointer(cni_call *call, const char *field, const void *pointer);
/* count >= 0; array not NULL unless count is 0. */
void cni_check_array(cni_call *call, const char *field, const void *array, int32_t count);
/* The results of a list: capacity, out and out_count. */
void cni_check_output(cni_call *call, const void *out, int32_t capacity, const int32_t *out_count);
/* Zeros a definition and sets its first member, struct_size. 0 for NULL. */
static inline int32_t cni_def_begin(void *def, size_t bytes)
{
	if (def == NULL)
		return 0;
	memset(def, 0, bytes);
	*(uint32_t *)def = (uint32_t)bytes;
	return 1;
}

/* def comes from its init function. Returns 1 unless the call has failed. */
int32_t cni_check_def(cni_call *call, const void *def, size_t bytes, const char *init);

void cni_check_finite(cni_call *call, const char *field, float value);
void cni_check_finite2(cni_call *call, const char *field, cn_vec2 value);
/* Both from -most to most. */
void cni_check_within(cni_call *call, const char *field, cn_vec2 value, float most);
void cni_check_at_least(cni_call *call, const char *field, float value, float lower);
/* >= 0 (> 0), or CN_DEFAULT. */
void cni_check_at_least_or_default(cni_call *call, const char *field, float value);
void cni_check_positive_or_default(cni_call *call, const char *field, float value);
/* > 0 and at most upper, or CN_DEFAULT. */
void cni_check_above_0_or_default(cni_call *call, const char *field, float value, float upper);
void cni_check_positive(cni_call *call, const char *field, float value);
void cni_check_range(cni_call *call, const char *field, float value, float lower, float upper);
void cni_check_range_int(cni_call *call, const char *field, int32_t value, int32_t lower, int32_t upper);
/* 1 to CNI_CONSTRAINT_BUDGET_MAX, or CN_DEFAULT. */
void cni_check_work_budget(cni_call *call, int32_t value);

/* Records hold 0 where a definition's CN_DEFAULT means no limit, rigid or never, and the definition refuses 0. */
static inline float cni_zero_of_default(float value) { return value == (float)CN_DEFAULT ? 0.0f : value; }
static inline float cni_default_of_zero(float value) { return value == 0.0f ? (float)CN_DEFAULT : value; }

/* The flags of a world that this build permits. */
#define CNI_RESERVE_ALL (uint32_t)(CN_RESERVE_NAMES | CN_RESERVE_CHAINS | CN_RESERVE_EXTRA_ROWS | CN_RESERVE_MOVED)
#define CNI_WORLD_FLAGS \
	(CN_WORLD_SLEEP | CN_WORLD_WARM_START | CN_WORLD_PROFILE | (CNI_HAS_CONTINUOUS ? (uint32_t)CN_WORLD_CONTINUOUS : 0u))
/* Between two steps: within one there is no state to save and go on from. */
void cni_check_boundary(cni_call *call, const cn_world *world);
/* From CN_SOLVER_AUTO to most, and part of this build. */
void cni_check_solver(cni_call *call, int32_t solver, int32_t most);
void cni_check_flags(cni_call *call, const char *field, uint32_t value, uint32_t allowed);
/* Within CNI_POSITION_MAX_UNITS / CNI_ANGLE_MAX_RAD. */
void cni_check_position(cni_call *call, const char *field, cn_vec2 value);
void cni_check_angle(cni_call *call, const char *field, float value);
/* A shape's mass, and its inertia about the body's origin: 0, or in the range in which inverses and products of floats stay finite. */
void cni_check_shape_mass(cni_call *call, cn_mass_data mass);
void cni_check_material(cni_call *call, const cn_material *material);

/* Record of a live handle, or NULL. */
static inline cni_body *cni_live_body(const cn_world *world, cn_body body)
{
	int32_t index = cni_handles_find(&world->body_handles, body);
	return index != CNI_NONE ? cni_body_at(world, index) : NULL;
}
static inline cni_shape *cni_live_shape(const cn_world *world, cn_shape shape)
{
	int32_t index = cni_handles_find(&world->shape_handles, shape);
	return index != CNI_NONE ? cni_shape_at(world, index) : NULL;
}
static inline cni_joint *cni_live_record(const cn_world *world, uint32_t handle, int32_t constraint)
{
	int32_t index = cni_joint_find(world, handle, constraint);
	return index != CNI_NONE ? cni_joint_at(world, index) : NULL;
}
static inline cni_joint *cni_live_joint(const cn_world *world, cn_joint joint) { return cni_live_record(world, joint, 0); }
static inline cni_joint *cni_live_constraint(const cn_world *world, cn_constraint constraint) { return cni_live_record(world, constraint, 1); }
/* ... or NULL when the call has failed. */
cni_body *cni_check_body(cni_call *call, const char *field, cn_body body);
cni_shape *cni_check_shape(cni_call *call, const char *field, cn_shape shape);
cni_joint *cni_check_joint(cni_call *call, const char *field, cn_joint joint);
cni_joint *cni_check_constraint(cni_call *call, const char *field, cn_constraint constraint);

/* ---- output lists: write at most capacity handles and count all */

typedef struct cni_list {
	uint32_t *out;
	int32_t capacity;
	int32_t count;
} cni_list;

/* Checks capacity >= 0, out (NULL only with capacity 0) and out_count. */
cni_list cni_list_begin(cni_call *call, uint32_t *out, int32_t capacity, const int32_t *out_count);
static inline void cni_list_add(cni_list *list, uint32_t handle)
{
	if (list->count < list->capacity)
		list->out[list->count] = handle;
	++list->count;
}

/* ---- index and handle of a record, after a successful check of the handle */

/* Without a passed check the index is meaningless, but the call is safe. */
static inline int32_t cni_body_index(const cn_world *world, cn_body body) { return world == NULL ? CNI_NONE : cni_handles_slot(&world->body_handles, body); }
static inline int32_t cni_shape_index(const cn_world *world, cn_shape shape) { return world == NULL ? CNI_NONE : cni_handles_slot(&world->shape_handles, shape); }
/* Joints and constraints differ in the kind alone. */
static inline int32_t cni_joint_index(const cn_world *world, uint32_t joint_or_constraint)
{
	return world == NULL ? CNI_NONE : cni_handles_slot(&world->joint_handles, (joint_or_constraint & ~(3u << 20)) | (uint32_t)CNI_KIND_JOINT << 20);
}
/* Sort key of handles of one kind: the slot, except for a slot that continues under another index. */
static inline int32_t cni_order_of(uint32_t handle) { return (int32_t)(handle & 0xFFFFFu); }
/* CNI_NONE gives 0. */
static inline uint32_t cni_handle_or_zero(const cni_handles *handles, int32_t index)
{
	return index == CNI_NONE ? 0u : cni_handles_of(handles, index);
}

/* A body's pose between the last two steps: update.c. */
cn_pose cni_pose_between(const cn_world *world, int32_t body, float factor);

/* Reserves extra slots in a handle table and in the table of its records. */
cn_result cni_slots_reserve(cn_world *world, cni_handles *handles, cni_table *records, int32_t extra);

#endif
