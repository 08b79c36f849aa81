/*
 * joints/joint_type.c - the joint types: the rows of each, its position and its speed (signs and letters as in joint.h, meaning of p[] there).
 *
 * Most revolute, fixed and distance joints are solved without rows: joints/joint_kernel.h has the same formulas.
 */
#include "joints/joint_type.h"

#include <string.h>

/* ---- rows ---- */

static cni_row row_of(cni_lever lever, uint8_t kind, int32_t slot, float error)
{
	cni_row r;
	memset(&r, 0, sizeof r);
	r.lever = lever;
	r.error = error;
	r.kind = kind;
	r.slot = (uint8_t)slot;
	return r;
}

/* d/dt of sign * (angle b - ratio * angle a). */
static cni_row row_angular(uint8_t kind, int32_t slot, float sign, float ratio, float error)
{
	const cni_lever lever = { 0.0f, 0.0f, -sign * ratio, 0.0f, 0.0f, sign };
	cni_row r = row_of(lever, kind, slot, error);
	r.angular = 1;
	return r;
}

/* d/dt of sign * direction . d; reach is a's lever: ra, or ra + d when the direction turns with a. */
static cni_row row_along(const cni_joint_frame *f, cni_vec2 direction, cni_vec2 reach, uint8_t kind, int32_t slot, float sign, float error)
{
	const cni_lever lever = { -sign * direction.x, -sign * direction.y, -sign * cni_cross(reach, direction),
		sign * direction.x, sign * direction.y, sign * cni_cross(f->rb, direction) };
	return row_of(lever, kind, slot, error);
}

/* The two rows of a point of b held at a point of a; slots 0 and 1. */
static void rows_point(const cni_joint_frame *f, cni_vec2 ra, cni_vec2 gap, uint8_t kind, cni_row *rows)
{
	memset(rows, 0, 2 * sizeof *rows);
	rows[0].lever.ax = rows[1].lever.ay = -1.0f;
	rows[0].lever.bx = rows[1].lever.by = 1.0f;
	rows[0].kind = rows[1].kind = kind;
	rows[1].slot = 1;
	cni_rows_point_turn(rows, ra, f->rb, gap);
}

static cni_row row_spring(cni_row r, float hertz, float damping_ratio)
{
	r.hertz = hertz;
	r.damping_ratio = damping_ratio;
	return r;
}

/* Nearer end of lower <= x <= upper: returns 1 or -1, the row's sign, and the remaining gap there. */
static float limit_side(float x, float lower, float upper, float *out_room)
{
	float room_lower = x - lower, room_upper = upper - x;
	*out_room = cni_min(room_lower, room_upper);
	return room_lower <= room_upper ? 1.0f : -1.0f;
}

/* ---- coordinates, on which springs, motors and limits act ---- */

typedef struct coordinate {
	const cni_joint_frame *f;
	float x;
	int32_t angular;       /* 1: the angle */
	cni_vec2 axis, reach;  /* 0: position along the axis; see row_along */
} coordinate;

static coordinate angle_of(const cni_joint_frame *f)
{
	coordinate c = { f, f->angle, 1, { 0.0f, 0.0f }, { 0.0f, 0.0f } };
	return c;
}

/* Along the type's axis, which is fixed in body a. */
static coordinate slide_of(const cni_joint *j, const cni_joint_frame *f)
{
	coordinate c = { f, 0.0f, 0, cni_rotate(f->qa, cni_v(j->p[CNI_P_AXIS_X], j->p[CNI_P_AXIS_Y])), cni_add(f->ra, f->d) };
	c.x = cni_dot(c.axis, f->d);
	return c;
}

/* d/dt |d| = axis . (vb + wb x rb - va - wa x ra) */
static coordinate distance_of(const cni_joint_frame *f)
{
	coordinate c = { f, 0.0f, 0, { 0.0f, 0.0f }, f->ra };
	c.axis = cni_distance_axis(f->d, &c.x);
	return c;
}

CNI_INLINE cni_row coordinate_row(const coordinate *c, uint8_t kind, int32_t slot, float sign, float error)
{
	return c->angular ? row_angular(kind, slot, sign, 1.0f, error) : row_along(c->f, c->axis, c->reach, kind, slot, sign, error);
}

