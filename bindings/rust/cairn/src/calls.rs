// Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
use crate::*;

pub use cairn_sys::cn_body as Body;
pub use cairn_sys::cn_shape as Shape;
pub use cairn_sys::cn_joint as Joint;
pub use cairn_sys::cn_constraint as Constraint;
pub use cairn_sys::cn_vec2 as Vec2;
pub use cairn_sys::cn_pose as Pose;
pub use cairn_sys::cn_velocity as Velocity;
pub use cairn_sys::cn_aabb as Aabb;
pub use cairn_sys::cn_mass_data as MassData;
pub use cairn_sys::cn_world_def as WorldDef;
pub use cairn_sys::cn_counters as Counters;
pub use cairn_sys::cn_island_report as IslandReport;
pub use cairn_sys::cn_profile as Profile;
pub use cairn_sys::cn_memory_stats as MemoryStats;
pub use cairn_sys::cn_body_def as BodyDef;
pub use cairn_sys::cn_body_moved as BodyMoved;
pub use cairn_sys::cn_filter as Filter;
pub use cairn_sys::cn_material as Material;
pub use cairn_sys::cn_shape_def as ShapeDef;
pub use cairn_sys::cn_circle as Circle;
pub use cairn_sys::cn_capsule as Capsule;
pub use cairn_sys::cn_edge as Edge;
pub use cairn_sys::cn_polygon as Polygon;
pub use cairn_sys::cn_chain as Chain;
pub use cairn_sys::cn_manifold_point as ManifoldPoint;
pub use cairn_sys::cn_manifold as Manifold;
pub use cairn_sys::cn_contact_event as ContactEvent;
pub use cairn_sys::cn_sensor_event as SensorEvent;
pub use cairn_sys::cn_joint_base as JointBase;
pub use cairn_sys::cn_revolute_def as RevoluteDef;
pub use cairn_sys::cn_distance_def as DistanceDef;
pub use cairn_sys::cn_fixed_def as FixedDef;
pub use cairn_sys::cn_prismatic_def as PrismaticDef;
pub use cairn_sys::cn_wheel_def as WheelDef;
pub use cairn_sys::cn_motor_def as MotorDef;
pub use cairn_sys::cn_mouse_def as MouseDef;
pub use cairn_sys::cn_gear_def as GearDef;
pub use cairn_sys::cn_pulley_def as PulleyDef;
pub use cairn_sys::cn_ratchet_def as RatchetDef;
pub use cairn_sys::cn_rotary_spring_def as RotarySpringDef;
pub use cairn_sys::cn_groove_def as GrooveDef;
pub use cairn_sys::cn_filter_joint_def as FilterJointDef;
pub use cairn_sys::cn_joint_event as JointEvent;
pub use cairn_sys::cn_angle_constraint_def as AngleConstraintDef;
pub use cairn_sys::cn_line_constraint_def as LineConstraintDef;
pub use cairn_sys::cn_update_report as UpdateReport;
pub use cairn_sys::cn_ray as Ray;
pub use cairn_sys::cn_ray_hit as RayHit;
pub use cairn_sys::cn_query_filter as QueryFilter;
pub use cairn_sys::cn_closest as Closest;
pub use cairn_sys::cn_distance as Distance;
pub use cairn_sys::cn_sweep as Sweep;
pub use cairn_sys::cn_impact as Impact;
pub use cairn_sys::cn_plane as Plane;
pub use cairn_sys::cn_mover_def as MoverDef;
pub use cairn_sys::cn_mover as Mover;
pub use cairn_sys::cn_area_def as AreaDef;
pub use cairn_sys::cn_explosion_def as ExplosionDef;
pub use cairn_sys::cn_debug_draw as DebugDraw;

pub(crate) trait Cleared {
    /// A copy without pointers, which C would follow.
    fn cleared(&self) -> Self;
}
impl Cleared for WorldDef {
    fn cleared(&self) -> Self {
        Self {
            memory: core::ptr::null_mut(),
            alloc: None,
            free: None,
            allocator_user: core::ptr::null_mut(),
            enqueue: None,
            finish: None,
            task_user: core::ptr::null_mut(),
            ..*self
        }
    }
}
impl Cleared for BodyDef {
    fn cleared(&self) -> Self {
        Self {
            name: core::ptr::null(),
            ..*self
        }
    }
}
impl Cleared for Chain {
    fn cleared(&self) -> Self {
        Self {
            points_m: core::ptr::null(),
            ..*self
        }
    }
}
impl Cleared for QueryFilter {
    fn cleared(&self) -> Self {
        Self {
            visit: None,
            user: core::ptr::null_mut(),
            ..*self
        }
    }
}
impl Cleared for MoverDef {
    fn cleared(&self) -> Self {
        Self {
            filter: self.filter.cleared(),
            ..*self
        }
    }
}
impl Cleared for ExplosionDef {
    fn cleared(&self) -> Self {
        Self {
            filter: self.filter.cleared(),
            ..*self
        }
    }
}
impl Cleared for DebugDraw {
    fn cleared(&self) -> Self {
        Self {
            polygon: None,
            circle: None,
            capsule: None,
            segment: None,
            point: None,
            text: None,
            user: core::ptr::null_mut(),
            reserved: core::ptr::null_mut(),
            ..*self
        }
    }
}

