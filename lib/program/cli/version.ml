let current = "0.1.0"
let told = Printf.sprintf "%s (semantics %s)" current Scc_calculus.Parameters.version
