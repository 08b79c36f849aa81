/*
 * bindings/record/environment.c - recording without a change of the program, for record/libcairn.so (library.sh): each world is recorded
 * from its creation, the first into the file that CAIRN_RECORD names, the second into that name with ".2", and so on. Without
 * CAIRN_RECORD nothing is recorded. The files end with the worlds, or with the program.
 */
#include "record/record.h"

#include <stdlib.h>

cn_result cnr_world_create(const cn_world_def *def, cn_world **out_world);
cn_result cnr_world_read(const cn_world_def *def, const void *bytes, uint64_t count, cn_world **out_world);

static void record_from_now(cn_world *world)
{
	static int32_t worlds;
	const char *name = getenv("CAIRN_RECORD");
	char path[512];
	FILE *file;
	if (name == NULL || name[0] == '\0')
		return;
	++worlds;
	if (worlds > 1)
		snprintf(path, sizeof path, "%s.%d", name, (int)worlds);
	else
		snprintf(path, sizeof path, "%s", name);
	file = fopen(path, "wb");
	if (file != NULL && record_begin(world, NULL, record_to_file, file))
		return;
	fprintf(stderr, "cairn: cannot record into %s\n", path);
	if (file != NULL) {
		(void)fclose(file);
		(void)remove(path);
	}
}

cn_result cnr_world_create(const cn_world_def *def, cn_world **out_world)
{
	cn_result result = cn_world_create(def, out_world);
	if (result == CN_OK)
		record_from_now(*out_world);
	return result;
}

cn_result cnr_world_read(const cn_world_def *def, const void *bytes, uint64_t count, cn_world **out_world)
{
	cn_result result = cn_world_read(def, bytes, count, out_world);
	if (result == CN_OK)
		record_from_now(*out_world);
	return result;
}
