/*
 * examples/bench/scale_scenes.h - the scenes of `make bench-scale`: of any number of bodies, always as many in an
 * area. Many equal cells lie in rows one above the other and make a world about as wide as it is high, so that only
 * the number of cells grows, and walls and corners stay few.
 *
 *     scene which;
 *     scene_run run;
 *     scale_field(&which, 10000);
 *     scene_open(&run, &which, NULL);   which must outlive the run
 */
#ifndef CAIRN_BENCH_SCALE_SCENES_H
#define CAIRN_BENCH_SCALE_SCENES_H

#include "scenes/scenes.h"

/* Boxes and circles of several sizes on long shelves, kept moving by a turning paddle in each cell. bodies counts the
   dynamic ones; there are a paddle for each 42 of them and one static body besides. */
void scale_field(scene *out, int32_t bodies);
/* Pyramids of 55 boxes that stand on long shelves, the last one as high as the boxes suffice for; and one static body. */
void scale_piles(scene *out, int32_t bodies);

#endif
