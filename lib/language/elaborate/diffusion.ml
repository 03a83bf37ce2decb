open Scc_exact
open Scc_calculus

type lattice = { kick : Rat.t; spread : Rat.t; chosen : bool }

let axes = [ Vec.of_ints 1 0 0; Vec.of_ints 0 1 0; Vec.of_ints 0 0 1 ]
let constants (d : Vec.t) = [ d.x; d.y; d.z ]
let sum = List.fold_left Rat.add Rat.zero
let two = Rat.of_int 2

(* E[a^2] of all coordinates together. *)
let spread ~timestep d = Rat.mul two (Rat.mul timestep (sum (constants d)))
let is_enough ~spread kick = Rat.compare (Rat.mul kick kick) spread >= 0

let least_kick ~timestep d =
  let spread = spread ~timestep d in
  let rec down kick =
    let half = Rat.div kick two in
    if is_enough ~spread half then down half else kick
  in
  let rec up kick = if is_enough ~spread kick then kick else up (Rat.mul two kick) in
  if Rat.sign spread = 0 then Rat.one else down (up Rat.one)

let plus ((x, y, z) : Law.vector) (v : Vec.t) : Law.vector =
  let add (e : Law.expr) q : Law.expr =
    match e with
    | Const p -> Const (Rat.add p q)
    | e -> if Rat.sign q = 0 then e else Add (e, Const q)
  in
  (add x v.x, add y v.y, add z v.z)

let kicks ~timestep ~drift ~kick d =
  let spread = spread ~timestep d in
  if not (is_enough ~spread kick) then Error spread
  else
    let square = Rat.mul kick kick and speed = Rat.div kick timestep in
    let along axis constant =
      let weight = Law.Const (Rat.div (Rat.mul constant timestep) square) in
      let one v = { Law.velocity = plus drift (Vec.scale v axis); weight } in
      if Rat.sign constant = 0 then [] else [ one speed; one (Rat.neg speed) ]
    in
    let rest = Rat.sub Rat.one (Rat.div spread square) in
    let resting = if Rat.sign rest = 0 then [] else [ { Law.velocity = drift; weight = Const rest } ] in
    Ok (List.concat (List.map2 along axes (constants d)) @ resting)
