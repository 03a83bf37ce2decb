type corner = { number : int; at : Homogeneous.t }

type t = {
  a : Homogeneous.t;
  b : Homogeneous.t;  (* the segment from a to b is left *)
  ends : corner * corner;  (* of the whole edge *)
  near : corner list;  (* some that an edge joins to these *)
  sides : int * int;  (* the planes of its polygons *)
  off : Homogeneous.t * Homogeneous.t;  (* a corner of each polygon that is not on the edge *)
}

(* {1 Of a surface} *)

module Places = Hashtbl.Make (Homogeneous)

let numbered polygons =
  let numbers = Places.create 256 in
  let corner at =
    match Places.find_opt numbers at with
    | Some corner -> corner
    | None ->
      let corner = { number = Places.length numbers; at } in
      Places.add numbers at corner;
      corner
  in
  Array.map (fun (_, polygon) -> Array.map corner polygon) polygons

(* What is tried for an edge must not grow with what meets at its ends. *)
let most_near = 12

let of_surface planes polygons =
  let cycles = numbered polygons in
  let each_edge f =
    Array.iteri (fun i cycle -> Array.iteri (fun k p -> f i p cycle.((k + 1) mod Array.length cycle)) cycle) cycles
  in
  let owners = Hashtbl.create 1024 and joined = Hashtbl.create 1024 in
  let near p = Option.value ~default:[] (Hashtbl.find_opt joined p.number) in
  each_edge (fun i p q ->
      Hashtbl.replace owners (p.number, q.number) i;
      if List.length (near p) < most_near then Hashtbl.replace joined p.number (q :: near p));
  let found = ref [] in
  let ahead k polygon = List.find_opt (fun x -> Plane.side planes.(k) x > 0) (Array.to_list polygon) in
  let look i p q =
    match Hashtbl.find_opt owners (q.number, p.number) with
    | Some j when p.number < q.number -> (
        let k, this = polygons.(i) and l, other = polygons.(j) in
        match (ahead l this, ahead k other) with
        | Some x, Some y ->
          let near = near p @ near q in
          found := { a = p.at; b = q.at; ends = (p, q); near; sides = (k, l); off = (x, y) } :: !found
        | _ -> ())
    | _ -> ()
  in
  each_edge look;
  Array.of_list (List.rev !found)

(* {1 Cuts} *)

let split plane notches =
  let front = ref [] and back = ref [] in
  let cut notch =
    let s = Plane.side plane notch.a and t = Plane.side plane notch.b in
    if s * t < 0 then begin
      let x = Homogeneous.crossing notch.a (Plane.height plane notch.a) notch.b (Plane.height plane notch.b) in
      let of_a, of_b = if s > 0 then (front, back) else (back, front) in
      of_a := { notch with b = x } :: !of_a;
      of_b := { notch with a = x } :: !of_b
    end
    else if s > 0 || t > 0 then front := notch :: !front
    else if s < 0 || t < 0 then back := notch :: !back
  in
  Array.iter cut notches;
  (Array.of_list (List.rev !back), Array.of_list (List.rev !front))

type preference = Even | Any

(* For [Even], edges that are cut in two count as much as halves that are uneven by so many: the trees of uneven
   halves are deep, and the deeper a tree, the more is cut in two. *)
let per_cut_edge = 20

let cost prefer notches plane =
  let cut = ref 0 and gone = ref 0 and front = ref 0 and back = ref 0 in
  let count notch =
    let s = Plane.side plane notch.a and t = Plane.side plane notch.b in
    if s * t < 0 then incr cut
    else if s > 0 || t > 0 then incr front
    else if s < 0 || t < 0 then incr back
    else if Plane.side plane (fst notch.off) * Plane.side plane (snd notch.off) <= 0 then incr gone
  in
  Array.iter count notches;
  match prefer with
  | Even -> (per_cut_edge * (!cut - !gone)) + abs (!front - !back)
  | Any -> !cut - !gone

(* {1 Planes that are tried} *)

type candidate = Through of t * corner | Of_polygon of int

(* Those strictly between the polygons: so it does not matter which side is the front. *)
let plane_of planes = function
  | Of_polygon k -> Some planes.(k)
  | Through ({ ends = p, q; off = x, y; _ }, r) -> (
      match Plane.through p.at q.at r.at with
      | Some plane when Plane.side plane x * Plane.side plane y < 0 -> Some plane
      | _ -> None)

let sample most all =
  let n = Array.length all in
  if n <= most then all else Array.init most (fun i -> all.(i * n / most))

let most_elsewhere = 8

(* The planes of polygons last, so that they are taken only if they are better: they go on from other edges of the
   polygon into faces beside them, where {!Scc_concave.Refined} has to cut again. *)
let candidates notches some =
  let elsewhere = List.map (fun n -> fst n.ends) (Array.to_list (sample most_elsewhere notches)) in
  let through n = List.map (fun corner -> Through (n, corner)) (n.near @ elsewhere) in
  let polygons = List.concat_map (fun { sides = k, l; _ } -> [ k; l ]) some in
  List.concat_map through some @ List.map (fun k -> Of_polygon k) (List.sort_uniq Int.compare polygons)

(* So that the work at one cell is near linear, and that at all cells as well: from 8 000 edges on, less is
   spent on a cell. *)
let most_tried ~all n = Int.max 24 (200_000 / Int.max 1 (all / 4_000) / n)

let plane ~prefer ~all planes notches =
  let n = Array.length notches in
  if n = 0 then None
  else
    let most = most_tried ~all n in
    let better found candidate =
      match (plane_of planes candidate, found) with
      | None, _ -> found
      | Some plane, None -> Some (cost prefer notches plane, plane)
      | Some plane, Some (least, _) ->
        let c = cost prefer notches plane in
        if c < least || (c = least && prefer = Any) then Some (c, plane) else found
    in
    let list = candidates notches (Array.to_list (sample most notches)) in
    match Array.fold_left better None (sample most (Array.of_list list)) with
    | Some (_, plane) -> Some plane
    | None -> Some planes.(fst notches.(0).sides)
