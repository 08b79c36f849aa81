/*
 * examples/record/calls.c - the table of calls.
 */
#include "record/calls.h"

#include <stddef.h>
#include <string.h>

#include "../../bindings/record/calls.h"

int32_t call_find(const char *name)
{
	int32_t k;
	for (k = 0; k < call_count; ++k)
		if (strcmp(call_entries[k].name, name) == 0)
			return k;
	return -1;
}

int32_t call_things(const call_entry *entry, int32_t param, const call_value *v)
{
	const call_param *p = &entry->params[param];
	if (p->count < 0)
		return 1;
	return v[p->count].i > 0 ? v[p->count].i : 0;
}
