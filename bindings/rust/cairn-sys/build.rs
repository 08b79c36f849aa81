//! Compiles the library from one file, cairn.c beside this one (as in a published crate) or in build/amalgamation (make amalgamation),
//! by the C compiler in CC (default cc) with CFLAGS (default -O3). CAIRN_SOURCE_DIR names another folder with cairn.c, and
//! CAIRN_LIBRARY_DIR one with a built library to use instead.
use std::{env, path::Path, process::Command};

fn main() {
    println!("cargo:rerun-if-env-changed=CAIRN_LIBRARY_DIR");
    println!("cargo:rerun-if-env-changed=CC");
    println!("cargo:rerun-if-env-changed=CFLAGS");
    if let Ok(folder) = env::var("CAIRN_LIBRARY_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
        println!("cargo:rustc-link-lib=dylib=cairn");
        return;
    }
    println!("cargo:rerun-if-env-changed=CAIRN_SOURCE_DIR");
    let folders = [env::var("CAIRN_SOURCE_DIR").unwrap_or(".".into()), "../../../build/amalgamation".into()];
    let source = folders.iter().map(|folder| format!("{folder}/cairn.c")).find(|name| Path::new(name).exists());
    let source = &source.expect("no cairn.c: run make amalgamation in the top folder");
    println!("cargo:rerun-if-changed={source}");
    let out = env::var("OUT_DIR").unwrap();
    let object = format!("{out}/cairn.o");
    let flags = env::var("CFLAGS").unwrap_or("-O3".into());
    let compiler = env::var("CC").unwrap_or("cc".into());
    let mut words = compiler.split_whitespace().chain(flags.split_whitespace());
    run(Command::new(words.next().expect("CC is empty")).args(words).args(["-std=c99", "-fPIC", "-c", source, "-o", &object]));
    run(Command::new(env::var("AR").unwrap_or("ar".into())).args(["rcs", &format!("{out}/libcairn.a"), &object]));
    println!("cargo:rustc-link-search=native={out}");
    println!("cargo:rustc-link-lib=static=cairn");
    if env::var("CARGO_CFG_UNIX").is_ok() {
        println!("cargo:rustc-link-lib=m");
    }
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?} failed");
}
