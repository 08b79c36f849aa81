/*
 * model/tuning.h - the solver's tuning constants, by the folder that uses them.
 *
 * Here: speeds, angles, tolerances, rates, ratios and counts of rounds and steps that decide how well a scene is solved. Sizes, capacities,
 * bits, loop grains and prefetch distances, which only decide how fast, stay beside their code. Long derivations stay there, too.
 *
 * Lengths and speeds marked "length units" are multiplied by the world's length_unit. "Part" is a fraction. Where nothing is said of a
 * measurement, the value is a choice; test/tuning/README.md lists the bounds of the stability suite that 0.7 and 1.4 times a value lose.
 *
 * CNI_TUNING_FLOAT and CNI_TUNING_COUNT make constants. In a build with -DCNI_ABLATION they declare variables, which
 * test/ablation/tuning.c defines from this same list: it defines CNI_TUNING_LIST and both macros, undefines the
 * include guard, and includes this file again.
 */
#ifndef CNI_MODEL_TUNING_H
#define CNI_MODEL_TUNING_H

#include "base/config.h"

#include <stdint.h>

#ifdef CNI_TUNING_LIST
/* The including file defines the macros. */
#elif defined CNI_ABLATION
#define CNI_TUNING_FLOAT(name, value) extern float name;
#define CNI_TUNING_COUNT(name, value) extern int32_t name;
#else
#define CNI_TUNING_FLOAT(name, value) static const float name = value;
#define CNI_TUNING_COUNT(name, value) enum { name = value };
#endif

/* ---------------------------------------------------------------- model */

/* Part of coordinates and extents. Covers the rounding of a box in a step, and rotations that are not quite of unit length. */
CNI_TUNING_FLOAT(CNI_BODY_ROUNDING, 4e-6f)
/* Steps of free flight that the box of a body without contacts covers ahead, so that it need not move in them. With two more,
   pairs that never meet cost more than the saved moves. */
CNI_TUNING_FLOAT(CNI_BOX_FLIGHT_STEPS, 1.0f)
/* Margin of a box, part of its larger side. Wider margins are left less often, but then small bodies in a heap have more neighbours
   that do not touch them than neighbours that do. */
CNI_TUNING_FLOAT(CNI_BOX_MARGIN_PART, 0.1f)
/* Part of the mobility without locked axes. Locked axes that leave less along a direction, and to turns, leave none: a body pushed nearly
   across its free axis by an obstacle that does not yield would have to escape along it at a hundred times the speed. */
CNI_TUNING_FLOAT(CNI_MOBILITY_LEAST_PART, 1e-4f)
/* Radians. CN_SOLVER_AUTO and _SOFT: the normal of a lane with two points lags until the true one has turned by more; see model/world.h, where the
   fallen stacks at 0, 0.01, 0.03, 0.1 and 0.2 are listed. */
CNI_TUNING_FLOAT(CNI_NORMAL_LAG, 0.1f)
/* rad/s. Lanes whose bodies turn faster use the true normal. A stack that begins to lean is slower; as many stand with a tenth of it. */
CNI_TUNING_FLOAT(CNI_NORMAL_LAG_SPIN, 0.1f)
/* 1/s. Rate at which compliance offsets follow the impulses; see model/solve.h. */
CNI_TUNING_FLOAT(CNI_LOAD_RATE, 0.6f)
/* Sleep delays for which a body has been slow when its loads no longer rise; see model/solve.h. Soft towers lean by 31 mm with 1, by 20 mm
   with 3 and by 11 mm with 8, and poured heaps come to rest the later. */
CNI_TUNING_FLOAT(CNI_SETTLED_DELAYS, 3.0f)
/* Slops. Islands with deeper overlaps are projected, still ones and those of which parts move, and so much overlap is left: see
   step/overlap_projection.c. */
CNI_TUNING_FLOAT(CNI_OVERLAP_FROM, 0.5f)
CNI_TUNING_FLOAT(CNI_OVERLAP_FROM_MOVING, 2.0f)
CNI_TUNING_FLOAT(CNI_OVERLAP_LEFT, 0.2f)
/* Part of an overlap that a step projects, of at most a slop. */
CNI_TUNING_FLOAT(CNI_OVERLAP_PART, 0.2f)
/* Limit of the part by which they follow in a substep, times h stress^2; see model/solve.h. */
CNI_TUNING_FLOAT(CNI_LOAD_HEAVY, 0.1f)
/* Length units per second squared. What loads of contacts are compared with in a world without gravity; see step/solve_make.c. */
CNI_TUNING_FLOAT(CNI_STANDARD_GRAVITY, 10.0f)
/* Slops. Overlap from which a contact has twice its frequency; see step/solve_make.c. */
CNI_TUNING_FLOAT(CNI_DEEP_SLOPS, 3.0f)
/* Length units per second squared, about 50 weights. A contact that gives the lighter body this acceleration hardens half. */
CNI_TUNING_FLOAT(CNI_CRUSH_ACCELERATION, 480.0f)
/* Part of the accuracy. A larger overlap or gap is bad. A component whose joints contacts would open by more than this part of the
   accuracy in a substep is projected before positions move. */
