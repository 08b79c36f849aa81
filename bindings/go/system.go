//go:build cairn_system

package cairn

// #cgo LDFLAGS: -lcairn
import "C"
