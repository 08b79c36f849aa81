# Definitions that leave parts of the library out; read by run.sh and sizes.sh.
bare_metal='-DCN_NO_THREADS -DCN_NO_CLOCK -DCN_NO_MALLOC -DCN_NO_SIMD'
without_solvers='-DCN_NO_DIRECT -DCN_NO_SEQUENTIAL -DCN_NO_SWEEP -DCN_NO_AREAS -DCN_SMALL_BLOCKS'
without_joints='-DCN_NO_JOINTS'
without_refinements='-DCN_PLAIN_STEP'
without_rest='-DCN_NO_CONTINUOUS -DCN_NO_EVENTS -DCN_NO_RESTITUTION -DCN_NO_CHAINS -DCN_NO_CIRCLES -DCN_NO_MESSAGES'