CNI_TUNING_FLOAT(CNI_BAD_PART, 0.1f)

/* ---------------------------------------------------------------- contacts */

/* Length units a second. A faster body is not part of a quiet pile. */
CNI_TUNING_FLOAT(CNI_PILE_QUIET_SPEED, 0.5f)
/* Radians a second. A kinematic body that turns faster carries no pile as one that is at rest. */
CNI_TUNING_FLOAT(CNI_CARRIER_SPIN, 1e-3f)
/* Own weights. The soft solver crushes a body that bears more. */
CNI_TUNING_FLOAT(CNI_PILE_STRESS_MAX, 15.0f)
/* Part of the body's size. A body that bears s weights is stressed when s^2 g h^2 exceeds this part: it may buckle. */
CNI_TUNING_FLOAT(CNI_PILE_BUCKLING_PART, 0.055f)
/* Slops. Arms of what rolls that change more within half a step are left as they are at its beginning: what moves so fast is soon struck. */
CNI_TUNING_FLOAT(CNI_ROLLING_ADVANCE_SLOPS, 1.0f)
/* Part of the smaller body's extent. Farther sliding of surfaces along each other invalidates a reused manifold. */
CNI_TUNING_FLOAT(CNI_REUSE_PART, 1.0f / 1024.0f)
/* Likewise where corners of one body touch a face of the other and both may move: the reused manifold is exact until other features touch. */
CNI_TUNING_FLOAT(CNI_REUSE_FACE_PART, 1.0f / 16.0f)
/* Slops. The same limit for large bodies. */
CNI_TUNING_FLOAT(CNI_REUSE_FACE_SLOPS, 3.0f)
/* Part of that for a single corner, of which it is not known where the face ends. */
CNI_TUNING_FLOAT(CNI_REUSE_CORNER_PART, 1.0f / 16.0f)
/* Steps. A pair that comes to rest gets a new manifold: it may have slid by no more than its present motion in so many steps. */
CNI_TUNING_FLOAT(CNI_REUSE_STEPS, 32.0f)
/* Contact margins. Deeper overlaps get a new manifold: another face may be the nearest. */
CNI_TUNING_FLOAT(CNI_REUSE_DEPTH_MARGINS, 2.0f)
/* Slops. What is closer counts as one: a circle and its body's centre, where turning changes nothing, and surfaces that touch. */
CNI_TUNING_FLOAT(CNI_ROUND_PER_SLOP, 0.01f)
/* Restitution above which impacts are left to the next substep. A lower restitution returns a quarter of the energy at most, and crowds
   that are pressed together are held apart sooner. */
CNI_TUNING_FLOAT(CNI_BOUNCE_DELAY_RESTITUTION, 0.5f)
/* Substeps. A contact that overlaps after more of them is braked. A body of 0.1 kg hinged to a falling one of 0.5 kg bounced in each
   substep, was pulled back in the same, and went through a floor. With 4, crowds of elastic discs lose 0.5% of their energy in the
   test, with 8 half of that. */
CNI_TUNING_FLOAT(CNI_BOUNCE_MISSED_SUBSTEPS, 8.0f)
/* Times static friction: what a contact that sticks may need in a pass. With 1 boxes slid that were pushed at once with 78 to 90% of static
   friction, and on slopes of 97%. */
CNI_TUNING_FLOAT(CNI_STICK_MARGIN, 1.5f)
/* Rounds between normals and friction of a lane in the substep in which its contact begins to bear. */
CNI_TUNING_COUNT(CNI_NEW_CONTACT_ROUNDS, 4)
/* Sweeps of restitution. A wave through touching balls may need several; the next solve takes the rest. */
CNI_TUNING_COUNT(CNI_RESTITUTION_SWEEPS, 4)
/* Touching contacts between awake bodies, for each awake body, beyond which bodies are in a crowd; see contacts/contact_solve.c. */
CNI_TUNING_COUNT(CNI_CROWD_CONTACTS, 4)
/* Sweeps of the relax pass in a crowd. 1,000 boxes made in one spot are up to 120 m high after 3 s with 1, 58 m with 4. 340 boxes come apart
   within 2 s with either; if all steps take 16, 42 boxes have not after 5 s. */
