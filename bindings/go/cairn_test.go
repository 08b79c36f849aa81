package cairn

import (
	"fmt"
	"math"
	"os"
	"runtime"
	"strings"
	"syscall"
	"testing"
)

func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

func bodyAt(w *World, kind int32, x, y float32) Body {
	def := DefaultBodyDef()
	def.Type, def.PositionM = kind, Vec2{x, y}
	return must(w.BodyCreate(&def))
}

func addBox(w *World, body Body, friction, halfWidth, halfHeight, radius float32) Shape {
	def := DefaultShapeDef()
	def.Body = body
	def.Material.StaticFriction, def.Material.DynamicFriction = friction, friction
	return must(w.ShapeCreateBox(&def, halfWidth, halfHeight, radius))
}

// The falling-hinges scene of examples/scenes/joints.c. Conversions round to float32 after every operation, as C does.
func hinges() string {
	const columns, rows, steps = 4, 30, 480
	var half, radius, lean, pi, low, high float32 = 0.25, 0.025, 0.06, 3.14159265, -0.3, 0.1
	w := must(NewWorld(DefaultWorldDef()))
	defer w.Close()
	addBox(w, bodyAt(w, BodyStatic, 0, -1), 0.6, 30, 1, 0)
	for j := 0; j < columns; j++ {
		x := float32(2.5*float32(j)) - float32(1.25*float32(columns-1))
		var below Body
		for i := 0; i < rows; i++ {
			row := float32(i)
			body := bodyAt(w, BodyDynamic, x+float32(lean*row), half+float32(2*half*row))
			addBox(w, body, 0.3, half-radius, half-radius, radius)
			if i%2 == 1 {
				def := DefaultRevoluteDef()
				def.Base.BodyA, def.Base.BodyB = below, body
				def.Base.AnchorAM, def.Base.AnchorBM = Vec2{half, half}, Vec2{half - lean, -half}
				def.Base.Flags = JointLimit
				def.LowerAngleRad, def.UpperAngleRad = low*pi, high*pi
				must(w.JointCreateRevolute(&def))
			}
			below = body
		}
	}
	poses := make([]Pose, len(must(w.GetBodies())))
	var sum uint32
	entered := 0
	for range make([]struct{}, steps) {
		if err := w.Step(1.0 / 60); err != nil {
			panic(err)
		}
		if err := w.ReadPoses(nil, poses); err != nil {
			panic(err)
		}
		entered += len(must(w.ContactEvents(EventEnter)))
		for _, p := range poses {
			for _, number := range []float32{p.PositionM.X, p.PositionM.Y, p.Cosine, p.Sine} {
				sum = 31*sum + math.Float32bits(number)
			}
		}
	}
	return fmt.Sprintf("falling_hinges: %d steps, %d bodies, %d entered, poses %08x, hash %016x", steps, len(poses), entered, sum, must(w.Hash()))
}

// The line of bindings/test/hinges.c is in CAIRN_HINGES.
func TestHinges(t *testing.T) {
	if line := hinges(); line != os.Getenv("CAIRN_HINGES") {
		t.Errorf("%q instead of %q", line, os.Getenv("CAIRN_HINGES"))
	}
}

func TestLayer(t *testing.T) {
	def := DefaultWorldDef()
	def.SubstepCount = 8
	w := must(NewWorld(def))
	body := bodyAt(w, BodyDynamic, 0, 0)
	shape := addBox(w, body, 0.5, 1, 1, 0)
	if must(w.GetSubstepCount()) != 8 || must(w.BodyGetShapes(body))[0] != shape || must(w.OverlapPoint(0, 0, nil))[0] != shape {
		t.Error("what was set is not what is read")
	}
	err := w.Step(-1)
	if e, ok := err.(*Error); !ok || e.Code != ErrorArgument || !strings.Contains(e.Text, "dt_s") {
		t.Error(err)
	}
	if w.ReadPoses([]Body{body}, make([]Pose, 2)) == nil {
		t.Error("one body filled two poses")
	}
	if err := w.BodySetName(body, "crate"); err != nil || must(w.BodyGetName(body)) != "crate" {
		t.Error("the name is another")
	}
	shapeDef := DefaultShapeDef()
	shapeDef.Body = body
	chain := must(w.ShapeCreateChain(&shapeDef, []Vec2{{-1, 0}, {1, 0}, {2, 1}}, false))
	if points := must(w.ShapeGetChainPoints(chain)); len(points) != 3 || points[2] != (Vec2{2, 1}) {
		t.Error(points)
	}
	saved, before := must(w.Save()), must(w.Hash())
	if err := w.Step(0.1); err != nil || must(w.Hash()) == before {
		t.Error("a step changed nothing")
	}
	if err := w.Restore(saved); err != nil || must(w.Hash()) != before {
		t.Error("restore gave another world")
	}
	w.Close()
	w.Close()
	if w.Step(0.1) == nil {
		t.Error("a closed world took a step")
	}
	for i := 0; i < 100; i++ {
		must(NewWorld(def))
	}
	runtime.GC()
}

// Nanoseconds per body for reading 1,000 poses, with CAIRN_TIMES set.
func TestTimes(t *testing.T) {
	if os.Getenv("CAIRN_TIMES") == "" {
		t.Skip()
	}
	w := must(NewWorld(DefaultWorldDef()))
	poses := make([]Pose, 1000)
	for i := range poses {
		bodyAt(w, BodyDynamic, float32(i), 0)
	}
	spent := func() int64 {
		var usage syscall.Rusage
		_ = syscall.Getrusage(syscall.RUSAGE_SELF, &usage)
		return usage.Utime.Nano() + usage.Stime.Nano()
	}
	start := spent()
	for i := 0; i < 5000; i++ {
		if err := w.ReadPoses(nil, poses); err != nil {
			t.Fatal(err)
		}
	}
	fmt.Printf("%.2f\n", float64(spent()-start)/5000/1000)
}
