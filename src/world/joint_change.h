/*
 * world/joint_change.h - shared by the public functions on joints and constraints: definitions by type, changing.
 */
#ifndef CNI_WORLD_JOINT_CHANGE_H
#define CNI_WORLD_JOINT_CHANGE_H

#include "world/error.h"

#define CNI_JOINT_FLAGS (CN_JOINT_COLLIDE | CN_JOINT_LIMIT | CN_JOINT_MOTOR | CN_JOINT_SPRING | CN_JOINT_BREAKS)
#define CNI_HERTZ_MAX 1e6f
#define CNI_DAMPING_RATIO_MAX 1e6f

/* The definition of a type beyond its first fields (joints: cn_joint_base; constraints: size, flags and body). */
typedef struct cni_joint_field cni_joint_field; /* one number or vector of a definition: joint_kinds.c */
typedef struct cni_joint_kind {
	size_t bytes;                  /* of the definition */
	const char *init;              /* name of its init function */
	const cni_joint_field *fields; /* without those of base */
	int32_t field_count;
	uint32_t has;                  /* CNI_KIND_HAS_* */
} cni_joint_kind;
enum {
	CNI_KIND_HAS_MOTOR = 1u << 0,      /* cn_joint_set_motor */
	CNI_KIND_HAS_LIMITS = 1u << 1,     /* cn_joint_set_limits */
	CNI_KIND_NEEDS_FORCE_MAX = 1u << 2 /* force_max_N must be > 0 */
};
/* In place of a type: the fields of cn_joint_base that say how strong a joint of any type is. */
enum { CNI_JOINT_STRENGTH = CNI_JOINT_TYPES };
const cni_joint_kind *cni_joint_kind_of(int32_t type);

/* Fields of a definition: set defaults (NULL does nothing), check, store in the record, read from the record. */
void cni_joint_def_init(int32_t type, void *def);
void cni_joint_def_check(cni_call *call, int32_t type, const void *def);
void cni_joint_def_store(cni_joint *j, int32_t type, const void *def);
void cni_joint_def_read(const cni_joint *j, int32_t type, void *def);
/* Revolute: -pi <= lower <= upper <= pi. Distance: 0 <= lower <= upper. Others: lower <= upper. */
void cni_check_joint_limits(cni_call *call, int32_t type, float lower, float upper);

/* The record of a live joint or constraint of this type, or NULL when the call has failed. */
cni_joint *cni_check_joint_of_type(cni_call *call, int32_t type, uint32_t handle);
/* Reserves memory for cni_joint_change_flags. */
void cni_joint_change_reserve(cni_call *call, cn_world *world, const cni_joint *j);
/* Replaces the flags, ends or permits contacts between the bodies, clears the impulses of missing rows, and wakes both bodies. */
void cni_joint_change_flags(cn_world *world, int32_t joint, uint32_t flags);

#endif
