open Scc_exact
open Scc_geometry

type placed = { body : int; solid : Solid.t; position : Vec.t }

let box p = Float_box.at p.position p.solid.Solid.box

let interpenetrate cache p q =
  let obstacle = Obstacle_cache.find cache p.solid q.solid in
  match Obstacle.relation obstacle (Vec.sub q.position p.position) with
  | Interpenetrating -> true
  | Touching | Apart -> false

module Places = Hashtbl.Make (struct
    type t = int * Vec.t

    let equal (i, v) (j, w) = Int.equal i j && Vec.equal v w
    let hash (i, v) = (i * 65599) + Vec.hash v
  end)

(* Many copies at one place (a loop without [at]) would make quadratically many pairs: they are set apart,
   paired with the first of them. *)
let coincident placed =
  let first = Places.create (Array.length placed) in
  let visit (distinct, pairs) i p =
    let key = (p.solid.Solid.id, p.position) in
    match Places.find_opt first key with
    | Some j when placed.(j).body <> p.body -> (distinct, (j, i) :: pairs)
    | Some _ -> (distinct, pairs)
    | None ->
      Places.add first key i;
      (i :: distinct, pairs)
  in
  let _, (distinct, pairs) =
    Array.fold_left (fun (i, found) p -> (i + 1, visit found i p)) (0, ([], [])) placed
  in
  (Array.of_list (List.rev distinct), List.rev pairs)

let compare_pair (i, j) (k, l) =
  Int.compare i k <?> fun () -> Int.compare j l

let all_pairs cache placed =
  let distinct, coinciding = coincident placed in
  let near = Boxes.pairs (Array.map (fun i -> box placed.(i)) distinct) in
  let overlapping (a, b) =
    let i = distinct.(a) and j = distinct.(b) in
    if placed.(i).body <> placed.(j).body && interpenetrate cache placed.(i) placed.(j) then Some (i, j)
    else None
  in
  List.sort compare_pair (List.rev_append coinciding (List.filter_map overlapping near))

(* With a limit, ever longer beginnings are looked at: a heap of bodies shows early, before its pairs are all
   written down. *)
let first_chunk = 64

let rec limited limit cache placed n =
  let whole = n >= Array.length placed in
  let found = all_pairs cache (if whole then placed else Array.sub placed 0 n) in
  if whole || List.compare_length_with found limit >= 0 then Scc_data.Lists.take limit found
  else limited limit cache placed (2 * n)

let pairs ?limit cache placed =
  match limit with
  | None -> all_pairs cache placed
  | Some limit -> limited limit cache placed first_chunk

(* The half-spaces of a placed solid: outward normals with a point of each face. *)
let half_spaces p =
  Array.mapi
    (fun i normal ->
       let _, corners = p.solid.Solid.polyhedron.Polyhedron.faces.(i) in
       (Ivec.to_vec normal, Vec.add p.position (Solid.vertex p.solid corners.(0))))
    p.solid.Solid.normals

(* The ends of the part of the segment from a to b inside the half-spaces, if any. *)
let clip spaces a b =
  let d = Vec.sub b a in
  let cut interval (normal, point) =
    match interval with
    | None -> None
    | Some (low, high) ->
      (* inside where height + t * slope <= 0 *)
      let height = Vec.dot normal (Vec.sub a point) and slope = Vec.dot normal d in
      let low, high =
        match Rat.sign slope with
        | 0 -> if Rat.sign height > 0 then (Rat.one, Rat.zero) else (low, high)
        | s ->
          let t = Rat.neg (Rat.div height slope) in
          if s > 0 then (low, Rat.min high t) else (Rat.max low t, high)
      in
      if Rat.compare low high > 0 then None else Some (low, high)
  in
  match Array.fold_left cut (Some (Rat.zero, Rat.one)) spaces with
  | None -> []
  | Some (low, high) -> [ Vec.axpy low d a; Vec.axpy high d a ]

let clipped_edges p q =
  let spaces = half_spaces q in
  let place i = Vec.add p.position (Solid.vertex p.solid i) in
  Array.to_list p.solid.Solid.polyhedron.Polyhedron.edges
  |> List.concat_map (fun (i, j) -> clip spaces (place i) (place j))

let inside p x =
  Array.for_all (fun (normal, point) -> Rat.sign (Vec.dot normal (Vec.sub x point)) < 0) (half_spaces p)

(* Every vertex of the intersection lies on an edge of one solid and in the other, so the ends of the clipped
   edges span it, and their mean is in its interior if it has one. *)
let common_point p q =
  match clipped_edges p q @ clipped_edges q p with
  | [] -> None
  | points ->
    let sum = List.fold_left Vec.add Vec.zero points in
    let mean = Vec.scale (Rat.make Z.one (Z.of_int (List.length points))) sum in
    if inside p mean && inside q mean then Some mean else None