static cni_row motor_row(const cni_joint *j, const coordinate *c, int32_t slot, int32_t limited)
{
	cni_row r = coordinate_row(c, CNI_ROW_MOTOR, slot, 1.0f, 0.0f);
	r.target = j->p[CNI_P_MOTOR_SPEED];
	r.limit = j->p[CNI_P_MOTOR_MAX];
	r.below = limited ? c->x - j->p[CNI_P_LOWER] : CNI_NO_LIMIT;
	r.above = limited ? j->p[CNI_P_UPPER] - c->x : CNI_NO_LIMIT;
	return r;
}

static cni_row limit_row(const cni_joint *j, const coordinate *c, int32_t slot)
{
	float room, sign = limit_side(c->x, j->p[CNI_P_LOWER], j->p[CNI_P_UPPER], &room);
	return coordinate_row(c, CNI_ROW_LIMIT, slot, sign, room);
}

/* Writes the spring, motor and limit that the joint has, with this slot and the next two. p[hertz]: the spring's, before its damping ratio;
   motor: its coordinate, the same as the others' or one that has no limits. Returns the number of rows. */
CNI_INLINE int32_t parts_write(const cni_joint *j, const coordinate *c, const coordinate *motor, int32_t slot, float rest, int32_t hertz, cni_row *rows)
{
	int32_t count = 0;
	if (j->flags & CN_JOINT_SPRING)
		rows[count++] = row_spring(coordinate_row(c, CNI_ROW_SPRING, slot, 1.0f, c->x - rest), j->p[hertz], j->p[hertz + 1]);
	if (j->flags & CN_JOINT_MOTOR)
		rows[count++] = motor_row(j, motor, slot + 1, motor == c && (j->flags & CN_JOINT_LIMIT));
	if (j->flags & CN_JOINT_LIMIT)
		rows[count++] = limit_row(j, c, slot + 2);
	return count;
}

/* ---- position and speed: the angle, the position along the axis, the distance of the anchors ---- */

static float angle_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return f->angle;
}

static cni_row angle_speed(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return row_angular(CNI_ROW_MOTOR, 0, 1.0f, f->ratio, 0.0f);
}

static float slide_position(const cni_joint *j, const cni_joint_frame *f)
{
	return slide_of(j, f).x;
}

static cni_row slide_speed(const cni_joint *j, const cni_joint_frame *f)
{
	coordinate c = slide_of(j, f);
	return coordinate_row(&c, CNI_ROW_MOTOR, 0, 1.0f, 0.0f);
}

static float distance_position(const cni_joint *j, const cni_joint_frame *f)
{
	(void)j;
	return cni_length(f->d);
}

/* ---- points ---- */

/* Two bodies share a point; spring, motor and limit act on the angle. Slots: 0, 1 point (x, y); 2 spring; 3 motor; 4 limit. */
int32_t cni_joint_revolute_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = angle_of(f);
	rows_point(f, f->ra, f->d, CNI_ROW_RIGID, rows);
	return 2 + parts_write(j, &c, &c, 2, j->p[CNI_P_TARGET], CNI_P_HERTZ, rows + 2);
}

/* Two bodies welded together; hertz and damping ratio are of the angle alone (0 Hz: as stiff as the point). Slots: 0, 1 point; 2 angle. */
static int32_t fixed_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	uint8_t kind = j->p[CNI_P_HERTZ] > 0.0f ? CNI_ROW_SOFT : CNI_ROW_RIGID;
	rows_point(f, f->ra, f->d, CNI_ROW_RIGID, rows);
	rows[2] = row_spring(row_angular(kind, 2, 1.0f, 1.0f, f->angle), j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	rows[2].limit = j->torque_max;
	return 3;
}

/* Drives b to an offset, in a's frame, and an angle from a, by a spring with bounded force and torque. Slots: 0, 1 point; 2 angle. */
static int32_t motor_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	cni_vec2 offset = cni_rotate(f->qa, cni_v(j->p[CNI_P_MOTOR_OFFSET_X], j->p[CNI_P_MOTOR_OFFSET_Y]));
	rows_point(f, cni_add(f->ra, offset), cni_sub(f->d, offset), CNI_ROW_DRIVE, rows);
	rows[2] = row_angular(CNI_ROW_DRIVE, 2, 1.0f, 1.0f, f->angle);
	for (int32_t k = 0; k < 3; ++k)
		rows[k] = row_spring(rows[k], j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	return 3;
}

static float motor_position(const cni_joint *j, const cni_joint_frame *f)
{
	return f->angle + j->p[CNI_P_MOTOR_ANGLE];
}

