#include "cairn.h"
#include <stdio.h>

int main(void)
{
	cn_world_def world_def;
	cn_world *world;
	cn_world_def_init(&world_def); /* gravity (0, -10) m/s^2 */
	if (cn_world_create(&world_def, &world) != CN_OK)
		return 1;

	cn_body_def body_def;
	cn_body ground, box;
	cn_body_def_init(&body_def);
	body_def.type = CN_BODY_STATIC;
	cn_body_create(world, &body_def, &ground);
	body_def.type = CN_BODY_DYNAMIC;
	body_def.position_m.y = 4.0f;
	cn_body_create(world, &body_def, &box);

	cn_shape_def shape_def;
	cn_shape_def_init(&shape_def);
	shape_def.body = ground;
	cn_shape_create_box(world, &shape_def, 20.0f, 0.5f, 0.0f, NULL); /* half sizes, rounding */
	shape_def.body = box;
	cn_shape_create_box(world, &shape_def, 0.5f, 0.5f, 0.0f, NULL);

	for (int step = 1; step <= 90; ++step) {
		cn_pose pose;
		cn_world_step(world, 1.0f / 60.0f);
		cn_body_get_pose(world, box, &pose);
		if (step % 15 == 0)
			printf("%.2f s: the box is at %.2f m\n", step / 60.0, (double)pose.position_m.y);
	}
	cn_world_destroy(world);
	return 0;
}
