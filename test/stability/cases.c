/*
 * test/stability/cases.c - the scenes that make stability runs: which family, which parameters, which bounds.
 *
 * Names that begin with a number are those of the chart (--sweep), the rest are variations. The bounds are targets, for
 * default settings at 60 frames a second; nothing else in this program knows them.
 */
#include "scene.h"

#include <string.h>

#define FLIGHT "pos_err_m<=1e-3 ang_err_rad<=1e-4"
#define PERIOD "period_err_pct<=0.01 period20_err_pct<=0.01 period_mean_err_pct<=0.01"
#define PENDULUM "energy_max_gain_pct<=0.05 energy_end_pct>=-0.05 energy_end_pct<=0.05 pin_drift_max_m<=1e-3 " PERIOD
#define DOUBLE_PEND "tip_err_max_1s_m<=1e-3 energy_max_gain_pct<=1"
#define CHAIN_LIGHT "joint_stretch_max_m<=3e-3 energy_max_gain_pct<=1"
#define CHAIN_HEAVY "joint_stretch_max_m<=1e-3 energy_max_gain_pct<=1"
#define CHAIN_EXTREME "joint_stretch_max_m<=0.08 energy_max_gain_pct<=1"
#define STACK "stands>=1 pen_max_m<=1e-3 drift_x_m<=2e-3"
#define STACK_TALL "stands>=1 pen_max_m<=2e-3 drift_x_m<=5e-3"
#define HEAVY "stands>=1 pen_max_m<=1e-3"
#define STICKS "slip_err_m<=1e-5"
#define SLIDES "slip_err_m<=2e-3"
#define APEX "apex_maxerr_frac_of_h0<=1e-3"
#define CLUSTER "energy_max_over_E0<=1.0001 lin_mom_drift_rel<=1e-6 ang_mom_drift_rel<=1e-5"
#define LINKS "joint_stretch_max_m<=5e-3 energy_max_gain_pct<=1 lost<=0"
#define RANDOM "energy_max_over_E0<=1.001 not_finite<=0 lost<=0"
#define STOPS "tunnel_frac<=0"

