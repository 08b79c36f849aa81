/* examples/testbed/entries.h - scenes of the testbed that are made of small examples (examples/NAME.c). */
#ifndef CAIRN_TESTBED_ENTRIES_H
#define CAIRN_TESTBED_ENTRIES_H

#include "scenes/scenes.h"

extern const scene entry_ragdoll;
extern const scene entry_car;
extern const scene entry_billiards;
extern const scene entry_breakable_wall;
extern const scene entry_conveyor;
extern const scene entry_mouse;
extern const scene entry_wind;
extern const scene entry_areas;
extern const scene entry_destructible_terrain;
extern const scene entry_platformer;

#endif