CNI_TUNING_COUNT(CNI_CROWD_RELAX_SWEEPS, 4)
/* Cosine between gravity and a contact normal from which the contact can bear a body by itself. */
CNI_TUNING_FLOAT(CNI_PRELOAD_SUPPORT_COSINE, 0.5f)
/* Share of friction beside the normals, where normals alone do not suffice. */
CNI_TUNING_FLOAT(CNI_PRELOAD_FRICTION_SHARE, 0.1f)
/* Factor on the share of a friction row that slides. */
CNI_TUNING_FLOAT(CNI_PRELOAD_SLIDING_FACTOR, 0.3f)
/* Rounds of the active set of one body's supports. */
CNI_TUNING_COUNT(CNI_PRELOAD_ROUNDS, 12)
/* Iterative refinements of one body's system. */
CNI_TUNING_COUNT(CNI_PRELOAD_REFINEMENTS, 3)
/* Part of the trace, added to the diagonal for directions without a support. */
CNI_TUNING_FLOAT(CNI_PRELOAD_REGULARIZATION, 1e-5f)
/* Own weights. With a smaller residual no more contacts are added to the supports. */
CNI_TUNING_FLOAT(CNI_PRELOAD_RESIDUAL_GOOD, 1e-3f)
/* Own weights. With a larger residual the body's preload is not used. */
CNI_TUNING_FLOAT(CNI_PRELOAD_RESIDUAL_MAX, 0.05f)
/* Part of the half width of its supports by which the load of a leaning body is off their middle. */
CNI_TUNING_FLOAT(CNI_PRELOAD_LEANING_PART, 0.25f)

/* ---------------------------------------------------------------- narrowphase */

/* Part of the slop (0.5 um). Centres that are nearer have no direction from one to the other. */
CNI_TUNING_FLOAT(CNI_COINCIDENT_PER_SLOP, 1e-4f)
/* Factor on the radii of bounding circles that must be apart, against rounding. */
CNI_TUNING_FLOAT(CNI_CIRCLES_APART, 1.0001f)
/* Part of the slop (0.2 mm). Resting contacts yield by up to this: g / (2 pi 30 Hz)^2 is 0.28 mm for a body as light as its contact,
   0.07 mm for most. The core of a thin shape is smaller than the shape by as much, or it would hang on its ground. */
CNI_TUNING_FLOAT(CNI_CORE_SAG_PER_SLOP, 0.04f)
/* Part of the inner radius: depth of the inner core, which stops shapes that were pressed in beyond the outer core's depth. */
CNI_TUNING_FLOAT(CNI_CORE_INNER_DEPTH_PART, 0.95f)
/* Part of the core's depth within which it is stopped, half as much again with the tolerance. A sliding shape whose contacts yield by
   CNI_CORE_SAG_PER_SLOP stays clear of edges that are flush with its ground. */
CNI_TUNING_FLOAT(CNI_CORE_CLEAR_PART, 0.2f)
/* Part of the inner radius. Bodies that move farther in a step, or overlap more with static ones, are checked: either alone leaves the core,
   half as large, clear. */
CNI_TUNING_FLOAT(CNI_CORE_NEAR_PART, 0.25f)
/* Radians in a step. For larger turns continuous collision does not use the short test. */
CNI_TUNING_FLOAT(CNI_CORE_TURN_MAX_RAD, 1.0f)

/* ---------------------------------------------------------------- joints */

/* Impulse (N s or N m s) of a row without a limit. */
CNI_TUNING_FLOAT(CNI_NO_LIMIT, 1e30f)
/* Radians in a step. Joints of faster bodies are solved by rows, which turn their lever arms exactly at any angle. */
CNI_TUNING_FLOAT(CNI_LANE_TURN_MAX_RAD, 1.5f)
/* Part of its gap that a directly solved joint closes in a substep of the longest step of late. */
CNI_TUNING_FLOAT(CNI_JOINT_ERROR_RATE, 0.3f)

/* ---------------------------------------------------------------- direct: regularization */

/* Part added to the diagonal of systems with contacts. Loops, the two points of a contact, and piles that can bear the same weight in
   several ways have redundant rows. */
CNI_TUNING_FLOAT(CNI_REGULARIZATION_CONTACTS, 1e-4f)
/* The same where a pass starts from the impulses of the last one. Redundant rows answer to a speed within the tolerance with impulses of
   this speed times their mass over the regularization: with 1e-4 more than their weights, and a wall that no set fits needed a new solution
   of its friction cones every 7 steps. With 1e-2 towers of 16 boxes swayed by 13 mm. */
CNI_TUNING_FLOAT(CNI_REGULARIZATION_WARM, 3e-3f)
/* The same of loops of joints alone, whose solutions are checked. */
CNI_TUNING_FLOAT(CNI_REGULARIZATION_LOOPS, 5e-5f)
/* Factor on the regularization of a system that is still nearly singular. */
CNI_TUNING_FLOAT(CNI_REGULARIZATION_STEP, 10.0f)
/* Limit of it: with more, joints are about as soft as soft ones. */
CNI_TUNING_FLOAT(CNI_REGULARIZATION_MAX, 0.05f)
/* Part of a row's inverse effective mass by which it yields to its whole impulse. Among many impulses that bear the same, this selects
   those of least energy. */
CNI_TUNING_FLOAT(CNI_DIRECT_LEAK, 1e-5f)

/* ---------------------------------------------------------------- direct: joints */

