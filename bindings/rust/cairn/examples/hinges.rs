//! The falling-hinges scene of examples/scenes/joints.c; prints what bindings/test/hinges.c prints, but for callbacks, which the safe
//! layer does not have. With the word times: nanoseconds per body for reading 1,000 poses.
use cairn::*;

const HALF: f32 = 0.25;
const RADIUS: f32 = 0.025;
const LEAN: f32 = 0.06;
const PI: f32 = 3.14159265;

fn body_at(world: &mut World, kind: i32, x: f32, y: f32) -> Result<Body> {
    world.body_create(&BodyDef { r#type: kind, position_m: Vec2 { x, y }, ..Default::default() })
}

fn add_box(world: &mut World, body: Body, friction: f32, half: [f32; 2], radius: f32) -> Result<Shape> {
    let mut def = ShapeDef { body, ..Default::default() };
    def.material.static_friction = friction;
    def.material.dynamic_friction = friction;
    world.shape_create_box(&def, half[0], half[1], radius)
}

fn join(world: &mut World, below: Body, body: Body) -> Result<Joint> {
    let mut def = RevoluteDef { lower_angle_rad: -0.3 * PI, upper_angle_rad: 0.1 * PI, ..Default::default() };
    def.base.body_a = below;
    def.base.body_b = body;
    def.base.anchor_a_m = Vec2 { x: HALF, y: HALF };
    def.base.anchor_b_m = Vec2 { x: HALF - LEAN, y: -HALF };
    def.base.flags = sys::CN_JOINT_LIMIT;
    world.joint_create_revolute(&def)
}

fn hinges() -> Result<()> {
    let (columns, rows, steps) = (4, 30, 480);
    let mut world = World::new(&WorldDef::default())?;
    let ground = body_at(&mut world, sys::CN_BODY_STATIC, 0.0, -1.0)?;
    add_box(&mut world, ground, 0.6, [30.0, 1.0], 0.0)?;
    for j in 0..columns {
        let x = 2.5 * j as f32 - 0.5 * 2.5 * (columns - 1) as f32;
        let mut below = Body::default();
        for i in 0..rows {
            let body = body_at(&mut world, sys::CN_BODY_DYNAMIC, x + LEAN * i as f32, HALF + 2.0 * HALF * i as f32)?;
            add_box(&mut world, body, 0.3, [HALF - RADIUS; 2], RADIUS)?;
            if i % 2 == 1 {
                join(&mut world, below, body)?;
            }
            below = body;
        }
    }
    let mut poses = vec![Pose::default(); world.get_bodies()?.len()];
    let (mut entered, mut sum) = (0, 0u32);
    for _ in 0..steps {
        world.step(1.0 / 60.0)?;
        world.read_poses(None, &mut poses)?;
        entered += world.contact_events(sys::CN_EVENT_ENTER)?.len();
        for pose in &poses {
            for number in [pose.position_m.x, pose.position_m.y, pose.cosine, pose.sine] {
                sum = sum.wrapping_mul(31).wrapping_add(number.to_bits());
            }
        }
    }
    println!("falling_hinges: {steps} steps, {} bodies, {entered} entered, poses {sum:08x}, hash {:016x}", poses.len(), world.hash()?);
    Ok(())
}

fn times() -> Result<()> {
    let mut world = World::new(&WorldDef::default())?;
    let mut poses = vec![Pose::default(); 1000];
    for i in 0..poses.len() {
        body_at(&mut world, sys::CN_BODY_DYNAMIC, i as f32, 0.0)?;
    }
    let mut least = f64::MAX; // of rounds: there is no clock of the processor's time in std
    for _ in 0..500 {
        let start = std::time::Instant::now();
        for _ in 0..10 {
            world.read_poses(None, &mut poses)?;
        }
        least = least.min(start.elapsed().as_nanos() as f64 / 10.0 / poses.len() as f64);
    }
    println!("{least:.2}");
    Ok(())
}

/// What the layer adds: errors with sentences, slices, lists.
fn layer() -> Result<()> {
    let mut world = World::new(&WorldDef { substep_count: 8, ..Default::default() })?;
    assert_eq!(world.get_substep_count()?, 8);
    let error = world.step(-1.0).unwrap_err();
    assert!(error.code == sys::CN_ERROR_ARGUMENT && error.to_string().contains("dt_s"), "{error}");
    let body = body_at(&mut world, sys::CN_BODY_DYNAMIC, 0.0, 0.0)?;
    let shape = add_box(&mut world, body, 0.5, [1.0, 1.0], 0.0)?;
    assert_eq!(world.body_get_shapes(body)?, [shape]);
    assert_eq!(world.overlap_point(0.0, 0.0, None)?, [shape]);
    // A pointer that safe code made up is not followed.
    let name = 1 as *const _;
    world.body_create(&BodyDef { name, ..Default::default() })?;
    world.body_create_many(&[BodyDef { name, ..Default::default() }; 3], &mut [Body::default(); 3])?;
    assert!(world.read_poses(Some(&[body]), &mut [Pose::default(); 2]).is_err());
    world.body_set_name(body, Some(c"crate"))?;
    assert_eq!(world.body_get_name(body)?, c"crate");
    let points = [Vec2 { x: -1.0, y: 0.0 }, Vec2 { x: 1.0, y: 0.0 }, Vec2 { x: 2.0, y: 1.0 }];
    let chain = world.shape_create_chain(&ShapeDef { body, ..Default::default() }, &points, false)?;
    assert_eq!(world.shape_get_chain_points(chain)?.len(), 3);
    let (saved, before) = (world.save()?, world.hash()?);
    world.step(0.1)?;
    let later = world.save()?;
    let delta = save_delta(&saved, &later)?;
    assert!(save_apply(&saved, &delta)? == later && delta.len() < saved.len());
    world.restore(&saved)?;
    assert_eq!(world.hash()?, before);
    assert_eq!(World::read(&world.write()?, &WorldDef::default())?.hash()?, before);
    assert_eq!(World::read(&delta, &WorldDef::default()).err().map(|error| error.code), Some(sys::CN_ERROR_FORMAT));
    let moved = std::thread::spawn(move || world.hash().unwrap());
    assert_eq!(moved.join().unwrap(), before);
    Ok(())
}

fn main() -> Result<()> {
    if std::env::args().nth(1).as_deref() == Some("times") {
        return times();
    }
    layer()?;
    hinges()
}
