open Scc_exact
open Scc_geometry

(* {1 Cutting} *)

type piece = { of_region : int; corners : Vec.t array }

let height (region : Drawn.region) x = Rat.sub (Vec.dot (Ivec.to_vec region.normal) x) region.level

(* What of a convex polygon is strictly on a side of the plane: [side] is 1 or -1. *)
let on_side height side polygon =
  let n = Array.length polygon in
  let heights = Array.map height polygon in
  let step k =
    let l = (k + 1) mod n in
    let h = heights.(k) and i = heights.(l) in
    let here = if side * Rat.sign h >= 0 then [ polygon.(k) ] else [] in
    if Rat.sign h * Rat.sign i < 0 then
      here @ [ Vec.axpy (Rat.div h (Rat.sub h i)) (Vec.sub polygon.(l) polygon.(k)) polygon.(k) ]
    else here
  in
  if Array.exists (fun h -> side * Rat.sign h > 0) heights then Array.of_list (List.concat (List.init n step)) else [||]

let keep region side pieces =
  List.filter_map
    (fun p ->
       let corners = on_side (height region) side p.corners in
       if Array.length corners = 0 then None else Some { p with corners })
    pieces

(* Pieces that are not on the surface of the cell. *)
let inner cell pieces =
  let face_plane (_, at) =
    let corner k = snd cell.Polyhedron.vertices.(at.(k)) in
    (Vec.cross (Vec.sub (corner 1) (corner 0)) (Vec.sub (corner 2) (corner 0)), corner 0)
  in
  let planes = Array.to_list (Array.map face_plane cell.Polyhedron.faces) in
  let on p (n, x) = Array.for_all (fun y -> Rat.sign (Vec.dot n (Vec.sub y x)) = 0) p.corners in
  List.filter (fun p -> not (List.exists (on p) planes)) pieces

let looked_at = 24

(* The plane that cuts the fewest other pieces, of some that are tried, and of those the one with the most pieces. *)
let best (d : Drawn.t) pieces =
  let count = Hashtbl.create 16 in
  List.iter
    (fun p -> Hashtbl.replace count p.of_region (1 + Option.value ~default:0 (Hashtbl.find_opt count p.of_region)))
    pieces;
  let regions = List.sort Int.compare (Hashtbl.fold (fun r _ all -> r :: all) count []) in
  let step = Int.max 1 (List.length regions / looked_at) in
  let tried = List.filteri (fun i _ -> i mod step = 0) regions in
  let cost r =
    let region = d.regions.(r) in
    let cuts p =
      let signs = Array.map (fun x -> Rat.sign (height region x)) p.corners in
      Array.exists (Int.equal 1) signs && Array.exists (Int.equal (-1)) signs
    in
    (List.length (List.filter cuts pieces), -Hashtbl.find count r)
  in
  let compare (_, (a, b)) (_, (c, e)) = if a <> c then Int.compare a c else Int.compare b e in
  match List.sort compare (List.map (fun r -> (r, cost r)) tried) with
  | (r, _) :: _ -> r
  | [] -> Scc_base.Bug.fail __POS__ "a cell without pieces"

(* A cell that no piece of the surface cuts is inside or outside as a whole. It is next to a piece on the plane that made
   it, which faces outward: behind it is the inside. *)
type cell = { solid : Polyhedron.t; pieces : piece list; inside : bool }

let cells ~limit (d : Drawn.t) root =
  let rec cut found count = function
    | _ when count > limit -> None
    | [] -> Some (List.rev found)
    | cell :: rest when cell.pieces = [] -> cut (if cell.inside then cell.solid :: found else found) count rest
    | cell :: rest ->
      let region = d.regions.(best d cell.pieces) in
      let behind, before = Refined.halves region cell.solid in
      let half solid side = { solid; pieces = keep region side cell.pieces; inside = side < 0 } in
      cut found (count + 1) (half behind (-1) :: half before 1 :: rest)
  in
  cut [] 1 [ root ]

(* {1 Merging} *)

let plane (p : Polyhedron.t) f =
  let at = snd p.faces.(f) in
  let corner k = snd p.vertices.(at.(k)) in
  (Vec.cross (Vec.sub (corner 1) (corner 0)) (Vec.sub (corner 2) (corner 0)), corner 0)

(* All of [other] is behind the faces of [one], but for the face that they share. *)
let behind (one : Polyhedron.t) shared (other : Polyhedron.t) =
  let holds f =
    f = shared
    ||
    let n, x = plane one f in
    Array.for_all (fun (_, y) -> Rat.sign (Vec.dot n (Vec.sub y x)) <= 0) other.vertices
  in
  List.for_all holds (List.init (Array.length one.faces) Fun.id)

let face_key (p : Polyhedron.t) f =
  let corners = List.map (fun v -> snd p.vertices.(v)) (Array.to_list (snd p.faces.(f))) in
  String.concat ";" (List.map Vec.to_string (List.sort Vec.compare corners))

let corners (p : Polyhedron.t) = Array.to_list (Array.map snd p.vertices)

let merged list =
  let parts = Hashtbl.create 64 and at_face = Hashtbl.create 256 and next = ref 0 in
  let queue = Queue.create () in
  let enter p =
    let k = !next in
    incr next;
    Hashtbl.replace parts k p;
    for f = 0 to Array.length p.Polyhedron.faces - 1 do
      Hashtbl.add at_face (face_key p f) (k, f)
    done;
    Queue.add k queue
  in
  List.iter enter list;
  let partner k (p : Polyhedron.t) f =
    let fits (l, g) =
      l <> k
      && match Hashtbl.find_opt parts l with
      | Some other -> behind p f other && behind other g p
      | None -> false
    in
    List.find_opt fits (Hashtbl.find_all at_face (face_key p f))
  in
  let rec first k p f =
    if f >= Array.length p.Polyhedron.faces then None
    else match partner k p f with Some (l, _) -> Some l | None -> first k p (f + 1)
  in
  let rec work () =
    match Queue.take_opt queue with
    | None -> ()
    | Some k ->
      (match Hashtbl.find_opt parts k with
       | None -> ()
       | Some p -> (
           match first k p 0 with
           | None -> ()
           | Some l ->
             let other = Hashtbl.find parts l in
             Hashtbl.remove parts k;
             Hashtbl.remove parts l;
             enter (Refined.solid (corners p @ corners other))));
      work ()
  in
  work ();
  List.sort (fun (k, _) (l, _) -> Int.compare k l) (Hashtbl.fold (fun k p all -> (k, p) :: all) parts [])
  |> List.map snd

let parts ~limit (d : Drawn.t) =
  let root = Refined.solid (Array.to_list (Array.map snd d.set.ifs_vertices)) in
  let all =
    List.concat
      (List.mapi
         (fun r (region : Drawn.region) -> List.map (fun corners -> { of_region = r; corners }) region.pieces)
         (Array.to_list d.regions))
  in
  let root = { solid = root; pieces = inner root all; inside = true } in
  Option.map merged (cells ~limit d root)
