/*
 * test/save/file_hostile_test.c - cn_world_read refuses what is no written world, whatever the bytes say: shortened, changed, and changed
 * with a checksum that fits. What passes the checks is a world that can be stepped, asked and destroyed (under the sanitizers of
 * test/variants.sh, which see what is read outside).
 */
#include "files.h"

#include "world/memory_session.h"
#include "save/file.h"

#define HEADER 32

static void checksum_fit(saved *f)
{
	uint8_t *bytes = (uint8_t *)f->data;
	cni_file_put(bytes + 16, f->bytes, 8);
	cni_file_put(bytes + 24, cni_file_checksum(bytes + HEADER, f->bytes - HEADER), 8);
}

static saved copy_of(const saved *f, uint64_t bytes)
{
	saved copy;
	copy.bytes = bytes;
	copy.data = malloc((size_t)bytes + 1);
	if (copy.data == NULL)
		exit(2);
	memcpy(copy.data, f->data, (size_t)(bytes < f->bytes ? bytes : f->bytes));
	return copy;
}

static cn_result read_result(const saved *f, cn_world **world)
{
	*world = NULL;
	return cn_world_read(NULL, f->data, f->bytes, world);
}

static int32_t is_refused(const saved *f)
{
	cn_world *world;
	cn_result result = read_result(f, &world);
	cn_world_destroy(world);
	return result == CN_ERROR_FORMAT && world == NULL;
}

static saved zoo_file(void)
{
	cn_world *world = zoo_world();
	saved f = write_world(world);
	cn_world_destroy(world);
	return f;
}

/* In a piece of exactly its length, so that a sanitizer sees each byte that is read behind it. */
static void t_every_shortened_file_is_refused(void)
{
	saved f = zoo_file();
	int32_t refused = 0, fitted = 0, k;
	for (k = 0; k < (int32_t)f.bytes; ++k) {
		saved part = copy_of(&f, (uint64_t)k);
		part.data = realloc(part.data, (size_t)(k > 0 ? k : 1));
		refused += is_refused(&part);
		if (k >= HEADER) {
			checksum_fit(&part);
			fitted += is_refused(&part);
		}
		saved_free(&part);
	}
	printf("  %d of %d lengths refused, %d with a fitting checksum\n", (int)refused, (int)f.bytes, (int)fitted);
	CHECK(refused == (int32_t)f.bytes && fitted == (int32_t)f.bytes - HEADER);
	saved_free(&f);
}

static void t_every_changed_byte_is_refused(void)
{
	saved f = zoo_file();
	uint8_t *bytes = (uint8_t *)f.data;
	int32_t refused = 0, k;
	for (k = 0; k < (int32_t)f.bytes; ++k) {
		uint8_t change = (uint8_t)(1u << k % 8);
		bytes[k] ^= change;
		refused += is_refused(&f);
		bytes[k] ^= change;
	}
	printf("  %d of %d refused\n", (int)refused, (int)f.bytes);
	CHECK(refused == (int32_t)f.bytes);
	CHECK(!is_refused(&f));
	saved_free(&f);
}

/* ---- a checksum that fits ---- */

static uint32_t noise = 1u;

static uint32_t noise_next(void)
{
	noise ^= noise << 13;
	noise ^= noise >> 17;
	noise ^= noise << 5;
	return noise;
}

/* Bits, words of special meaning, words from elsewhere in the file. */
static void mutate(saved *f)
{
	static const uint32_t special[] = { 0, 1, 0xFFFFFFFFu, 0x7FFFFFFFu, 0x80000000u, 0x7FC00000u, 0x7F800000u, 2, 15, 16, 31, 1u << 20, 1u << 30 };
	uint8_t *bytes = (uint8_t *)f->data;
	uint32_t size = (uint32_t)f->bytes - HEADER - 4u, at = HEADER + noise_next() % size, from = HEADER + noise_next() % size;
	switch (noise_next() % 4u) {
	case 0: bytes[at] ^= (uint8_t)(1u << noise_next() % 8u); break;
	case 1: cni_file_put(bytes + (at & ~3u), special[noise_next() % 13u], 4); break;
	case 2: memmove(bytes + (at & ~3u), bytes + (from & ~3u), 4); break;
	default: cni_file_put(bytes + (at & ~3u), cni_file_get(bytes + (at & ~3u), 4) + (noise_next() % 7u - 3u), 4); break;
	}
}

