/*
 * stages/contact_solve.c - warm start, soft solve and relax of all contacts: colours in order, blocks of a
 * colour through the widest kernel there is.
 *
 * Within a colour no dynamic body appears twice, so its lanes are independent. In static colours lane body
 * b is read and not written. Contacts in the overflow colour are solved one by one.
 */
#include "base/cpu.h"
#include "stages/contact_pass.h"

#include <string.h>

const cni_contact_kernel *cni_contact_kernel_choose(void)
{
#if CNI_HAS_WIDE_8
	if (cni_cpu_has_avx2())
		return &cni_contact_kernel_8;
#endif
#if CNI_HAS_WIDE_4
	return &cni_contact_kernel_4;
#else
	return &cni_contact_kernel_plain;
#endif
}

static cni_contact_pass pass_make(const cni_solve *s, int32_t one_sided)
{
	cni_contact_pass pass;
	pass.inv_h = s->inv_h;
	pass.push_speed = s->push_speed;
	pass.impact_speed = -s->restitution_threshold;
	pass.warm_scale = s->warm_scale;
	pass.load_part = cni_min(CNI_LOAD_RATE * s->dt, 1.0f);
	pass.load_heavy = s->load_heavy;
	pass.one_sided = one_sided;
	pass.soft = one_sided ? s->contact_static : s->contact;
	return pass;
}

static uint32_t fresh_of(const cn_world *world, const cni_block_info *info)
{
	return info->fresh_step == world->step_count + 1u ? info->fresh : 0;
}

/* Copies one lane between blocks. */
static void lane_copy(const cni_contact_block *from, int32_t from_lane, cni_contact_block *to, int32_t to_lane)
{
	const int32_t rows = (int32_t)(sizeof *from / (CNI_LANES * sizeof(float)));
	int32_t row;
	for (row = 0; row < rows; ++row)
		memcpy((float *)(void *)to + row * CNI_LANES + to_lane, (const float *)(const void *)from + row * CNI_LANES + from_lane, sizeof(float));
}

static void extra_lane_copy(const cni_block_extra *from, int32_t from_lane, cni_block_extra *to, int32_t to_lane)
{
	const int32_t rows = (int32_t)(sizeof *from / (CNI_LANES * sizeof(float)));
	int32_t row;
	if (from == NULL)
		return;
	for (row = 0; row < rows; ++row)
		memcpy((float *)(void *)to + row * CNI_LANES + to_lane, (const float *)(const void *)from + row * CNI_LANES + from_lane, sizeof(float));
}

static cni_block_extra *extra_of(const cn_world *world, int32_t block)
{
	return cni_block_info_at(world, block)->flags & CNI_BLOCK_EXTRA ? cni_block_extra_at(world, block) : NULL;
}

/* One lane at a time, through the plain kernel. */
static void overflow_run(cn_world *world, const cni_solve *s, cni_contact_kernel_fn *run)
{
	cni_motion *motions = cni_motions(world);
	int32_t block, l;
	cni_contact_block one;
	cni_block_extra one_extra;
	memset(&one, 0, sizeof one);
	memset(&one_extra, 0, sizeof one_extra);
	for (block = world->colors[CNI_COLOR_OVERFLOW].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
		cni_contact_block *k = cni_block_at(world, block);
		cni_block_extra *extra = extra_of(world, block);
		uint32_t fresh = fresh_of(world, cni_block_info_at(world, block));
		for (l = 0; l < CNI_LANES && cni_block_info_at(world, block)->contact[l] != CNI_NONE; ++l) {
			cni_contact_pass pass = pass_make(s, motions[k->ib[l]].inv_mass == 0.0f);
			lane_copy(k, l, &one, 0);
			extra_lane_copy(extra, l, &one_extra, 0);
			run(motions, &one, extra != NULL ? &one_extra : NULL, &pass, fresh >> l & 1u, 1);
			lane_copy(&one, 0, k, l);
			extra_lane_copy(extra != NULL ? &one_extra : NULL, 0, extra, l);
		}
	}
}

static void colors_run(cn_world *world, const cni_solve *s, cni_contact_kernel_fn *run)
{
	cni_motion *motions = cni_motions(world);
	int32_t color, block;
	for (color = 0; color < CNI_COLOR_OVERFLOW; ++color) {
		int32_t lanes = world->colors[color].lanes;
		cni_contact_pass pass;
		if (lanes == 0)
			continue;
		pass = pass_make(s, color >= CNI_COLOR_STATIC);
		for (block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			run(motions, cni_block_at(world, block), extra_of(world, block), &pass, fresh_of(world, cni_block_info_at(world, block)), cni_min_i(lanes, CNI_LANES));
			lanes -= CNI_LANES;
		}
	}
}

void cni_contacts_warm_start(cn_world *world, const cni_solve *s)
{
	colors_run(world, s, s->kernel->warm);
	overflow_run(world, s, cni_contact_kernel_plain.warm);
}

void cni_contacts_solve(cn_world *world, const cni_solve *s)
{
	overflow_run(world, s, cni_contact_kernel_plain.solve);
	colors_run(world, s, s->kernel->solve);
}

void cni_contacts_relax(cn_world *world, const cni_solve *s)
{
	overflow_run(world, s, cni_contact_kernel_plain.relax);
	colors_run(world, s, s->kernel->relax);
}