/* Length units a second squared, times the square of a substep, as what soft joints leave open: 2 mm at 240 substeps a second. A loop
   (is_open_loop), or an ill scaled tree that was soft, is soft while a joint is open by more: of a straight bridge, closing many small gaps takes
   away all of its sag. */
CNI_TUNING_FLOAT(CNI_LOOP_OPEN, 115.0f)
/* Times the speed of the moving ends of a loop, and length units a second: one of its bodies would have to follow them faster than both. The middle
   of a row is four times as fast as its ends at 97% of its length. Of 1,600 chains that handles pull too far 13 are three times as fast as with soft
   constraints, 17 with 6, 25 with 8, 48 without it. */
CNI_TUNING_FLOAT(CNI_LOOP_PULLED, 4.0f)
CNI_TUNING_FLOAT(CNI_LOOP_PULLED_SPEED, 1.0f)
/* Most bodies a loop between fixed ones that stay exact under contacts. Exact straight rows are thrown from about 60 planks on: what sags by a hair
   bears any load, and rounding grows with their length. */
CNI_TUNING_COUNT(CNI_LOOP_BODIES, 32)
/* Greatest mass over least of joined bodies from which a pivot is checked, and the part of its diagonal below which rounding has eaten it: rows of
   heavy and light bodies in turn are exact up to 1:1e5. Contacts of such bodies know no joints: what one does to the lightest is rounding. */
CNI_TUNING_FLOAT(CNI_ILL_MASS_RATIO, 1e4f)
CNI_TUNING_FLOAT(CNI_ILL_PIVOT, 2e-5f)
/* Radians, or length units. A joint that is farther beyond a limit, at ten times cni_soft_speed_most, is held there by others. */
CNI_TUNING_FLOAT(CNI_LIMIT_FORCED, 0.01f)
/* Kinetic energy that the warm start of a loop's joints may bring: so many times the energy without it, and that of all bodies at this part of
   the speed at which overlaps are pushed apart. That part is also what their solution may bring, and the speed across a rod that its tension may add in
   a substep: nets that are thrown have 100 times as much one step before. Mechanisms with fast rods have up to a few metres a second. */
CNI_TUNING_FLOAT(CNI_WARM_ENERGY_MOST, 5.0f)
CNI_TUNING_FLOAT(CNI_WARM_PUSH_PART, 0.5f)
/* Part by which a solution of a loop's joints may raise kinetic energy beyond that of closing gaps: what compensation of drift adds, and rounding.
   With any energy that pushing may bring nets that fall over a disc got 7 times theirs in a substep. */
CNI_TUNING_FLOAT(CNI_LOOP_ENERGY_PART, 0.01f)
/* Part of a diagonal below which a pivot has the solutions of a tree checked: light bodies between heavy ones, or on arms longer than they. What of such
   a tree has opened while it was soft stays soft until it is closed. */
CNI_TUNING_FLOAT(CNI_CHECKED_PIVOT, 1e-3f)
/* Inverse effective mass of a pin times the greatest mass of a body of its tree up to which a tree with heavy contacts stays in its batch. */
CNI_TUNING_FLOAT(CNI_BATCH_MASS_RATIO, 2e4f)
/* Changes of the active set of joint rows in a pass. */
CNI_TUNING_COUNT(CNI_JOINT_SET_ROUNDS, 3)
/* Length units or radians. A limit that is nearer may be reached. */
CNI_TUNING_FLOAT(CNI_LIMIT_ROOM, 0.05f)
/* Xi = h^2 sum(r.f) / I above which relative rotation is damped; see direct/geometric_stiffness.c. A light body under tension gains
   energy when Xi is much above one. */
CNI_TUNING_FLOAT(CNI_STIFFNESS_XI_MAX, 1.0f)
/* Radians in a substep. Joints of bodies that turn farther may open, as the arms leave the tangent: they are projected. */
CNI_TUNING_FLOAT(CNI_PROJECTION_TURN_RAD, 0.02f)
/* Own weights of the lighter body. Contacts that bear less in a substep are left to the kernel, where they yield by 3 mm at most at 240
   substeps a second. With 0 mechanisms take 4.1 times as long as soft ones, with 10 3.8 times. Also the most weights of its bodies and all that
   joints connect with them that a contact may keep as its load: with 60 parts that are pulled are thrown in 21 of 1,320 seeds instead of 15. */
CNI_TUNING_FLOAT(CNI_HEAVY_CONTACT_STRESS, 10.0f)
/* The same of contacts with static bodies. With 100 loaded chains in heaps overlap by 13% more, as links that the ground does not let yield
   press on others; with 1000 ropes over pegs gain half as much. */
CNI_TUNING_FLOAT(CNI_HEAVY_STATIC_STRESS, 300.0f)
/* The same, with a body of like mass into which it has sunk by this many slops. At any depth ragdolls on
   hills take 1.14 times the instructions, 1.01 times with this. */
