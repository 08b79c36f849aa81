/*
 * stages/joint_patches.c - which pins make nets, how nets are cut into patches, and the modes of those: see stages/joint_coarse.h.
 *
 * A net is what pins connect that have nearly as many rows, or more, as their bodies have freedoms, and of which some is to what
 * cannot move. It is cut into strips along its longer
 * side, each strip into pieces of as many bodies, and what is not connected in a piece is a patch of its own: in that
 * order the system has a narrow band.
 *
 * Modes of a patch: its bodies are walked along pins from the first; how each moves follows from the first one's velocity and the
 * turning of those on the way. What the other pins allow of these numbers is found row by row (Householder reflections).
 *
 * Reads joint blocks, motion, drive, bodies; writes world->coarse.
 */
#include "base/sort.h"
#include "stages/joint_coarse.h"

#include <string.h>

#define NET_LEAST 64         /* bodies; direct solvers take smaller ones, or passes see them whole */
#define PIECE 25             /* bodies of a patch */
#define UNKNOWNS (CNI_PATCH_BODIES + 2)
#define FREE_PART 2e-3       /* a row this much shorter than it was speaks against nothing that is left */
#define CANCELS 1e-9         /* nor does one as short as this: pins along which the walk went have rows of rounding errors */

typedef struct maker {
	cn_world *world;
	cni_net_pin *pins;       /* all that may be in nets; a and b are dense indices until their net is taken */
	int32_t *first;          /* by dense index: place of its first end among the ends; one more behind the last */
	int32_t *ends;           /* pin << 1 | side; in the end, scratch by mode */
	int32_t *list;           /* bodies of a net by dense index, in order; in the end, the patch of each net body */
	int32_t *label;          /* by dense index: where it is in the piece or the net that is looked at */
	uint64_t *keys;          /* twice as many as bodies */
	uint8_t *seen;           /* by dense index */
	int32_t pin_count;
	/* what is made */
	cni_net_range *nets;
	cni_net_body *bodies;
	cni_net_pin *net_pins;
	cni_patch *patches;
	float *parts;
	cni_coarse head;
} maker;

/* ---- pins and their ends ---- */

/* Free to move and to turn. */
static int32_t may_join(const cn_world *world, int32_t index)
{
	const cni_motion *m = cni_motions(world) + index;
	return m->inv_mass > 0.0f && m->inv_inertia > 0.0f && !(cni_drives(world)[index].flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y));
}

/* Pins to bodies that are no part of any net are left out: a net is then taken for freer than it is. */
static void pin_take(maker *m, int32_t lane)
{
	const cni_joint_block *k = cni_joint_blocks(m->world) + lane / CNI_LANES;
	int32_t l = lane % CNI_LANES, ia = k->ia[l], ib = k->ib[l];
	cni_net_pin *p = &m->pins[m->pin_count];
	if ((ia != 0 && !may_join(m->world, ia)) || (ib != 0 && !may_join(m->world, ib)))
		return;
	p->joint = ((const int32_t *)m->world->awake_joints.data)[k->work[l]];
	p->lane = lane;
	p->a = ia;
	p->b = ib;
	p->arms = cni_coarse_arms(k, l);
	++m->pin_count;
}

static void pins_take(maker *m)
{
	const cn_world *world = m->world;
	int32_t color, index, l;
	for (color = 0; color < CNI_JOINT_COLORS; ++color)
		for (index = world->joint_colors[color].first; index != CNI_NONE; index = cni_joint_blocks(world)[index].next)
			for (l = 0; l < CNI_LANES; ++l)
				if (cni_coarse_takes(&cni_joint_blocks(world)[index], l))
					pin_take(m, index * CNI_LANES + l);
}

static int32_t end_body(const maker *m, int32_t end)
{
	return end & 1 ? m->pins[end >> 1].b : m->pins[end >> 1].a;
}

