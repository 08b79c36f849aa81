/*
 * save/file.c - cn_world_write and cn_world_read: the header, its checks, and the world that is read (picture in file.h).
 *
 * A world is read into a new one: from the file's settings, with the memory, workers and capacities of the caller's definition.
 * When anything is wrong it is destroyed, and nothing has happened.
 */
#include "world/error.h"
#include "save/file.h"

#include <string.h>

#define VERSION 1u
#define HEADER_BYTES 32u
static const uint8_t magic[8] = { 'C', 'a', 'i', 'r', 'n', 'W', 'l', 'd' };

/* ---- writing ---- */

cn_result cn_world_write_size(const cn_world *world, uint64_t *out_bytes)
{
	cni_call call = cni_enter_const(world);
	cni_file f = cni_file_begin(CNI_FILE_MEASURE, NULL);
	cni_check_pointer(&call, "out_bytes", out_bytes);
	cni_check_boundary(&call, world);
	if (call.result != CN_OK)
		return call.result;
	cni_file_world((cn_world *)(uintptr_t)world, &f); /* which only reads */
	*out_bytes = HEADER_BYTES + f.bytes;
	return CN_OK;
}

cn_result cn_world_write(const cn_world *world, void *out, uint64_t capacity, uint64_t *out_bytes)
{
	uint8_t *to = (uint8_t *)out;
	uint64_t bytes;
	cn_result sized = out != NULL ? cn_world_write_size(world, &bytes) : CN_ERROR_ARGUMENT;
	if (sized != CN_OK || capacity < bytes)
		return sized != CN_OK ? sized : CN_ERROR_CAPACITY;
	cni_file f = cni_file_begin(CNI_FILE_WRITE, to + HEADER_BYTES);
	cni_file_world((cn_world *)(uintptr_t)world, &f);
	memcpy(to, magic, sizeof magic);
	cni_file_put(to + 8, VERSION, 4);
	cni_file_put(to + 12, 0, 4);
	cni_file_put(to + 16, bytes, 8);
	cni_file_put(to + 24, cni_file_checksum(to + HEADER_BYTES, f.bytes), 8);
	if (out_bytes != NULL)
		*out_bytes = bytes;
	return CN_OK;
}

/* ---- reading ---- */

static int32_t header_is_good(const uint8_t *file, uint64_t bytes)
{
	return bytes >= HEADER_BYTES && memcmp(file, magic, sizeof magic) == 0 && cni_file_get(file + 8, 4) == VERSION && cni_file_get(file + 12, 4) == 0 &&
	       cni_file_get(file + 16, 8) == bytes && cni_file_get(file + 24, 8) == cni_file_checksum(file + HEADER_BYTES, bytes - HEADER_BYTES);
}

static void def_take_settings(cn_world_def *def, const cni_settings *s)
{
	def->gravity_mps2 = s->gravity;
	def->length_unit_m = s->length_unit;
	def->solver = s->solver;
	def->broadphase = s->broadphase;
	def->substep_count = s->substeps;
	def->flags = s->flags;
	def->restitution_threshold_mps = s->restitution_threshold;
	def->hit_speed_mps = s->hit_speed;
	def->push_speed_max_mps = s->push_speed_max;
	def->linear_speed_max_mps = s->linear_speed_max;
	def->angular_speed_max_radps = s->angular_speed_max;
	def->sleep_speed_mps = s->sleep_speed;
	def->sleep_delay_s = s->sleep_delay;
	def->accuracy_m = s->accuracy;
	def->work_budget = s->work_budget == 0 ? CN_DEFAULT : s->work_budget;
}

/* The settings of a file are those of a definition, which then makes the same settings again. */
static int32_t settings_are_good(const cni_settings *s)
{
	cn_world_def def;
	cn_world_def_init(&def);
	def_take_settings(&def, s);
	return cn_world_def_check(&def, NULL, 0) == CN_OK;
}

static void world_fill(cn_world *world, cni_file *f)
{
	cni_file_world(world, f);
	cni_file_boxes(world, f);
	if (f->result == CN_OK)
		cni_file_need(f, cni_file_world_holds(world), CN_ERROR_FORMAT);
	cni_file_contacts(world, f);
	cni_file_broadphase(world, f);
	if (f->result == CN_OK)
		cni_file_need(f, cn_world_validate(world, NULL, 0) == CN_OK, CN_ERROR_FORMAT);
}

cn_result cn_world_read(const cn_world_def *def, const void *file, uint64_t bytes, cn_world **out_world)
{
	cni_call call = cni_enter_free();
	cni_settings settings;
	cn_world_def own;
	cn_world *world = NULL;
	cni_check_pointer(&call, "file", file);
	cni_check_pointer(&call, "out_world", out_world);
	cn_world_def_init(&own);
	if (def != NULL && cni_check_def(&call, def, sizeof *def, "cn_world_def_init"))
		own = *def;
	if (call.result != CN_OK)
		return call.result;
	if (!header_is_good((const uint8_t *)file, bytes))
		return CN_ERROR_FORMAT;
	cni_file f = cni_file_read((const uint8_t *)file + HEADER_BYTES, bytes - HEADER_BYTES);
	memset(&settings, 0, sizeof settings);
	cni_file_settings(&f, &settings);
	if (f.result != CN_OK || !settings_are_good(&settings))
		return CN_ERROR_FORMAT;
	def_take_settings(&own, &settings);
	cn_result created = cn_world_create(&own, &world);
	if (created != CN_OK)
		return created;
	world_fill(world, &f);
	if (f.result == CN_OK)
		*out_world = world;
	else
		cn_world_destroy(world);
	return f.result;
}
