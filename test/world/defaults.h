/*
 * test/world/defaults.h - shared by the tests of definitions: rows of fields, and the fields that include/cairn.h has, so that a new
 * field without a row fails.
 */
#ifndef TEST_WORLD_DEFAULTS_H
#define TEST_WORLD_DEFAULTS_H

#include "../test.h"
#include "cairn.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#ifndef CAIRN_HEADER
#define CAIRN_HEADER "include/cairn.h"
#endif

/* What a zero does. */
enum { ZERO_IS_STORED, ZERO_IS_REFUSED, ZERO_IS_NONE /* no room reserved; or accepted by a call that stores nothing */ };

typedef struct row {
	const char *structure, *field;
	size_t at;        /* in the definition */
	int32_t is_float;
	double by_default;
	int32_t zero;
	double resolved;  /* of CN_DEFAULT, in a world with a length unit of 2 m */
} row;

static inline double row_number(const void *def, const row *r)
{
	float f;
	int32_t i;
	memcpy(&f, (const char *)def + r->at, sizeof f);
	memcpy(&i, (const char *)def + r->at, sizeof i);
	return r->is_float ? (double)f : (double)i;
}

static inline void row_set(void *def, const row *r, double value)
{
	float f = (float)value;
	int32_t i = (int32_t)value;
	if (r->is_float)
		memcpy((char *)def + r->at, &f, sizeof f);
	else
		memcpy((char *)def + r->at, &i, sizeof i);
}

static inline int32_t has_row(const row *rows, int32_t count, const char *structure, const char *field, size_t length)
{
	int32_t k;
	for (k = 0; k < count; ++k)
		if (strcmp(rows[k].structure, structure) == 0 && strlen(rows[k].field) == length && strncmp(rows[k].field, field, length) == 0)
			return 1;
	return 0;
}

static inline const char *header_text(void)
{
	static char text[1 << 18];
	FILE *file = fopen(CAIRN_HEADER, "rb");
	size_t bytes = file != NULL ? fread(text, 1, sizeof text - 1, file) : 0;
	CHECK(bytes > 0);
	text[bytes] = '\0';
	if (file != NULL)
		fclose(file);
	return text;
}

/* Every float and int32_t of these structs has a row, and every row a field. */
static inline void check_fields(const char *const *structures, int32_t structure_count, const row *rows, int32_t row_count)
{
	const char *text = header_text();
	int32_t count = 0, missing = 0, k;
	for (k = 0; k < structure_count; ++k) {
		char open[64];
		const char *p, *end;
		snprintf(open, sizeof open, "typedef struct %s {", structures[k]);
		p = strstr(text, open);
		REQUIRE(p != NULL);
		end = strstr(p, "\n}");
		for (p = strchr(p, '\n'); p != NULL && p < end; p = strchr(p + 1, '\n')) {
			const char *name = strncmp(p, "\n\tfloat ", 8) == 0 ? p + 8 : strncmp(p, "\n\tint32_t ", 10) == 0 ? p + 10 : NULL;
			if (name == NULL || strncmp(name, "reserved;", 9) == 0)
				continue;
			++count;
			if (has_row(rows, row_count, structures[k], name, strcspn(name, ";")))
				continue;
			printf("  no row for %s.%.*s\n", structures[k], (int)strcspn(name, ";"), name);
			++missing;
		}
	}
	CHECK(count == row_count);
	CHECK_LE("fields without a row", missing, 0, "");
}

#endif
