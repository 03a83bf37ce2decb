open Scc_exact
open Scc_calculus

type lattice = { kick : Rat.t; spread : Rat.t; chosen : bool; spin : Rat.t option }

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
      let one v = { Law.motion = Law.velocity_alone (plus drift (Vec.scale v axis)); weight } in
      if Rat.sign constant = 0 then [] else [ one speed; one (Rat.neg speed) ]
    in
    let rest = Rat.sub Rat.one (Rat.div spread square) in
    let still = { Law.motion = Law.velocity_alone drift; weight = Const rest } in
    let resting = if Rat.sign rest = 0 then [] else [ still ] in
    Ok (List.concat (List.map2 along axes (constants d)) @ resting)

(* {1 Orientation} *)

(* 1 - cos of the angle of a step, for a kick of the spin 2 t / timestep (rule Turn): 2^k turns by 2 atan(t / 2^k),
   for the least k such that t / 2^k is at most 1/4. *)
let versine t =
  let double cos = Rat.sub (Rat.mul two (Rat.mul cos cos)) Rat.one in
  let rec doubled k cos = if k = 0 then cos else doubled (k - 1) (double cos) in
  let rec cos k t =
    if Rat.compare t (Rat.make Z.one (Z.of_int 4)) > 0 then cos (k + 1) (Rat.mul Rat.half t)
    else
      let square = Rat.mul t t in
      doubled k (Rat.div (Rat.sub Rat.one square) (Rat.add Rat.one square))
  in
  Rat.sub Rat.one (cos 0 t)

(* Beyond a tangent of 1 a step turns by more than half a turn, and greater kicks turn by less. *)
let most_turning = versine Rat.one

let turns ~timestep c =
  let total = Rat.mul timestep (sum (constants c)) in
  let is_enough t = Rat.compare (versine t) total >= 0 in
  let rec down t =
    let half = Rat.mul Rat.half t in
    if is_enough half then down half else t
  in
  if Rat.sign total = 0 then Ok (Rat.zero, [ (Vec.zero, Rat.one) ])
  else if not (is_enough Rat.one) then Error (Rat.div most_turning timestep)
  else
    let tangent = down Rat.one in
    let versine = versine tangent and spin = Rat.div (Rat.mul two tangent) timestep in
    let about axis constant =
      let chance = Rat.div (Rat.mul constant timestep) (Rat.mul two versine) in
      let one w = (Vec.scale w axis, chance) in
      if Rat.sign constant = 0 then [] else [ one spin; one (Rat.neg spin) ]
    in
    let rest = Rat.sub Rat.one (Rat.div total versine) in
    let still = if Rat.sign rest = 0 then [] else [ (Vec.zero, rest) ] in
    Ok (spin, List.concat (List.map2 about axes (constants c)) @ still)

let spun kicks spins =
  let weighed (e : Law.expr) chance : Law.expr =
    match e with Const w -> Const (Rat.mul w chance) | e -> Mul (e, Const chance)
  in
  let fixed (w : Vec.t) : Law.vector = (Const w.x, Const w.y, Const w.z) in
  let with_spin (k : Law.kick) (w, chance) =
    { Law.motion = { k.motion with spin = Some (fixed w) }; weight = weighed k.weight chance }
  in
  List.concat_map (fun k -> List.map (with_spin k) spins) kicks
