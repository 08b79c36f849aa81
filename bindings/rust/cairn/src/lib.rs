//! Cairn, 2D rigid-body physics, for Rust: worlds that destroy themselves, results, slices, handles of distinct types.
//!
//! ```
//! let mut world = cairn::World::new(&Default::default())?;
//! let body = world.body_create(&cairn::BodyDef { position_m: cairn::Vec2 { x: 0.0, y: 4.0 }, ..Default::default() })?;
//! world.shape_create_box(&cairn::ShapeDef { body, ..Default::default() }, 0.5, 0.5, 0.0)?;
//! world.step(1.0 / 60.0)?;
//! println!("{:?}", world.body_get_pose(body)?);
//! # Ok::<(), cairn::Error>(())
//! ```
//!
//! A method is C's function without `cn_` and without the world: `cn_body_get_pose(world, body, &out)` is `world.body_get_pose(body)?`.
//! Pointers in definitions (names, hooks, callbacks) are ignored by the safe functions; `sys` has C's functions for `World::pointer`.
#![allow(non_snake_case, clippy::too_many_arguments, clippy::unnecessary_map_or)]

mod calls;
pub use cairn_sys as sys;
pub use calls::*;

/// A call that failed. When it failed nothing has changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// `sys::CN_ERROR_...`
    pub code: i32,
    text: String,
}
pub type Result<T> = core::result::Result<T, Error>;

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(&self.text)
    }
}
impl std::error::Error for Error {}

impl Error {
    fn uneven() -> Self {
        Error { code: sys::CN_ERROR_ARGUMENT, text: "slices of different lengths".into() }
    }
}

fn check(code: i32) -> Result<()> {
    if code == sys::CN_OK {
        return Ok(());
    }
    Err(Error { code, text: result_text(code).to_string_lossy().into_owned() })
}

/// A world with everything in it.
pub struct World(core::ptr::NonNull<sys::cn_world>);
// As in cairn.h: one thread at a time may change a world, several may read it at once.
unsafe impl Send for World {}
unsafe impl Sync for World {}

impl World {
    /// A world of a definition. Pointers in it (memory, hooks, tasks) are ignored: for these call `sys` and `from_pointer`.
    pub fn new(def: &WorldDef) -> Result<World> {
        let mut pointer = core::ptr::null_mut();
        check(unsafe { sys::cn_world_create(&def.cleared(), &mut pointer) })?;
        Ok(World(core::ptr::NonNull::new(pointer).expect("a created world is not NULL")))
    }

    /// A world from the bytes of `write`. Of the definition only workers and capacities are used.
    pub fn read(file: &[u8], def: &WorldDef) -> Result<World> {
        let mut pointer = core::ptr::null_mut();
        check(unsafe { sys::cn_world_read(&def.cleared(), file.as_ptr().cast(), file.len() as u64, &mut pointer) })?;
        Ok(World(core::ptr::NonNull::new(pointer).expect("a world that was read is not NULL")))
    }

    /// Takes over a world that `sys` created.
    ///
    /// # Safety
    /// Nothing else destroys it, and what its definition points to lives as long as it.
    pub unsafe fn from_pointer(pointer: *mut sys::cn_world) -> Option<World> {
        core::ptr::NonNull::new(pointer).map(World)
    }

    /// Creates a chain through points in the body's frame; `closed`: the last joins the first.
    pub fn shape_create_chain(&mut self, def: &ShapeDef, points_m: &[Vec2], closed: bool) -> Result<Shape> {
        let chain = Chain { points_m: points_m.as_ptr(), count: points_m.len() as i32, r#loop: closed as u32 };
        let mut out = Shape::default();
        self.check(unsafe { sys::cn_shape_create_chain(self.pointer(), def, &chain, &mut out) })?;
        Ok(out)
    }

    /// For functions of `sys`.
    pub fn pointer(&self) -> *mut sys::cn_world {
        self.0.as_ptr()
    }

    fn check(&self, code: i32) -> Result<()> {
        check(code).map_err(|error| {
            let text = unsafe { core::ffi::CStr::from_ptr(sys::cn_world_error_text(self.pointer())) };
            Error { text: text.to_string_lossy().into_owned(), ..error }
        })
    }
}

impl Drop for World {
    fn drop(&mut self) {
        unsafe { sys::cn_world_destroy(self.pointer()) }
    }
}

/// A dynamic AABB tree apart from any world.
pub struct Tree(core::ptr::NonNull<sys::cn_tree>);
unsafe impl Send for Tree {}
unsafe impl Sync for Tree {}

impl Tree {
    /// An empty tree; `margin_m` >= 0 is added around every box.
    pub fn new(margin_m: f32) -> Result<Tree> {
        let mut pointer = core::ptr::null_mut();
        check(unsafe { sys::cn_tree_create(margin_m, None, None, core::ptr::null_mut(), &mut pointer) })?;
        Ok(Tree(core::ptr::NonNull::new(pointer).expect("a created tree is not NULL")))
    }

    /// For functions of `sys`.
    pub fn pointer(&self) -> *mut sys::cn_tree {
        self.0.as_ptr()
    }
}

impl Drop for Tree {
    fn drop(&mut self) {
        unsafe { sys::cn_tree_destroy(self.pointer()) }
    }
}