const scene_case scene_cases[] = {
	/* One body. */
	{ "1_free_w3", "free", "spin=3", FLIGHT, 0 },
	{ "1_free_w30", "free", "spin=30", FLIGHT, 0 },
	{ "11_rod_free_w20", "rod", "spin=20", "ang_err_rad<=1e-4 spin_loss_pct<=1e-4 energy_end_pct<=1e-4", 0 },
	{ "11_rod_free_w100", "rod", "spin=100", "ang_err_rad<=1e-3 spin_loss_pct<=1e-4 energy_end_pct<=1e-4", 0 },
	{ "7_incline_0.98", "incline", "ratio=0.98", STICKS, 0 },
	{ "7_incline_1.02", "incline", "ratio=1.02", SLIDES, 0 },
	{ "incline_0.9", "incline", "ratio=0.9", STICKS, 0 },
	{ "incline_0.999", "incline", "ratio=0.999", STICKS, 0 },
	{ "incline_1.001", "incline", "ratio=1.001", SLIDES, 0 },
	{ "incline_1.1", "incline", "ratio=1.1", SLIDES, 0 },

	/* Impacts. */
	{ "8_drop_e1", "drop", "e=1", APEX, 0 },
	{ "8_drop_e0.8", "drop", "e=0.8", APEX, 0 },
	{ "8_drop_e0.5", "drop", "e=0.5", APEX, 0 },
	{ "9_cluster_e0", "cluster", "e=0", CLUSTER, 0 },
	{ "9_cluster_e0.5", "cluster", "e=0.5", CLUSTER, 0 },
	{ "9_cluster_e1", "cluster", "e=1", CLUSTER, 0 },
	{ "cluster_friction", "cluster", "e=0.5 friction=0.3", CLUSTER, 0 },
	{ "collision_chain_e1", "collision_chain", "e=1", "last_speed_err_rel<=1e-3 energy_max_over_E0<=1.0001 lin_mom_drift_rel<=1e-6", 0 },
	{ "collision_chain_e0.5", "collision_chain", "e=0.5 balls=5 gap=0.2", "last_speed_err_rel<=1e-3 energy_max_over_E0<=1.0001 lin_mom_drift_rel<=1e-6", 0 },
	{ "10_bullet_static_v10", "bullet", "wall=0 speed=10", STOPS, 0 },
	{ "10_bullet_static_v30", "bullet", "wall=0 speed=30", STOPS, 0 },
	{ "10_bullet_static_v60", "bullet", "wall=0 speed=60", STOPS, 0 },
	{ "10_bullet_static_v120", "bullet", "wall=0 speed=120", STOPS, 0 },
	{ "10_bullet_static_v240", "bullet", "wall=0 speed=240", STOPS, 0 },
	{ "10_bullet_static_v390", "bullet", "wall=0 speed=390", STOPS, 0 },
	{ "bullet_static_v400", "bullet", "wall=0 speed=400", STOPS, 0 },
	{ "10_bullet_dyn_v10", "bullet", "wall=1 speed=10", STOPS, 0 },
	{ "10_bullet_dyn_v30", "bullet", "wall=1 speed=30", STOPS, 0 },
	{ "10_bullet_dyn_v60", "bullet", "wall=1 speed=60", STOPS, 0 },
	{ "10_bullet_dyn_v120", "bullet", "wall=1 speed=120", STOPS, 0 },
	{ "10_bullet_dyn_v240", "bullet", "wall=1 speed=240", STOPS, 0 },
	{ "10_bullet_dyn_v390", "bullet", "wall=1 speed=390", STOPS, 0 },
	{ "10_bullet_dynflag_v10", "bullet", "wall=2 speed=10", STOPS, 0 },
	{ "10_bullet_dynflag_v30", "bullet", "wall=2 speed=30", STOPS, 0 },
	{ "10_bullet_dynflag_v60", "bullet", "wall=2 speed=60", STOPS, 0 },
	{ "10_bullet_dynflag_v120", "bullet", "wall=2 speed=120", STOPS, 0 },
	{ "10_bullet_dynflag_v240", "bullet", "wall=2 speed=240", STOPS, 0 },
	{ "10_bullet_dynflag_v390", "bullet", "wall=2 speed=390", STOPS, 0 },

	/* Joints. */
	{ "2_pendulum", "pendulum", "", PENDULUM, 0 },
	{ "2_double_pend", "double_pend", "", DOUBLE_PEND, 0 },
	{ "3_chain_hang_1:10", "chain", "hang=1 ratio=10", CHAIN_LIGHT, 0 },
	{ "3_chain_hang_1:100", "chain", "hang=1 ratio=100", CHAIN_HEAVY, 0 },
	{ "3_chain_hang_1:1000", "chain", "hang=1 ratio=1000", CHAIN_HEAVY, 0 },
	{ "chain_hang_1:10000", "chain", "hang=1 ratio=10000", CHAIN_EXTREME, 0 },
	{ "3_chain_swing_1:10", "chain", "hang=0 ratio=10", CHAIN_LIGHT, 0 },
	{ "3_chain_swing_1:100", "chain", "hang=0 ratio=100", CHAIN_HEAVY, 0 },
	{ "3_chain_swing_1:1000", "chain", "hang=0 ratio=1000", CHAIN_HEAVY, 0 },
	{ "chain_swing_1:10000", "chain", "hang=0 ratio=10000", CHAIN_EXTREME, 0 },
	{ "11_cantilever10", "cantilever", "tip=1", "tip_sag_max_m<=1e-3 joint_stretch_max_m<=1e-3", 0 },
	{ "11_cantilever10_tip100", "cantilever", "tip=100", "tip_sag_max_m<=1e-2 joint_stretch_max_m<=1e-3", 0 },
	{ "cantilever20", "cantilever", "boxes=20", "tip_sag_max_m<=1e-2 joint_stretch_max_m<=1e-3", 0 },
	{ "bridge", "bridge", "", "joint_stretch_max_m<=0.005 energy_max_gain_pct<=1 fallen<=0", 0 }, /* CN_SOLVER_SOFT 0.109, Box2D 3.2 0.109 */
	{ "bridge_load50", "bridge", "load=50", "joint_stretch_max_m<=0.005 energy_max_gain_pct<=1 fallen<=0", 0 }, /* 0.253, 0.229; through those falls load=100 */
	{ "joint_grid100", "joint_grid", "", "joint_stretch_max_m<=0.6 joint_stretch_end_m<=0.4936 energy_max_gain_pct<=1", 0 }, /* Box2D 3.2: 0.578, 0.4936 */
	{ "gear_train", "gear_train", "", "gear_err_max_rad<=1e-3 speed_err_rel<=1e-3 joint_stretch_max_m<=1e-3", 0 },
	{ "links_of_2", "links", "", LINKS, 0 },
	{ "links_of_2_1:10", "links", "ratio=10", LINKS, 0 },
	{ "links_of_3", "links", "links=3", LINKS, 0 },
	{ "links_of_4_1:10", "links", "links=4 ratio=10", LINKS, 0 },
	{ "ragdolls", "ragdolls", "", "joint_stretch_max_m<=1e-2 energy_max_gain_pct<=1 lost<=0", 0 },

	/* Piles. */
	{ "4_stack10", "stack", "boxes=10", STACK, 0 },
	{ "4_stack20", "stack", "boxes=20", STACK, 0 },
	{ "4_stack50", "stack", "boxes=50", STACK_TALL, 0 },
	{ "stack100", "stack", "boxes=100", "stands>=1", 0 },
	{ "stack20_aside", "stack", "boxes=20 offset=0.01", STACK, 0 },
	{ "4_heavy_top_x10", "stack", "boxes=10 top=10", HEAVY, 0 },
	{ "4_heavy_top_x100", "stack", "boxes=10 top=100", HEAVY, 0 },
	{ "4_heavy_top_x1000", "stack", "boxes=10 top=1000", "stands>=1 pen_max_m<=2e-3", 0 },
	{ "heavy_top_x10000", "stack", "boxes=10 top=10000", "stands>=1 pen_max_m<=0.02", 0 },
	{ "5_pyramid20", "pyramid", "base=20", "stands>=1 disp_max_m<=5e-3", 0 },
	{ "pyramid50", "pyramid", "base=50 seconds=5", "stands>=1 disp_max_m<=5e-3 top_sag_m<=0.02", 0 },
	{ "pyramid100", "pyramid", "base=100 seconds=5", "stands>=1 disp_max_m<=5e-3 top_sag_m<=0.05", 0 },
	{ "pyramid100_pushed", "pyramid", "base=100 push=0.3 seconds=12", "stands>=1 v_end<=0.05", 0 },

	/* Structures. */
	{ "6_arch", "arch", "", "stands>=1 key_sag_m<=0.02", 0 },
	{ "arch_thick", "arch", "stones=15 inner=7 outer=9", "stands>=1 key_sag_m<=0.02", 0 },
	{ "card_house2", "card_house", "floors=2", "stands>=1", 0 },
	{ "card_house3", "card_house", "floors=3", "stands>=1", 0 },
	{ "card_house4", "card_house", "floors=4", "stands>=1", 0 },
	{ "card_house5", "card_house", "floors=5", "stands>=1", 0 },
	{ "plank", "plank", "", "stands>=1 height_loss_m<=1e-3 drift_x_m<=1e-3 tilt_max_rad<=1e-3", 0 },

	/* Other time steps: what holds at 60 holds at 120, and when frames are uneven; half of that at 30. */
	{ "free_30hz", "free", "spin=3 hertz=30", FLIGHT, 0 },
	{ "free_vary", "free", "spin=3 vary=1", FLIGHT, 0 },
	{ "pendulum_30hz", "pendulum", "hertz=30", "energy_max_gain_pct<=0.2 energy_end_pct>=-0.2 energy_end_pct<=0.2 period_mean_err_pct<=0.04", 0 },
	{ "pendulum_120hz", "pendulum", "hertz=120", PENDULUM, 0 },
	{ "pendulum_vary", "pendulum", "vary=1", "energy_max_gain_pct<=0.2 energy_end_pct>=-0.2 energy_end_pct<=0.2 period_mean_err_pct<=0.04", 0 },
	{ "chain_swing_1:100_30hz", "chain", "ratio=100 hertz=30", "joint_stretch_max_m<=0.6 joint_stretch_end_m<=0.4936 energy_max_gain_pct<=1", 0 }, /* Box2D 3.2: 0.578, 0.4936 */
	{ "chain_swing_1:100_120hz", "chain", "ratio=100 hertz=120", CHAIN_HEAVY, 0 },
	{ "chain_swing_1:100_vary", "chain", "ratio=100 vary=1", CHAIN_HEAVY, 0 },
	{ "stack20_30hz", "stack", "boxes=20 hertz=30", "stands>=1 pen_max_m<=2e-3 drift_x_m<=4e-3", 0 },
	{ "stack20_120hz", "stack", "boxes=20 hertz=120", STACK, 0 },
	{ "stack20_vary", "stack", "boxes=20 vary=1", STACK, 0 },
	{ "pyramid40_vary", "pyramid", "base=40 vary=1 seconds=5", "stands>=1 disp_max_m<=0.05", 0 },

	/* Other sizes: 1 cm and 50 m; with the world's length unit to match, and without. */
	{ "stack10_1cm", "stack", "boxes=10 size=0.01 unit=0.01", "stands>=1 pen_max_m<=1e-4 drift_x_m<=2e-4", 0 },
	{ "stack10_1cm_unit1m", "stack", "boxes=10 size=0.01", "stands>=1 pen_max_m<=1e-3 drift_x_m<=1e-3", 0 },
	{ "stack10_50m", "stack", "boxes=10 size=50 unit=50", "stands>=1 pen_max_m<=0.05 drift_x_m<=0.1", 0 },
	{ "stack10_50m_unit1m", "stack", "boxes=10 size=50", "stands>=1 pen_max_m<=0.05 drift_x_m<=0.1", 0 },
	{ "chain_swing_1:10_1cm", "chain", "ratio=10 size=0.01 unit=0.01", "joint_stretch_max_m<=3e-4 energy_max_gain_pct<=1", 0 },
	{ "chain_swing_1:10_50m", "chain", "ratio=10 size=50 unit=50", "joint_stretch_max_m<=0.15 energy_max_gain_pct<=1", 0 },

	/* Far away: floats are 0.06 mm apart at 1 km, 1 mm at 10 km, 8 mm at 100 km. The limits are about 10 of these. */
	{ "stack10_1km", "stack", "boxes=10 far=1e3", STACK, 0 },
	{ "stack10_10km", "stack", "boxes=10 far=1e4", "stands>=1 pen_max_m<=0.01 drift_x_m<=0.01", 0 },
	{ "stack10_100km", "stack", "boxes=10 far=1e5", "stands>=1 pen_max_m<=0.08 drift_x_m<=0.08", 0 },
	{ "chain_swing_1:10_1km", "chain", "ratio=10 far=1e3", CHAIN_LIGHT, 0 },
	{ "chain_swing_1:10_10km", "chain", "ratio=10 far=1e4", "joint_stretch_max_m<=0.01 energy_max_gain_pct<=1", 0 },
	{ "chain_swing_1:10_100km", "chain", "ratio=10 far=1e5", "joint_stretch_max_m<=0.08 energy_max_gain_pct<=5", 0 },

	{ "random", "random", "", RANDOM, 100 },
	{ "random_30hz", "random", "hertz=30", RANDOM, 100 },
	{ "random_120hz", "random", "hertz=120", RANDOM, 100 },
	{ "random_vary", "random", "vary=1", RANDOM, 100 },
};
const int32_t scene_case_count = (int32_t)(sizeof scene_cases / sizeof *scene_cases);

const scene_family *scene_family_find(const char *name)
{
	const scene_family *const lists[] = { motion_families, impact_families, swing_families, joint_families, pile_families, structure_families, random_families };
	const int32_t counts[] = { motion_family_count, impact_family_count, swing_family_count, joint_family_count, pile_family_count, structure_family_count, random_family_count };
	int32_t l, k;
	for (l = 0; l < (int32_t)(sizeof lists / sizeof *lists); ++l)
		for (k = 0; k < counts[l]; ++k)
			if (strcmp(lists[l][k].name, name) == 0)
				return &lists[l][k];
	return NULL;
}