/* By counting: each body's ends in order. */
static void ends_sort(maker *m)
{
	int32_t k, sum = 0, count = m->world->awake_count;
	memset(m->first, 0, sizeof(int32_t) * (size_t)(count + 1));
	for (k = 0; k < 2 * m->pin_count; ++k)
		++m->first[end_body(m, k)];
	for (k = 0; k <= count; ++k)
		m->first[k] = sum += m->first[k];
	for (k = 2 * m->pin_count - 1; k >= 0; --k)
		m->ends[--m->first[end_body(m, k)]] = k;
}

static int32_t other_of(const maker *m, int32_t end)
{
	return end_body(m, end ^ 1);
}

/* ---- modes of a patch ---- */

/* A connected part of a piece. */
typedef struct part {
	int32_t body[CNI_PATCH_BODIES];             /* dense index */
	int32_t count;
	double to[CNI_PATCH_BODIES][2][UNKNOWNS];   /* velocity of its centre by the unknowns: velocity of the first, turning of each */
	double way[UNKNOWNS][UNKNOWNS];             /* columns: what pins allow, orthonormal */
	double length;                              /* turning is measured in speed at this arm */
	int32_t ways;
} part;

/* row += sign * velocity of the end of a body's arm */
static void arm_speed(const part *p, int32_t body, float x, float y, double sign, double row[2][UNKNOWNS])
{
	int32_t k, unknowns = p->count + 2;
	for (k = 0; k < unknowns; ++k) {
		row[0][k] += sign * p->to[body][0][k];
		row[1][k] += sign * p->to[body][1][k];
	}
	row[0][2 + body] -= sign * (double)y / p->length;
	row[1][2 + body] += sign * (double)x / p->length;
}

static double length_of(const double *row, int32_t count)
{
	double sum = 0.0;
	int32_t k;
	for (k = 0; k < count; ++k)
		sum += row[k] * row[k];
	return cni_sqrt_double(sum);
}

/* Takes out of the ways what the row forbids. */
static void row_forbid(part *p, const double *row)
{
	double along[UNKNOWNS], size, most = length_of(row, p->count + 2), sq;
	int32_t k, i, unknowns = p->count + 2, last = p->ways - 1;
	for (i = 0; i < p->ways; ++i)
		for (along[i] = 0.0, k = 0; k < unknowns; ++k)
			along[i] += row[k] * p->way[k][i];
	size = length_of(along, p->ways);
	if (p->ways == 0 || size <= FREE_PART * most || size <= CANCELS)
		return;
	along[last] += along[last] >= 0.0 ? size : -size;
	for (sq = 0.0, i = 0; i < p->ways; ++i)
		sq += along[i] * along[i];
	for (k = 0; k < unknowns; ++k) {
		double sum = 0.0;
		for (i = 0; i < p->ways; ++i)
			sum += p->way[k][i] * along[i];
		sum *= 2.0 / sq;
		for (i = 0; i < p->ways; ++i)
			p->way[k][i] -= sum * along[i];
	}
	--p->ways;
}

static void pin_forbid(part *p, const cni_net_pin *pin, int32_t a, int32_t b)
{
	double row[2][UNKNOWNS];
	memset(row, 0, sizeof row);
	if (a != CNI_NONE)
		arm_speed(p, a, pin->arms.ax, pin->arms.ay, -1.0, row);
	if (b != CNI_NONE)
		arm_speed(p, b, pin->arms.bx, pin->arms.by, 1.0, row);
	row_forbid(p, row[0]);
	row_forbid(p, row[1]);
}

/* Place in the part, or CNI_NONE. Labels of the piece count from 1 where a body waits, and from -1 down where it has its place. */
static int32_t place_of(const maker *m, int32_t index)
{
	return m->label[index] < 0 ? -1 - m->label[index] : CNI_NONE;
}

static void body_place(maker *m, part *p, int32_t index)
{
	m->label[index] = -1 - p->count;
	p->body[p->count++] = index;
}

