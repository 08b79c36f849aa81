// test/stability/chart/rapier/lib.rs - Rapier behind the few C functions that peer_rapier.c needs: default integration
// parameters, whose solver iterations are the substeps. Friction of a pair is the geometric mean, restitution the greater.
use rapier2d::prelude::*;

pub struct World {
    gravity: Vector,
    parameters: IntegrationParameters,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    soft_bodies: SoftBodySet,
    continuous: CCDSolver,
    sleep: bool,
    stepped: bool,
    body_list: Vec<RigidBodyHandle>, // by number; number 0 is the ground that joints may hang on
    joint_list: Vec<ImpulseJointHandle>,
}

#[repr(C)]
pub struct Surface {
    density: f32,
    friction: f32,
    restitution: f32,
    group: i32, // below 0: those of the suite's one group do not collide
}

#[repr(C)]
pub struct Motion {
    x: f32,
    y: f32,
    cosine: f32,
    sine: f32,
    center_x: f32,
    center_y: f32,
    vx: f32,
    vy: f32,
    w: f32,
    mass: f32,
    inertia: f32,
    local_center_x: f32,
    local_center_y: f32,
}

#[repr(C)]
pub struct Pin {
    body_a: u32,
    body_b: u32,
    anchor_a: [f32; 2],
    anchor_b: [f32; 2],
    reference: f32,
    collide: i32,
    limited: i32,
    lower: f32,
    upper: f32,
}

#[no_mangle]
pub extern "C" fn rapier_create(gravity_x: f32, gravity_y: f32, sleep: i32, substeps: i32) -> *mut World {
    let mut bodies = RigidBodySet::new();
    let ground = bodies.insert(RigidBodyBuilder::fixed());
    let mut parameters = IntegrationParameters::default();
    parameters.num_solver_iterations = substeps as usize;
    Box::into_raw(Box::new(World {
        gravity: Vector::new(gravity_x, gravity_y),
        parameters,
        pipeline: PhysicsPipeline::new(),
        islands: IslandManager::new(),
        broad_phase: DefaultBroadPhase::new(),
        narrow_phase: NarrowPhase::new(),
        bodies,
        colliders: ColliderSet::new(),
        impulse_joints: ImpulseJointSet::new(),
        multibody_joints: MultibodyJointSet::new(),
        soft_bodies: SoftBodySet::new(),
        continuous: CCDSolver::new(),
        sleep: sleep != 0,
        stepped: false,
        body_list: vec![ground],
        joint_list: Vec::new(),
    }))
}

/// # Safety
/// Every world below is one of rapier_create's that was not destroyed; bodies and joints are its own.
#[no_mangle]
pub unsafe extern "C" fn rapier_destroy(world: *mut World) {
    drop(Box::from_raw(world));
}

#[no_mangle]
pub unsafe extern "C" fn rapier_step(world: *mut World, dt: f32) {
    let w = &mut *world;
    w.parameters.dt = dt;
    w.stepped = true;
    w.pipeline.step(
        w.gravity,
        &w.parameters,
        &mut w.islands,
        &mut w.broad_phase,
        &mut w.narrow_phase,
        &mut w.bodies,
        &mut w.colliders,
        &mut w.impulse_joints,
        &mut w.multibody_joints,
        &mut w.soft_bodies,
        &mut w.continuous,
        &(),
        &(),
    );
}

#[no_mangle]
pub unsafe extern "C" fn rapier_add_body(world: *mut World, dynamic: i32, bullet: i32, x: f32, y: f32, angle: f32) -> u32 {
    let w = &mut *world;
    let number = w.body_list.len() as u32;
    let kind = if dynamic != 0 { RigidBodyBuilder::dynamic() } else { RigidBodyBuilder::fixed() };
    let builder = kind.translation(Vector::new(x, y)).rotation(angle).can_sleep(w.sleep).user_data(number as u128);
    let builder = if bullet != 0 { builder.ccd_enabled(true) } else { builder };
    w.body_list.push(w.bodies.insert(builder));
    number
}

#[no_mangle]
pub unsafe extern "C" fn rapier_set_velocity(world: *mut World, body: u32, vx: f32, vy: f32, turn: f32) {
    let w = &mut *world;
    let at = &mut w.bodies[w.body_list[body as usize]];
    at.set_linvel(Vector::new(vx, vy), true);
    at.set_angvel(turn, true);
}

#[no_mangle]
pub unsafe extern "C" fn rapier_read(world: *mut World, body: u32, out: *mut Motion) {
    let w = &mut *world;
    let handle = w.body_list[body as usize];
    // Masses are summed up by the first step; the suite asks before it.
    if !w.stepped {
        w.bodies[handle].recompute_mass_properties_from_colliders(&w.colliders);
    }
    let at = &w.bodies[handle];
    let (place, turned, center, local) = (at.translation(), at.rotation(), at.center_of_mass(), at.local_center_of_mass());
    let inverse = at.mass_properties().local_mprops.inv_principal_inertia;
    *out = Motion {
        x: place.x,
        y: place.y,
        cosine: turned.angle().cos(),
        sine: turned.angle().sin(),
        center_x: center.x,
        center_y: center.y,
        vx: at.linvel().x,
        vy: at.linvel().y,
        w: at.angvel(),
        mass: at.mass(),
        inertia: if inverse > 0.0 { 1.0 / inverse } else { 0.0 },
        local_center_x: local.x,
        local_center_y: local.y,
    };
}

