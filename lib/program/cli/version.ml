let current = Version_number.current
let told = Printf.sprintf "%s (semantics %s)" current Scc_calculus.Parameters.version
