/*
 * examples/peers/engine.h - what a physics engine must be able to do to be compared. A scene speaks these
 * words only, and each engine_*.c translates them, so that every engine is given the same work.
 *
 * Metres, kilograms, seconds, radians. Definitions have no defaults: peer_body_of and the like in world.h
 * fill them in. An engine keeps no list of its own: bodies are 64-bit handles that the caller holds.
 */
#ifndef CAIRN_PEERS_ENGINE_H
#define CAIRN_PEERS_ENGINE_H

#include <stdint.h>

typedef struct peer_vec {
	float x;
	float y;
} peer_vec;

typedef struct peer_pose {
	double x;
	double y;
	double angle;
} peer_pose;

/* An engine's own name of a body. 0: the ground that joints may hang on. */
typedef uint64_t peer_handle;

typedef struct peer_world_def {
	peer_vec gravity;
	int32_t sleep;
	int32_t workers;            /* threads that work on a step, 1 or more; an engine that has no threads fails beyond 1 */
} peer_world_def;

enum {
	PEER_DYNAMIC = 1u << 0,     /* else static */
	PEER_NEVER_SLEEPS = 1u << 1,
	PEER_ASLEEP = 1u << 2       /* from the start */
};

typedef struct peer_body_def {
	uint32_t flags;             /* PEER_* */
	peer_vec position;
	peer_vec velocity;
	float linear_damping;
} peer_body_def;

enum {
	PEER_CIRCLE,                /* radius about points[0] */
	PEER_CAPSULE,               /* radius about points[0] to points[1] */
	PEER_POLYGON,               /* convex, counter-clockwise; radius is added outside */
	PEER_EDGE,                  /* points[0] to points[1] */
	PEER_CHAIN,                 /* smooth one-sided ground, solid on the left of its direction, at least 4 points */
	PEER_LOOP                   /* a chain whose last point joins the first */
};

#define PEER_POLYGON_MAX 8

typedef struct peer_shape_def {
	int32_t kind;
	int32_t count;
	const peer_vec *points;     /* in the body's frame, copied by the engine */
	float radius;
	float density;
	float friction;             /* a pair has the square root of the product */
	float restitution;          /* a pair has the greater */
	uint32_t category;          /* two shapes collide when each has its category in the other's mask ... */
	uint32_t mask;
	int32_t group;              /* ... and not the same group below 0 */
} peer_shape_def;

enum {
	PEER_LIMIT = 1u << 0,
	PEER_MOTOR = 1u << 1,
	PEER_SPRING = 1u << 2
};

/* A pin. Its angle is that of b less that of a less the reference. The two bodies do not collide. */
typedef struct peer_joint_def {
	uint32_t flags;
	peer_vec anchor_a;          /* in the body's frame; the ground's is the world */
	peer_vec anchor_b;
	float reference;
	float lower;
	float upper;
	float motor_speed;
	float motor_torque;
	float spring_hertz;         /* pulls the angle to 0 */
	float spring_damping_ratio;
} peer_joint_def;

typedef struct peer_engine {
	const char *name;
	const char *settings;       /* what it was told, in words */
	void *(*create)(const peer_world_def *def);                             /* NULL: failed */
	void (*destroy)(void *world);
	int32_t (*add_body)(void *world, const peer_body_def *def, peer_handle *out); /* these three: 0 if it cannot */
	int32_t (*add_shape)(void *world, peer_handle body, const peer_shape_def *def);
	int32_t (*add_joint)(void *world, peer_handle a, peer_handle b, const peer_joint_def *def);
	void (*fall_asleep)(void *world, peer_handle body);                     /* NULL: PEER_ASLEEP was enough */
	void (*remove_body)(void *world, peer_handle body);                     /* and its shapes and joints */
	void (*step)(void *world, float dt);
	void (*read_pose)(void *world, peer_handle body, peer_pose *out);
} peer_engine;

extern const peer_engine peer_engine_cairn;
extern const peer_engine peer_engine_box2d;
extern const peer_engine peer_engine_chipmunk;

#endif