/* Drags anchor b to anchor a, a point of the world, by a spring with bounded force. Slots: 0, 1 point. */
static int32_t mouse_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows_point(f, f->ra, f->d, CNI_ROW_DRIVE, rows);
	for (int32_t k = 0; k < 2; ++k)
		rows[k] = row_spring(rows[k], j->p[CNI_P_HERTZ], j->p[CNI_P_DAMPING]);
	return 2;
}

static cni_row mouse_speed(const cni_joint *j, const cni_joint_frame *f)
{
	float length = cni_length(f->d);
	(void)j;
	return row_along(f, length > 0.0f ? cni_mul(1.0f / length, f->d) : cni_v(0.0f, 0.0f), f->ra, CNI_ROW_DRIVE, 0, 1.0f, 0.0f);
}

/* ---- slides along an axis fixed in a ---- */

/* Keeps b on the axis, within the tolerance to either side; slot 0. */
static cni_row across_row(const cni_joint_frame *f, const coordinate *slide, float tolerance)
{
	cni_vec2 across = cni_left_perp(slide->axis);
	float x = cni_dot(across, f->d), room = x;
	float sign = tolerance != 0.0f ? limit_side(x, -tolerance, tolerance, &room) : 1.0f;
	return row_along(f, across, slide->reach, tolerance != 0.0f ? CNI_ROW_LIMIT : CNI_ROW_RIGID, 0, sign, room);
}

/* b does not turn against a. Slots: 0 across the axis; 1 angle; along it 2 spring; 3 motor; 4 limit. */
static int32_t prismatic_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = slide_of(j, f);
	rows[0] = across_row(f, &c, 0.0f);
	rows[1] = row_angular(CNI_ROW_RIGID, 1, 1.0f, 1.0f, f->angle);
	return 2 + parts_write(j, &c, &c, 2, j->p[CNI_P_TARGET], CNI_P_HERTZ, rows + 2);
}

/* A wheel b on the suspension of a, which turns freely. Slots: 0 across the axis; 2 spring; 3 motor (turns the wheel); 4 limit. */
static int32_t wheel_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = slide_of(j, f), turn = angle_of(f);
	rows[0] = across_row(f, &c, 0.0f);
	return 1 + parts_write(j, &c, &turn, 2, 0.0f, CNI_P_HERTZ, rows + 1);
}

/* Anchor b slides in a slot of body a, from anchor a to an end. Slots: 0 across the slot; 1 its ends. */
static int32_t groove_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = slide_of(j, f);
	rows[0] = across_row(f, &c, 0.0f);
	rows[1] = limit_row(j, &c, 1);
	return 2;
}

/* Constraint on one body: one of its points stays on a line in the world, optionally between limits. Slots: 0 across the line; 1 along it. */
static int32_t line_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = slide_of(j, f);
	rows[0] = across_row(f, &c, j->p[CNI_P_LINE_TOLERANCE]);
	rows[1] = limit_row(j, &c, 1);
	return j->flags & CN_JOINT_LIMIT ? 2 : 1;
}

/* ---- distances ---- */

/* Keeps the distance of two points: rigid rod, spring, or rope with limits. Slots: 0 rod; 1 spring; 2 motor; 3 limit. */
static int32_t distance_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = distance_of(f);
	if (j->flags & (CN_JOINT_SPRING | CN_JOINT_LIMIT))
		return parts_write(j, &c, &c, 1, j->p[CNI_P_LENGTH], CNI_P_DISTANCE_HERTZ, rows);
	rows[0] = coordinate_row(&c, CNI_ROW_RIGID, 0, 1.0f, c.x - j->p[CNI_P_LENGTH]);
	return 1;
}

static cni_row distance_speed(const cni_joint *j, const cni_joint_frame *f)
{
	coordinate c = distance_of(f);
	(void)j;
	return coordinate_row(&c, CNI_ROW_MOTOR, 2, 1.0f, 0.0f);
}

/* Unit vector along x; 0 for an anchor that lies on its pulley. */
static cni_vec2 pulley_direction(cni_vec2 x)
{
	float length = cni_length(x);
	return length > 1e-9f ? cni_mul(1.0f / length, x) : cni_v(0.0f, 0.0f);
}

static float pulley_position(const cni_joint *j, const cni_joint_frame *f)
{
	return cni_length(f->d) + j->p[CNI_P_PULLEY_RATIO] * cni_length(f->e);
}

