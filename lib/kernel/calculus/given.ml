open Scc_exact

type t = { velocity : Vec.t; spin : Vec.t option }

let compare a b =
  Vec.compare a.velocity b.velocity <?> fun () -> Option.compare Vec.compare a.spin b.spin

let equal a b = compare a b = 0

let hash g =
  let spin = match g.spin with None -> 0 | Some w -> 1 + Vec.hash w in
  Vec.hash g.velocity lxor (31 * spin)

let to_string g =
  Vec.to_string g.velocity ^ match g.spin with None -> "" | Some w -> " spin " ^ Vec.to_string w
