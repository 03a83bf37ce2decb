open Scc_exact

(* The pyramids over the facets from the origin, with the sign of the side on which it is: on a facet a.x = b the
   sum has b / |a_j| times the volume of its shadow along x_j, for any j with a_j not 0, and 1/n of it is the
   volume. *)

let without_variable j (c : Constraint.t) =
  let n = Constraint.dimension c in
  let at = Array.init n (fun i -> if i < j then i else i - 1) in
  Constraint.rename c ~dimension:(n - 1) at

let facet n (facet : Constraint.t) j others =
  let by = Constraint.tight facet in
  let rest = List.map (fun c -> without_variable j (Constraint.eliminate c j ~by)) others in
  Polyhedron.of_constraints (n - 1) rest

(* Facets through the origin add nothing: it is moved to a point where many meet, which is a vertex. *)
let moved_to corner p =
  let n = Polyhedron.dimension p in
  let shifted i = Linear.add (Linear.variable n i) (Linear.constant n corner.(i)) in
  Polyhedron.preimage p ~dimension:n (Array.init n shifted)

let rec bounded p =
  let n = Polyhedron.dimension p in
  if Polyhedron.affine_dimension p < n then Rat.zero
  else if n = 0 then Rat.one
  else
    let p = Polyhedron.minimal p in
    let p = moved_to (Option.get (Polyhedron.corner p)) p in
    let facets = List.map Constraint.closed (Polyhedron.constraints p) in
    let pyramid (c : Constraint.t) =
      if Z.sign c.right = 0 then Rat.zero
      else
        let j = Option.get (Constraint.first_variable c) in
        let base = bounded (facet n c j (List.filter (fun d -> not (d == c)) facets)) in
        Rat.mul (Rat.make c.right (Z.abs c.normal.(j))) base
    in
    Rat.div (List.fold_left (fun sum c -> Rat.add sum (pyramid c)) Rat.zero facets) (Rat.of_int n)

let of_polyhedron p =
  if Polyhedron.affine_dimension p < Polyhedron.dimension p then Some Rat.zero
  else if Polyhedron.is_bounded p then Some (bounded p)
  else None

let of_union u =
  let add sum p =
    match (sum, of_polyhedron p) with
    | Some sum, Some volume -> Some (Rat.add sum volume)
    | _ -> None
  in
  List.fold_left add (Some Rat.zero) (Union.pieces (Union.disjoint u))