/* Everything that may be asked of a world that was read. */
static void world_use(cn_world *world)
{
	const cn_body_moved *moved;
	cn_aabb everywhere = { { -100.0f, -100.0f }, { 100.0f, 100.0f } };
	cn_shape shapes[16];
	cn_body bodies[64];
	int32_t count, k;
	uint64_t hash;
	saved f;
	(void)digest_contact_events(0, world);
	must(cn_world_moved(world, &moved, &count), world, "cn_world_moved");
	for (k = 0; k < 4; ++k)
		(void)cn_world_step(world, FRAME_S);
	(void)cn_world_overlap_aabb(world, &everywhere, NULL, shapes, 16, &count);
	(void)digest_contact_events(0, world);
	(void)cn_world_hash(world, &hash);
	f = write_world(world);
	saved_free(&f);
	if (cn_world_get_bodies(world, bodies, 64, &count) == CN_OK)
		for (k = 0; k < count && k < 64; ++k)
			(void)cn_body_destroy(world, bodies[k]);
	(void)cn_world_step(world, FRAME_S);
}

/* The records of a chunk, and their bytes and number. */
static uint8_t *records_of(const saved *f, const char *tag, uint32_t *stride, int32_t *count)
{
	uint8_t *at = (uint8_t *)f->data + HEADER;
	while (memcmp(at, tag, 4) != 0)
		at += 16 + cni_file_get(at + 4, 4) * cni_file_get(at + 8, 8);
	*stride = (uint32_t)cni_file_get(at + 4, 4);
	*count = (int32_t)cni_file_get(at + 8, 8);
	return at + 16;
}

/* Is the file refused with this word changed? */
static int32_t refused_with(saved *f, uint8_t *place, uint64_t word)
{
	uint64_t was = cni_file_get(place, 4);
	int32_t refused;
	cni_file_put(place, word, 4);
	checksum_fit(f);
	refused = is_refused(f);
	cni_file_put(place, was, 4);
	return refused;
}

/* A body's extent and turn reach must span its shapes, and boxes contain them: later steps trust both without looking again. */
static void t_bodies_smaller_than_their_shapes_are_refused(void)
{
	saved f = zoo_file();
	uint32_t stride;
	int32_t bodies, proxies, k, tried[3] = { 0, 0, 0 }, refused[3] = { 0, 0, 0 };
	uint8_t *at = records_of(&f, "BODY", &stride, &bodies);
	for (k = 0; k < bodies; ++k, at += stride) {
		uint64_t kinds = cni_file_get(at + 44, 4); /* type, turn reach, room */
		if ((kinds & 0xFFu) == CN_BODY_STATIC)
			continue;
		++tried[0];
		refused[0] += refused_with(&f, at + 32, 0x3C23D70Au); /* extent: 0.01 */
		if ((kinds & 0xFF00u) == 0)
			continue; /* a wheel */
		++tried[1];
		refused[1] += refused_with(&f, at + 44, kinds & ~(uint64_t)0xFF00u);
	}
	at = records_of(&f, "PROX", &stride, &proxies);
	for (k = 0; k < proxies; ++k, at += stride)
		if (cni_file_get(at + 36, 4) & CNI_PROXY_ALIVE) {
			++tried[2];
			refused[2] += refused_with(&f, at + 8, cni_file_get(at, 4)); /* no width */
		}
	printf("  refused: %d of %d small extents, %d of %d turn reaches, %d of %d boxes\n", (int)refused[0], (int)tried[0], (int)refused[1], (int)tried[1], (int)refused[2], (int)tried[2]);
	for (k = 0; k < 3; ++k)
		CHECK(tried[k] > 0 && refused[k] == tried[k]);
	saved_free(&f);
}