/* All bodies of the piece that pins connect with the first. */
static void part_walk(maker *m, part *p, int32_t index)
{
	int32_t k, e;
	float arms = 0.0f;
	p->count = 0;
	body_place(m, p, index);
	for (k = 0; k < p->count; ++k)
		for (e = m->first[p->body[k]]; e < m->first[p->body[k] + 1]; ++e) {
			const cni_net_pin *pin = &m->pins[m->ends[e] >> 1];
			int32_t other = other_of(m, m->ends[e]);
			arms = cni_max(arms, m->ends[e] & 1 ? cni_abs(pin->arms.bx) + cni_abs(pin->arms.by) : cni_abs(pin->arms.ax) + cni_abs(pin->arms.ay));
			if (other != 0 && m->label[other] > 0)
				body_place(m, p, other);
		}
	p->length = arms > 0.0f ? (double)arms : 1.0;
}

/* How the bodies of the part move by the unknowns, each by a pin to one before it. */
static void part_lead(const maker *m, part *p)
{
	int32_t k, e;
	memset(p->to, 0, sizeof p->to);
	p->to[0][0][0] = p->to[0][1][1] = 1.0;
	for (k = 1; k < p->count; ++k)
		for (e = m->first[p->body[k]]; e < m->first[p->body[k] + 1]; ++e) {
			const cni_net_pin *pin = &m->pins[m->ends[e] >> 1];
			int32_t is_b = m->ends[e] & 1, other = other_of(m, m->ends[e]), before = other == 0 ? CNI_NONE : place_of(m, other);
			if (before == CNI_NONE || before >= k)
				continue;
			arm_speed(p, before, is_b ? pin->arms.ax : pin->arms.bx, is_b ? pin->arms.ay : pin->arms.by, 1.0, p->to[k]);
			p->to[k][0][2 + k] += (double)(is_b ? pin->arms.by : pin->arms.ay) / p->length;
			p->to[k][1][2 + k] -= (double)(is_b ? pin->arms.bx : pin->arms.ax) / p->length;
			break;
		}
}

static void part_free(const maker *m, part *p)
{
	int32_t k, e;
	memset(p->way, 0, sizeof p->way);
	p->ways = p->count + 2;
	for (k = 0; k < p->ways; ++k)
		p->way[k][k] = 1.0;
	for (k = 0; k < p->count; ++k)
		for (e = m->first[p->body[k]]; e < m->first[p->body[k] + 1]; ++e) {
			int32_t other = other_of(m, m->ends[e]), is_b = m->ends[e] & 1, place = other == 0 ? CNI_NONE : place_of(m, other);
			if (other != 0 && (place == CNI_NONE || !is_b))
				continue; /* to another patch; or seen from the other side */
			pin_forbid(p, &m->pins[m->ends[e] >> 1], is_b ? place : k, is_b ? k : place);
		}
}

/* Parts of the modes, orthonormal in the masses (Gram and Schmidt). */
static void part_modes(maker *m, const part *p, cni_patch *patch)
{
	double mode[CNI_PATCH_MODES][3 * CNI_PATCH_BODIES], weight[3 * CNI_PATCH_BODIES];
	int32_t i, j, k, n, unknowns = p->count + 2;
	for (k = 0; k < p->count; ++k) {
		const cni_motion *motion = cni_motions(m->world) + p->body[k];
		weight[3 * k] = weight[3 * k + 1] = 1.0 / (double)motion->inv_mass;
		weight[3 * k + 2] = 1.0 / (double)motion->inv_inertia;
	}
	for (i = 0; i < p->ways; ++i) {
		double sq = 0.0;
		for (k = 0; k < p->count; ++k) {
			mode[i][3 * k] = mode[i][3 * k + 1] = 0.0;
			for (n = 0; n < unknowns; ++n) {
				mode[i][3 * k] += p->to[k][0][n] * p->way[n][i];
				mode[i][3 * k + 1] += p->to[k][1][n] * p->way[n][i];
			}
			mode[i][3 * k + 2] = p->way[2 + k][i] / p->length;
		}
		for (j = 0; j < i; ++j) {
			double along = 0.0;
			for (n = 0; n < 3 * p->count; ++n)
				along += weight[n] * mode[i][n] * mode[j][n];
			for (n = 0; n < 3 * p->count; ++n)
				mode[i][n] -= along * mode[j][n];
		}
		for (n = 0; n < 3 * p->count; ++n)
			sq += weight[n] * mode[i][n] * mode[i][n];
		sq = 1.0 / cni_sqrt_double(sq);
		for (n = 0; n < 3 * p->count; ++n)
			mode[i][n] *= sq;
	}
	for (k = 0; k < p->count; ++k)
		for (i = 0; i < p->ways; ++i)
			for (n = 0; n < 3; ++n)
				m->parts[patch->part + 3 * (k * p->ways + i) + n] = (float)mode[i][3 * k + n];
}

