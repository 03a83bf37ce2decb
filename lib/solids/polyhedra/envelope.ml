open Scc_exact

let halves p = List.concat_map Constraint.halves (Polyhedron.constraints p)

let kept constraints p = List.filter (Polyhedron.implies p) constraints

(* Where a strict constraint does not hold, it may hold with its border. *)
let with_borders constraints =
  List.sort_uniq Constraint.compare (constraints @ List.map Constraint.closed constraints)

let join p q =
  if Polyhedron.is_empty p then q
  else if Polyhedron.is_empty q then p
  else
    let from p q = kept (with_borders (halves p)) q in
    Polyhedron.minimal (Polyhedron.of_constraints (Polyhedron.dimension p) (from p q @ from q p))

let widen old next =
  if Polyhedron.is_empty old then next
  else Polyhedron.minimal (Polyhedron.of_constraints (Polyhedron.dimension old) (kept (halves old) next))

(* A strict constraint that keeps the piece out: the least face of the whole on which the piece lies is where all
   constraints that are tight on it are tight, which is the border of their sum. *)
let without_face whole piece =
  let inequality (c : Constraint.t) = c.relation <> Equal in
  let tight c = inequality c && Polyhedron.implies piece (Constraint.tight c) in
  match List.filter tight (Polyhedron.constraints (Polyhedron.closure whole)) with
  | [] -> None
  | c :: others ->
    let add sum d = Linear.add sum (Constraint.to_form d) in
    Some (Constraint.of_form (List.fold_left add (Constraint.to_form c) others) Less)

let all_some options =
  if List.exists Option.is_none options then None else Some (List.filter_map Fun.id options)

(* Mostly two inequalities show that they are apart. *)
let seen_apart p q =
  let excluded c d =
    Constraint.(glance (closed c) d = Excludes) && Constraint.(glance c (closed d) = Excludes)
  in
  let others = Polyhedron.constraints q in
  List.exists (fun c -> List.exists (excluded c) others) (Polyhedron.constraints p)

(* A convex union of two has a point of one on the border of the other. *)
let apart p q =
  seen_apart p q
  || (Polyhedron.disjoint (Polyhedron.closure p) q && Polyhedron.disjoint p (Polyhedron.closure q))

(* Some points between one of each, which a convex union has all. *)
let between =
  List.map (fun (n, d) -> Rat.make (Z.of_int n) (Z.of_int d)) [ (1, 2); (1, 4); (3, 4); (1, 8); (7, 8) ]

let seem_convex p q =
  match (Polyhedron.point p, Polyhedron.point q) with
  | Some a, Some b ->
    let at t = Array.map2 (fun x y -> Rat.add x (Rat.mul t (Rat.sub y x))) a b in
    List.for_all (fun t -> let c = at t in Polyhedron.mem p c || Polyhedron.mem q c) between
  | None, _ | _, None -> true

(* If the union of p and q is a polyhedron, the join may still have some faces more. A convex set in finitely many
   faces is in one of them, so each piece of what is too much lies in a face that has nothing of the union. *)
let merge p q =
  if Polyhedron.not_convex p q then None
  else if Polyhedron.included p q then Some q
  else if Polyhedron.included q p then Some p
  else if apart p q || not (seem_convex p q) then None
  else
    let whole = join p q in
    let left = List.concat_map (fun piece -> Difference.pieces piece q) (Difference.pieces whole p) in
    let without_faces = all_some (List.map (without_face whole) left) in
    let cut = Option.map (Polyhedron.add_all whole) without_faces in
    match cut with
    | Some cut when Polyhedron.included p cut && Polyhedron.included q cut -> Some (Polyhedron.minimal cut)
    | Some _ | None -> None
