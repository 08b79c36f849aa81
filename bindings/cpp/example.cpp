// Drops eight boxes and prints where they are, four times a second; one call a frame reads all poses.
// c++ -std=c++17 -Iinclude -Ibindings/cpp bindings/cpp/example.cpp -Lbuild -lcairn
#include "cairn.hpp"
#include <cstdio>

static cairn::Body add_box(cairn::World &world, int32_t type, float x, float y, float half_width, float half_height)
{
	cairn::BodyDef body_def;
	cairn::ShapeDef shape_def;
	body_def.type = type;
	body_def.position_m = { x, y };
	cairn::Body body = world.body_create(body_def).value();
	shape_def.body = body;
	world.shape_create_box(shape_def, half_width, half_height, 0.0f).value();
	return body;
}

int main()
{
	cairn::World world; // gravity (0, -10) m/s^2
	std::vector<cn_body> boxes;
	std::vector<cn_pose> poses(8);
	add_box(world, CN_BODY_STATIC, 0.0f, -1.0f, 20.0f, 1.0f);
	for (int i = 0; i < 8; ++i)
		boxes.push_back(add_box(world, CN_BODY_DYNAMIC, 5.0f + 0.25f * static_cast<float>(i), 2.0f + 1.5f * static_cast<float>(i), 0.5f, 0.5f));
	for (int frame = 1; frame <= 120; ++frame) {
		world.step(1.0f / 60.0f).check();
		world.read_poses(boxes, poses).check();
		if (frame % 15 != 0)
			continue;
		std::printf("%.2f s:", static_cast<double>(frame) / 60.0);
		for (const cn_pose &pose : poses)
			std::printf(" (%.2f, %.2f)", static_cast<double>(pose.position_m.x), static_cast<double>(pose.position_m.y));
		std::printf("\n");
	}
}
