/*
 * examples/peers/scene_list.c - the scenes by name, with what counts as leaving them.
 */
#include "peers/world.h"

#define EARTH {0.0f, -10.0f}
#define STANDS PEER_SCENE_STANDS
#define SLEEP PEER_SCENE_SLEEP

static const peer_scene scenes[] = {
	{"large_pyramid", "5,050 boxes in one pyramid", peer_large_pyramid, NULL, 500, 100, STANDS, EARTH, {-100.0f, -4.0f}, {100.0f, 140.0f}},
	{"many_pyramids", "400 pyramids of 55 boxes", peer_many_pyramids, NULL, 200, 20, STANDS, EARTH, {-115.0f, -5.0f}, {115.0f, 260.0f}},
	{"joint_grid", "10,000 circles on 19,794 pins", peer_joint_grid, NULL, 500, 100, 0, EARTH, {-200.0f, -400.0f}, {300.0f, 200.0f}},
	{"tumbler", "2,025 boxes in a drum that turns", peer_tumbler, NULL, 750, 45, 0, EARTH, {-16.0f, -6.0f}, {16.0f, 26.0f}},
	{"spinner", "6,076 mixed shapes in a ring with a driven arm", peer_spinner, NULL, 500, 6076, SLEEP, EARTH, {-41.0f, -9.0f}, {41.0f, 73.0f}},
	{"smash", "A brick at 40 m/s into 9,600 sleeping boxes", peer_smash, NULL, 300, 120, SLEEP, {0.0f, 0.0f}, {-1000.0f, -1000.0f}, {1000.0f, 1000.0f}},
	{"rain", "Up to 1,000 ragdolls rain on five floors", peer_rain, peer_rain_step, 1000, 0, SLEEP | PEER_SCENE_OPEN, EARTH, {-122.0f, -2.0f}, {122.0f, 300.0f}},
	{"small_10", "10 mixed bodies in a bowl", peer_bowl, NULL, 600, 10, 0, EARTH, {-6.0f, -1.0f}, {6.0f, 60.0f}},
	{"small_50", "50 mixed bodies in a bowl", peer_bowl, NULL, 600, 50, 0, EARTH, {-6.0f, -1.0f}, {6.0f, 60.0f}},
	{"small_200", "200 mixed bodies in a bowl", peer_bowl, NULL, 600, 200, 0, EARTH, {-6.0f, -1.0f}, {6.0f, 60.0f}},
	{"small_200_sleep", "200 mixed bodies in a bowl, sleeping on", peer_bowl, NULL, 600, 200, SLEEP, EARTH, {-6.0f, -1.0f}, {6.0f, 60.0f}},
	{"ball_pit", "5,000 circles fall into a pit", peer_ball_pit, NULL, 600, 5000, 0, EARTH, {-18.5f, -0.5f}, {18.5f, 70.0f}},
	{"cars", "200 cars on a chain of 2,203 edges", peer_cars, NULL, 600, 200, 0, EARTH, {-560.0f, -10.0f}, {560.0f, 80.0f}},
	{"mostly_asleep", "10,000 boxes, 1% of them awake", peer_mostly_asleep, NULL, 300, 10000, SLEEP, EARTH, {-510.0f, -1.0f}, {510.0f, 210.0f}},
	{"pit_150", "150 mixed bodies in a pit", peer_junkyard, NULL, 600, 150, SLEEP, EARTH, {-6.0f, -2.0f}, {6.0f, 60.0f}},
	{"junkyard", "2,000 bodies of all shapes in a pit", peer_junkyard, NULL, 400, 2000, SLEEP, EARTH, {-24.0f, -2.0f}, {24.0f, 60.0f}},
	{"compounds", "700 bodies of five or seven shapes in a pit", peer_compounds, NULL, 400, 700, SLEEP, EARTH, {-24.0f, -2.0f}, {24.0f, 60.0f}},
	{"washer", "500 bodies of all shapes in a drum with paddles", peer_washer, NULL, 600, 500, 0, EARTH, {-20.0f, -8.0f}, {20.0f, 32.0f}},
	{"churn", "500 bodies made and removed in each frame", peer_churn, peer_churn_step, 300, 500, SLEEP, EARTH, {-32.0f, -2.0f}, {32.0f, 60.0f}},
	{"ragdoll_hills", "120 ragdolls on a chain of hills", peer_ragdoll_hills, NULL, 600, 120, SLEEP, EARTH, {-560.0f, -10.0f}, {560.0f, 80.0f}},
	{"flails", "40 chains of 12 links with a head, 400 boxes", peer_flails, NULL, 400, 40, SLEEP | PEER_SCENE_OPEN, EARTH, {-120.0f, -3.0f}, {120.0f, 40.0f}},
	{"few_awake", "20,000 sleeping boxes and 500 rolling balls", peer_few_awake, NULL, 400, 20000, SLEEP | PEER_SCENE_OPEN, EARTH, {-3100.0f, -3.0f}, {3100.0f, 40.0f}},
};

int32_t peer_scene_count(void) { return (int32_t)(sizeof scenes / sizeof scenes[0]); }
const peer_scene *peer_scene_at(int32_t index) { return index >= 0 && index < peer_scene_count() ? &scenes[index] : NULL; }
