// The falling-hinges scene through the Go package; prints what bindings/test/hinges.c prints, but for the callback, after checks of what
// the layer adds. With the word times: nanoseconds per body for reading 1,000 poses, into a slice that is kept.
package main

import (
	. "cairn"
	"bytes"
	"fmt"
	"math"
	"os"
	"runtime"
	"strings"
	"syscall"
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

func expect(condition bool, words ...any) {
	if !condition {
		panic(fmt.Sprint(words...))
	}
}

func layer() {
	def := DefaultWorldDef()
	def.SubstepCount = 8
	w := must(NewWorld(def))
	body := bodyAt(w, BodyDynamic, 0, 0)
	shape := addBox(w, body, 0.5, 1, 1, 0)
	expect(must(w.GetSubstepCount()) == 8 && must(w.BodyGetShapes(body))[0] == shape && must(w.OverlapPoint(0, 0, nil))[0] == shape,
		"what was set is not what is read")
	err := w.Step(-1)
	e, ok := err.(*Error)
	expect(ok && e.Code == ErrorArgument && strings.Contains(e.Text, "dt_s"), err)
	expect(w.ReadPoses([]Body{body}, make([]Pose, 2)) != nil, "one body filled two poses")
	expect(w.BodySetName(body, "crate") == nil && must(w.BodyGetName(body)) == "crate", "the name is another")
	shapeDef := DefaultShapeDef()
	shapeDef.Body = body
	chain := must(w.ShapeCreateChain(&shapeDef, []Vec2{{-1, 0}, {1, 0}, {2, 1}}, false))
	points := must(w.ShapeGetChainPoints(chain))
	expect(len(points) == 3 && points[2] == Vec2{2, 1}, points)
	saved, before := must(w.Save()), must(w.Hash())
	expect(w.Step(0.1) == nil && must(w.Hash()) != before, "a step changed nothing")
	later := must(w.Save())
	delta := must(SaveDelta(saved, later))
	expect(bytes.Equal(must(SaveApply(saved, delta)), later) && len(delta) < len(saved), "the delta gave another save")
	expect(w.Restore(saved) == nil && must(w.Hash()) == before, "restore gave another world")
	read := must(ReadWorld(must(w.Write()), def))
	expect(must(read.Hash()) == before, "the file has another world")
	_, refused := ReadWorld(delta, def)
	expect(refused != nil, "a delta was read as a world")
	w.Close()
	w.Close()
	expect(w.Step(0.1) != nil, "a closed world took a step")
	for i := 0; i < 100; i++ {
		must(NewWorld(def))
	}
	runtime.GC()
}

func times() {
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
			panic(err)
		}
	}
	fmt.Printf("%.2f\n", float64(spent()-start)/5000/1000)
}

func main() {
	if len(os.Args) > 1 && os.Args[1] == "times" {
		times()
		return
	}
	layer()
	fmt.Println(hinges())
}