/* Every other shape, the dead one too, at the head of a body's list. */
static void t_lists_of_other_shapes_are_refused(void)
{
	saved f = zoo_file();
	uint32_t stride;
	int32_t bodies, shapes, k, slot, tried = 0, refused = 0;
	uint8_t *at;
	(void)records_of(&f, "SHAP", &stride, &shapes);
	at = records_of(&f, "BODY", &stride, &bodies);
	for (k = 0; k < bodies; ++k, at += stride)
		for (slot = -1; slot <= shapes; ++slot)
			if (cni_file_get(at + 16, 8) != 0 && slot != (int32_t)cni_file_get(at + 108, 4)) { /* a living body has a rotation */
				++tried;
				refused += refused_with(&f, at + 108, (uint32_t)slot);
			}
	printf("  refused: %d of %d\n", (int)refused, (int)tried);
	CHECK(tried > 10 && refused == tried);
	saved_free(&f);
}

/* Passes over blocks read the rows of lanes without a contact, too. */
static void t_rows_of_lanes_without_a_contact_are_refused(void)
{
	saved f = zoo_file();
	uint32_t stride, info_stride;
	int32_t blocks, infos, k, word, tried = 0, refused = 0;
	uint8_t *at = records_of(&f, "BLOK", &stride, &blocks), *info = records_of(&f, "INFO", &info_stride, &infos);
	for (k = 0; k < blocks; ++k)
		for (word = 0; word < (int32_t)stride / 4; ++word)
			if (cni_file_get(info + (uint32_t)k * info_stride + 4 * (word % CNI_LANES), 4) == 0xFFFFFFFFu) {
				++tried;
				refused += refused_with(&f, at + (uint32_t)k * stride + 4 * word, 0xBF800000u); /* -1 */
			}
	printf("  refused: %d of %d\n", (int)refused, (int)tried);
	CHECK((tried > 10 || CNI_LANES == 1) && refused == tried);
	saved_free(&f);
}

#define MUTATIONS TEST_SAMPLES(2500)

static void t_forged_files_do_no_harm(void)
{
	saved f = zoo_file();
	int32_t refused = 0, accepted = 0, other = 0, k, n;
	for (k = 0; k < MUTATIONS; ++k) {
		saved forged = copy_of(&f, f.bytes);
		cn_world *world;
		cn_result result;
		for (n = (int32_t)(noise_next() % 3u); n >= 0; --n)
			mutate(&forged);
		checksum_fit(&forged);
		result = read_result(&forged, &world);
		refused += result == CN_ERROR_FORMAT;
		accepted += result == CN_OK;
		other += result != CN_OK && result != CN_ERROR_FORMAT;
		if (result == CN_OK) {
			world_use(world);
			cn_world_destroy(world);
		}
		saved_free(&forged);
	}
	printf("  %d forged: %d refused, %d read, %d other\n", MUTATIONS, (int)refused, (int)accepted, (int)other);
	CHECK(other == 0 && refused > MUTATIONS / 10 && accepted > MUTATIONS / 10);
	saved_free(&f);
}

/* ---- later versions ---- */

/* Puts a chunk of another kind in front, and bytes behind each record of one chunk. */
static saved later_file(const saved *f, const char *longer)
{
	saved later = copy_of(f, f->bytes + (1u << 16));
	uint8_t *to = (uint8_t *)later.data + HEADER;
	const uint8_t *from = (const uint8_t *)f->data + HEADER, *end = (const uint8_t *)f->data + f->bytes;
	memcpy(to, "NEW!", 4);
	cni_file_put(to + 4, 3, 4);
	cni_file_put(to + 8, 5, 8);
	to += 16 + 15;
	while (from < end) {
		uint32_t record = (uint32_t)cni_file_get(from + 4, 4), count = (uint32_t)cni_file_get(from + 8, 8), more = memcmp(from, longer, 4) == 0 ? 12u : 0u, k;
		memcpy(to, from, 16);
		cni_file_put(to + 4, record + more, 4);
		to += 16;
		for (k = 0; k < count; ++k) {
			memcpy(to, from + 16 + (size_t)k * record, record);
			to += record + more;
		}
		from += 16 + (size_t)record * count;
	}
	later.bytes = (uint64_t)(to - (uint8_t *)later.data);
	checksum_fit(&later);
	return later;
}