/* 0: it has more freedom than a net's patch. */
static int32_t part_take(maker *m, const part *p)
{
	cni_patch *patch = &m->patches[m->head.patch_count];
	int32_t k;
	if (p->ways > CNI_PATCH_MODES)
		return 0;
	patch->body_begin = m->head.body_count;
	patch->body_end = m->head.body_count + p->count;
	patch->modes = p->ways;
	patch->mode = m->head.mode_count;
	patch->part = (int32_t)m->head.part_count;
	for (k = 0; k < p->count; ++k) {
		const cni_motion *motion = cni_motions(m->world) + p->body[k];
		cni_net_body *b = &m->bodies[m->head.body_count++];
		b->index = p->body[k];
		b->body = cni_awake_ids(m->world)[p->body[k]];
		b->inv_mass = motion->inv_mass;
		b->inv_inertia = motion->inv_inertia;
	}
	part_modes(m, p, patch);
	m->head.part_count += 3 * p->count * p->ways;
	m->head.mode_count += p->ways;
	++m->head.patch_count;
	return 1;
}

/* 0: this is no net. */
static int32_t piece_take(maker *m, const int32_t *list, int32_t count)
{
	part p;
	int32_t k, i, fits = 1;
	for (k = 0; k < count; ++k)
		m->label[list[k]] = 1;
	for (k = 0; k < count && fits; ++k) {
		if (m->label[list[k]] <= 0)
			continue;
		part_walk(m, &p, list[k]);
		part_lead(m, &p);
		part_free(m, &p);
		fits = part_take(m, &p);
		for (i = 0; i < p.count; ++i)
			m->label[p.body[i]] = 0;
	}
	for (k = 0; k < count; ++k)
		m->label[list[k]] = 0;
	return fits;
}

/* ---- nets ---- */

static float place_along(const maker *m, int32_t index, int32_t axis)
{
	const cni_body *b = cni_body_at(m->world, cni_awake_ids(m->world)[index]);
	return axis ? b->cy : b->cx;
}

static void sort_along(maker *m, int32_t *list, int32_t count, int32_t axis)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		m->keys[k] = (uint64_t)cni_sort_float_key(place_along(m, list[k], axis)) << 32 | (uint32_t)list[k];
	cni_sort_keys(m->keys, m->keys + count, count);
	for (k = 0; k < count; ++k)
		list[k] = (int32_t)(m->keys[k] & 0xffffffffu);
}

static float extent_along(const maker *m, const int32_t *list, int32_t count, int32_t axis)
{
	float least = FLT_MAX, most = -FLT_MAX;
	int32_t k;
	for (k = 0; k < count; ++k) {
		least = cni_min(least, place_along(m, list[k], axis));
		most = cni_max(most, place_along(m, list[k], axis));
	}
	return most - least;
}

/* Where the k-th of so many equal shares begins. */
static int32_t share(int32_t count, int32_t k, int32_t shares)
{
	return (int32_t)((int64_t)count * k / shares);
}

/* 0: a patch has too much freedom. */
static int32_t net_cut(maker *m, int32_t *list, int32_t count)
{
	float width = extent_along(m, list, count, 0), height = extent_along(m, list, count, 1);
	int32_t axis = height > width, strips, k, i;
	float slender = cni_max(width, height) / cni_max(cni_min(width, height), 1e-6f * cni_max(width, height) + FLT_MIN);
	strips = cni_min_i(cni_max_i((int32_t)cni_sqrt(cni_min((float)count / (float)PIECE * slender, 1e12f)), 1), (count + PIECE - 1) / PIECE);
	sort_along(m, list, count, axis);
	for (k = 0; k < strips; ++k) {
		int32_t begin = share(count, k, strips), length = share(count, k + 1, strips) - begin, pieces = cni_max_i(1, (length + PIECE / 2) / PIECE);
		pieces = cni_max_i(pieces, (length + CNI_PATCH_BODIES - 1) / CNI_PATCH_BODIES);
		sort_along(m, list + begin, length, !axis);
		for (i = 0; i < pieces; ++i) {
			int32_t from = share(length, i, pieces);
			if (!piece_take(m, list + begin + from, share(length, i + 1, pieces) - from))
				return 0;
		}
	}
	return 1;
}

