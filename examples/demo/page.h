/*
 * examples/demo/page.h - index.html beside the pictures: each scene's animation, still and figures.
 */
#ifndef CAIRN_DEMO_PAGE_H
#define CAIRN_DEMO_PAGE_H

#include "demo/duel.h"

#include <stdint.h>

typedef struct demo_figures {
	const char *name;
	const char *title;
	int32_t width, height; /* of the animation */
	int32_t steps;
	int32_t bodies, joints, asleep;
	int32_t contacts;      /* touching, at the end */
	double ms_min, ms_median, ms_p99;
	float rest_overlap_m;  /* deepest overlap at the end of bodies at rest */
	int32_t rest_points;   /* contact points of such bodies; 0: nothing rests */
	float motion_overlap_m, joint_error_m; /* largest of the whole run */
	uint64_t hash;
	long gif_bytes;
} demo_figures;

/* folder gets index.html: the first scenes, duels, the other scenes. 0 when it cannot be written. */
int32_t page_write(const char *folder, const demo_figures *figures, int32_t count, int32_t first, const duel_figures *duels, int32_t duel_count);

#endif
