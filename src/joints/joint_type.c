/*
 * joints/joint_type.c - the table of joint types.
 */
#include "joints/joint_type.h"

const cni_joint_type *cni_joint_type_of(int32_t type)
{
	static const cni_joint_type *const types[CNI_JOINT_TYPES] = {
		&cni_joint_revolute, &cni_joint_distance, &cni_joint_fixed, &cni_joint_prismatic, &cni_joint_wheel,
		&cni_joint_motor, &cni_joint_mouse, &cni_joint_gear, &cni_joint_pulley, &cni_joint_ratchet,
		&cni_joint_rotary_spring, &cni_joint_groove, &cni_joint_filter, &cni_joint_angle, &cni_joint_line
	};
	return types[type];
}
