/*
 * step/event_callbacks.c - stage 9: calls the user's contact callbacks in the order of the event arrays. The world is locked
 * meanwhile. Reads logs and contacts. Without callbacks it does nothing.
 */
#include "step/stages.h"

void cni_stage_events(cn_world *world)
{
	for (int32_t kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		cn_contact_event_fn *callback = world->events.callback[kind];
		if (callback == NULL)
			continue;
		if (cni_events_build(world, kind) != CN_OK) {
			world->warnings |= CN_WARNING_EVENT_MEMORY;
			world->events_not_reported += world->events.log[kind].count;
			continue;
		}
		++world->locked;
		for (int32_t k = 0; k < world->events.seen[kind].count; ++k)
			callback(world, (const cn_contact_event *)world->events.seen[kind].data + k, world->events.callback_user[kind]);
		--world->locked;
	}
}