/* Pins of the net in the order of its bodies, each once; m->label is 1 + the net body of what is in the net. */
static void net_pins_take(maker *m, cni_net_range *net)
{
	int32_t k, e;
	for (k = net->body_begin; k < net->body_end; ++k)
		m->label[m->bodies[k].index] = 1 + k;
	for (k = net->body_begin; k < net->body_end; ++k) {
		int32_t index = m->bodies[k].index;
		for (e = m->first[index]; e < m->first[index + 1]; ++e) {
			const cni_net_pin *pin = &m->pins[m->ends[e] >> 1];
			cni_net_pin *to = &m->net_pins[m->head.pin_count];
			if (!(m->ends[e] & 1) && pin->b != 0)
				continue;
			*to = *pin;
			to->a = m->label[pin->a] - 1; /* CNI_NONE for index 0 */
			to->b = m->label[pin->b] - 1;
			net->ends += (to->a != CNI_NONE) + (to->b != CNI_NONE);
			++m->head.pin_count;
		}
	}
	for (k = net->body_begin; k < net->body_end; ++k)
		m->label[m->bodies[k].index] = 0;
}

/* Ends of pins on the bodies, doubled where the other is fixed: two for each pin. */
static int32_t ends_count(const maker *m, const int32_t *list, int32_t count)
{
	int32_t k, e, ends = 0;
	for (k = 0; k < count; ++k)
		for (e = m->first[list[k]]; e < m->first[list[k] + 1]; ++e)
			ends += other_of(m, m->ends[e]) == 0 ? 2 : 1;
	return ends;
}

/* Is some pin to what cannot move? */
static int32_t is_held(const maker *m, const int32_t *list, int32_t count)
{
	int32_t k, e;
	for (k = 0; k < count; ++k)
		for (e = m->first[list[k]]; e < m->first[list[k] + 1]; ++e)
			if (other_of(m, m->ends[e]) == 0)
				return 1;
	return 0;
}

/* The list holds what pins connect. */
static void net_take(maker *m, int32_t *list, int32_t count)
{
	cni_coarse before = m->head;
	cni_net_range *net = &m->nets[m->head.net_count];
	/* 2 rows a pin, 3 freedoms a body; a tenth less will do, since a net has a rim */
	if (count < NET_LEAST || 10 * (int64_t)ends_count(m, list, count) < 27 * (int64_t)count || !is_held(m, list, count))
		return;
	memset(net, 0, sizeof *net);
	net->body_begin = before.body_count;
	net->pin_begin = before.pin_count;
	net->patch_begin = before.patch_count;
	net->mode_begin = before.mode_count;
	if (!net_cut(m, list, count)) {
		m->head = before;
		return;
	}
	net->body_end = m->head.body_count;
	net->patch_end = m->head.patch_count;
	net->mode_end = m->head.mode_count;
	net_pins_take(m, net);
	net->pin_end = m->head.pin_count;
	++m->head.net_count;
}

/* Each body that has pins is in one list. */
static void nets_take(maker *m)
{
	int32_t index, count = m->world->awake_count, k, e;
	memset(m->seen, 0, (size_t)count);
	m->seen[0] = 1;
	for (index = 1; index < count; ++index) {
		int32_t found = 0;
		if (m->seen[index] || m->first[index] == m->first[index + 1])
			continue;
		m->seen[index] = 1;
		m->list[found++] = index;
		for (k = 0; k < found; ++k)
			for (e = m->first[m->list[k]]; e < m->first[m->list[k] + 1]; ++e) {
				int32_t other = other_of(m, m->ends[e]);
				if (m->seen[other])
					continue;
				m->seen[other] = 1;
				m->list[found++] = other;
			}
		net_take(m, m->list, found);
	}
}

