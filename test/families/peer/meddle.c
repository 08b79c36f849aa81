/*
 * test/families/peer/meddle.c - takes the place of meddle.c where another engine runs the families: nothing is done to a scene.
 *
 * Adapters (test/stability/chart/peer.h) need none of the calls that change a scene while it runs.
 */
#include "../families.h"

#include <stdio.h>
#include <stdlib.h>

void meddle_begin(scene *s, int32_t kind)
{
	(void)s;
	if (kind == 0)
		return;
	fprintf(stderr, "families: nothing can be done to a scene that another engine runs\n");
	exit(2);
}

cn_result meddle(scene *s, double now_s, double dt_s)
{
	(void)s, (void)now_s, (void)dt_s;
	return CN_OK;
}
