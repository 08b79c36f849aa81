// Package cairn is Cairn, 2D rigid-body physics: same input, same bits.
//
//	world, err := cairn.NewWorld(cairn.DefaultWorldDef())
//	def := cairn.DefaultBodyDef()
//	def.PositionM = cairn.Vec2{X: 0, Y: 4}
//	body, err := world.BodyCreate(&def)
//	err = world.Step(1.0 / 60)
//	pose, err := world.BodyGetPose(body)
//
// A method is C's function without cn_ and without the world: cn_body_get_pose(world, body, &out) is world.BodyGetPose(body). A slice
// of bodies that is nil stands for all bodies. Callbacks and hooks are not part of the package; every event is also in an array.
package cairn

/*
#cgo CFLAGS: -std=c99 -I${SRCDIR}/source -I${SRCDIR}/../../build/amalgamation
#cgo linux LDFLAGS: -lm -lpthread
#include "cairn.h"
*/
import "C"
import (
	"errors"
	"runtime"
	"unsafe"
)

// Error is a call that failed; then nothing has changed.
type Error struct {
	Code int32 // ErrorArgument, ...
	Text string
}

func (e *Error) Error() string { return e.Text }

var errUneven error = &Error{ErrorArgument, "slices of different lengths"}

func check(code C.cn_result) error {
	if code == C.CN_OK {
		return nil
	}
	return &Error{int32(code), C.GoString(C.cn_result_text(code))}
}

// World is a world with everything in it. One goroutine at a time may use it.
type World struct{ pointer *C.cn_world }

// NewWorld creates a world. Close destroys it, or the garbage collector.
func NewWorld(def WorldDef) (*World, error) {
	w := &World{}
	if err := check(C.cn_world_create((*C.cn_world_def)(unsafe.Pointer(&def)), &w.pointer)); err != nil {
		return nil, err
	}
	runtime.SetFinalizer(w, (*World).Close)
	return w, nil
}

// ReadWorld creates a world from the bytes of Write. Of the definition only workers and capacities are used.
func ReadWorld(file []byte, def WorldDef) (*World, error) {
	w := &World{}
	if err := check(C.cn_world_read((*C.cn_world_def)(unsafe.Pointer(&def)), unsafe.Pointer(unsafe.SliceData(file)), C.uint64_t(len(file)), &w.pointer)); err != nil {
		return nil, err
	}
	runtime.SetFinalizer(w, (*World).Close)
	return w, nil
}

// Close destroys the world; every later call on it fails.
func (w *World) Close() {
	C.cn_world_destroy(w.pointer)
	w.pointer = nil
	runtime.SetFinalizer(w, nil)
}

func (w *World) c() *C.cn_world { return w.pointer }

// check adds the library's sentence, which the calling thread's world holds.
func (w *World) check(code C.cn_result) error {
	if code == C.CN_OK {
		return nil
	}
	if w.pointer == nil {
		return errors.New("the world is closed")
	}
	return &Error{int32(code), C.GoString(C.cn_world_error_text(w.pointer))}
}

// ShapeCreateChain creates a chain through points in the body's frame; loop: the last joins the first.
func (w *World) ShapeCreateChain(def *ShapeDef, pointsM []Vec2, loop bool) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out Shape
	var pinner runtime.Pinner
	defer pinner.Unpin()
	chain := Chain{c_points_m: unsafe.Pointer(unsafe.SliceData(pointsM)), Count: int32(len(pointsM))}
	if len(pointsM) > 0 {
		pinner.Pin(&pointsM[0])
	}
	if loop {
		chain.Loop = 1
	}
	err := w.check(C.cn_shape_create_chain(w.pointer, (*C.cn_shape_def)(unsafe.Pointer(def)), (*C.cn_chain)(unsafe.Pointer(&chain)), (*C.cn_shape)(unsafe.Pointer(&out))))
	return out, err
}

// Tree is a dynamic AABB tree apart from any world.
type Tree struct{ pointer *C.cn_tree }

// NewTree creates an empty tree; marginM >= 0 is added around every box.
func NewTree(marginM float32) (*Tree, error) {
	t := &Tree{}
	if err := check(C.cn_tree_create(C.float(marginM), nil, nil, nil, &t.pointer)); err != nil {
		return nil, err
	}
	runtime.SetFinalizer(t, func(t *Tree) { C.cn_tree_destroy(t.pointer) })
	return t, nil
}

func (t *Tree) c() *C.cn_tree { return t.pointer }
