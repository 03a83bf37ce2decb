open Scc_exact

(* {1 The affine hull} *)

let is_zero q = Rat.sign q = 0

let homogeneous coefficients = Constraint.of_form (Linear.make ~constant:Rat.zero coefficients) Equal

(* Vectors that span all solutions of equalities without constants. *)
let null_space n equalities =
  let leading = List.filter_map Constraint.first_variable equalities in
  let direction free =
    let d = Array.make n Rat.zero in
    d.(free) <- Rat.one;
    let give c =
      match Constraint.first_variable c with
      | None -> ()
      | Some i ->
        let f = Constraint.to_form c in
        d.(i) <- Rat.neg (Rat.div (Linear.coefficient f free) (Linear.coefficient f i))
    in
    List.iter give equalities;
    d
  in
  List.init n Fun.id |> List.filter (fun i -> not (List.mem i leading)) |> List.map direction

let echelon vectors =
  let nonzero v = not (Array.for_all is_zero v) in
  match Echelon.of_list (List.map (homogeneous) (List.filter nonzero vectors)) with
  | Some system -> Echelon.to_list system
  | None -> Scc_base.Bug.fail __POS__ "equalities without constants are solved by 0"

let direction_of c = (Constraint.to_form c).Linear.coefficients

let affine ~through vectors =
  let n = Array.length through in
  let equality normal =
    let f = Linear.make ~constant:Rat.zero normal in
    Constraint.equals f (Linear.constant n (Linear.eval f through))
  in
  List.map equality (null_space n (echelon vectors))

let common_equalities p q =
  let n = Polyhedron.dimension p in
  match (Polyhedron.point p, Polyhedron.point q) with
  | Some a, Some b ->
    let along p = null_space n (echelon (List.map direction_of (Polyhedron.equalities p))) in
    affine ~through:a ((Array.map2 Rat.sub b a :: along p) @ along q)
  | None, _ | _, None -> []

(* {1 Borders} *)

(* The plane in a direction, outside of both. *)
let border p q f =
  let n = Polyhedron.dimension p in
  match (Polyhedron.supremum p f, Polyhedron.supremum q f) with
  | Some (Polyhedron.Bound a), Some (Polyhedron.Bound b) ->
    let order = Rat.compare a.value b.value in
    let value = if order >= 0 then a.value else b.value in
    let attained = (order >= 0 && a.attained) || (order <= 0 && b.attained) in
    let limit = Linear.constant n value in
    Some (if attained then Constraint.at_most f limit else Constraint.less f limit)
  | _ -> None

(* The direction alone, in one form of all that are the same but for a factor where the equalities hold. *)
let direction system f =
  let n = Linear.dimension f in
  let c = Echelon.reduce system (Constraint.of_form f At_most) in
  let form = Linear.make ~constant:Rat.zero (Array.init n (Linear.coefficient (Constraint.to_form c))) in
  if Linear.is_constant form then None else Some form

let join ~directions p q =
  if Polyhedron.is_empty p then q
  else if Polyhedron.is_empty q then p
  else
    let n = Polyhedron.dimension p in
    let equalities = common_equalities p q in
    let system =
      match Echelon.of_list equalities with
      | Some system -> system
      | None -> Scc_base.Bug.fail __POS__ "both satisfy the equalities"
    in
    let own p = List.map Constraint.to_form (List.concat_map Constraint.halves (Polyhedron.constraints p)) in
    let both_ways = List.concat_map (fun f -> [ f; Linear.neg f ]) directions in
    let looked_in =
      List.filter_map (direction system) (own p @ own q @ both_ways) |> List.sort_uniq Linear.compare
    in
    Polyhedron.of_constraints n (equalities @ List.filter_map (border p q) looked_in) |> Polyhedron.minimal
