/*
 * test/arch/hashes_test.c - the eight scenes of scenes.h give the same numbers in every build and on every processor. CAIRN_PRINT_GOLDEN=1 prints
 * the table; it may be replaced under the rules of world/determinism_test.c. `make test-arch` runs this everywhere (test/arch/run.sh).
 */
#include "../test.h"
#include "scenes.h"

static void arch_world_def(cn_world_def *def) { cn_world_def_init(def); }

static void every_scene_has_its_number(void)
{
	int32_t k, print = getenv("CAIRN_PRINT_GOLDEN") != NULL;
	for (k = 0; k < ARCH_SCENES; ++k) {
		const arch_scene *scene = &arch_scenes[k];
		uint64_t number = arch_number(scene);
		if (arch_failed_line != 0)
			printf("  %s: the call in %s:%d fails\n", scene->name, arch_failed_file, (int)arch_failed_line);
		CHECK(arch_failed_line == 0);
		if (print)
			printf("\t{ \"%s\", scene_%s, 0x%016llx },\n", scene->name, scene->name, (unsigned long long)number);
		else
			printf("  %s: %016llx, golden %016llx\n", scene->name, (unsigned long long)number, (unsigned long long)scene->expected);
		CHECK(print || test_golden_holds(number, scene->expected));
	}
	printf("  seen: %x of %x\n", arch_seen, ARCH_SEEN_ALL);
	CHECK(arch_seen == ARCH_SEEN_ALL);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(every_scene_has_its_number);
	return test_end();
}
