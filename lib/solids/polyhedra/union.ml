type t = { dimension : int; pieces : Polyhedron.t list }

let some pieces = List.filter (fun p -> not (Polyhedron.is_empty p)) pieces

let of_polyhedra dimension pieces =
  if List.exists (fun p -> Polyhedron.dimension p <> dimension) pieces then
    Scc_base.Bug.fail __POS__ "polyhedra of another dimension";
  { dimension; pieces = some pieces }

let empty dimension = { dimension; pieces = [] }
let of_polyhedron p = of_polyhedra (Polyhedron.dimension p) [ p ]
let universe n = of_polyhedron (Polyhedron.universe n)
let dimension u = u.dimension
let pieces u = u.pieces
let is_empty u = u.pieces = []
let mem u point = List.exists (fun p -> Polyhedron.mem p point) u.pieces

let point u =
  match u.pieces with
  | [] -> None
  | p :: _ -> Polyhedron.interior_point p

let same_dimension u n = if u.dimension <> n then Scc_base.Bug.fail __POS__ "sets of different dimensions"

let without pieces q = List.concat_map (fun p -> Difference.pieces p q) pieces

let covers u p =
  same_dimension u (Polyhedron.dimension p);
  List.exists (Polyhedron.included p) u.pieces || List.fold_left without (some [ p ]) u.pieces = []

let outside u p =
  same_dimension u (Polyhedron.dimension p);
  (* one piece after the other is left out, and what is left is followed at once *)
  let rec go p = function
    | [] -> Polyhedron.point p
    | q :: rest when Polyhedron.disjoint p q -> go p rest
    | q :: rest -> List.find_map (fun p -> go p rest) (Difference.pieces p q)
  in
  if Polyhedron.is_empty p then None else go p u.pieces

let included u v = List.for_all (covers v) u.pieces
let equal u v = u == v || (included u v && included v u)

let union u v =
  same_dimension u v.dimension;
  { u with pieces = u.pieces @ v.pieces }

let inter u v =
  same_dimension u v.dimension;
  let with_piece p = List.map (Polyhedron.inter p) v.pieces in
  { u with pieces = some (List.concat_map with_piece u.pieces) }

let difference u v =
  same_dimension u v.dimension;
  { u with pieces = List.fold_left without u.pieces v.pieces }

let map ~dimension f u = of_polyhedra dimension (List.map f u.pieces)

let disjoint u =
  let put pieces p = pieces @ List.fold_left without [ p ] pieces in
  { u with pieces = List.fold_left put [] u.pieces }

(* The piece, with all that it can be merged with, and the others. *)
let rec absorb p before = function
  | [] -> (p, List.rev before)
  | q :: rest -> (
      match Envelope.merge p q with
      (* what did not fit before may fit the greater one *)
      | Some whole -> absorb whole [] (List.rev_append before rest)
      | None -> absorb p (q :: before) rest)

let add_merged p settled =
  let p, others = absorb (Polyhedron.minimal p) [] settled in
  p :: others

let merged u = { u with pieces = List.rev (List.fold_left (fun settled p -> add_merged p settled) [] u.pieces) }
