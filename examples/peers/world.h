/*
 * examples/peers/world.h - a scene that runs in one engine, and in a judge beside it (judge.h). Scenes are
 * made of the words below; the first that fails is kept and everything after it does nothing.
 */
#ifndef CAIRN_PEERS_WORLD_H
#define CAIRN_PEERS_WORLD_H

#include "measure/measure.h"
#include "peers/engine.h"

#define PEER_STEP_S (1.0f / 60.0f)
#define PEER_PI 3.14159265f

/* Number of a body in its world, in order of creation. */
typedef int32_t peer_body;
#define PEER_GROUND (-1)

typedef struct peer_slot {
	peer_handle engine;
	peer_handle judge;
	peer_vec start;
	uint32_t flags;         /* PEER_* of its definition */
	int32_t alive;
} peer_slot;

typedef struct peer_scene peer_scene;

typedef struct peer_world {
	const peer_scene *scene;
	const peer_engine *engine;
	void *world;            /* the engine's */
	void *judge;            /* NULL: nobody measures */
	peer_slot *slots;
	int32_t count;
	int32_t capacity;
	int32_t failed;
	void *memory;           /* the scene's own; freed with free() */
} peer_world;

struct peer_scene {
	const char *name;
	const char *title;
	void (*create)(peer_world *world);
	void (*step)(peer_world *world, int32_t step_index); /* NULL, or called before each step; not timed */
	int32_t step_count;
	int32_t size;           /* the scene's parameter */
	uint32_t flags;         /* PEER_SCENE_* */
	peer_vec gravity;
	peer_vec lower;         /* a body outside of this box is lost */
	peer_vec upper;
};

enum {
	PEER_SCENE_STANDS = 1u << 0, /* bodies should stay where they start */
	PEER_SCENE_SLEEP = 1u << 1,  /* sleeping on */
	PEER_SCENE_OPEN = 1u << 2    /* bodies may fall off its sides: only those above and below the box are lost */
};

int32_t peer_scene_count(void);
const peer_scene *peer_scene_at(int32_t index);

/* judged 0: no judge. 0: failed (and closed). */
int32_t peer_world_open(peer_world *world, const peer_engine *engine, const peer_scene *scene, int32_t workers, int32_t judged);
void peer_world_close(peer_world *world);

/* What is wrong with the poses of now. */
typedef struct peer_errors {
	double displacement;    /* farthest from its start that a dynamic body is */
	double penetration;     /* deepest overlap that the judge has seen, now or before */
	double joint;           /* widest open joint that the judge has seen */
	int32_t lost;           /* dynamic bodies that left the scene, as of now */
	int32_t broken;         /* 1: a pose was not a number, or the judge could not measure */
} peer_errors;
/* Places and lost bodies; with_surfaces 1: penetration and joints too. O(everything). Needs a judge. */
void peer_world_measure(peer_world *world, int32_t with_surfaces, peer_errors *errors);
/* FNV-1a of all poses: equal for equal histories. */
uint64_t peer_world_hash(const peer_world *world);

/* ------------------------------------------------------------------ words of scenes */

static inline peer_vec peer_at(float x, float y)
{
	peer_vec v;
	v.x = x;
	v.y = y;
	return v;
}

void *peer_memory(peer_world *world, uint64_t bytes);
peer_body peer_add(peer_world *world, uint32_t flags, float x, float y);
peer_body peer_add_body(peer_world *world, const peer_body_def *def);
void peer_remove(peer_world *world, peer_body body);

/* Density 1, friction 0.6, no restitution, collides with all. */
peer_shape_def peer_surface(void);
void peer_circle(peer_world *world, peer_body body, const peer_shape_def *surface, float radius);
void peer_capsule(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec a, peer_vec b, float radius);
void peer_polygon(peer_world *world, peer_body body, const peer_shape_def *surface, const peer_vec *points, int32_t count, float radius);
/* Half sizes; radius is added outside of them. */
void peer_box(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec center, float half_x, float half_y, float radius);
void peer_edge(peer_world *world, peer_body body, const peer_shape_def *surface, peer_vec a, peer_vec b);
void peer_chain(peer_world *world, peer_body body, const peer_shape_def *surface, const peer_vec *points, int32_t count, int32_t loop);
/* A dynamic box of the usual surface. */
peer_body peer_simple_box(peer_world *world, float x, float y, float half);

void peer_join(peer_world *world, peer_body a, peer_body b, const peer_joint_def *def);
void peer_pin(peer_world *world, peer_body a, peer_vec anchor_a, peer_body b, peer_vec anchor_b);
void peer_pin_motor(peer_world *world, peer_body a, peer_vec anchor_a, peer_body b, peer_vec anchor_b, float speed, float torque);

/* create and step functions; scene_list.c says what they are for */
void peer_large_pyramid(peer_world *world);
void peer_many_pyramids(peer_world *world);
void peer_joint_grid(peer_world *world);
void peer_tumbler(peer_world *world);
void peer_spinner(peer_world *world);
void peer_smash(peer_world *world);
void peer_rain(peer_world *world);
void peer_rain_step(peer_world *world, int32_t step_index);
void peer_bowl(peer_world *world);
void peer_ball_pit(peer_world *world);
void peer_mostly_asleep(peer_world *world);
void peer_cars(peer_world *world);
void peer_ragdoll_hills(peer_world *world);
void peer_flails(peer_world *world);
void peer_junkyard(peer_world *world);
void peer_compounds(peer_world *world);
void peer_washer(peer_world *world);
void peer_churn(peer_world *world);
void peer_churn_step(peer_world *world, int32_t step_index);
void peer_few_awake(peer_world *world);

#endif
