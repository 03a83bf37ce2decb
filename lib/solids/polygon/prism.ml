open Scc_exact

(* Of twice the area of the face, along its normal. *)
let normal (vertices : Vec.t array) face =
  let n = Array.length face in
  let sum = ref Vec.zero in
  for k = 0 to n - 1 do
    sum := Vec.add !sum (Vec.cross vertices.(face.(k)) vertices.(face.((k + 1) mod n)))
  done;
  !sum

module Directions = Hashtbl.Make (Ivec)

let direction v = Ivec.primitive (fst (Ivec.of_vec v))

(* All of the faces are in one plane across n: how far along n. *)
let level vertices n faces =
  let height face = Vec.dot n vertices.(face.(0)) in
  match faces with
  | [] -> None
  | face :: rest ->
    let h = height face in
    if List.for_all (fun face -> Rat.equal h (height face)) rest then Some h else None

(* The boundary of faces side by side: what goes out of each vertex, if that is one edge. *)
let boundary faces =
  let directed = Hashtbl.create 64 in
  List.iter (fun face -> List.iter (fun e -> Hashtbl.replace directed e ()) (Polygon.edges face)) faces;
  let next = Hashtbl.create 64 in
  let once =
    Hashtbl.fold
      (fun (u, v) () once ->
         if Hashtbl.mem directed (v, u) then once
         else begin
           let fresh = not (Hashtbl.mem next u) in
           Hashtbl.replace next u v;
           once && fresh
         end)
      directed true
  in
  if once then Some next else None

(* Each beginning with its least vertex, in the order of these. *)
let loops next =
  let starts = List.sort Int.compare (Hashtbl.fold (fun u _ all -> u :: all) next []) in
  let seen = Hashtbl.create 64 in
  let rec walk start u found =
    Hashtbl.replace seen u ();
    match Hashtbl.find_opt next u with
    | None -> None
    | Some v when v = start -> Some (Array.of_list (List.rev (u :: found)))
    | Some v when Hashtbl.mem seen v -> None
    | Some v -> walk start v (u :: found)
  in
  let add all start =
    if Hashtbl.mem seen start then all
    else
      match (all, walk start start []) with
      | Some all, Some loop -> Some (loop :: all)
      | _ -> None
  in
  Option.map List.rev (List.fold_left add (Some []) starts)

(* The vector that takes the corners of one cap to those of the other, which keeps their order, and for each corner
   of the first that of the second. *)
let match_corners (vertices : Vec.t array) low high =
  let sorted loops =
    let all = Array.concat loops in
    Array.stable_sort (fun u v -> Vec.compare vertices.(u) vertices.(v)) all;
    all
  in
  let low = sorted low and high = sorted high in
  if Array.length low <> Array.length high || Array.length low = 0 then None
  else
    let along = Vec.sub vertices.(high.(0)) vertices.(low.(0)) in
    let above = Hashtbl.create 64 in
    let fits k u =
      Hashtbl.replace above u high.(k);
      Vec.equal (Vec.add vertices.(u) along) vertices.(high.(k))
    in
    if List.for_all Fun.id (List.mapi fits (Array.to_list low)) then Some (along, above) else None

(* With the cap whose outward normal is n. *)
let polygon vertices n loops =
  let corners = Array.concat loops in
  let start = ref 0 in
  let ring loop =
    let first = !start in
    start := first + Array.length loop;
    Array.init (Array.length loop) (fun k -> first + k)
  in
  let rings = List.map ring loops in
  let points = Array.map (fun u -> Grid.seen_along n vertices.(u)) corners in
  let grid = Grid.make points in
  match List.partition (fun ring -> Grid.twice_area grid ring > 0) rings with
  | [ outer ], holes -> (
      match Polygon.make points (outer :: holes) with
      | Ok polygon -> Some (polygon, corners)
      | Error _ -> None)
  | _ -> None

(* Of faces with their directions, by these; n is a direction across which there are faces on both sides. *)
let along vertices all by_direction n =
  let low = Directions.find by_direction (Ivec.neg n) and high = Directions.find by_direction n in
  let is_cap m = Ivec.equal m n || Ivec.equal m (Ivec.neg n) in
  let n = Ivec.to_vec n in
  let*? bottom = level vertices n low in
  let*? top = level vertices n high in
  let*? next_low = boundary low in
  let*? next_high = boundary high in
  let*? low = loops next_low in
  let*? high = loops next_high in
  let*? t, above = match_corners vertices low high in
  let is_wall (_, m) = is_cap m || Rat.sign (Vec.dot (Ivec.to_vec m) t) = 0 in
  if Rat.compare bottom top >= 0 || not (List.for_all is_wall all) then None
  else
    let*? polygon, corners = polygon vertices (Vec.neg n) low in
    let prism piece =
      let base = Array.map (fun k -> corners.(k)) piece in
      Array.append base (Array.map (Hashtbl.find above) base)
    in
    Some (List.map prism (Partition.convex polygon))

let pieces ~vertices ~faces =
  let normals = Array.map (normal vertices) faces in
  if Array.exists Vec.is_zero normals then None
  else begin
    let all = List.combine (Array.to_list faces) (List.map direction (Array.to_list normals)) in
    let by_direction = Directions.create 64 in
    let at n = Option.value ~default:[] (Directions.find_opt by_direction n) in
    List.iter (fun (face, n) -> Directions.replace by_direction n (face :: at n)) (List.rev all);
    let tried = Directions.create 64 in
    let attempt (_, n) =
      let back = Ivec.neg n in
      if Directions.mem tried n || Directions.mem tried back || not (Directions.mem by_direction back) then None
      else begin
        Directions.replace tried n ();
        along vertices all by_direction n
      end
    in
    List.find_map attempt all
  end
