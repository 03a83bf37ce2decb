open Scc_data
open Scc_exact
open Scc_geometry

(* A processor that multiplies and adds in one step would round otherwise, and find other groups. *)
let ( *! ) a b = Sys.opaque_identity (a *. b)

module Ints = Set.Make (Int)

type point = { x : float; y : float; z : float }

let sub a b = { x = a.x -. b.x; y = a.y -. b.y; z = a.z -. b.z }
let add a b = { x = a.x +. b.x; y = a.y +. b.y; z = a.z +. b.z }
let dot a b = (a.x *! b.x) +. (a.y *! b.y) +. (a.z *! b.z)

let cross a b =
  { x = (a.y *! b.z) -. (a.z *! b.y); y = (a.z *! b.x) -. (a.x *! b.z); z = (a.x *! b.y) -. (a.y *! b.x) }

let length a = sqrt (dot a a)
let zero = { x = 0.; y = 0.; z = 0. }

(* About a point of the solid, so that floats tell small distances. *)
let points (set : Polyhedron.ifs) =
  let centre = snd set.ifs_vertices.(0) in
  Array.map
    (fun (_, p) ->
       let v = Vec.sub p centre in
       { x = Rat.to_float v.x; y = Rat.to_float v.y; z = Rat.to_float v.z })
    set.ifs_vertices

(* What is known of a group: its area as a vector, the areas of its faces together, its corners and neighbours. *)
type group = { normal : point; area : float; corners : Ints.t; beside : Ints.t }

let of_face points corners beside =
  let base = points.(corners.(0)) in
  let normal = ref zero in
  for k = 1 to Array.length corners - 2 do
    normal := add !normal (cross (sub points.(corners.(k)) base) (sub points.(corners.(k + 1)) base))
  done;
  { normal = !normal; area = length !normal; corners = Ints.of_list (Array.to_list corners); beside }

let joined a b =
  {
    normal = add a.normal b.normal;
    area = a.area +. b.area;
    corners = Ints.union a.corners b.corners;
    beside = Ints.union a.beside b.beside;
  }

(* How far its corners are from the plane between the highest and the lowest. What is folded over has none. *)
let bend points g =
  let size = length g.normal in
  if size < 0.5 *. g.area || size = 0. then infinity
  else
    let heights = List.map (fun v -> dot g.normal points.(v)) (Ints.elements g.corners) in
    let low = List.fold_left Float.min infinity heights and high = List.fold_left Float.max neg_infinity heights in
    (high -. low) /. (2. *. size)

let neighbours faces =
  let along : (int * int, int) Hashtbl.t = Hashtbl.create (4 * Array.length faces) in
  let each_edge f use =
    let c = faces.(f) in
    Array.iteri (fun i v -> use v c.((i + 1) mod Array.length c)) c
  in
  Array.iteri (fun f _ -> each_edge f (fun v w -> Hashtbl.replace along (v, w) f)) faces;
  Array.init (Array.length faces) (fun f ->
      let found = ref Ints.empty in
      each_edge f (fun v w -> Option.iter (fun g -> found := Ints.add g !found) (Hashtbl.find_opt along (w, v)));
      Ints.remove f !found)

(* A union that may be: how bent it is, and of which groups, as they are now. *)
type candidate = { bent : float; first : int; second : int; sizes : int * int }

let compare_candidates a b =
  Float.compare a.bent b.bent <?> fun () ->
    Int.compare a.first b.first <?> fun () -> Int.compare a.second b.second

let groups ~within (set : Polyhedron.ifs) =
  let faces = Array.map snd set.ifs_faces and points = points set in
  let group = Array.map2 (of_face points) faces (neighbours faces) in
  let sets = Union_find.create (Array.length faces) in
  let size = Array.make (Array.length faces) 1 in
  let heap = Heap.create ~near:(fun c -> c.bent) ~compare:compare_candidates in
  let propose a b =
    let first = Int.min a b and second = Int.max a b in
    let bent = bend points (joined group.(first) group.(second)) in
    if bent <= within then Heap.add heap { bent; first; second; sizes = (size.(first), size.(second)) }
  in
  let alive c =
    let is_root i n = Int.equal (Union_find.find sets i) i && Int.equal size.(i) n in
    is_root c.first (fst c.sizes) && is_root c.second (snd c.sizes)
  in
  let unite c =
    ignore (Union_find.union sets c.first c.second);
    let all = joined group.(c.first) group.(c.second) in
    let roots = Ints.map (Union_find.find sets) all.beside in
    group.(c.first) <- { all with beside = Ints.remove c.first roots };
    size.(c.first) <- size.(c.first) + size.(c.second);
    Ints.iter (propose c.first) group.(c.first).beside
  in
  let rec grow () =
    match Heap.take heap with
    | None -> ()
    | Some c ->
      if alive c then unite c;
      grow ()
  in
  Array.iteri (fun f g -> Ints.iter (fun h -> if (h : int) > f then propose f h) g.beside) group;
  grow ();
  Array.init (Array.length faces) (Union_find.find sets)
