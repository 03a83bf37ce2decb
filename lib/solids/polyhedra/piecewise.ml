open Scc_exact

type value = { least : Rat.t; most : Rat.t }

module Value = struct
  type t = value

  let equal a b = Rat.equal a.least b.least && Rat.equal a.most b.most
  let hash v = (Rat.hash v.least * 31) + (Rat.hash v.most * 2) + 1
  let any = { least = Rat.zero; most = Rat.zero }
  let compose v ~dimension:_ _ = v
end

include (Diagram.Make (Value) : Diagram.S with type value := value)

let both of_values v w =
  match (v, w) with Some v, Some w -> Some (of_values v w) | None, _ | _, None -> None

let either of_values v w =
  match (v, w) with Some v, Some w -> Some (of_values v w) | v, None -> v | None, w -> w

let by_ends f v w = { least = f v.least w.least; most = f v.most w.most }
let add s = combine s Add (both (by_ends Rat.add))
let least s = combine s Least (either (by_ends Rat.min))
let greatest s = combine s Greatest (either (by_ends Rat.max))
let ends s = combine s Ends (both (fun v w -> { least = v.least; most = w.most }))
let scale s k = map s (fun v -> { least = Rat.mul k v.least; most = Rat.mul k v.most })
let sum s terms = List.fold_left (fun all (k, f) -> add s all (scale s k f)) (constant s Value.any) terms
