/*
 * test/examples/readme_test.c - what the README shows is what there is: its first C block is
 * examples/hello.c to the byte, and that program does what it says.
 */
#define main hello_main
#include "hello.c"
#undef main
#include "test.h"
#include <stdlib.h>

static char *read_text(const char *path)
{
	FILE *f = fopen(path, "rb");
	if (f == NULL)
		return NULL;
	char *text = (char *)calloc(1, 65536);
	if (text != NULL && fread(text, 1, 65535, f) == 0)
		text[0] = '\0';
	fclose(f);
	return text;
}

static void t_readme_shows_hello(void)
{
	char *readme = read_text("README.md"), *hello = read_text("examples/hello.c");
	REQUIRE(readme != NULL && hello != NULL);
	char *begin = strstr(readme, "```c\n");
	REQUIRE(begin != NULL);
	begin += 5;
	char *end = strstr(begin, "```");
	REQUIRE(end != NULL);
	CHECK(strlen(hello) == (size_t)(end - begin) && memcmp(begin, hello, strlen(hello)) == 0);
	free(readme);
	free(hello);
}

static void t_hello_runs(void) { CHECK(hello_main() == 0); }

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_readme_shows_hello);
	RUN(t_hello_runs);
	return test_end();
}
