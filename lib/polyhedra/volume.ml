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

(* Variables that no constraint has together, directly or by others: the polyhedron is the product of what it is in
   each block of variables, and a box is quick in any dimension. *)
let blocks n constraints =
  let add blocks c =
    let has i = Constraint.mentions c i in
    let touched, others = List.partition (List.exists has) blocks in
    match touched with [] -> others | _ :: _ -> List.concat touched :: others
  in
  List.fold_left add (List.init n (fun i -> [ i ])) constraints

let of_block p block =
  let onto = Array.of_list (List.sort Int.compare block) in
  let at = Array.make (Polyhedron.dimension p) 0 in
  Array.iteri (fun k i -> at.(i) <- k) onto;
  let m = Array.length onto in
  let about c = List.exists (Constraint.mentions c) block in
  let own = List.filter about (Polyhedron.constraints p) in
  bounded (Polyhedron.of_constraints m (List.map (fun c -> Constraint.rename c ~dimension:m at) own))

let of_polyhedron p =
  let n = Polyhedron.dimension p in
  if Polyhedron.affine_dimension p < n then Some Rat.zero
  else if Polyhedron.is_bounded p then
    let volumes = List.map (of_block p) (blocks n (Polyhedron.constraints p)) in
    Some (List.fold_left Rat.mul Rat.one volumes)
  else None

let of_union u =
  let add sum p =
    match (sum, of_polyhedron p) with
    | Some sum, Some volume -> Some (Rat.add sum volume)
    | _ -> None
  in
  List.fold_left add (Some Rat.zero) (Union.pieces (Union.disjoint u))