/* ---- all of it ---- */

/* From scratch to what is kept. 0: no memory. */
static int32_t keep(maker *m)
{
	cn_world *world = m->world;
	cni_coarse_view v = { &m->head, m->nets, m->bodies, m->net_pins, m->patches, NULL, NULL, m->parts }, sizes;
	cni_coarse_system_size(&v, m->list);
	if (!cni_array_reserve_exact(&world->coarse, &world->memory, (int32_t)(cni_coarse_lay_out(&sizes, &m->head, NULL) / CNI_COARSE_BYTES)))
		return 0;
	*(cni_coarse *)world->coarse.data = m->head;
	world->coarse.count = 1;
	v = cni_coarse_view_of(world);
	memcpy(v.nets, m->nets, sizeof(cni_net_range) * (size_t)m->head.net_count);
	memcpy(v.bodies, m->bodies, sizeof(cni_net_body) * (size_t)m->head.body_count);
	memcpy(v.pins, m->net_pins, sizeof(cni_net_pin) * (size_t)m->head.pin_count);
	memcpy(v.patches, m->patches, sizeof(cni_patch) * (size_t)m->head.patch_count);
	memcpy(v.parts, m->parts, sizeof(float) * (size_t)m->head.part_count);
	cni_coarse_system_make(&v, m->list, m->ends);
	return 1;
}

/* Returns how many bytes it takes; scratch NULL: only that. */
static uint64_t maker_carve(maker *m, uint8_t *scratch, uint64_t pins, uint64_t bodies)
{
	uint64_t at = 0, ends = 2 * pins > CNI_PATCH_MODES * bodies ? 2 * pins : CNI_PATCH_MODES * bodies;
	m->pins = (cni_net_pin *)cni_coarse_piece(scratch, &at, sizeof(cni_net_pin) * pins);
	m->net_pins = (cni_net_pin *)cni_coarse_piece(scratch, &at, sizeof(cni_net_pin) * pins);
	m->first = (int32_t *)cni_coarse_piece(scratch, &at, sizeof(int32_t) * (bodies + 1));
	m->ends = (int32_t *)cni_coarse_piece(scratch, &at, sizeof(int32_t) * ends);
	m->list = (int32_t *)cni_coarse_piece(scratch, &at, sizeof(int32_t) * bodies);
	m->label = (int32_t *)cni_coarse_piece(scratch, &at, sizeof(int32_t) * bodies);
	m->keys = (uint64_t *)cni_coarse_piece(scratch, &at, 2 * sizeof(uint64_t) * bodies);
	m->seen = (uint8_t *)cni_coarse_piece(scratch, &at, bodies);
	m->nets = (cni_net_range *)cni_coarse_piece(scratch, &at, sizeof(cni_net_range) * (bodies / NET_LEAST + 1));
	m->bodies = (cni_net_body *)cni_coarse_piece(scratch, &at, sizeof(cni_net_body) * bodies);
	m->patches = (cni_patch *)cni_coarse_piece(scratch, &at, sizeof(cni_patch) * bodies);
	m->parts = (float *)cni_coarse_piece(scratch, &at, 3 * CNI_PATCH_MODES * sizeof(float) * bodies);
	return at;
}

int32_t cni_coarse_make(cn_world *world, int32_t lanes)
{
	maker m;
	uint8_t *scratch;
	int32_t kept;
	memset(&m, 0, sizeof m);
	m.world = world;
	scratch = (uint8_t *)cni_arena_push_once(&world->arena, maker_carve(&m, NULL, (uint64_t)lanes, (uint64_t)world->awake_count));
	if (scratch == NULL)
		return 0;
	(void)maker_carve(&m, scratch, (uint64_t)lanes, (uint64_t)world->awake_count);
	memset(m.label, 0, sizeof(int32_t) * (size_t)world->awake_count);
	pins_take(&m);
	ends_sort(&m);
	nets_take(&m);
	kept = keep(&m);
	(void)cni_arena_pop(&world->arena, scratch);
	return kept;
}