CNI_TUNING_FLOAT(CNI_HEAVY_LIKE_STRESS, 60.0f)
CNI_TUNING_FLOAT(CNI_HEAVY_LIKE_SLOPS, 4.0f)
/* The same, with any body, of a component in which no body is faster than CNI_HEAVY_SLOW_SPEED (length units a second). A light foot under a
   frame is an oscillator that the kernel, which knows the foot's mass alone, does not damp: of 320 tables, cars, frames and linkages set down
   102 still moved after 20 s, 22 with this. */
CNI_TUNING_FLOAT(CNI_HEAVY_SLOW_STRESS, 3.0f)
CNI_TUNING_FLOAT(CNI_HEAVY_SLOW_SPEED, 1.0f)
/* Blocks of the system of a component that has others of its class, at most: ragdolls on hills would take 1.75 times as long. */
CNI_TUNING_COUNT(CNI_HEAVY_SLOW_BLOCKS, 12)
/* Part by which the root of such a contact's inverse mass may change, as joints turn, until their response is found again. */
CNI_TUNING_FLOAT(CNI_HEAVY_TURN_PART, 0.3f)
/* Times the speed of pushing: all bodies of such a contact and its joints would get it by the greatest impulse. A tower that a kinematic part presses
   into the ground had 4 million weights on one contact, and was thrown at 337 m/s when the part let go. */
CNI_TUNING_FLOAT(CNI_HEAVY_SPEED_MOST, 10.0f)
/* A contact with a lighter body that bounces is solved so, too, where the joints leave less than this of its inverse mass: the impact of free
   bodies would be lost on a board that its joints stop. A wrecking ball on its chain bounces as a free one. */
CNI_TUNING_FLOAT(CNI_HEAVY_BOUNCE_PART, 0.97f)
/* Gauss-Seidel rounds over the rows of a component's contacts in a pass, at most. With 4 overlaps of trusses are 1.1 times as large. */
CNI_TUNING_COUNT(CNI_HEAVY_CONTACT_ROUNDS, 8)
/* Blocks of the system of a component, times its contacts that are solved so: each has three solutions of it in a step. With 512 overlaps on
   suspension bridges are 2.1 times as large, on trusses and frames 1.5 times, in 0.94 of the time. */
CNI_TUNING_COUNT(CNI_HEAVY_CONTACT_BLOCKS, 2048)
/* Most of a component: a round takes the square of their number. */
CNI_TUNING_COUNT(CNI_HEAVY_COMPONENT_MOST, 12)
/* Radians in a substep. A body that turns farther may have to be locked to its neighbours: cni_geometric_stiffness_lock. */
CNI_TUNING_FLOAT(CNI_SNAP_RAD, 0.1f)
/* The same where contacts turn it: it may be rolling or falling, and a lock would hold it. With 0.1 ropes over pegs gained up to 40% of
   energy, and loaded chains in heaps overlapped by more than soft ones in 13 of 200 seeds instead of 7. */
CNI_TUNING_FLOAT(CNI_BUCKLE_RAD, 0.3f)
/* Rounds between joints and the contacts that open them, in a substep. */
CNI_TUNING_COUNT(CNI_PROJECTION_ROUNDS, 4)
/* The same after the relax passes, of slow trees, and the part of the speed below which bodies may sleep at which contacts may open them then. Of 80 heaps
   of figures 42 sleep after 20 s without it, 56 with two rounds, 70 with three, 62 with four (soft constraints 64). */
CNI_TUNING_COUNT(CNI_SETTLE_ROUNDS, 3)
CNI_TUNING_FLOAT(CNI_SETTLE_PART, 0.05f)
/* Steps until a failed direct solution is tried again; doubles when it fails again soon. */
CNI_TUNING_COUNT(CNI_TRUST_LEAST, 2)
/* Limit of that, in steps. */
CNI_TUNING_COUNT(CNI_TRUST_MOST, 256)

/* ---------------------------------------------------------------- direct: contacts */

/* Length units a second that count as no motion: tolerance ("speed_least") of the direct contact solver. */
CNI_TUNING_FLOAT(CNI_DIRECT_SPEED_LEAST, 1e-4f)
/* Seconds: in shorter substeps that speed is less, in proportion. */
CNI_TUNING_FLOAT(CNI_DIRECT_SHORT_S, 5e-4f)
/* Times speed_least. Contacts that part or slide faster yield. */
CNI_TUNING_FLOAT(CNI_DIRECT_PARTING, 10.0f)
/* Times the momentum of all bodies of a system, and of pushing them: a point that bears more and still closes is squeezed. */
CNI_TUNING_FLOAT(CNI_DIRECT_SQUEEZE_MOST, 2.0f)
/* Part of the kinetic energy that counts as rounding when a solution is checked for gained energy. */
CNI_TUNING_FLOAT(CNI_DIRECT_ENERGY_ROUNDING, 1e-3f)
/* Length units a second, root mean square by mass. A slower island is at rest or begins to move. */
CNI_TUNING_FLOAT(CNI_DIRECT_STILL_SPEED, 0.4f)
/* Seconds of fall, at CNI_STANDARD_GRAVITY or more. The soft solver begins with no impulse that gives the lighter body a greater speed: 300 weights at
   240 substeps a second. With 100, joints of a bridge under loads of 50 planks stretched by 0.36 m, with 300 by 0.26 m as with all of its tension. */
