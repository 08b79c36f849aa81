/*
 * test/arch/events.h - scenes with events of every kind and all callbacks, and the bytes of a file that has everything in it.
 */
#ifndef CAIRN_TEST_ARCH_EVENTS_H
#define CAIRN_TEST_ARCH_EVENTS_H

#include "joints.h"

static void mix_contact(cn_world *world, const cn_contact_event *event, void *user)
{
	int32_t k;
	(void)world;
	(void)user;
	see(SEEN_EVENT + event->kind);
	mix(event->shape_a);
	mix(event->shape_b);
	mix(event->contact_id);
	mix((uint32_t)event->child_a);
	mix((uint32_t)event->kind);
	mix_float(event->approach_speed_mps);
	mix_float(event->normal_impulse_Ns);
	mix_float(event->friction_impulse_Ns);
	mix_vec2(event->hit_point_m);
	mix_vec2(event->manifold.normal);
	for (k = 0; k < event->manifold.point_count; ++k) {
		mix_vec2(event->manifold.points[k].point_m);
		mix_float(event->manifold.points[k].separation_m);
		mix_float(event->manifold.points[k].normal_impulse_Ns);
	}
}

static int32_t every_third_passes(cn_world *world, const cn_contact_event *contact, void *user)
{
	mix_contact(world, contact, user);
	if (contact->contact_id % 3u == 0u)
		see(SEEN_REFUSED);
	return contact->contact_id % 3u != 0u;
}

static int32_t not_both_of_seven(cn_world *world, cn_shape a, cn_shape b, void *user)
{
	(void)world;
	(void)user;
	mix(a ^ b);
	return (a ^ b) % 7u != 0u;
}

static void mix_events(cn_world *world)
{
	const cn_contact_event *contacts;
	const cn_sensor_event *sensors;
	const cn_joint_event *joints;
	const cn_body_moved *moved;
	const cn_body *asleep;
	int32_t kind, count, k;
	for (kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		MUST(cn_world_contact_events(world, kind, &contacts, &count));
		for (k = 0; k < count; ++k)
			mix_contact(world, &contacts[k], NULL);
	}
	MUST(cn_world_sensor_events(world, &sensors, &count));
	for (k = 0; k < count; ++k) {
		see(SEEN_SENSOR);
		mix(sensors[k].visitor);
		mix((uint32_t)sensors[k].kind);
	}
	MUST(cn_world_joint_events(world, &joints, &count));
	for (k = 0; k < count; ++k) {
		see(joints[k].destroyed ? SEEN_BROKEN : SEEN_YIELDED);
		mix(joints[k].joint);
		mix_float(joints[k].force_N);
		mix_float(joints[k].torque_Nm);
	}
	MUST(cn_world_moved(world, &moved, &count));
	for (k = 0; k < count; ++k) {
		mix(moved[k].body);
		mix_vec2(moved[k].pose.position_m);
		mix_float(moved[k].pose.sine);
	}
	MUST(cn_world_fell_asleep(world, &asleep, &count));
	for (k = 0; k < count; ++k) {
		see(SEEN_ASLEEP);
		mix(asleep[k]);
	}
}

static void add_loud(cn_world *world)
{
	int32_t k;
	for (k = 0; k < 24; ++k) {
		cn_shape_def def = shape_on(body_at(world, CN_BODY_DYNAMIC, arch_random(-6.0f, 6.0f), 2.5f + 0.4f * (float)k, 0.3f * (float)k));
		def.event_mask = (1u << CN_EVENT_KINDS) - 1u;
		def.flags = k % 4 == 0 ? CN_SHAPE_PRE_SOLVE : 0u;
		def.material.restitution = 0.2f;
		add_any_shape(world, k, &def);
	}
}

static void scene_events(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_SWEEP);
	cn_shape_def sensor = shape_on(add_ground(world));
	cn_explosion_def blast;
	int32_t k;
	sensor.flags = CN_SHAPE_SENSOR;
	sensor.offset_m = vec2(0.0f, 1.0f);
	MUST(cn_shape_create_box(world, &sensor, 3.0f, 1.0f, 0.0f, NULL));
	add_every_joint(world);
	for (k = 0; k < 6; ++k) {
		cn_joint_base base;
		MUST(cn_joint_get_base(world, arch_joints[k], &base));
		base.break_force_N = 6.0f + (float)k;
		MUST(cn_joint_set_base(world, arch_joints[k], &base));
		if (k % 2 == 0)
			MUST(cn_joint_set_flags(world, arch_joints[k], CN_JOINT_BREAKS));
	}
	add_loud(world);
	MUST(cn_world_set_sleep(world, 0.3f, 0.2f));
	MUST(cn_world_set_contact_callback(world, CN_EVENT_ENTER, mix_contact, NULL));
	MUST(cn_world_set_pre_solve_callback(world, every_third_passes, NULL));
	MUST(cn_world_set_filter_callback(world, not_both_of_seven, NULL));
	cn_explosion_def_init(&blast);
	blast.radius_m = 2.0f;
	blast.falloff_m = 3.0f;
	blast.impulse_Nspm = 3.0f;
	for (k = 0; k < 120; ++k) {
		if (k % 40 == 35)
			MUST(cn_world_explode(world, &blast));
		MUST(cn_world_step(world, 1.0f / 60.0f));
		mix_events(world);
	}
	mix_world(world);
	cn_world_destroy(world);
}

#define ARCH_FILE_BYTES (512 * 1024)
static unsigned char arch_file[ARCH_FILE_BYTES];

/* The bytes of a file with everything in it; the world that is read goes on like the one that was written. */
static void scene_file(void)
{
	cn_world *world = world_of(CN_SOLVER_AUTO, CN_BROADPHASE_TREE), *read = NULL;
	cn_world_def def;
	uint64_t bytes = 0, k, hashes[2];
	add_ground(world);
	add_every_joint(world);
	add_loud(world);
	steps(world, 50);
	MUST(cn_world_shift_origin(world, 3.5f, -0.25f));
	MUST(cn_world_write(world, arch_file, sizeof arch_file, &bytes));
	for (k = 0; k < bytes; ++k)
		arch_digest = (arch_digest ^ arch_file[k]) * 0x100000001B3u;
	arch_world_def(&def);
	MUST(cn_world_read(&def, arch_file, bytes, &read));
	steps(world, 30);
	for (k = 1; k <= 30; ++k)
		MUST(cn_world_step(read, k % 7 == 0 ? 1.0f / 90.0f : 1.0f / 60.0f));
	MUST(cn_world_hash(world, &hashes[0]));
	MUST(cn_world_hash(read, &hashes[1]));
	MUST(hashes[0] == hashes[1] ? CN_OK : CN_ERROR_INTERNAL);
	cn_world_destroy(read);
	cn_world_destroy(world);
}

#endif
