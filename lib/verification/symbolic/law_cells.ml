open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets

exception Bad_law of { leaf : int; fault : Law.fault; at : Rat.t array }

let not_affine format = Printf.ksprintf (fun text -> raise (Instant.Not_affine text)) format

(* {1 Expressions} *)

(* A law as a form over the variables of a zone, by regions. What has no value is left to the kernel, which
   evaluates the law at a state of each region. *)
type env = { leaf : string; value : Law.variable -> Linear.t }

let constant region q = Linear.constant (Polyhedron.dimension region) q

let product env (a : Linear.t) (b : Linear.t) =
  if Linear.is_constant a then Linear.scale a.constant b
  else if Linear.is_constant b then Linear.scale b.constant a
  else not_affine "the law of `%s` multiplies numbers that are not known" env.leaf

let quotient env region a (b : Linear.t) =
  if not (Linear.is_constant b) then not_affine "the law of `%s` divides by a number that is not known" env.leaf
  else if Rat.sign b.constant = 0 then constant region Rat.zero
  else Linear.scale (Rat.div Rat.one b.constant) a

let rounded env region (a : Linear.t) (b : Linear.t) =
  if not (Linear.is_constant a && Linear.is_constant b) then
    not_affine "the law of `%s` rounds a number that is not known" env.leaf
  else if Rat.sign b.constant <= 0 then constant region Rat.zero
  else constant region (Rat.round_to a.constant ~quantum:b.constant)

let compared region (relation : Law.comparison) f =
  let zero = constant region Rat.zero in
  let split c = Region.split region [ c ] in
  let yes, no =
    match relation with
    | Lt -> split (Constraint.less f zero)
    | Le -> split (Constraint.at_most f zero)
    | Gt -> split (Constraint.greater f zero)
    | Ge -> split (Constraint.at_least f zero)
    | Eq | Ne -> split (Constraint.equals f zero)
  in
  let holds = match relation with Ne -> false | Lt | Le | Gt | Ge | Eq -> true in
  List.map (fun p -> (p, holds)) (Option.to_list yes) @ List.map (fun p -> (p, not holds)) no

let rec number env region (e : Law.expr) : (Polyhedron.t * Linear.t) list =
  let both f a b =
    let with_second (p, x) = List.map (fun (q, y) -> (q, f q x y)) (number env p b) in
    List.concat_map with_second (number env region a)
  in
  match e with
  | Const q | Open { value = q; _ } -> [ (region, constant region q) ]
  | Var v -> [ (region, env.value v) ]
  | Neg a -> List.map (fun (p, x) -> (p, Linear.neg x)) (number env region a)
  | Add (a, b) -> both (fun _ -> Linear.add) a b
  | Sub (a, b) -> both (fun _ -> Linear.sub) a b
  | Mul (a, b) -> both (fun _ -> product env) a b
  | Div (a, b) -> both (quotient env) a b
  | Round (a, b) -> both (rounded env) a b
  | If (c, a, b) -> List.concat_map (fun (p, holds) -> number env p (if holds then a else b)) (truth env region c)

and truth env region (c : Law.cond) : (Polyhedron.t * bool) list =
  let after a ~goes_on b =
    let next (p, holds) = if Bool.equal holds goes_on then truth env p b else [ (p, holds) ] in
    List.concat_map next (truth env region a)
  in
  match c with
  | Bool b -> [ (region, b) ]
  | Compare (relation, a, b) ->
    List.concat_map (fun (p, f) -> compared p relation f) (number env region (Sub (a, b)))
  | And (a, b) -> after a ~goes_on:true b
  | Or (a, b) -> after a ~goes_on:false b
  | Not a -> List.map (fun (p, holds) -> (p, not holds)) (truth env region a)

(* {1 Laws} *)

let depends env what =
  not_affine "a %s in the law of `%s` depends on the place or the time, and not by conditions alone" what env.leaf

let of_velocity env region (x, y, z) =
  let of_number region e =
    let one (p, f) =
      if Linear.is_constant f then p
      else depends env "velocity"
    in
    List.map one (number env region e)
  in
  List.fold_left (fun regions e -> List.concat_map (fun p -> of_number p e) regions) [ region ] [ x; y; z ]

let of_kick z leaf env region (k : Law.kick) =
  let of_weight (p, (w : Linear.t)) =
    if Linear.is_constant w then if Rat.sign w.constant > 0 then of_velocity env p k.motion.velocity else [ p ]
    else
      match Region.where p [ Constraint.less w (constant p Rat.zero) ] with
      | [] -> depends env "weight"
      | negative :: _ ->
        let at = Zone.values z (Option.get (Polyhedron.interior_point negative)) in
        raise (Bad_law { leaf; fault = Negative_weight; at })
  in
  List.concat_map of_weight (number env region k.weight)

let of_law z leaf env region (law : Law.t) =
  match law with
  | Inertial -> [ region ]
  | Gives motion -> of_velocity env region motion.velocity
  | Choose kicks ->
    List.fold_left (fun regions k -> List.concat_map (fun p -> of_kick z leaf env p k) regions) [ region ] kicks

let env (m : Model.t) (z : Zone.t) (p : State.process) (leaf : Model.leaf) i =
  let n = Zone.dimension z in
  let centre axis =
    let place = List.nth (Scc_offsets.Place.coordinates z.places.(i)) axis in
    let offset = Model.leaf_centroid leaf in
    let offset = match axis with 0 -> offset.Vec.x | 1 -> offset.y | _ -> offset.z in
    Linear.add place (Linear.constant n offset)
  in
  let known q = Linear.constant n q in
  let value : Law.variable -> Linear.t = function
    | X -> centre 0
    | Y -> centre 1
    | Z -> centre 2
    | Vx -> known p.velocity.x
    | Vy -> known p.velocity.y
    | Vz -> known p.velocity.z
    | Wx | Wy | Wz -> known Rat.zero (* ranges are refused where bodies turn *)
    | Mass -> known leaf.mass
    | Time -> Option.value z.time ~default:(known Rat.zero)
    | Dt -> Linear.sub (known m.timestep) (Option.value z.step ~default:(known Rat.zero))
  in
  { leaf = leaf.name; value }

let sees_place law =
  Law.mentions (function X | Y | Z | Time | Dt -> true | Vx | Vy | Vz | Wx | Wy | Wz | Mass -> false) law

let cells (c : Instant.context) z region (p : State.process) =
  let m = Semantics.model c.semantics in
  let of_leaf regions (l : State.leaf) =
    let leaf = m.leaves.(l.leaf) in
    let is_open (part : Model.part) = Option.is_some part.open_offset in
    if not (sees_place leaf.law) then regions
    else if Law.mentions_position leaf.law && Array.exists is_open leaf.parts then
      not_affine "the law of `%s` depends on its place, and its parts are at places that are not known" leaf.name
    else List.concat_map (fun q -> of_law z l.leaf (env m z p leaf l.leaf) q leaf.law) regions
  in
  Array.fold_left of_leaf [ region ] p.leaves