CNI_TUNING_FLOAT(CNI_SOFT_FALL_S, 1.25f)
/* Rounds of the active set of contacts, until friction cones are solved, which take about twice as many factorizations. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_ROUNDS, 10)
/* Rounds for systems that are too large for friction cones. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_ROUNDS_LARGE, 32)
/* Rounds, from the first, in which all violated rows change at once. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_ROUNDS_ALL, 6)
/* Rounds that start from the impulses of the last pass. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_ROUNDS_WARM, 4)
/* Solutions with one set until sliding impulses match their normal impulses. The error shrinks by about the friction coefficient each time. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_SLIDES, 8)
/* Solutions with one factorization. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_REFINEMENTS, 3)
/* The same of a pass that starts from the impulses of the last one: its regularization is larger, and most passes need none. */
CNI_TUNING_COUNT(CNI_CONTACT_SET_REFINEMENTS_WARM, 16)
/* Part of an overlap that is pushed apart in a substep: little, because all points of a pile are pushed at once. */
CNI_TUNING_FLOAT(CNI_CONTACT_SET_PUSH_RATE, 0.1f)
/* Part of it up to a slop of the overlap, and how many steps that counts, where an island that may sway is selected. Of 320 pushed towers with
   2 substeps 24 fall with 1, 9 with 0.1 and 8 steps, 11, 9, 12 with 5, 11, 16 steps; 12 of 160 instead of 6 with any overlap. */
CNI_TUNING_FLOAT(CNI_CONTACT_SET_SWAY_PART, 0.1f)
CNI_TUNING_COUNT(CNI_CONTACT_SET_SWAY_STEPS, 8)
/* Length units. A smaller gap or overlap is rounding of positions. Redundant rows would react to rounding with impulses of any size. */
CNI_TUNING_FLOAT(CNI_CONTACT_SET_TOUCHING, 5e-6f)
/* Most normal impulses of a pass over those without the friction of contacts that slip. What is struck or slides has 0.7 to 2 in 95 of 100 passes,
   columns of heavy boxes on light ones that jam 2 to 9. With 1.5, 2, 3, 4 and no limit 17, 24, 53, 79, 92 of 2,400 columns change their momentum
   in a step by more than twice what those of soft constraints do. */
CNI_TUNING_FLOAT(CNI_CONTACT_SET_JAM, 2.0f)
/* Part by which the friction of a sliding contact may differ from coefficient times normal force. */
CNI_TUNING_FLOAT(CNI_SLIDE_CLOSE, 0.01f)

/* ---------------------------------------------------------------- direct: friction cones (interior point) */

/* Factorizations of a pass. A pile that stands takes 5 to 25, one that begins to slide or fall 30 to 90. */
CNI_TUNING_COUNT(CNI_CONE_FACTORS_MAX, 60)
/* The same of a large system: the limit then follows from its work. A loaded wall of 40 bricks takes 16. */
CNI_TUNING_COUNT(CNI_CONE_FACTORS_LEAST, 24)
/* The same of CN_SOLVER_DIRECT. */
CNI_TUNING_COUNT(CNI_CONE_FACTORS_DIRECT, 120)
/* Part of the way to the boundary of the cones that a step may take. */
CNI_TUNING_FLOAT(CNI_CONE_STEP_PART, 0.995f)
/* Part of the friction bound that the first friction impulse may have. */
CNI_TUNING_FLOAT(CNI_CONE_INSIDE_PART, 0.9f)
/* Solutions, each with the slip speeds of the one before. */
CNI_TUNING_COUNT(CNI_CONE_SLIP_ROUNDS, 3)
/* Times speed_least: tolerance of the speed by which slip lifts a contact. */
CNI_TUNING_FLOAT(CNI_CONE_SLIP_CLOSE, 10.0f)
/* Part of the rows' missing speed. Its square is the lower limit of tau, the barrier parameter. */
CNI_TUNING_FLOAT(CNI_CONE_PATH_SPEED, 0.3f)
/* Times a row's own stiffness: limit of an entry of Z/S. */
CNI_TUNING_FLOAT(CNI_CONE_STIFF_MAX, 1e12f)
/* A smaller coefficient of friction counts as none. */
CNI_TUNING_FLOAT(CNI_CONE_FRICTION_LEAST, 1e-4f)

/* ---------------------------------------------------------------- soft joints */

/* Radians in a substep, by which soft joints may turn a body more than it turned before. With 0.2 what is left of a truss that loses a wall is
   thrown at 51 m/s instead of 22, with 0.4 at 24. */