/// Numbers of the bodies that touch this one; returns how many there are.
#[no_mangle]
pub unsafe extern "C" fn rapier_contacts(world: *const World, body: u32, out: *mut u32, capacity: i32) -> i32 {
    let w = &*world;
    let mut count = 0;
    for collider in w.bodies[w.body_list[body as usize]].colliders() {
        for pair in w.narrow_phase.contact_pairs_with(*collider) {
            let other = if pair.collider1 == *collider { pair.collider2 } else { pair.collider1 };
            let parent = w.colliders.get(other).and_then(|c| c.parent());
            if let (true, Some(parent)) = (pair.has_any_active_contact(), parent) {
                if count < capacity {
                    *out.add(count as usize) = w.bodies[parent].user_data as u32;
                }
                count += 1;
            }
        }
    }
    count
}

unsafe fn insert(w: &mut World, body: u32, surface: *const Surface, shape: ColliderBuilder) {
    let s = &*surface;
    let own = Group::GROUP_2;
    let groups = if s.group < 0 {
        InteractionGroups::new(own, Group::ALL ^ own, InteractionTestMode::And)
    } else {
        InteractionGroups::all()
    };
    let built = shape
        .density(s.density)
        .friction(s.friction)
        .friction_combine_rule(CoefficientCombineRule::GeometricMean)
        .restitution(s.restitution)
        .restitution_combine_rule(CoefficientCombineRule::Max)
        .collision_groups(groups);
    w.colliders.insert_with_parent(built, w.body_list[body as usize], &mut w.bodies);
}

#[no_mangle]
pub unsafe extern "C" fn rapier_add_ball(world: *mut World, body: u32, surface: *const Surface, x: f32, y: f32, radius: f32) {
    insert(&mut *world, body, surface, ColliderBuilder::ball(radius).translation(Vector::new(x, y)));
}

#[no_mangle]
pub unsafe extern "C" fn rapier_add_capsule(world: *mut World, body: u32, surface: *const Surface, ends: *const [f32; 2], radius: f32) {
    let (a, b) = (*ends, *ends.add(1));
    let shape = ColliderBuilder::capsule_from_endpoints(Vector::new(a[0], a[1]), Vector::new(b[0], b[1]), radius);
    insert(&mut *world, body, surface, shape);
}

#[no_mangle]
pub unsafe extern "C" fn rapier_add_box(world: *mut World, body: u32, surface: *const Surface, half_x: f32, half_y: f32, radius: f32) {
    let shape = if radius > 0.0 { ColliderBuilder::round_cuboid(half_x, half_y, radius) } else { ColliderBuilder::cuboid(half_x, half_y) };
    insert(&mut *world, body, surface, shape);
}

/// 0 when no hull is found.
#[no_mangle]
pub unsafe extern "C" fn rapier_add_polygon(world: *mut World, body: u32, surface: *const Surface, points: *const [f32; 2], count: i32, radius: f32) -> i32 {
    let list: Vec<Vector> = (0..count as usize).map(|k| Vector::new((*points.add(k))[0], (*points.add(k))[1])).collect();
    let shape = if radius > 0.0 { ColliderBuilder::round_convex_hull(&list, radius) } else { ColliderBuilder::convex_hull(&list) };
    match shape {
        Some(shape) => {
            insert(&mut *world, body, surface, shape);
            1
        }
        None => 0,
    }
}

unsafe fn join(w: &mut World, pin: &Pin, joint: GenericJoint) -> u32 {
    let (a, b) = (w.body_list[pin.body_a as usize], w.body_list[pin.body_b as usize]);
    w.joint_list.push(w.impulse_joints.insert(a, b, joint, true));
    w.joint_list.len() as u32 - 1
}

fn point(at: [f32; 2]) -> Vector {
    Vector::new(at[0], at[1])
}

#[no_mangle]
pub unsafe extern "C" fn rapier_pin(world: *mut World, pin: *const Pin) -> u32 {
    let p = &*pin;
    let mut joint = RevoluteJointBuilder::new().local_anchor1(point(p.anchor_a)).local_anchor2(point(p.anchor_b)).contacts_enabled(p.collide != 0);
    if p.limited != 0 {
        joint = joint.limits([p.lower + p.reference, p.upper + p.reference]);
    }
    join(&mut *world, p, joint.build().into())
}

#[no_mangle]
pub unsafe extern "C" fn rapier_weld(world: *mut World, pin: *const Pin) -> u32 {
    let p = &*pin;
    let joint = FixedJointBuilder::new()
        .local_frame1(Pose::new(point(p.anchor_a), p.reference))
        .local_frame2(Pose::new(point(p.anchor_b), 0.0))
        .contacts_enabled(p.collide != 0);
    join(&mut *world, p, joint.build().into())
}