static void t_later_versions_may_add_chunks_and_fields(void)
{
	static const char *const chunks[] = { "BODY", "JOIN", "CONT", "ISLA", "WRLD", "SHAP", "INFO" };
	saved f = zoo_file();
	size_t k;
	for (k = 0; k < sizeof chunks / sizeof chunks[0]; ++k) {
		saved later = later_file(&f, chunks[k]);
		cn_world *world = read_world(&later);
		CHECK(writes_the_same(world, &f));
		cn_world_destroy(world);
		saved_free(&later);
	}
	((uint8_t *)f.data)[8] = 2; /* another version: its meaning is not known */
	CHECK(is_refused(&f));
	saved_free(&f);
}

/* ---- arguments, memory ---- */

static void t_arguments_are_checked(void)
{
	cn_world *world = zoo_world(), *read = NULL;
	cn_world_def def;
	saved f = write_world(world);
	cn_world_def_init(&def);
	CHECK(cn_world_write(world, f.data, f.bytes - 1, NULL) == CN_ERROR_CAPACITY);
	CHECK(cn_world_write(world, NULL, f.bytes, NULL) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_write_size(world, NULL) == CN_ERROR_ARGUMENT && cn_world_write_size(NULL, &f.bytes) == CN_ERROR_ARGUMENT);
	CHECK(cn_world_read(NULL, NULL, f.bytes, &read) == CN_ERROR_ARGUMENT && cn_world_read(NULL, f.data, f.bytes, NULL) == CN_ERROR_ARGUMENT);
	def.struct_size = 3;
	CHECK(cn_world_read(&def, f.data, f.bytes, &read) == CN_ERROR_ARGUMENT && read == NULL);
	cn_world_def_init(&def);
	def.worker_count = -1;
	CHECK(cn_world_read(&def, f.data, f.bytes, &read) == CN_ERROR_ARGUMENT && read == NULL);
	saved_free(&f);
	cn_world_destroy(world);
}

/* Whichever allocation fails: no world, no leak. */
static void t_without_memory_there_is_no_world(void)
{
	session_hooks hooks = { 0, 0, 0, 0, 0, 0, 0 };
	cn_world_def def;
	cn_world *world = NULL;
	saved f = zoo_file();
	int32_t failed = 0;
	cn_world_def_init(&def);
	def.alloc = session_alloc;
	def.free = session_free;
	def.allocator_user = &hooks;
	for (;;) {
		hooks.calls = 0;
		hooks.fail_first = failed + 1;
		hooks.fail_last = INT64_MAX;
		if (cn_world_read(&def, f.data, f.bytes, &world) == CN_OK)
			break;
		REQUIRE(world == NULL && hooks.pieces == 0);
		++failed;
		REQUIRE(failed < 1000);
	}
	hooks.fail_first = 0;
	printf("  %d allocations that failed\n", (int)failed);
	CHECK(failed >= 20 && writes_the_same(world, &f));
	cn_world_destroy(world);
	CHECK(hooks.pieces == 0 && hooks.wrong == 0);
	saved_free(&f);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_every_shortened_file_is_refused);
	RUN(t_every_changed_byte_is_refused);
	RUN(t_bodies_smaller_than_their_shapes_are_refused);
	RUN(t_lists_of_other_shapes_are_refused);
	RUN(t_rows_of_lanes_without_a_contact_are_refused);
	RUN(t_forged_files_do_no_harm);
	RUN(t_later_versions_may_add_chunks_and_fields);
	RUN(t_arguments_are_checked);
	RUN(t_without_memory_there_is_no_world);
	return test_end();
}
