/*
 * test/world/arguments_areas.h - entries of arguments_test for areas and wind: good and bad calls of each function. Included by
 * arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_AREAS_H
#define CAIRN_TEST_ARGUMENTS_AREAS_H

#define AREA(field, value) (cn_area_def_init(&area), area.field = (value), &area)
#define SET_AREA(field, value) cn_shape_set_area(W, f.sensor, AREA(field, value))

ENTRY(cn_area_def_init, (cn_area_def_init(&area), CN_OK), cn_area_def_init(NULL);)
ENTRY(cn_shape_set_area, SET_AREA(priority, -3),
	cn_area_def_init(&area); NOW(cn_shape_set_area(NULL, f.sensor, &area)); SHAPE(h, cn_shape_set_area(W, h, &area)); SHAPE(h, cn_shape_set_area(W, h, NULL)); SIZES(x, SET_AREA(struct_size, x));
	FLAGS(x, 1, SET_AREA(flags, x)); VECTOR(v, SET_AREA(gravity_mps2, v)); POSITION(v, SET_AREA(center_m, v)); FLOAT(x, SET_AREA(pull_mps2, x));
	DEFAULT_OR_ABOVE_0(x, 1.1e6f, SET_AREA(pull_distance_m, x)); RANGE(x, -1e-30f, 1.1e9f, SET_AREA(linear_damping_per_s, x));
	RANGE(x, -1e-30f, 1.1e9f, SET_AREA(angular_damping_per_s, x)); RANGE(x, -1e-30f, 1.1e9f, SET_AREA(density_kgpm2, x));
	RANGE(x, -1e-30f, 1.1e9f, SET_AREA(drag_kgpm2, x)); RANGE(x, -1e-30f, 1.1e9f, SET_AREA(lift_kgpm2, x)); VECTOR(v, SET_AREA(flow_mps, v));
	STATE(cn_shape_set_area(W, f.ball_shape, AREA(priority, 0))); STATE(cn_shape_set_area(W, f.ball_shape, NULL));)
ENTRY(cn_shape_get_area, cn_shape_get_area(W, f.area, OUT(cn_area_def)),
	NOW(cn_shape_get_area(NULL, f.area, OUT(cn_area_def))); SHAPE(h, cn_shape_get_area(W, h, OUT(cn_area_def)));
	ARG(cn_shape_get_area(W, f.area, NULL)); STATE(cn_shape_get_area(W, f.sensor, OUT(cn_area_def))); STATE(cn_shape_get_area(W, f.ball_shape, OUT(cn_area_def)));)
#define WIND(x, y, drag, lift, dt) cn_shape_apply_wind(W, f.ball_shape, x, y, drag, lift, dt, 1)
ENTRY(cn_shape_apply_wind, WIND(1.0f, 2.0f, 1.0f, 1.0f, 0.1f),
	NOW(cn_shape_apply_wind(NULL, f.ball_shape, 1.0f, 1.0f, 1.0f, 1.0f, 0.1f, 1)); SHAPE(h, cn_shape_apply_wind(W, h, 1.0f, 1.0f, 1.0f, 1.0f, 0.1f, 1));
	FLOAT(x, WIND(x, 0.0f, 1.0f, 1.0f, 0.1f)); FLOAT(x, WIND(0.0f, x, 1.0f, 1.0f, 0.1f)); RANGE(x, -1e-30f, 1.1e9f, WIND(1.0f, 1.0f, x, 1.0f, 0.1f));
	RANGE(x, -1e-30f, 1.1e9f, WIND(1.0f, 1.0f, 1.0f, x, 0.1f)); RANGE(x, -1e-30f, 1.1f, WIND(1.0f, 1.0f, 1.0f, 1.0f, x));
	ARG(WIND(3e38f, 3e38f, 1e9f, 1e9f, 1.0f)); STATE(cn_shape_apply_wind(W, f.loose, 1.0f, 2.0f, 1.0f, 1.0f, 0.1f, 1));)

#endif
