/*
 * examples/rollback.c - rollback: a ball is steered by a player whose inputs arrive 6 frames late. The game guesses that the
 * player goes on as before; where the guess was wrong it restores the frame of the input and steps to the present again. In the end
 * everything is where it would be without the delay, bit for bit.
 */
#include "cairn.h"
#include <stdio.h>
#include <stdlib.h>

#define FRAMES 600
#define DELAY 6

/* All that the game has beside the world must be rolled back with it. Here that is nothing but handles, which never change. */
typedef struct game {
	cn_world *world;
	cn_body ball;
} game;

/* What the player does: left, right or nothing. */
static float player_input(int frame) { return (float)(frame / 25 % 3 - 1); }

static cn_body box(cn_world *world, int type, float x, float y, float half_width, float half_height)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body = 0;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m.x = x;
	body_def.position_m.y = y;
	cn_body_create(world, &body_def, &body);
	cn_shape_def_init(&shape_def);
	shape_def.body = body;
	cn_shape_create_box(world, &shape_def, half_width, half_height, 0.0f, NULL);
	return body;
}

static game game_create(void)
{
	cn_world_def def;
	game g = {NULL, 0};
	cn_world_def_init(&def);
	if (cn_world_create(&def, &g.world) != CN_OK)
		exit(1);
	box(g.world, CN_BODY_STATIC, 0.0f, -1.0f, 30.0f, 1.0f);
	for (int i = 0; i < 55; ++i)
		box(g.world, CN_BODY_DYNAMIC, 4.0f + (float)(i % 11), 0.3f + 0.6f * (float)(i / 11), 0.3f, 0.3f);
	g.ball = box(g.world, CN_BODY_DYNAMIC, 0.0f, 1.0f, 0.6f, 0.6f);
	return g;
}

static void game_step(game *g, float input)
{
	cn_body_apply_force(g->world, g->ball, 60.0f * input, 0.0f);
	cn_world_step(g->world, 1.0f / 60.0f);
}

/* Saves of the last frames: of frame f in slot f % (DELAY + 1). */
typedef struct frame {
	void *data;
	uint64_t capacity, bytes;
	float input; /* with which the game went on from here */
} frame;

static void frame_save(frame *f, const game *g)
{
	cn_world_save_size(g->world, &f->bytes);
	if (f->bytes > f->capacity) {
		free(f->data);
		f->capacity = 2 * f->bytes;
		f->data = malloc((size_t)f->capacity);
	}
	if (f->data == NULL || cn_world_save(g->world, f->data, f->capacity, NULL) != CN_OK)
		exit(1);
}

int main(void)
{
	game straight = game_create(), late = game_create();
	frame ring[DELAY + 1] = {{NULL, 0, 0, 0.0f}};
	uint64_t straight_hash, late_hash;
	int rollbacks = 0;
	for (int now = 0; now < FRAMES + DELAY; ++now) {
		int known = now - DELAY; /* the frame whose input arrives now */
		float truth = known >= 0 ? player_input(known) : 0.0f;
		if (known >= 0 && ring[known % (DELAY + 1)].input != truth) {
			frame *f = &ring[known % (DELAY + 1)];
			if (cn_world_restore(late.world, f->data, f->bytes) != CN_OK)
				return 1;
			++rollbacks;
			for (int again = known; again < now && again < FRAMES; ++again) {
				frame_save(&ring[again % (DELAY + 1)], &late);
				ring[again % (DELAY + 1)].input = truth;
				game_step(&late, truth);
			}
		}
		if (now < FRAMES) {
			frame_save(&ring[now % (DELAY + 1)], &late);
			ring[now % (DELAY + 1)].input = truth; /* a guess: as in the last frame that is known */
			game_step(&late, truth);
			game_step(&straight, player_input(now));
		}
	}
	cn_world_hash(straight.world, &straight_hash);
	cn_world_hash(late.world, &late_hash);
	printf("%d frames, inputs %d frames late, %d rollbacks, %llu bytes a save\n", FRAMES, DELAY, rollbacks, (unsigned long long)ring[0].bytes);
	printf("without delay %016llx\nrolled back   %016llx\n", (unsigned long long)straight_hash, (unsigned long long)late_hash);
	for (int k = 0; k <= DELAY; ++k)
		free(ring[k].data);
	cn_world_destroy(straight.world);
	cn_world_destroy(late.world);
	return straight_hash != late_hash;
}
