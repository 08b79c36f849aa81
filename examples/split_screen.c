/* examples/split_screen.c - four players, a world and a thread each: worlds share nothing. The same inputs give the same bits; a player
   who plays otherwise gets another world. */
#include "cairn.h"
#include <pthread.h>
#include <stdio.h>

#define PLAYERS 4

typedef struct player {
	pthread_t thread;
	float push_N;     /* his input */
	cn_world *world;
	cn_body ball;
	cn_vec2 at;
	uint64_t hash;
} player;

static int player_start(player *p, float push_N)
{
	const cn_circle circle = { { 0.0f, 0.0f }, 0.5f };
	cn_world_def def;
	cn_body_def body_def;
	cn_shape_def shape_def;
	p->push_N = push_N;
	cn_world_def_init(&def);
	if (cn_world_create(&def, &p->world) != CN_OK)
		return 0;
	cn_body_def_init(&body_def);
	cn_shape_def_init(&shape_def);
	for (int i = 0; i <= 20; ++i) { /* ground and a wall of boxes */
		body_def.type = i == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
		body_def.position_m = i == 0 ? (cn_vec2){ 0.0f, -1.0f } : (cn_vec2){ 4.0f + (float)(i % 4), 0.5f + (float)((i - 1) / 4) };
		cn_body_create(p->world, &body_def, &shape_def.body);
		cn_shape_create_box(p->world, &shape_def, i == 0 ? 50.0f : 0.5f, i == 0 ? 1.0f : 0.5f, 0.0f, NULL);
	}
	body_def.position_m = (cn_vec2){ 0.0f, 0.5f };
	cn_body_create(p->world, &body_def, &p->ball);
	shape_def.body = p->ball;
	shape_def.density_kgpm2 = 5.0f;
	cn_shape_create_circle(p->world, &shape_def, &circle, NULL);
	return 1;
}

/* One second of one player's game. */
static void *player_run(void *user)
{
	player *p = (player *)user;
	for (int step = 0; step < 60; ++step) {
		cn_body_apply_force(p->world, p->ball, p->push_N, 0.0f);
		cn_world_step(p->world, 1.0f / 60.0f);
	}
	cn_body_get_center(p->world, p->ball, &p->at);
	cn_world_hash(p->world, &p->hash);
	return NULL;
}

int main(void)
{
	static player players[PLAYERS];
	const float inputs[PLAYERS] = { 60.0f, 60.0f, -30.0f, 90.0f };
	for (int i = 0; i < PLAYERS; ++i) {
		if (!player_start(&players[i], inputs[i]))
			return 1;
	}
	for (int second = 1; second <= 3; ++second) {
		for (int i = 0; i < PLAYERS; ++i) {
			if (pthread_create(&players[i].thread, NULL, player_run, &players[i]) != 0)
				return 1;
		}
		printf("%d s:", second);
		for (int i = 0; i < PLAYERS; ++i) {
			pthread_join(players[i].thread, NULL);
			printf("  %6.2f m %08x", (double)players[i].at.x, (unsigned)(players[i].hash >> 32));
		}
		printf("\n");
	}
	for (int i = 0; i < PLAYERS; ++i)
		cn_world_destroy(players[i].world);
	return !(players[0].hash == players[1].hash && players[0].hash != players[2].hash && players[0].hash != players[3].hash);
}