CNI_TUNING_FLOAT(CNI_JOINT_TURN_MOST, 0.3f)
/* Length units a second. */
CNI_TUNING_FLOAT(CNI_JOINT_RESTLESS, 1.0f)
/* Length units and radians. Rows of joints that were made, put or changed so that they are apart see no greater gaps: at 240 substeps a second they
   close at 75 times as much a second.
   Joints that are open by more, in whatever way, are soft, with those that are joined to them. With 0.12 ropes over pegs that were torn in an
   impact open by 13% more, as they are soft under their loads and stay open. */
CNI_TUNING_FLOAT(CNI_JOINT_GAP_MOST, 0.25f)
/* Length units a second. With more substeps they see less, and close at this speed. With 15 rows are weaker at 240 substeps, too, and a tangle of
   soft joints that were made apart reaches 400 m/s. */
CNI_TUNING_FLOAT(CNI_JOINT_CLOSING_MOST, 20.0f)
/* Most bodies of an island whose joints are relaxed again. */
CNI_TUNING_COUNT(CNI_JOINT_RELAX_BODIES, 64)
/* Relax passes in a substep. */
CNI_TUNING_COUNT(CNI_JOINT_RELAX_ROUNDS, 8)

/* ---------------------------------------------------------------- direct: RATTLE */

/* Length units or radians. A joint with a smaller gap is closed. */
CNI_TUNING_FLOAT(CNI_RATTLE_CLOSED, 2e-6f)
/* Times CNI_RATTLE_CLOSED. A larger gap is from before this step. */
CNI_TUNING_FLOAT(CNI_RATTLE_OLD_GAP, 100.0f)
/* Part of an old gap that is closed in a substep. */
CNI_TUNING_FLOAT(CNI_RATTLE_CLOSING_RATE, 0.2f)
/* Newton iterations of a substep. */
CNI_TUNING_COUNT(CNI_RATTLE_NEWTON_ROUNDS, 5)
/* Times CNI_RATTLE_CLOSED. With larger gaps after all iterations the substep is too long. */
CNI_TUNING_FLOAT(CNI_RATTLE_FAILED_GAP, 50.0f)
/* Rounds of the projection of gaps. */
CNI_TUNING_COUNT(CNI_RATTLE_PROJECT_ROUNDS, 12)
/* Least part of a step of Newton's method in a projection. */
CNI_TUNING_FLOAT(CNI_RATTLE_STEP_LEAST, 0.01f)
/* Part of its gap that a round of the projection may leave to a loop, or the projection ends: some loops cannot be closed. */
CNI_TUNING_FLOAT(CNI_RATTLE_SLOWEST_PART, 0.9f)
/* Part of the kinetic energy that correcting a step's energy may take out. A step that gains more has failed. */
CNI_TUNING_FLOAT(CNI_RATTLE_ENERGY_PART, 0.01f)
/* Part of the kinetic energy that some minutes of rounding may gain. */
CNI_TUNING_FLOAT(CNI_RATTLE_ENERGY_ROUNDING, 1e-3f)
/* Limit of substeps that pins need; beyond it dampers help. */
CNI_TUNING_FLOAT(CNI_RATTLE_SUBSTEPS_PIN, 8.0f)
/* Limit of substeps that rods need; no damper helps them. */
CNI_TUNING_FLOAT(CNI_RATTLE_SUBSTEPS_ROD, 32.0f)
/* Limit of substeps of the retries of a failed step. */
CNI_TUNING_COUNT(CNI_RATTLE_SUBSTEPS_RETRY, 64)
/* Substeps of the fallback that projects joints in every substep; large systems have fewer. */
CNI_TUNING_COUNT(CNI_RATTLE_SUBSTEPS_FIRM, 16)
/* What elimination leaves of a row's diagonal: n times the regularization where the others of n nodes imply the row. RATTLE's energy jumps by a
   percent in single steps then: five wheels coupled by two rods lost 47% of it in 10 s at 25 rad/s. So straight bridges of up to 20 planks are
   not for RATTLE. Longer ones are: of 60 planks the tension by which the other path holds them throws them when boxes fall on them. */
CNI_TUNING_FLOAT(CNI_RATTLE_REDUNDANT, 1e-3f)
/* Times that for each body of a loop that stays exact under contacts: of 300 straight and sagging bridges of up to 32 planks, on which boxes and
   discs fall, 26 gain more than 1% of energy without it. Linkages of few bodies stay with RATTLE, which loses none. */
CNI_TUNING_FLOAT(CNI_RATTLE_BRACED, 0.3f)

/* ---------------------------------------------------------------- direct: solver selection */