impl World {
    /// Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
    /// O(awake bodies and their contacts and joints).
    pub fn step(&mut self, dt_s: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_step(self.pointer(), dt_s) })?;
        Ok(())
    }

    /// Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
    pub fn set_gravity(&mut self, gravity_x_mps2: f32, gravity_y_mps2: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_gravity(self.pointer(), gravity_x_mps2, gravity_y_mps2) })?;
        Ok(())
    }

    /// Reads gravity in m/s^2.
    pub fn get_gravity(&self) -> Result<Vec2> {
        let mut out_mps2 = Vec2::default();
        check(unsafe { cairn_sys::cn_world_get_gravity(self.pointer(), &mut out_mps2) })?;
        Ok(out_mps2)
    }

    /// Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.
    pub fn set_substep_count(&mut self, count: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_substep_count(self.pointer(), count) })?;
        Ok(())
    }

    /// Reads the substeps of a step.
    pub fn get_substep_count(&self) -> Result<i32> {
        let mut out_count = i32::default();
        check(unsafe { cairn_sys::cn_world_get_substep_count(self.pointer(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
    /// memory of the solver it was created with; a solver that needs more works without direct solving
    /// (CN_WARNING_FRAME_MEMORY).
    pub fn set_solver(&mut self, solver: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_solver(self.pointer(), solver) })?;
        Ok(())
    }

    /// Reads the solver (CN_SOLVER_*).
    pub fn get_solver(&self) -> Result<i32> {
        let mut out_solver = i32::default();
        check(unsafe { cairn_sys::cn_world_get_solver(self.pointer(), &mut out_solver) })?;
        Ok(out_solver)
    }

    /// Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
    pub fn set_accuracy(&mut self, accuracy_m: f32, work_budget: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_accuracy(self.pointer(), accuracy_m, work_budget) })?;
        Ok(())
    }

    /// Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
    /// (CN_DEFAULT: none).
    pub fn get_accuracy(&self) -> Result<(f32, i32)> {
        let mut out_accuracy_m = f32::default();
        let mut out_work_budget = i32::default();
        check(unsafe { cairn_sys::cn_world_get_accuracy(self.pointer(), &mut out_accuracy_m, &mut out_work_budget) })?;
        Ok((out_accuracy_m, out_work_budget))
    }

    /// Reads how many workers a step can use: 1, or worker_count where the library supports threads.
    pub fn get_worker_count(&self) -> Result<i32> {
        let mut out_count = i32::default();
        check(unsafe { cairn_sys::cn_world_get_worker_count(self.pointer(), &mut out_count) })?;
        Ok(out_count)
    }

    /// Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
    pub fn set_flags(&mut self, flags: u32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_flags(self.pointer(), flags) })?;
        Ok(())
    }

    /// Reads the CN_WORLD_ flags.
    pub fn get_flags(&self) -> Result<u32> {
        let mut out_flags = u32::default();
        check(unsafe { cairn_sys::cn_world_get_flags(self.pointer(), &mut out_flags) })?;
        Ok(out_flags)
    }

    /// Impacts slower than this, in m/s, do not bounce; >= 0.
    pub fn set_restitution_threshold(&mut self, speed_mps: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_restitution_threshold(self.pointer(), speed_mps) })?;
        Ok(())
    }

    /// Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
    pub fn set_hit_speed(&mut self, speed_mps: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_hit_speed(self.pointer(), speed_mps) })?;
        Ok(())
    }

    /// Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster
    /// bodies down to them and keeps the direction.
    pub fn set_speed_limits(&mut self, linear_mps: f32, angular_radps: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_speed_limits(self.pointer(), linear_mps, angular_radps) })?;
        Ok(())
    }

    /// Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
    /// they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
    /// others that no joint holds and that are slower than four times the speed lose theirs within a second
    /// or two: what rocks in a hollow would keep all of a heap awake.
    pub fn set_sleep(&mut self, speed_mps: f32, delay_s: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_sleep(self.pointer(), speed_mps, delay_s) })?;
        Ok(())
    }

    /// Stores a number for the user.
    pub fn set_user_data(&mut self, user_data: u64) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_user_data(self.pointer(), user_data) })?;
        Ok(())
    }

    /// Reads the user's number.
    pub fn get_user_data(&self) -> Result<u64> {
        let mut out_user_data = u64::default();
        check(unsafe { cairn_sys::cn_world_get_user_data(self.pointer(), &mut out_user_data) })?;
        Ok(out_user_data)
    }

    /// Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
    /// capacity is 0. out_count is their number. O(slots).
    pub fn get_bodies(&self) -> Result<Vec<Body>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_get_bodies(self.pointer(), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_get_bodies(self.pointer(), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    pub fn get_shapes(&self) -> Result<Vec<Shape>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_get_shapes(self.pointer(), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_get_shapes(self.pointer(), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(slots).
    pub fn get_joints(&self) -> Result<Vec<Joint>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_get_joints(self.pointer(), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_get_joints(self.pointer(), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Reads counts of objects and what the last step reported. O(bodies + islands).
    pub fn get_counters(&self) -> Result<Counters> {
        let mut out_out = Counters::default();
        check(unsafe { cairn_sys::cn_world_get_counters(self.pointer(), &mut out_out) })?;
        Ok(out_out)
    }

    /// Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies,
    /// in a deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their
    /// number. A step does no work for it. O(bodies + contacts and joints of the islands written).
    pub fn get_islands(&self) -> Result<Vec<IslandReport>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_get_islands(self.pointer(), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_get_islands(self.pointer(), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Reads the seconds of the last step by stage.
    pub fn get_profile(&self) -> Result<Profile> {
        let mut out_out = Profile::default();
        check(unsafe { cairn_sys::cn_world_get_profile(self.pointer(), &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads the memory statistics.
    pub fn get_memory_stats(&self) -> Result<MemoryStats> {
        let mut out_out = MemoryStats::default();
        check(unsafe { cairn_sys::cn_world_get_memory_stats(self.pointer(), &mut out_out) })?;
        Ok(out_out)
    }

    /// Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position
    /// p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
    /// world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay,
    /// and no event is reported. Distances between bodies keep their digits; world anchors are rounded to
    /// floats at the new place. Arrays returned before become invalid; the user moves their own points
    /// (movers, rays, cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next
    /// step looks at all pairs again.
    pub fn shift_origin(&mut self, x_m: f32, y_m: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_shift_origin(self.pointer(), x_m, y_m) })?;
        Ok(())
    }

    /// 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
    /// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
    /// every compiler, CPU and thread count. O(bodies + contacts + joints).
    pub fn hash(&self) -> Result<u64> {
        let mut out_hash = u64::default();
        check(unsafe { cairn_sys::cn_world_hash(self.pointer(), &mut out_hash) })?;
        Ok(out_hash)
    }

    /// Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn save_size(&self) -> Result<u64> {
        let mut out_bytes = u64::default();
        check(unsafe { cairn_sys::cn_world_save_size(self.pointer(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    /// Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and
    /// the number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the
    /// world), about 1 KB per body.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { cairn_sys::cn_world_save_size(self.pointer(), &mut bytes) })?;
        let mut out: Vec<u8> = vec![0; bytes as usize];
        check(unsafe { cairn_sys::cn_world_save(self.pointer(), out.as_mut_ptr().cast(), bytes, &mut bytes) })?;
        out.truncate(bytes as usize);
        Ok(out)
    }

    /// Restores a saved state, into the saved world or one created with the same definition (broadphase,
    /// length unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save;
    /// CN_ERROR_FORMAT for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the
    /// objects alive then (a world in a caller's block has room for its own saves). Arrays returned before
    /// become invalid. Handles of objects alive at the save are valid again, also of objects destroyed since;
    /// handles created since are refused until the same handle is given to a new object: with the same calls
    /// to the same object. O(memory of the world).
    pub fn restore(&mut self, save: &[u8]) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_restore(self.pointer(), save.as_ptr().cast(), save.len() as u64) })?;
        Ok(())
    }

    /// Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
    pub fn write_size(&self) -> Result<u64> {
        let mut out_bytes = u64::default();
        check(unsafe { cairn_sys::cn_world_write_size(self.pointer(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    /// Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
    /// of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about
    /// 1 KB per body.
    pub fn write(&self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { cairn_sys::cn_world_write_size(self.pointer(), &mut bytes) })?;
        let mut out: Vec<u8> = vec![0; bytes as usize];
        check(unsafe { cairn_sys::cn_world_write(self.pointer(), out.as_mut_ptr().cast(), bytes, &mut bytes) })?;
        out.truncate(bytes as usize);
        Ok(out)
    }

    /// Creates a body. O(1) amortized.
    pub fn body_create(&mut self, def: &BodyDef) -> Result<Body> {
        let def = &def.cleared();
        let mut out_body = Body::default();
        self.check(unsafe { cairn_sys::cn_body_create(self.pointer(), def, &mut out_body) })?;
        Ok(out_body)
    }

    /// Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
    pub fn body_create_many(&mut self, defs: &[BodyDef], out_bodies: &mut [Body]) -> Result<()> {
        if defs.len() != out_bodies.len() {
            return Err(Error::uneven());
        }
        let defs: Vec<_> = defs.iter().map(Cleared::cleared).collect();
        self.check(unsafe { cairn_sys::cn_body_create_many(self.pointer(), defs.as_ptr(), out_bodies.len() as i32, out_bodies.as_mut_ptr()) })?;
        Ok(())
    }

    /// Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
    /// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts
    /// + joints + shapes).
    pub fn body_destroy(&mut self, body: Body) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_destroy(self.pointer(), body) })?;
        Ok(())
    }

    /// Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
    /// O(their contacts + joints + shapes).
    pub fn body_destroy_many(&mut self, bodies: &[Body]) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_destroy_many(self.pointer(), bodies.as_ptr(), bodies.len() as i32) })?;
        Ok(())
    }

    /// 1 if the handle names a living body of this world, else 0 (also for a NULL world).
    pub fn body_is_valid(&self, body: Body) -> bool {
        (unsafe { cairn_sys::cn_body_is_valid(self.pointer(), body) }) != 0
    }

    /// Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those
    /// that still overlap begin again in the next step), with its forces and any mass override; a body made
    /// static stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints +
    /// shapes).
    pub fn body_set_type(&mut self, body: Body, r#type: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_type(self.pointer(), body, r#type) })?;
        Ok(())
    }

    /// Reads the type (CN_BODY_*).
    pub fn body_get_type(&self, body: Body) -> Result<i32> {
        let mut out_type = i32::default();
        check(unsafe { cairn_sys::cn_body_get_type(self.pointer(), body, &mut out_type) })?;
        Ok(out_type)
    }

    /// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
    /// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
    /// are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
    pub fn body_set_flags(&mut self, body: Body, flags: u32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_flags(self.pointer(), body, flags) })?;
        Ok(())
    }

    /// Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
    pub fn body_get_flags(&self, body: Body) -> Result<u32> {
        let mut out_flags = u32::default();
        check(unsafe { cairn_sys::cn_body_get_flags(self.pointer(), body, &mut out_flags) })?;
        Ok(out_flags)
    }

    /// 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and
    /// disabled bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
    pub fn body_set_awake(&mut self, body: Body, awake: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_awake(self.pointer(), body, awake) })?;
        Ok(())
    }

    /// Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <=
    /// 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
    /// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
    /// neighbours. O(contacts + joints + shapes).
    pub fn body_set_pose(&mut self, body: Body, position_x_m: f32, position_y_m: f32, angle_rad: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_pose(self.pointer(), body, position_x_m, position_y_m, angle_rad) })?;
        Ok(())
    }

    /// Reads the position of the origin and the rotation.
    pub fn body_get_pose(&self, body: Body) -> Result<Pose> {
        let mut out_out = Pose::default();
        check(unsafe { cairn_sys::cn_body_get_pose(self.pointer(), body, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads the position of the origin as the sum of two floats: the high part is within rounding that of
    /// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in
    /// double is more precise; so is a difference of two bodies, taken high from high and low from low, in
    /// floats.
    pub fn body_get_position_parts(&self, body: Body) -> Result<(Vec2, Vec2)> {
        let mut out_high_m = Vec2::default();
        let mut out_low_m = Vec2::default();
        check(unsafe { cairn_sys::cn_body_get_position_parts(self.pointer(), body, &mut out_high_m, &mut out_low_m) })?;
        Ok((out_high_m, out_low_m))
    }

    /// Reads the angle in radians, in (-pi, pi\].
    pub fn body_get_angle(&self, body: Body) -> Result<f32> {
        let mut out_rad = f32::default();
        check(unsafe { cairn_sys::cn_body_get_angle(self.pointer(), body, &mut out_rad) })?;
        Ok(out_rad)
    }

    /// Reads the world position of the centre of mass, in metres.
    pub fn body_get_center(&self, body: Body) -> Result<Vec2> {
        let mut out_m = Vec2::default();
        check(unsafe { cairn_sys::cn_body_get_center(self.pointer(), body, &mut out_m) })?;
        Ok(out_m)
    }

    /// Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
    /// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.
    pub fn body_set_velocity(&mut self, body: Body, linear_x_mps: f32, linear_y_mps: f32, angular_radps: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_velocity(self.pointer(), body, linear_x_mps, linear_y_mps, angular_radps) })?;
        Ok(())
    }

    /// Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
    pub fn body_get_velocity(&self, body: Body) -> Result<Velocity> {
        let mut out_out = Velocity::default();
        check(unsafe { cairn_sys::cn_body_get_velocity(self.pointer(), body, &mut out_out) })?;
        Ok(out_out)
    }

    /// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1)
    /// takes it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits.
    /// Unlike after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this
    /// before every step, or stop the body after it.
    pub fn body_set_target_pose(&mut self, body: Body, position_x_m: f32, position_y_m: f32, angle_rad: f32, dt_s: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_target_pose(self.pointer(), body, position_x_m, position_y_m, angle_rad, dt_s) })?;
        Ok(())
    }

    /// Velocity in m/s of the body's material at a world point in metres.
    pub fn body_get_velocity_at(&self, body: Body, point_x_m: f32, point_y_m: f32) -> Result<Vec2> {
        let mut out_mps = Vec2::default();
        check(unsafe { cairn_sys::cn_body_get_velocity_at(self.pointer(), body, point_x_m, point_y_m, &mut out_mps) })?;
        Ok(out_mps)
    }

    /// World position of a point given in the body's frame, both in metres.
    pub fn body_get_world_point(&self, body: Body, local_x_m: f32, local_y_m: f32) -> Result<Vec2> {
        let mut out_m = Vec2::default();
        check(unsafe { cairn_sys::cn_body_get_world_point(self.pointer(), body, local_x_m, local_y_m, &mut out_m) })?;
        Ok(out_m)
    }

    /// Position in the body's frame of a world point, both in metres.
    pub fn body_get_local_point(&self, body: Body, world_x_m: f32, world_y_m: f32) -> Result<Vec2> {
        let mut out_m = Vec2::default();
        check(unsafe { cairn_sys::cn_body_get_local_point(self.pointer(), body, world_x_m, world_y_m, &mut out_m) })?;
        Ok(out_m)
    }

    /// Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
    /// O(shapes).
    pub fn body_get_aabb(&self, body: Body) -> Result<Aabb> {
        let mut out_out = Aabb::default();
        check(unsafe { cairn_sys::cn_body_get_aabb(self.pointer(), body, &mut out_out) })?;
        Ok(out_out)
    }

    /// Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static,
    /// kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.
    pub fn body_apply_force(&mut self, body: Body, force_x_N: f32, force_y_N: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_force(self.pointer(), body, force_x_N, force_y_N) })?;
        Ok(())
    }

    /// Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
    /// cn_body_apply_force.
    pub fn body_apply_force_at(&mut self, body: Body, force_x_N: f32, force_y_N: f32, point_x_m: f32, point_y_m: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_force_at(self.pointer(), body, force_x_N, force_y_N, point_x_m, point_y_m) })?;
        Ok(())
    }

    /// Adds a torque in newton metres; otherwise as cn_body_apply_force.
    pub fn body_apply_torque(&mut self, body: Body, torque_Nm: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_torque(self.pointer(), body, torque_Nm) })?;
        Ok(())
    }

    /// Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
    /// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
    /// overflows.
    pub fn body_apply_impulse(&mut self, body: Body, impulse_x_Ns: f32, impulse_y_Ns: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_impulse(self.pointer(), body, impulse_x_Ns, impulse_y_Ns) })?;
        Ok(())
    }

    /// Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity
    /// too; otherwise as cn_body_apply_impulse.
    pub fn body_apply_impulse_at(&mut self, body: Body, impulse_x_Ns: f32, impulse_y_Ns: f32, point_x_m: f32, point_y_m: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_impulse_at(self.pointer(), body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m) })?;
        Ok(())
    }

    /// Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
    /// cn_body_apply_impulse.
    pub fn body_apply_angular_impulse(&mut self, body: Body, impulse_Nms: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_apply_angular_impulse(self.pointer(), body, impulse_Nms) })?;
        Ok(())
    }

    /// Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
    /// shapes have no mass weighs 1 kg; without shapes it does not rotate.
    pub fn body_get_mass_data(&self, body: Body) -> Result<MassData> {
        let mut out_out = MassData::default();
        check(unsafe { cairn_sys::cn_body_get_mass_data(self.pointer(), body, &mut out_out) })?;
        Ok(out_out)
    }

    /// Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
    /// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35.
    /// Wakes the body.
    pub fn body_set_mass_data(&mut self, body: Body, mass: &MassData) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_mass_data(self.pointer(), body, mass) })?;
        Ok(())
    }

    /// Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
    pub fn body_reset_mass_data(&mut self, body: Body) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_reset_mass_data(self.pointer(), body) })?;
        Ok(())
    }

    /// Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
    pub fn body_set_damping(&mut self, body: Body, linear_per_s: f32, angular_per_s: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_damping(self.pointer(), body, linear_per_s, angular_per_s) })?;
        Ok(())
    }

    /// Reads the linear and angular damping in 1/s.
    pub fn body_get_damping(&self, body: Body) -> Result<(f32, f32)> {
        let mut out_linear_per_s = f32::default();
        let mut out_angular_per_s = f32::default();
        check(unsafe { cairn_sys::cn_body_get_damping(self.pointer(), body, &mut out_linear_per_s, &mut out_angular_per_s) })?;
        Ok((out_linear_per_s, out_angular_per_s))
    }

    /// Sets the factor on gravity for this body, finite. A change wakes the body.
    pub fn body_set_gravity_scale(&mut self, body: Body, scale: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_gravity_scale(self.pointer(), body, scale) })?;
        Ok(())
    }

    /// Reads the factor on gravity.
    pub fn body_get_gravity_scale(&self, body: Body) -> Result<f32> {
        let mut out_scale = f32::default();
        check(unsafe { cairn_sys::cn_body_get_gravity_scale(self.pointer(), body, &mut out_scale) })?;
        Ok(out_scale)
    }

    /// Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
    pub fn body_set_sleep_speed(&mut self, body: Body, speed_mps: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_sleep_speed(self.pointer(), body, speed_mps) })?;
        Ok(())
    }

    /// Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
    /// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
    /// bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
    /// within the work_budget. Takes effect with the next step; does not wake.
    pub fn body_set_solver(&mut self, body: Body, solver: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_solver(self.pointer(), body, solver) })?;
        Ok(())
    }

    /// Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn body_get_solver(&self, body: Body) -> Result<i32> {
        let mut out_solver = i32::default();
        check(unsafe { cairn_sys::cn_body_get_solver(self.pointer(), body, &mut out_solver) })?;
        Ok(out_solver)
    }

    /// Stores a number for the user.
    pub fn body_set_user_data(&mut self, body: Body, user_data: u64) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_user_data(self.pointer(), body, user_data) })?;
        Ok(())
    }

    /// Reads the user's number.
    pub fn body_get_user_data(&self, body: Body) -> Result<u64> {
        let mut out_user_data = u64::default();
        check(unsafe { cairn_sys::cn_body_get_user_data(self.pointer(), body, &mut out_user_data) })?;
        Ok(out_user_data)
    }

    /// Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
    /// O(length).
    pub fn body_set_name(&mut self, body: Body, name: Option<&core::ffi::CStr>) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_body_set_name(self.pointer(), body, name.map_or(core::ptr::null(), |value| value.as_ptr())) })?;
        Ok(())
    }

    /// Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
    pub fn body_get_name(&self, body: Body) -> Result<&core::ffi::CStr> {
        let mut text = core::ptr::null();
        check(unsafe { cairn_sys::cn_body_get_name(self.pointer(), body, &mut text) })?;
        Ok(unsafe { core::ffi::CStr::from_ptr(text) })
    }

    /// Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).
    pub fn body_get_shapes(&self, body: Body) -> Result<Vec<Shape>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_body_get_shapes(self.pointer(), body, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_body_get_shapes(self.pointer(), body, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Handles of the body's joints without constraints; out, capacity and *out_count as in
    /// cn_world_get_bodies. O(joints).
    pub fn body_get_joints(&self, body: Body) -> Result<Vec<Joint>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_body_get_joints(self.pointer(), body, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_body_get_joints(self.pointer(), body, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then
    /// be their number. One bad handle fails the whole call. O(count).
    pub fn read_poses(&self, bodies: Option<&[Body]>, out: &mut [Pose]) -> Result<()> {
        if bodies.map_or(false, |value| value.len() != out.len()) {
            return Err(Error::uneven());
        }
        check(unsafe { cairn_sys::cn_world_read_poses(self.pointer(), bodies.map_or(core::ptr::null(), |value| value.as_ptr()), out.len() as i32, out.as_mut_ptr()) })?;
        Ok(())
    }

    /// Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
    pub fn read_velocities(&self, bodies: Option<&[Body]>, out: &mut [Velocity]) -> Result<()> {
        if bodies.map_or(false, |value| value.len() != out.len()) {
            return Err(Error::uneven());
        }
        check(unsafe { cairn_sys::cn_world_read_velocities(self.pointer(), bodies.map_or(core::ptr::null(), |value| value.as_ptr()), out.len() as i32, out.as_mut_ptr()) })?;
        Ok(())
    }

    /// Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
    /// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).
    pub fn write_velocities(&mut self, bodies: Option<&[Body]>, velocities: &[Velocity]) -> Result<()> {
        if bodies.map_or(false, |value| value.len() != velocities.len()) {
            return Err(Error::uneven());
        }
        self.check(unsafe { cairn_sys::cn_world_write_velocities(self.pointer(), bodies.map_or(core::ptr::null(), |value| value.as_ptr()), velocities.len() as i32, velocities.as_ptr()) })?;
        Ok(())
    }

    /// Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since.
    /// The first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
    pub fn moved(&mut self) -> Result<&[BodyMoved]> {
        let (mut data, mut count) = (core::ptr::null(), 0);
        self.check(unsafe { cairn_sys::cn_world_moved(self.pointer(), &mut data, &mut count) })?;
        Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })
    }

    /// Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
    pub fn shape_create_circle(&mut self, def: &ShapeDef, circle: &Circle) -> Result<Shape> {
        let mut out_shape = Shape::default();
        self.check(unsafe { cairn_sys::cn_shape_create_circle(self.pointer(), def, circle, &mut out_shape) })?;
        Ok(out_shape)
    }

    /// Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body.
    /// out_shape may be NULL.
    pub fn shape_create_capsule(&mut self, def: &ShapeDef, capsule: &Capsule) -> Result<Shape> {
        let mut out_shape = Shape::default();
        self.check(unsafe { cairn_sys::cn_shape_create_capsule(self.pointer(), def, capsule, &mut out_shape) })?;
        Ok(out_shape)
    }

    /// Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.
    pub fn shape_create_edge(&mut self, def: &ShapeDef, edge: &Edge) -> Result<Shape> {
        let mut out_shape = Shape::default();
        self.check(unsafe { cairn_sys::cn_shape_create_edge(self.pointer(), def, edge, &mut out_shape) })?;
        Ok(out_shape)
    }

    /// Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
    /// out_shape may be NULL.
    pub fn shape_create_polygon(&mut self, def: &ShapeDef, polygon: &Polygon) -> Result<Shape> {
        let mut out_shape = Shape::default();
        self.check(unsafe { cairn_sys::cn_shape_create_polygon(self.pointer(), def, polygon, &mut out_shape) })?;
        Ok(out_shape)
    }

    /// Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body.
    /// out_shape may be NULL.
    pub fn shape_create_box(&mut self, def: &ShapeDef, half_width_m: f32, half_height_m: f32, radius_m: f32) -> Result<Shape> {
        let mut out_shape = Shape::default();
        self.check(unsafe { cairn_sys::cn_shape_create_box(self.pointer(), def, half_width_m, half_height_m, radius_m, &mut out_shape) })?;
        Ok(out_shape)
    }

    /// Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static
    /// one. CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
    pub fn shape_attach(&mut self, shape: Shape, body: Body) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_attach(self.pointer(), shape, body) })?;
        Ok(())
    }

    /// Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no
    /// body. O(contacts + shapes of the body).
    pub fn shape_detach(&mut self, shape: Shape) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_detach(self.pointer(), shape) })?;
        Ok(())
    }

    /// Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
    pub fn shape_destroy(&mut self, shape: Shape) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_destroy(self.pointer(), shape) })?;
        Ok(())
    }

    /// 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
    pub fn shape_is_valid(&self, shape: Shape) -> bool {
        (unsafe { cairn_sys::cn_shape_is_valid(self.pointer(), shape) }) != 0
    }

    /// Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
    pub fn shape_get_type(&self, shape: Shape) -> Result<i32> {
        let mut out_type = i32::default();
        check(unsafe { cairn_sys::cn_shape_get_type(self.pointer(), shape, &mut out_type) })?;
        Ok(out_type)
    }

    /// Reads the body; 0 if unattached.
    pub fn shape_get_body(&self, shape: Shape) -> Result<Body> {
        let mut out_body = Body::default();
        check(unsafe { cairn_sys::cn_shape_get_body(self.pointer(), shape, &mut out_body) })?;
        Ok(out_body)
    }

    /// Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
    /// body).
    pub fn shape_set_material(&mut self, shape: Shape, material: &Material) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_material(self.pointer(), shape, material) })?;
        Ok(())
    }

    /// Reads the material.
    pub fn shape_get_material(&self, shape: Shape) -> Result<Material> {
        let mut out_out = Material::default();
        check(unsafe { cairn_sys::cn_shape_get_material(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
    /// wakes the body. O(shapes of the body).
    pub fn shape_set_density(&mut self, shape: Shape, density_kgpm2: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_density(self.pointer(), shape, density_kgpm2) })?;
        Ok(())
    }

    /// Reads the density in kg/m^2.
    pub fn shape_get_density(&self, shape: Shape) -> Result<f32> {
        let mut out_kgpm2 = f32::default();
        check(unsafe { cairn_sys::cn_shape_get_density(self.pointer(), shape, &mut out_kgpm2) })?;
        Ok(out_kgpm2)
    }

    /// Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
    /// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn shape_set_filter(&mut self, shape: Shape, filter: &Filter) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_filter(self.pointer(), shape, filter) })?;
        Ok(())
    }

    /// Reads the filter.
    pub fn shape_get_filter(&self, shape: Shape) -> Result<Filter> {
        let mut out_out = Filter::default();
        check(unsafe { cairn_sys::cn_shape_get_filter(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts
    /// of the body).
    pub fn shape_set_event_mask(&mut self, shape: Shape, event_mask: u32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_event_mask(self.pointer(), shape, event_mask) })?;
        Ok(())
    }

    /// Reads the event mask.
    pub fn shape_get_event_mask(&self, shape: Shape) -> Result<u32> {
        let mut out_event_mask = u32::default();
        check(unsafe { cairn_sys::cn_shape_get_event_mask(self.pointer(), shape, &mut out_event_mask) })?;
        Ok(out_event_mask)
    }

    /// Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the
    /// next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
    pub fn shape_set_flags(&mut self, shape: Shape, flags: u32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_flags(self.pointer(), shape, flags) })?;
        Ok(())
    }

    /// Reads the CN_SHAPE_ flags.
    pub fn shape_get_flags(&self, shape: Shape) -> Result<u32> {
        let mut out_flags = u32::default();
        check(unsafe { cairn_sys::cn_shape_get_flags(self.pointer(), shape, &mut out_flags) })?;
        Ok(out_flags)
    }

    /// Stores a number for the user.
    pub fn shape_set_user_data(&mut self, shape: Shape, user_data: u64) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_user_data(self.pointer(), shape, user_data) })?;
        Ok(())
    }

    /// Reads the user's number.
    pub fn shape_get_user_data(&self, shape: Shape) -> Result<u64> {
        let mut out_user_data = u64::default();
        check(unsafe { cairn_sys::cn_shape_get_user_data(self.pointer(), shape, &mut out_user_data) })?;
        Ok(out_user_data)
    }

    /// AABB without margin, in the world (in the shape's own space when unattached). O(points).
    pub fn shape_get_aabb(&self, shape: Shape) -> Result<Aabb> {
        let mut out_out = Aabb::default();
        check(unsafe { cairn_sys::cn_shape_get_aabb(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
    /// O(points).
    pub fn shape_get_mass_data(&self, shape: Shape) -> Result<MassData> {
        let mut out_out = MassData::default();
        check(unsafe { cairn_sys::cn_shape_get_mass_data(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shape_get_circle(&self, shape: Shape) -> Result<Circle> {
        let mut out_out = Circle::default();
        check(unsafe { cairn_sys::cn_shape_get_circle(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shape_get_capsule(&self, shape: Shape) -> Result<Capsule> {
        let mut out_out = Capsule::default();
        check(unsafe { cairn_sys::cn_shape_get_capsule(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shape_get_edge(&self, shape: Shape) -> Result<Edge> {
        let mut out_out = Edge::default();
        check(unsafe { cairn_sys::cn_shape_get_edge(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
    pub fn shape_get_polygon(&self, shape: Shape) -> Result<Polygon> {
        let mut out_out = Polygon::default();
        check(unsafe { cairn_sys::cn_shape_get_polygon(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
    /// NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
    /// written).
    pub fn shape_get_chain_points(&self, shape: Shape) -> Result<Vec<Vec2>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_shape_get_chain_points(self.pointer(), shape, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_shape_get_chain_points(self.pointer(), shape, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
    /// of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
    /// once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
    /// the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
    /// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
    /// CN_ERROR_STATE for another type. O(contacts + shapes of the body).
    pub fn shape_set_circle(&mut self, shape: Shape, circle: &Circle) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_circle(self.pointer(), shape, circle) })?;
        Ok(())
    }

    /// Replaces a capsule in place; otherwise as cn_shape_set_circle.
    pub fn shape_set_capsule(&mut self, shape: Shape, capsule: &Capsule) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_capsule(self.pointer(), shape, capsule) })?;
        Ok(())
    }

    /// Replaces an edge in place; otherwise as cn_shape_set_circle.
    pub fn shape_set_edge(&mut self, shape: Shape, edge: &Edge) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_edge(self.pointer(), shape, edge) })?;
        Ok(())
    }

    /// Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.
    pub fn shape_set_polygon(&mut self, shape: Shape, polygon: &Polygon) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_polygon(self.pointer(), shape, polygon) })?;
        Ok(())
    }

    /// out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
    /// unattached), else 0. Edges and chains contain no point. O(points).
    pub fn shape_test_point(&self, shape: Shape, point_x_m: f32, point_y_m: f32) -> Result<i32> {
        let mut out_inside = i32::default();
        check(unsafe { cairn_sys::cn_shape_test_point(self.pointer(), shape, point_x_m, point_y_m, &mut out_inside) })?;
        Ok(out_inside)
    }

    /// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
    /// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
    /// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
    /// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
    /// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
    /// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of
    /// the step, and got an impulse; bodies that pass a blow on to others that already touch them, without
    /// closing, have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which
    /// they begin), STAY or HIT.
    pub fn contact_events(&mut self, kind: i32) -> Result<&[ContactEvent]> {
        let (mut data, mut count) = (core::ptr::null(), 0);
        self.check(unsafe { cairn_sys::cn_world_contact_events(self.pointer(), kind, &mut data, &mut count) })?;
        Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })
    }

    /// The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
    /// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
    /// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
    /// chains. A pair without an awake body reports nothing until one wakes.
    pub fn sensor_events(&self) -> Result<&[SensorEvent]> {
        let (mut data, mut count) = (core::ptr::null(), 0);
        check(unsafe { cairn_sys::cn_world_sensor_events(self.pointer(), &mut data, &mut count) })?;
        Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })
    }

    /// The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
    /// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
    /// impulses of the last substep. At rest their force is that of the points times substep_count (with
    /// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
    /// *out_count is their number. O(contacts).
    pub fn body_get_contacts(&self, body: Body) -> Result<Vec<ContactEvent>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_body_get_contacts(self.pointer(), body, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_body_get_contacts(self.pointer(), body, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
    /// cn_body_get_contacts. O(contacts of its body).
    pub fn shape_get_contacts(&self, shape: Shape) -> Result<Vec<ContactEvent>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_shape_get_contacts(self.pointer(), shape, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_shape_get_contacts(self.pointer(), shape, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
    /// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
    /// its body), squared for chains.
    pub fn shape_get_visitors(&self, sensor: Shape) -> Result<Vec<Shape>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_shape_get_visitors(self.pointer(), sensor, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_shape_get_visitors(self.pointer(), sensor, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
    /// destroyed since are stale.
    pub fn fell_asleep(&self) -> Result<&[Body]> {
        let (mut data, mut count) = (core::ptr::null(), 0);
        check(unsafe { cairn_sys::cn_world_fell_asleep(self.pointer(), &mut data, &mut count) })?;
        Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })
    }

    /// Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn joint_create_revolute(&mut self, def: &RevoluteDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_revolute(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn joint_create_distance(&mut self, def: &DistanceDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_distance(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_fixed(&mut self, def: &FixedDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_fixed(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or
    /// neither is dynamic. O(contacts of body_a).
    pub fn joint_create_prismatic(&mut self, def: &PrismaticDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_prismatic(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_wheel(&mut self, def: &WheelDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_wheel(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_motor(&mut self, def: &MotorDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_motor(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or body_a is not 0. O(contacts of body_a).
    pub fn joint_create_mouse(&mut self, def: &MouseDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_mouse(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
    /// dynamic. O(contacts of body_a).
    pub fn joint_create_gear(&mut self, def: &GearDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_gear(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_pulley(&mut self, def: &PulleyDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_pulley(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_ratchet(&mut self, def: &RatchetDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_ratchet(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic. O(contacts of body_a).
    pub fn joint_create_rotary_spring(&mut self, def: &RotarySpringDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_rotary_spring(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
    /// is dynamic, or the slot has no length. O(contacts of body_a).
    pub fn joint_create_groove(&mut self, def: &GrooveDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_groove(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
    /// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
    /// body_a).
    pub fn joint_create_filter(&mut self, def: &FilterJointDef) -> Result<Joint> {
        let mut out_joint = Joint::default();
        self.check(unsafe { cairn_sys::cn_joint_create_filter(self.pointer(), def, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// Destroys a joint and wakes its bodies. No event is reported.
    pub fn joint_destroy(&mut self, joint: Joint) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_destroy(self.pointer(), joint) })?;
        Ok(())
    }

    /// 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).
    pub fn joint_is_valid(&self, joint: Joint) -> bool {
        (unsafe { cairn_sys::cn_joint_is_valid(self.pointer(), joint) }) != 0
    }

    /// Reads the type (CN_JOINT_REVOLUTE to _FILTER).
    pub fn joint_get_type(&self, joint: Joint) -> Result<i32> {
        let mut out_type = i32::default();
        check(unsafe { cairn_sys::cn_joint_get_type(self.pointer(), joint, &mut out_type) })?;
        Ok(out_type)
    }

    /// Reads both bodies; 0 stands for the world.
    pub fn joint_get_bodies(&self, joint: Joint) -> Result<(Body, Body)> {
        let mut out_a = Body::default();
        let mut out_b = Body::default();
        check(unsafe { cairn_sys::cn_joint_get_bodies(self.pointer(), joint, &mut out_a, &mut out_b) })?;
        Ok((out_a, out_b))
    }

    /// Reads the world positions of both anchors, in metres.
    pub fn joint_get_anchors(&self, joint: Joint) -> Result<(Vec2, Vec2)> {
        let mut out_world_a_m = Vec2::default();
        let mut out_world_b_m = Vec2::default();
        check(unsafe { cairn_sys::cn_joint_get_anchors(self.pointer(), joint, &mut out_world_a_m, &mut out_world_b_m) })?;
        Ok((out_world_a_m, out_world_b_m))
    }

    /// Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
    /// after a change of type or of CN_BODY_ENABLED of one of its bodies.
    pub fn joint_get_reaction(&self, joint: Joint) -> Result<(Vec2, f32)> {
        let mut out_force_N = Vec2::default();
        let mut out_torque_Nm = f32::default();
        check(unsafe { cairn_sys::cn_joint_get_reaction(self.pointer(), joint, &mut out_force_N, &mut out_torque_Nm) })?;
        Ok((out_force_N, out_torque_Nm))
    }

    /// Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
    /// (angles beyond limits).
    pub fn joint_get_error(&self, joint: Joint) -> Result<(f32, f32)> {
        let mut out_m = f32::default();
        let mut out_rad = f32::default();
        check(unsafe { cairn_sys::cn_joint_get_error(self.pointer(), joint, &mut out_m, &mut out_rad) })?;
        Ok((out_m, out_rad))
    }

    /// Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
    /// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
    /// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for
    /// a world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next
    /// step; does not wake.
    pub fn joint_set_solver(&mut self, joint: Joint, solver: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_solver(self.pointer(), joint, solver) })?;
        Ok(())
    }

    /// Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
    pub fn joint_get_solver(&self, joint: Joint) -> Result<i32> {
        let mut out_solver = i32::default();
        check(unsafe { cairn_sys::cn_joint_get_solver(self.pointer(), joint, &mut out_solver) })?;
        Ok(out_solver)
    }

    /// Stores a number for the user.
    pub fn joint_set_user_data(&mut self, joint: Joint, user_data: u64) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_user_data(self.pointer(), joint, user_data) })?;
        Ok(())
    }

    /// Reads the user's number.
    pub fn joint_get_user_data(&self, joint: Joint) -> Result<u64> {
        let mut out_user_data = u64::default();
        check(unsafe { cairn_sys::cn_joint_get_user_data(self.pointer(), joint, &mut out_user_data) })?;
        Ok(out_user_data)
    }

    /// Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn joint_set_flags(&mut self, joint: Joint, flags: u32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_flags(self.pointer(), joint, flags) })?;
        Ok(())
    }

    /// Reads the CN_JOINT_ flags.
    pub fn joint_get_flags(&self, joint: Joint) -> Result<u32> {
        let mut out_flags = u32::default();
        check(unsafe { cairn_sys::cn_joint_get_flags(self.pointer(), joint, &mut out_flags) })?;
        Ok(out_flags)
    }

    /// Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
    pub fn joint_get_revolute(&self, joint: Joint) -> Result<RevoluteDef> {
        let mut out_out = RevoluteDef::default();
        check(unsafe { cairn_sys::cn_joint_get_revolute(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_revolute(&mut self, joint: Joint, def: &RevoluteDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_revolute(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a distance joint. CN_ERROR_STATE for another type.
    pub fn joint_get_distance(&self, joint: Joint) -> Result<DistanceDef> {
        let mut out_out = DistanceDef::default();
        check(unsafe { cairn_sys::cn_joint_get_distance(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_distance(&mut self, joint: Joint, def: &DistanceDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_distance(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
    pub fn joint_get_fixed(&self, joint: Joint) -> Result<FixedDef> {
        let mut out_out = FixedDef::default();
        check(unsafe { cairn_sys::cn_joint_get_fixed(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_fixed(&mut self, joint: Joint, def: &FixedDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_fixed(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
    pub fn joint_get_prismatic(&self, joint: Joint) -> Result<PrismaticDef> {
        let mut out_out = PrismaticDef::default();
        check(unsafe { cairn_sys::cn_joint_get_prismatic(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors
    /// and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_prismatic(&mut self, joint: Joint, def: &PrismaticDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_prismatic(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
    pub fn joint_get_wheel(&self, joint: Joint) -> Result<WheelDef> {
        let mut out_out = WheelDef::default();
        check(unsafe { cairn_sys::cn_joint_get_wheel(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_wheel(&mut self, joint: Joint, def: &WheelDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_wheel(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a motor joint. CN_ERROR_STATE for another type.
    pub fn joint_get_motor_to(&self, joint: Joint) -> Result<MotorDef> {
        let mut out_out = MotorDef::default();
        check(unsafe { cairn_sys::cn_joint_get_motor_to(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_motor_to(&mut self, joint: Joint, def: &MotorDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_motor_to(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
    pub fn joint_get_mouse(&self, joint: Joint) -> Result<MouseDef> {
        let mut out_out = MouseDef::default();
        check(unsafe { cairn_sys::cn_joint_get_mouse(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
    /// CN_JOINT_COLLIDE changes.
    pub fn joint_set_mouse(&mut self, joint: Joint, def: &MouseDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_mouse(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a gear joint. CN_ERROR_STATE for another type.
    pub fn joint_get_gear(&self, joint: Joint) -> Result<GearDef> {
        let mut out_out = GearDef::default();
        check(unsafe { cairn_sys::cn_joint_get_gear(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn joint_set_gear(&mut self, joint: Joint, def: &GearDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_gear(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
    pub fn joint_get_pulley(&self, joint: Joint) -> Result<PulleyDef> {
        let mut out_out = PulleyDef::default();
        check(unsafe { cairn_sys::cn_joint_get_pulley(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_pulley(&mut self, joint: Joint, def: &PulleyDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_pulley(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
    pub fn joint_get_ratchet(&self, joint: Joint) -> Result<RatchetDef> {
        let mut out_out = RatchetDef::default();
        check(unsafe { cairn_sys::cn_joint_get_ratchet(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes
    /// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
    pub fn joint_set_ratchet(&mut self, joint: Joint, def: &RatchetDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_ratchet(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
    pub fn joint_get_rotary_spring(&self, joint: Joint) -> Result<RotarySpringDef> {
        let mut out_out = RotarySpringDef::default();
        check(unsafe { cairn_sys::cn_joint_get_rotary_spring(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_rotary_spring(&mut self, joint: Joint, def: &RotarySpringDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_rotary_spring(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the definition of a groove joint. CN_ERROR_STATE for another type.
    pub fn joint_get_groove(&self, joint: Joint) -> Result<GrooveDef> {
        let mut out_out = GrooveDef::default();
        check(unsafe { cairn_sys::cn_joint_get_groove(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
    /// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
    /// changes.
    pub fn joint_set_groove(&mut self, joint: Joint, def: &GrooveDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_groove(self.pointer(), joint, def) })?;
        Ok(())
    }

    /// Reads the base of a joint of any type.
    pub fn joint_get_base(&self, joint: Joint) -> Result<JointBase> {
        let mut out_out = JointBase::default();
        check(unsafe { cairn_sys::cn_joint_get_base(self.pointer(), joint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges
    /// as in cn_joint_base. Wakes both bodies.
    pub fn joint_set_base(&mut self, joint: Joint, base: &JointBase) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_base(self.pointer(), joint, base) })?;
        Ok(())
    }

    /// Sets the target of a mouse joint, a world point in metres; cheap enough for every frame.
    /// CN_ERROR_STATE for another type. Wakes the body.
    pub fn joint_set_target(&mut self, joint: Joint, target_x_m: f32, target_y_m: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_target(self.pointer(), joint, target_x_m, target_y_m) })?;
        Ok(())
    }

    /// Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
    /// reference) in (-pi, pi\]. Distance, pulley: the present length. Prismatic, wheel, groove: the
    /// translation along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a;
    /// ratchet, rotary spring: angle b - angle a; these three over whole turns.
    pub fn joint_get_position(&self, joint: Joint) -> Result<f32> {
        let mut out_position = f32::default();
        check(unsafe { cairn_sys::cn_joint_get_position(self.pointer(), joint, &mut out_position) })?;
        Ok(out_position)
    }

    /// Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
    /// positive motor speed has the same sign.
    pub fn joint_get_speed(&self, joint: Joint) -> Result<f32> {
        let mut out_speed = f32::default();
        check(unsafe { cairn_sys::cn_joint_get_speed(self.pointer(), joint, &mut out_speed) })?;
        Ok(out_speed)
    }

    /// Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
    /// prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
    pub fn joint_set_motor(&mut self, joint: Joint, speed: f32, force_or_torque_max: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_motor(self.pointer(), joint, speed, force_or_torque_max) })?;
        Ok(())
    }

    /// Sets the limits, lower <= upper, of a revolute (radians in \[-pi, pi\]), distance (metres >= 0),
    /// prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
    pub fn joint_set_limits(&mut self, joint: Joint, lower: f32, upper: f32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_joint_set_limits(self.pointer(), joint, lower, upper) })?;
        Ok(())
    }

    /// Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a
    /// body in that step or between it and the step before.
    pub fn joint_events(&self) -> Result<&[JointEvent]> {
        let (mut data, mut count) = (core::ptr::null(), 0);
        check(unsafe { cairn_sys::cn_world_joint_events(self.pointer(), &mut data, &mut count) })?;
        Ok(if count == 0 { &[] } else { unsafe { core::slice::from_raw_parts(data, count as usize) } })
    }

    /// Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn constraint_create_angle(&mut self, def: &AngleConstraintDef) -> Result<Constraint> {
        let mut out_constraint = Constraint::default();
        self.check(unsafe { cairn_sys::cn_constraint_create_angle(self.pointer(), def, &mut out_constraint) })?;
        Ok(out_constraint)
    }

    /// Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
    /// not dynamic. Wakes the body.
    pub fn constraint_create_line(&mut self, def: &LineConstraintDef) -> Result<Constraint> {
        let mut out_constraint = Constraint::default();
        self.check(unsafe { cairn_sys::cn_constraint_create_line(self.pointer(), def, &mut out_constraint) })?;
        Ok(out_constraint)
    }

    /// Destroys a constraint and wakes its body. No event is reported.
    pub fn constraint_destroy(&mut self, constraint: Constraint) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_constraint_destroy(self.pointer(), constraint) })?;
        Ok(())
    }

    /// 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).
    pub fn constraint_is_valid(&self, constraint: Constraint) -> bool {
        (unsafe { cairn_sys::cn_constraint_is_valid(self.pointer(), constraint) }) != 0
    }

    /// Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
    pub fn constraint_get_type(&self, constraint: Constraint) -> Result<i32> {
        let mut out_type = i32::default();
        check(unsafe { cairn_sys::cn_constraint_get_type(self.pointer(), constraint, &mut out_type) })?;
        Ok(out_type)
    }

    /// Reads the body.
    pub fn constraint_get_body(&self, constraint: Constraint) -> Result<Body> {
        let mut out_body = Body::default();
        check(unsafe { cairn_sys::cn_constraint_get_body(self.pointer(), constraint, &mut out_body) })?;
        Ok(out_body)
    }

    /// Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
    pub fn constraint_get_angle(&self, constraint: Constraint) -> Result<AngleConstraintDef> {
        let mut out_out = AngleConstraintDef::default();
        check(unsafe { cairn_sys::cn_constraint_get_angle(self.pointer(), constraint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes
    /// the body.
    pub fn constraint_set_angle(&mut self, constraint: Constraint, def: &AngleConstraintDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_constraint_set_angle(self.pointer(), constraint, def) })?;
        Ok(())
    }

    /// Reads the definition of a line constraint. CN_ERROR_STATE for another type.
    pub fn constraint_get_line(&self, constraint: Constraint) -> Result<LineConstraintDef> {
        let mut out_out = LineConstraintDef::default();
        check(unsafe { cairn_sys::cn_constraint_get_line(self.pointer(), constraint, &mut out_out) })?;
        Ok(out_out)
    }

    /// Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
    /// body.
    pub fn constraint_set_line(&mut self, constraint: Constraint, def: &LineConstraintDef) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_constraint_set_line(self.pointer(), constraint, def) })?;
        Ok(())
    }

    /// Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
    /// along the axis, in metres from origin.
    pub fn constraint_get_position(&self, constraint: Constraint) -> Result<f32> {
        let mut out_position = f32::default();
        check(unsafe { cairn_sys::cn_constraint_get_position(self.pointer(), constraint, &mut out_position) })?;
        Ok(out_position)
    }

    /// Force in newtons and torque in newton metres that the constraint applied to the body in the last
    /// substep.
    pub fn constraint_get_reaction(&self, constraint: Constraint) -> Result<(Vec2, f32)> {
        let mut out_force_N = Vec2::default();
        let mut out_torque_Nm = f32::default();
        check(unsafe { cairn_sys::cn_constraint_get_reaction(self.pointer(), constraint, &mut out_force_N, &mut out_torque_Nm) })?;
        Ok((out_force_N, out_torque_Nm))
    }

    /// Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle
    /// constraint.
    pub fn constraint_get_error(&self, constraint: Constraint) -> Result<(f32, f32)> {
        let mut out_m = f32::default();
        let mut out_rad = f32::default();
        check(unsafe { cairn_sys::cn_constraint_get_error(self.pointer(), constraint, &mut out_m, &mut out_rad) })?;
        Ok((out_m, out_rad))
    }

    /// Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
    /// O(slots).
    pub fn get_constraints(&self) -> Result<Vec<Constraint>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_get_constraints(self.pointer(), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_get_constraints(self.pointer(), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
    /// constraints of the body).
    pub fn body_get_constraints(&self, body: Body) -> Result<Vec<Constraint>> {
        let mut count = 0;
        check(unsafe { cairn_sys::cn_body_get_constraints(self.pointer(), body, core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_body_get_constraints(self.pointer(), body, out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Sets the fixed step of cn_world_update: step_s in (0, 1\], default 1/60; at most steps_max steps an
    /// update, 1 to 1000, default 8.
    pub fn set_fixed_step(&mut self, step_s: f32, steps_max: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_world_set_fixed_step(self.pointer(), step_s, steps_max) })?;
        Ok(())
    }

    /// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
    /// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
    pub fn update(&mut self, elapsed_s: f32) -> Result<UpdateReport> {
        let mut out_out = UpdateReport::default();
        self.check(unsafe { cairn_sys::cn_world_update(self.pointer(), elapsed_s, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last
    /// step, 1 after it. Bodies that did not take part in the last step have their present pose. bodies and
    /// count as in cn_world_read_poses. O(count).
    pub fn read_poses_interpolated(&self, bodies: Option<&[Body]>, factor: f32, out: &mut [Pose]) -> Result<()> {
        if bodies.map_or(false, |value| value.len() != out.len()) {
            return Err(Error::uneven());
        }
        check(unsafe { cairn_sys::cn_world_read_poses_interpolated(self.pointer(), bodies.map_or(core::ptr::null(), |value| value.as_ptr()), out.len() as i32, factor, out.as_mut_ptr()) })?;
        Ok(())
    }

    /// Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
    /// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child.
    /// filter may be NULL: the defaults. O(log shapes) to O(shapes along the ray).
    pub fn cast_ray(&self, ray: &Ray, filter: Option<&QueryFilter>) -> Result<RayHit> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut out_out = RayHit::default();
        check(unsafe { cairn_sys::cn_world_cast_ray(self.pointer(), ray, filter.map_or(core::ptr::null(), |value| value as *const _), &mut out_out) })?;
        Ok(out_out)
    }

    /// out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL.
    /// O(log shapes) to O(shapes along the ray).
    pub fn cast_ray_any(&self, ray: &Ray, filter: Option<&QueryFilter>) -> Result<i32> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut out_hit = i32::default();
        check(unsafe { cairn_sys::cn_world_cast_ray_any(self.pointer(), ray, filter.map_or(core::ptr::null(), |value| value as *const _), &mut out_hit) })?;
        Ok(out_hit)
    }

    /// Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found.
    /// A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
    pub fn cast_ray_all(&self, ray: &Ray, filter: Option<&QueryFilter>) -> Result<Vec<RayHit>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_cast_ray_all(self.pointer(), ray, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_cast_ray_all(self.pointer(), ray, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
    /// filter may be NULL. O(sum of the rays).
    pub fn cast_rays(&self, rays: &[Ray], filter: Option<&QueryFilter>, out: &mut [RayHit]) -> Result<()> {
        if rays.len() != out.len() {
            return Err(Error::uneven());
        }
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        check(unsafe { cairn_sys::cn_world_cast_rays(self.pointer(), rays.as_ptr(), out.len() as i32, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr()) })?;
        Ok(())
    }

    /// Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
    /// O(points of the shape).
    pub fn shape_cast_ray(&self, shape: Shape, ray: &Ray) -> Result<RayHit> {
        let mut out_out = RayHit::default();
        check(unsafe { cairn_sys::cn_shape_cast_ray(self.pointer(), shape, ray, &mut out_out) })?;
        Ok(out_out)
    }

    /// First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
    /// way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or
    /// 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the
    /// moving points is in front of it. filter may be NULL. O(shapes along the way).
    pub fn cast_shape(&self, shape: &Polygon, translation_x_m: f32, translation_y_m: f32, filter: Option<&QueryFilter>) -> Result<RayHit> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut out_out = RayHit::default();
        check(unsafe { cairn_sys::cn_world_cast_shape(self.pointer(), shape, translation_x_m, translation_y_m, filter.map_or(core::ptr::null(), |value| value as *const _), &mut out_out) })?;
        Ok(out_out)
    }

    /// Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
    /// cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
    /// filter may be NULL. O(log shapes) to O(boxes in the region).
    pub fn overlap_aabb(&self, r#box: &Aabb, filter: Option<&QueryFilter>) -> Result<Vec<Shape>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_overlap_aabb(self.pointer(), r#box, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_overlap_aabb(self.pointer(), r#box, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
    /// Edges and chains are lines here, seen from both sides.
    pub fn overlap_circle(&self, circle: &Circle, filter: Option<&QueryFilter>) -> Result<Vec<Shape>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_overlap_circle(self.pointer(), circle, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_overlap_circle(self.pointer(), circle, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
    /// in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
    pub fn overlap_polygon(&self, polygon: &Polygon, filter: Option<&QueryFilter>) -> Result<Vec<Shape>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_overlap_polygon(self.pointer(), polygon, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_overlap_polygon(self.pointer(), polygon, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Shapes that contain a world point in metres; order, capacity, filter and cost as in
    /// cn_world_overlap_aabb. Edges and chains contain no point.
    pub fn overlap_point(&self, x_m: f32, y_m: f32, filter: Option<&QueryFilter>) -> Result<Vec<Shape>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_world_overlap_point(self.pointer(), x_m, y_m, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_world_overlap_point(self.pointer(), x_m, y_m, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
    /// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
    pub fn closest_point(&self, x_m: f32, y_m: f32, distance_max_m: f32, filter: Option<&QueryFilter>) -> Result<Closest> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut out_out = Closest::default();
        check(unsafe { cairn_sys::cn_world_closest_point(self.pointer(), x_m, y_m, distance_max_m, filter.map_or(core::ptr::null(), |value| value as *const _), &mut out_out) })?;
        Ok(out_out)
    }

    /// Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape)
    /// moved by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of
    /// least separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a
    /// one-way shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the
    /// length unit plus its rise in the last step. Shapes wholly behind the plane of another shape are left
    /// out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby,
    /// squared).
    pub fn mover_collide(&self, shape: &Polygon, position_x_m: f32, position_y_m: f32, margin_m: f32, filter: Option<&QueryFilter>) -> Result<Vec<Plane>> {
        let filter = filter.map(Cleared::cleared);
        let filter = filter.as_ref();
        let mut count = 0;
        check(unsafe { cairn_sys::cn_mover_collide(self.pointer(), shape, position_x_m, position_y_m, margin_m, filter.map_or(core::ptr::null(), |value| value as *const _), core::ptr::null_mut(), 0, &mut count) })?;
        let mut out = Vec::with_capacity(count as usize);
        if count > 0 {
            check(unsafe { cairn_sys::cn_mover_collide(self.pointer(), shape, position_x_m, position_y_m, margin_m, filter.map_or(core::ptr::null(), |value| value as *const _), out.as_mut_ptr(), count, &mut count) })?;
            unsafe { out.set_len((count as usize).min(out.capacity())) };
        }
        Ok(out)
    }

    /// Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step
    /// behind the ground that carries it. 1. carried   by the motion of its ground since the last move: of
    /// the point of ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across
    /// up, along the ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A
    /// step up where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground
    /// flying    in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off
    /// keep ground_velocity_mps 3. sliding   both by collision planes, cn_mover_solve and casts, up to
    /// iterations_max times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a
    /// force for the next step that brings them to the character's velocity, of at most push_force_N each 5.
    /// ground    ground that it touches, or that lies within snap_m below a walking character; velocity_mps
    /// loses blocked components The result depends on the world, def and mover alone: equal calls give equal
    /// bits. The loop of planes, solver and cast is that of Box2D 3's sample of a character mover (Catto,
    /// 2025). Pushed bodies wake; nothing else in the world changes. O(shapes nearby x iterations_max): about
    /// 1 us standing, 3 us walking, 10 us against a wall.
    pub fn mover_move(&mut self, def: &MoverDef, dt_s: f32, mover: &mut Mover) -> Result<()> {
        let def = &def.cleared();
        self.check(unsafe { cairn_sys::cn_mover_move(self.pointer(), def, dt_s, mover) })?;
        Ok(())
    }

    /// Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter
    /// says which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an
    /// area that loses the flag later does nothing while it is without. Gravity, and damping without density,
    /// act on bodies whose centre of mass is in the area (on its border too) while one of their shapes
    /// touches it: on a body half in it in full or not at all. The medium acts on the part of each shape that
    /// is in the area, exactly for polygons; parts of round shapes are computed as those of polygons of 16
    /// sides, to 1%. The surface of a circle or capsule is flat across a body, as of a planet. Shapes of a
    /// body do not shade each other. The area's body feels no reaction. Between steps nothing happens: the
    /// acceleration is that in the middle of the next step (leapfrog), so bodies on orbits and floating
    /// bodies keep their energy. Damping and drag are implicit: stable at any strength, mass and time step,
    /// with exact terminal speeds. Bodies that enter or leave, that are in an area that moves, and those in
    /// it now, wake; bodies at rest in it may sleep. Areas are in saves and files. Floats whose draught is
    /// less than about g dt^2 (3 mm at 60 steps a second) are damped, and carry less under a load. An area
    /// takes 64 bytes of the world's memory; a step takes about 0.15 us for each shape in an area, 0.35 us in
    /// a medium. Best on a body of its own: O(contacts of the body).
    pub fn shape_set_area(&mut self, shape: Shape, def: Option<&AreaDef>) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_set_area(self.pointer(), shape, def.map_or(core::ptr::null(), |value| value as *const _)) })?;
        Ok(())
    }

    /// Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
    pub fn shape_get_area(&self, shape: Shape) -> Result<AreaDef> {
        let mut out_out = AreaDef::default();
        check(unsafe { cairn_sys::cn_shape_get_area(self.pointer(), shape, &mut out_out) })?;
        Ok(out_out)
    }

    /// The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each
    /// step. flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w
    /// across it, with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton
    /// (1687), and across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle
    /// between surface and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the
    /// whole outline, round parts included, and drag along straight edges also for turning bodies; edges and
    /// chains are plates with two sides. Solved implicitly, so that wind never reverses the motion relative
    /// to it, at any speed, mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0:
    /// sleeping bodies stay asleep and unchanged; else they wake. Static, kinematic and disabled bodies are
    /// unchanged. CN_ERROR_STATE for a shape without a body. O(points).
    pub fn shape_apply_wind(&mut self, shape: Shape, flow_x_mps: f32, flow_y_mps: f32, drag_kgpm2: f32, lift_kgpm2: f32, dt_s: f32, wake: i32) -> Result<()> {
        self.check(unsafe { cairn_sys::cn_shape_apply_wind(self.pointer(), shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake) })?;
        Ok(())
    }

    /// Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
    /// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
    pub fn explode(&mut self, def: &ExplosionDef) -> Result<()> {
        let def = &def.cleared();
        self.check(unsafe { cairn_sys::cn_world_explode(self.pointer(), def) })?;
        Ok(())
    }
}

impl Tree {
    /// Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
    pub fn insert(&mut self, r#box: &Aabb, user_data: u64) -> Result<u32> {
        let mut out_item = u32::default();
        check(unsafe { cairn_sys::cn_tree_insert(self.pointer(), r#box, user_data, &mut out_item) })?;
        Ok(out_item)
    }

    /// Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
    pub fn remove(&mut self, item: u32) -> Result<()> {
        check(unsafe { cairn_sys::cn_tree_remove(self.pointer(), item) })?;
        Ok(())
    }

    /// Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log
    /// n). CN_ERROR_HANDLE for a stale item.
    pub fn r#move(&mut self, item: u32, r#box: &Aabb) -> Result<()> {
        check(unsafe { cairn_sys::cn_tree_move(self.pointer(), item, r#box) })?;
        Ok(())
    }

    /// Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
    pub fn get_box(&self, item: u32) -> Result<Aabb> {
        let mut out_out = Aabb::default();
        check(unsafe { cairn_sys::cn_tree_get_box(self.pointer(), item, &mut out_out) })?;
        Ok(out_out)
    }

    /// Reads the number of items and the height of the tree.
    pub fn get_stats(&self) -> Result<(i32, i32)> {
        let mut out_count = i32::default();
        let mut out_height = i32::default();
        check(unsafe { cairn_sys::cn_tree_get_stats(self.pointer(), &mut out_count, &mut out_height) })?;
        Ok((out_count, out_height))
    }
}

/// Version of the library as major * 1000000 + minor * 1000 + patch.
pub fn version() -> i32 {
    unsafe { cairn_sys::cn_version() }
}

/// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
pub fn abi_version() -> i32 {
    unsafe { cairn_sys::cn_abi_version() }
}

/// English text for a result code: static, never NULL.
pub fn result_text(result: i32) -> &'static core::ffi::CStr {
    unsafe { core::ffi::CStr::from_ptr(cairn_sys::cn_result_text(result)) }
}

/// Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
pub fn save_delta_size(base: &[u8], save: &[u8]) -> Result<u64> {
    let mut out_bytes = u64::default();
    check(unsafe { cairn_sys::cn_save_delta_size(base.as_ptr().cast(), base.len() as u64, save.as_ptr().cast(), save.len() as u64, &mut out_bytes) })?;
    Ok(out_bytes)
}

/// Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
pub fn save_delta(base: &[u8], save: &[u8]) -> Result<Vec<u8>> {
    let mut bytes = 0;
    check(unsafe { cairn_sys::cn_save_delta_size(base.as_ptr().cast(), base.len() as u64, save.as_ptr().cast(), save.len() as u64, &mut bytes) })?;
    let mut out: Vec<u8> = vec![0; bytes as usize];
    check(unsafe { cairn_sys::cn_save_delta(base.as_ptr().cast(), base.len() as u64, save.as_ptr().cast(), save.len() as u64, out.as_mut_ptr().cast(), bytes, &mut bytes) })?;
    out.truncate(bytes as usize);
    Ok(out)
}

/// Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
/// CN_ERROR_CAPACITY if out is too small. O(bytes).
pub fn save_apply(base: &[u8], delta: &[u8]) -> Result<Vec<u8>> {
    let mut bytes = 0;
    bytes += (base.len() + delta.len()) as u64;
    let mut out: Vec<u8> = vec![0; bytes as usize];
    check(unsafe { cairn_sys::cn_save_apply(base.as_ptr().cast(), base.len() as u64, delta.as_ptr().cast(), delta.len() as u64, out.as_mut_ptr().cast(), bytes, &mut bytes) })?;
    out.truncate(bytes as usize);
    Ok(out)
}

/// Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
/// O(count^2) at worst.
pub fn polygon_make_hull(points_m: &[Vec2], radius_m: f32) -> Result<Polygon> {
    let mut out_out = Polygon::default();
    check(unsafe { cairn_sys::cn_polygon_make_hull(points_m.as_ptr(), points_m.len() as i32, radius_m, &mut out_out) })?;
    Ok(out_out)
}

/// A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
/// (|angle| <= 1e4); radius_m >= 0.
pub fn polygon_make_box(half_width_m: f32, half_height_m: f32, center_x_m: f32, center_y_m: f32, angle_rad: f32, radius_m: f32) -> Result<Polygon> {
    let mut out_out = Polygon::default();
    check(unsafe { cairn_sys::cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, &mut out_out) })?;
    Ok(out_out)
}

/// Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
/// thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
/// area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
/// *out_count is the number of all. 34 KB of stack. O(count^2).
pub fn outline_decompose(points_m: &[Vec2], length_unit_m: f32) -> Result<Vec<Polygon>> {
    let mut count = 0;
    check(unsafe { cairn_sys::cn_outline_decompose(points_m.as_ptr(), points_m.len() as i32, length_unit_m, core::ptr::null_mut(), 0, &mut count) })?;
    let mut out = Vec::with_capacity(count as usize);
    if count > 0 {
        check(unsafe { cairn_sys::cn_outline_decompose(points_m.as_ptr(), points_m.len() as i32, length_unit_m, out.as_mut_ptr(), count, &mut count) })?;
        unsafe { out.set_len((count as usize).min(out.capacity())) };
    }
    Ok(out)
}

/// Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
/// points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst.
pub fn outline_simplify(points_m: &[Vec2], closed: i32, tolerance_m: f32) -> Result<Vec<Vec2>> {
    let mut count = 0;
    check(unsafe { cairn_sys::cn_outline_simplify(points_m.as_ptr(), points_m.len() as i32, closed, tolerance_m, core::ptr::null_mut(), 0, &mut count) })?;
    let mut out = Vec::with_capacity(count as usize);
    if count > 0 {
        check(unsafe { cairn_sys::cn_outline_simplify(points_m.as_ptr(), points_m.len() as i32, closed, tolerance_m, out.as_mut_ptr(), count, &mut count) })?;
        unsafe { out.set_len((count as usize).min(out.capacity())) };
    }
    Ok(out)
}

/// An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
/// squares of side cell_m > 0 with the lower left corner of the first at the origin. cells\[row * columns +
/// column\] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
/// 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
/// counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
/// touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
/// (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
/// boundary of n edges.
pub fn outline_from_cells(cells: &[u8], columns: i32, origin_x_m: f32, origin_y_m: f32, cell_m: f32, outline: i32) -> Result<Vec<Vec2>> {
    let mut count = 0;
    check(unsafe { cairn_sys::cn_outline_from_cells(cells.as_ptr(), cells.len() as i32, columns, origin_x_m, origin_y_m, cell_m, outline, core::ptr::null_mut(), 0, &mut count) })?;
    let mut out = Vec::with_capacity(count as usize);
    if count > 0 {
        check(unsafe { cairn_sys::cn_outline_from_cells(cells.as_ptr(), cells.len() as i32, columns, origin_x_m, origin_y_m, cell_m, outline, out.as_mut_ptr(), count, &mut count) })?;
        unsafe { out.set_len((count as usize).min(out.capacity())) };
    }
    Ok(out)
}

/// The same for a field by marching squares (Lorensen, Cline, 1987): values\[row * columns + column\], all
/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
/// least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).
pub fn outline_from_field(values: &[f32], columns: i32, threshold: f32, origin_x_m: f32, origin_y_m: f32, spacing_m: f32, outline: i32) -> Result<Vec<Vec2>> {
    let mut count = 0;
    check(unsafe { cairn_sys::cn_outline_from_field(values.as_ptr(), values.len() as i32, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, core::ptr::null_mut(), 0, &mut count) })?;
    let mut out = Vec::with_capacity(count as usize);
    if count > 0 {
        check(unsafe { cairn_sys::cn_outline_from_field(values.as_ptr(), values.len() as i32, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, out.as_mut_ptr(), count, &mut count) })?;
        unsafe { out.set_len((count as usize).min(out.capacity())) };
    }
    Ok(out)
}

/// Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).
pub fn polygon_distance(a: &Polygon, pose_a: &Pose, b: &Polygon, pose_b: &Pose) -> Result<Distance> {
    let mut out_out = Distance::default();
    check(unsafe { cairn_sys::cn_polygon_distance(a, pose_a, b, pose_b, &mut out_out) })?;
    Ok(out_out)
}

/// Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
/// as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
pub fn polygon_cast(a: &Polygon, pose_a: &Pose, b: &Polygon, pose_b: &Pose, translation_x_m: f32, translation_y_m: f32) -> Result<(RayHit, i32)> {
    let mut out_out = RayHit::default();
    let mut out_hit = i32::default();
    check(unsafe { cairn_sys::cn_polygon_cast(a, pose_a, b, pose_b, translation_x_m, translation_y_m, &mut out_out, &mut out_hit) })?;
    Ok((out_out, out_hit))
}

/// Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
/// to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
/// O(points).
pub fn polygon_collide(a: &Polygon, pose_a: &Pose, b: &Polygon, pose_b: &Pose, margin_m: f32) -> Result<Manifold> {
    let mut out_out = Manifold::default();
    check(unsafe { cairn_sys::cn_polygon_collide(a, pose_a, b, pose_b, margin_m, &mut out_out) })?;
    Ok(out_out)
}

/// First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
/// hit. Needs no world; runs in any thread.
pub fn polygon_time_of_impact(a: &Polygon, sweep_a: &Sweep, b: &Polygon, sweep_b: &Sweep, distance_m: f32) -> Result<Impact> {
    let mut out_out = Impact::default();
    check(unsafe { cairn_sys::cn_polygon_time_of_impact(a, sweep_a, b, sweep_b, distance_m, &mut out_out) })?;
    Ok(out_out)
}

/// The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
/// of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
/// limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.
pub fn mover_solve(planes: &mut [Plane], translation_x_m: f32, translation_y_m: f32) -> Result<(Vec2, f32)> {
    let mut out_translation_m = Vec2::default();
    let mut out_overlap_m = f32::default();
    check(unsafe { cairn_sys::cn_mover_solve(planes.as_mut_ptr(), planes.len() as i32, translation_x_m, translation_y_m, &mut out_translation_m, &mut out_overlap_m) })?;
    Ok((out_translation_m, out_overlap_m))
}

/// The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
/// cn_mover_solve. Needs no world. O(count^2).
pub fn mover_clip(planes: &[Plane], velocity_x_mps: f32, velocity_y_mps: f32) -> Result<Vec2> {
    let mut out_mps = Vec2::default();
    check(unsafe { cairn_sys::cn_mover_clip(planes.as_ptr(), planes.len() as i32, velocity_x_mps, velocity_y_mps, &mut out_mps) })?;
    Ok(out_mps)
}