/* d/dt of sign * (length of rope in use). */
static cni_row rope_row(const cni_joint *j, const cni_joint_frame *f, float sign, float error)
{
	cni_vec2 u = pulley_direction(f->d), v = cni_mul(j->p[CNI_P_PULLEY_RATIO], pulley_direction(f->e));
	const cni_lever lever = { sign * u.x, sign * u.y, sign * cni_cross(f->ra, u), sign * v.x, sign * v.y, sign * cni_cross(f->rb, v) };
	return row_of(lever, CNI_ROW_LIMIT, 0, error);
}

/*
 * A rope from anchor a over two points of the world to anchor b: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls
 * and never pushes. Slot: 0.
 */
static int32_t pulley_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = rope_row(j, f, -1.0f, j->p[CNI_P_LENGTH] - pulley_position(j, f));
	return 1;
}

static cni_row pulley_speed(const cni_joint *j, const cni_joint_frame *f)
{
	return rope_row(j, f, 1.0f, 0.0f);
}

/* ---- angles over whole turns: joints/joint_turns.c; slot 0 ---- */

/* angle b = ratio * angle a + phase. */
static int32_t gear_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = row_angular(CNI_ROW_RIGID, 0, 1.0f, f->ratio, f->angle - j->p[CNI_P_GEAR_PHASE]);
	return 1;
}

/*
 * b may turn against a in one direction only, in clicks. The latch is the last click passed, counted from phase; it moves forwards at the
 * end of a step and keeps the angle from falling behind it.
 */
static int32_t ratchet_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	float click = j->p[CNI_P_RATCHET_CLICK], sign = click > 0.0f ? 1.0f : -1.0f;
	rows[0] = row_angular(CNI_ROW_LIMIT, 0, sign, 1.0f, sign * (f->angle - (j->p[CNI_P_RATCHET_PHASE] + click * j->p[CNI_P_RATCHET_LATCH])));
	return 1;
}

/* A torque that pulls angle b - angle a to rest. */
static int32_t rotary_spring_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	rows[0] = row_spring(row_angular(CNI_ROW_DRIVE, 0, 1.0f, 1.0f, f->angle - j->p[CNI_P_REST]), j->p[CNI_P_REST_HERTZ], j->p[CNI_P_REST_DAMPING]);
	return 1;
}

/* Constraint on one body: its angle stays within limits (equal: locked). */
static int32_t angle_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	coordinate c = angle_of(f);
	int32_t locked = j->p[CNI_P_LOWER] == j->p[CNI_P_UPPER];
	rows[0] = locked ? coordinate_row(&c, CNI_ROW_RIGID, 0, 1.0f, c.x - j->p[CNI_P_LOWER]) : limit_row(j, &c, 0);
	return 1;
}

/* ---- the table ---- */

/* The two bodies do not collide. Its axis is 0, and so is the speed along it. */
static int32_t filter_rows(const cni_joint *j, const cni_joint_frame *f, cni_row *rows)
{
	(void)j;
	(void)f;
	(void)rows;
	return 0;
}

const cni_joint_type cni_joint_types[CNI_JOINT_TYPES] = {
	{ cni_joint_revolute_rows, angle_position, angle_speed, CNI_USES_ANGLE | CNI_USES_REFERENCE },
	{ distance_rows, distance_position, distance_speed, 0 },
	{ fixed_rows, angle_position, angle_speed, CNI_USES_ANGLE | CNI_USES_REFERENCE },
	{ prismatic_rows, slide_position, slide_speed, CNI_USES_ANGLE | CNI_USES_REFERENCE },
	{ wheel_rows, slide_position, angle_speed, 0 },
	{ motor_rows, motor_position, angle_speed, CNI_USES_ANGLE | CNI_USES_REFERENCE | CNI_USES_DRIVE },
	{ mouse_rows, distance_position, mouse_speed, CNI_USES_DRIVE },
	{ gear_rows, angle_position, angle_speed, CNI_USES_TURNS | CNI_USES_RATIO },
	{ pulley_rows, pulley_position, pulley_speed, CNI_USES_GROUNDS },
	{ ratchet_rows, angle_position, angle_speed, CNI_USES_TURNS },
	{ rotary_spring_rows, angle_position, angle_speed, CNI_USES_TURNS | CNI_USES_DRIVE },
	{ groove_rows, slide_position, slide_speed, 0 },
	{ filter_rows, angle_position, slide_speed, 0 },
	{ angle_rows, angle_position, angle_speed, CNI_USES_TURNS },
	{ line_rows, slide_position, slide_speed, 0 }
};