/* Good steps until the soft solver gets an island back, the first time. */
CNI_TUNING_COUNT(CNI_SELECTION_STAY_FIRST, 15)
/* Factor on that, each time the island turned bad again. */
CNI_TUNING_COUNT(CNI_SELECTION_STAY_FACTOR, 4)
/* Limit of that, in steps. */
CNI_TUNING_COUNT(CNI_SELECTION_STAY_MAX, 100000)
/* Steps until a refused island is considered again; doubles each time. */
CNI_TUNING_COUNT(CNI_SELECTION_REFUSED_FIRST, 120)
/* The same of an island refused for its contacts' behaviour, which may not occur again. */
CNI_TUNING_COUNT(CNI_SELECTION_RETRY_FIRST, 8)
/* Limit of both, in steps. */
CNI_TUNING_COUNT(CNI_SELECTION_REFUSED_MAX, 1920)
/* Times the refusal or the stay. After that time both begin anew. */
CNI_TUNING_COUNT(CNI_SELECTION_FORGET_FACTOR, 8)
/* Steps in which an island comes down until it is left to the soft solver. */
CNI_TUNING_COUNT(CNI_SELECTION_FALL_STEPS, 8)
/* Steps in a row in which an island that still moves must need direct solving and be quiet. */
CNI_TUNING_COUNT(CNI_SELECTION_WAIT_STEPS, 8)
/* Steps for which an island stays soft whose bodies have yet to meet: as long as houses of cards take to settle. */
CNI_TUNING_COUNT(CNI_SELECTION_MEET_STEPS, 30)
/* Part of a body's inner radius. A first overlap beyond it is deep: cards that overlap by a third of their thickness fall where it is 1, and
   arches whose stones overlap by 12 mm fall where a slop suffices. */
CNI_TUNING_FLOAT(CNI_SELECTION_DEEP_PART, 0.5f)
/* Mass ratio from which a body may crush a lighter one below it. */
CNI_TUNING_FLOAT(CNI_SELECTION_MASS_RATIO, 5.0f)
/* A body that strikes another of so much less mass at this speed, length units a second, has its island of up to so many solved directly. */
CNI_TUNING_FLOAT(CNI_SELECTION_STRIKE_SPEED, 0.5f)
CNI_TUNING_COUNT(CNI_SELECTION_STRIKE_BODIES, 24)

/* ---------------------------------------------------------------- step */

/* Length units a second: a thousandth of the speed that gravity gives in a step. Slower islands are at rest. */
CNI_TUNING_FLOAT(CNI_REST_SPEED, 1e-4f)
/* Part of the speed that forces give in a substep that a held body may keep. */
CNI_TUNING_FLOAT(CNI_REST_HELD_PART, 3e-4f)
/* Part of the change of velocity by forces in the last substep that a body may keep and rest; a free one keeps all of it. Slow
   accelerations add up: cni_body_gains. With 0.1, of 80 heaps of short chains 24 are awake after 30 s, 8 with 0.5 (soft constraints 9). */
CNI_TUNING_FLOAT(CNI_REST_CHANGE_PART, 0.5f)
/* Part of CNI_REST_SPEED that a direct solution leaves: its iterations end there. */
CNI_TUNING_FLOAT(CNI_REST_SOLVED_PART, 0.2f)
/* Length units a second squared, 0.12% of gravity. A slow body that gains speed faster does not rest; see step/integrate_pass.h. A box on
   a slope 0.5% too steep for a friction of 0.5 has 22 mm/s^2; what creeps in a heap that settles changes its speed by 4 to 10. */
CNI_TUNING_FLOAT(CNI_STEADY_ACCELERATION, 12e-3f)
/* Parts of it: the least in a world of little gravity, and that of bodies which touch and are joined to no other. Those creep with nothing: of 1,000
   boxes on slopes 0.5 to 5% too steep 24 fell asleep with 1, none with 0.3. */
CNI_TUNING_FLOAT(CNI_STEADY_LEAST_PART, 0.02f)
CNI_TUNING_FLOAT(CNI_STEADY_ALONE_PART, 0.3f)
/* Limit of the ratio of a step to the one before, by which warm start impulses scale; see step/solve_make.c. Walls fell with 4 when a
   step was 0.2 to 1.8 times the mean (a ratio of 9). */
CNI_TUNING_FLOAT(CNI_WARM_STEP_RATIO_MAX, 20.0f)
/* Radians of its oscillation in a substep, up to which a spring is exact. */
CNI_TUNING_FLOAT(CNI_SPRING_TURN_MOST, 0.7f)
/* Seconds in which the longest step of late is forgotten. */
CNI_TUNING_FLOAT(CNI_LONGEST_STEP_S, 8.0f)
/* Hertz. Soft joints are no softer after a rare long step. */
CNI_TUNING_FLOAT(CNI_JOINT_HERTZ_LEAST, 60.0f)
/* Weight of a step in the mean step: about a second's steps count. */
CNI_TUNING_FLOAT(CNI_MEAN_STEP_PART, 1.0f / 64.0f)

#undef CNI_TUNING_FLOAT
#undef CNI_TUNING_COUNT
#endif
