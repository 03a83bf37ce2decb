open Scc_base
open Scc_data
open Scc_exact
open Scc_geometry
open Scc_mesh
module Ints = Set.Make (Int)

(* A processor that multiplies and adds in one step would round otherwise, and keep other faces. *)
let ( *! ) a b = Sys.opaque_identity (a *. b)

(* {1 Planes, and their dual} *)

type plane = { x : float; y : float; z : float; d : float }  (* a unit normal; about the middle of the solid *)

type corner = { planes : int list; px : float; py : float; pz : float }

let above p c = (p.x *! c.px) +. (p.y *! c.py) +. (p.z *! c.pz) -. p.d

let plane middle (set : Polyhedron.ifs) (_, corners) =
  let at k = Vec.sub (snd set.ifs_vertices.(corners.(k))) middle in
  let n = Vec.cross (Vec.sub (at 1) (at 0)) (Vec.sub (at 2) (at 0)) in
  let d = Vec.dot n (at 0) in
  let length = sqrt (Rat.to_float (Vec.norm2 n)) in
  let unit q = Rat.to_float q /. length in
  ({ x = unit n.x; y = unit n.y; z = unit n.z; d = unit d }, Vec.scale (Rat.div Rat.one d) n)

(* To so many parts of the farthest of them: short numbers, and few points fall together. *)
let parts = Rat.of_int (1 lsl 40)

let rounded points =
  let larger m (v : Vec.t) = List.fold_left Rat.max m (List.map Rat.abs [ v.x; v.y; v.z ]) in
  let quantum = Rat.div (Array.fold_left larger Rat.zero points) parts in
  let round q = Rat.floor (Rat.add (Rat.div q quantum) (Rat.half)) in
  (Array.map (fun (v : Vec.t) -> Ivec.make (round v.x) (round v.y) (round v.z)) points, quantum)

type t = {
  flat : plane array;
  dual : Ivec.t array;
  quantum : Rat.t;
  corners : corner Growable.t;
  at : Ints.t array;  (* the corners of each face *)
  gone : int list array;  (* near a face that is there: those that went *)
  changes : int array;
}

(* {1 Corners that a hull of the dual shows} *)

let by_names points list =
  let one f = (string_of_int f, Ivec.to_vec points.(f)) in
  { Polyhedron.ifs_vertices = Array.map one (Array.of_list list); ifs_faces = [||] }

(* Of a plane n . y = e of the dual, e > 0. *)
let corner t planes n e =
  let below = Z.mul e (Q.num t.quantum) and unit = Q.den t.quantum in
  (* not in lowest terms, which would take longer *)
  let coordinate c = Q.to_float { Q.num = Z.mul c unit; den = below } in
  { planes; px = coordinate n.Ivec.x; py = coordinate n.y; pz = coordinate n.z }

let through dual = function
  | a :: b :: c :: _ ->
    let n = Ivec.cross (Ivec.sub dual.(b) dual.(a)) (Ivec.sub dual.(c) dual.(a)) in
    (n, Ivec.dot n dual.(a))
  | _ -> Bug.fail __POS__ "a face of fewer than three corners"

let faces_of (hull : Polyhedron.ifs) =
  let index v = int_of_string (fst hull.ifs_vertices.(v)) in
  Array.to_list (Array.map (fun (_, f) -> List.map index (Array.to_list f)) hull.ifs_faces)

(* Those of the plane that some of the points are all in. *)
let flat_face dual list =
  let not_in_line a b c = not (Ivec.is_zero (fst (through dual [ a; b; c ]))) in
  match list with
  | a :: b :: rest -> (
      match List.find_opt (not_in_line a b) rest with
      | Some c ->
        let n, e = through dual [ a; b; c ] in
        Some (if Z.sign e < 0 then (Ivec.neg n, Z.neg e) else (n, e))
      | None -> None)
  | _ -> None

let beside t f =
  let planes c all = List.rev_append (Growable.get t.corners c).planes all in
  List.filter (fun g -> not (Int.equal g f)) (List.sort_uniq Int.compare (Ints.fold planes t.at.(f) []))

(* The faces of the hull of the points [list] from whose front the point [f] is seen, in floats. [None] where
   this is not certain, as with four points in a plane. Coordinates are integers of at most 41 bits, so that
   differences are exact. Let m bound those from [f], so that others are at most 2 m, and u be 2^-53. A
   coordinate of the normal is at most 8 m^2. It is off by 16 m^2 u: two products of at most 4 m^2 and a
   difference of at most 8 m^2 are rounded. One of the three products with it is at most 16 m^3. It is off by
   32 m^3 u and its own rounding, 16 m^3 u. The two sums are rounded by 32 m^3 u and 48 m^3 u. That is 224 m^3
   u, and less than 2^-44 m^3 with terms of order u^2. *)
let seen_from dual list f =
  let points = Array.of_list list in
  let count = Array.length points in
  let from axis = Array.map (fun g -> Z.to_float (Z.sub (axis dual.(g)) (axis dual.(f)))) points in
  let xs = from (fun v -> v.Ivec.x) and ys = from (fun v -> v.Ivec.y) and zs = from (fun v -> v.Ivec.z) in
  let greatest = Array.fold_left (fun m x -> Float.max m (Float.abs x)) in
  let m = greatest (greatest (greatest 0. xs) ys) zs in
  let error = 0x1p-44 *! (m *! (m *! m)) in
  let found = ref [] and certain = ref true in
  let look i j k =
    let ax = xs.(i) and ay = ys.(i) and az = zs.(i) in
    let bx = xs.(j) -. ax and by = ys.(j) -. ay and bz = zs.(j) -. az in
    let cx = xs.(k) -. ax and cy = ys.(k) -. ay and cz = zs.(k) -. az in
    let nx = (by *! cz) -. (bz *! cy) and ny = (bz *! cx) -. (bx *! cz) and nz = (bx *! cy) -. (by *! cx) in
    let up = (nx *! ax) +. (ny *! ay) +. (nz *! az) in
    let before = ref false and behind = ref false and unclear = ref false in
    let l = ref 0 in
    while !l < count && not (!before && !behind) do
      let p = !l in
      if p <> i && p <> j && p <> k then begin
        let d = (nx *! (xs.(p) -. ax)) +. (ny *! (ys.(p) -. ay)) +. (nz *! (zs.(p) -. az)) in
        if d > error then before := true else if d < -.error then behind := true else unclear := true
      end;
      incr l
    done;
    if !before && !behind then ()
    else if !unclear || Float.abs up <= error || not (!before || !behind) then certain := false
    else if (up < 0.) = !behind then
      found := (if up < 0. then [ points.(i); points.(j); points.(k) ]
                else [ points.(i); points.(k); points.(j) ]) :: !found
  in
  for i = 0 to count - 3 do
    for j = i + 1 to count - 2 do
      for k = j + 1 to count - 1 do
        if !certain then look i j k
      done
    done
  done;
  if !certain then Some !found else None

(* Beyond this many points, all triples take longer than the hull. *)
let most_beside = 24

(* The corners that there are when a face has gone; None when the solid is not bounded then. *)
let without t f =
  let list = beside t f in
  let in_front (n, e) = Z.compare (Ivec.dot n t.dual.(f)) e > 0 in
  let quick =
    if List.compare_length_with list most_beside > 0 || List.compare_length_with list 4 < 0 then None
    else seen_from t.dual list f
  in
  let faces =
    match quick with
    | Some list -> List.map (fun planes -> (planes, through t.dual planes)) list
    | None ->
      match Hull_of.hull (by_names t.dual list) with
      | Some hull -> List.map (fun planes -> (planes, through t.dual planes)) (faces_of hull)
      | None -> Option.to_list (Option.map (fun plane -> (list, plane)) (flat_face t.dual list))
  in
  let fresh = List.filter (fun (_, plane) -> in_front plane) faces in
  if fresh <> [] && List.for_all (fun (_, (_, e)) -> Z.sign e > 0) fresh then
    Some (List.map (fun (planes, (n, e)) -> corner t planes n e) fresh)
  else None

(* {1 One after the other} *)

let growth t f fresh =
  let over c =
    let further m g = Float.max m (above t.flat.(g) c) in
    let near m g = List.fold_left further m t.gone.(g) in
    List.fold_left near (further 0. f) (f :: c.planes)
  in
  List.fold_left (fun m c -> Float.max m (over c)) 0. fresh

let enter t c =
  let number = Growable.length t.corners in
  Growable.push t.corners c;
  List.iter (fun g -> t.at.(g) <- Ints.add number t.at.(g)) c.planes

(* What went is remembered by the face beside that looks the most to its side. *)
let remember t f list =
  let along g =
    let a = t.flat.(f) and b = t.flat.(g) in
    (a.x *! b.x) +. (a.y *! b.y) +. (a.z *! b.z)
  in
  let nearer g h = if along h > along g then h else g in
  let heir = List.fold_left nearer (List.hd list) (List.tl list) in
  t.gone.(heir) <- List.rev_append (f :: t.gone.(f)) t.gone.(heir);
  t.gone.(f) <- []

let drop t f fresh =
  let list = beside t f in
  let leave c =
    let corner = Growable.get t.corners c in
    let planes = List.filter (fun g -> not (Int.equal g f)) corner.planes in
    Growable.set t.corners c { corner with planes };
    if List.compare_length_with planes 3 < 0 then
      List.iter (fun g -> t.at.(g) <- Ints.remove c t.at.(g)) planes
  in
  Ints.iter leave t.at.(f);
  t.at.(f) <- Ints.empty;
  remember t f list;
  List.iter (enter t) fresh;
  list

type candidate = { face : int; grows : float; change : int; fresh : corner list }

let compare_candidates a b =
  Float.compare a.grows b.grows <?> fun () -> Int.compare a.face b.face

let start (set : Polyhedron.ifs) =
  let sum = Array.fold_left (fun s (_, p) -> Vec.add s p) Vec.zero set.ifs_vertices in
  let middle = Vec.scale (Rat.make Z.one (Z.of_int (Array.length set.ifs_vertices))) sum in
  let planes = Array.map (plane middle set) set.ifs_faces in
  let count = Array.length planes in
  let dual, quantum = rounded (Array.map snd planes) in
  let t =
    {
      flat = Array.map fst planes; dual; quantum; corners = Growable.create ();
      at = Array.make count Ints.empty; gone = Array.make count []; changes = Array.make count 0;
    }
  in
  let add planes =
    let n, e = through dual planes in
    enter t (corner t planes n e)
  in
  Option.iter (fun hull -> List.iter add (faces_of hull)) (Hull_of.hull (by_names dual (List.init count Fun.id)));
  t

let keep ~most set =
  let t = start set in
  let is_there f = not (Ints.is_empty t.at.(f)) in
  let there () = List.filter is_there (List.init (Array.length t.flat) Fun.id) in
  let heap = Heap.create ~near:(fun c -> c.grows) ~compare:compare_candidates in
  (* those with a candidate in the heap, of now or before: what a face grows by grows with what goes beside it, so
     that a candidate that has changed is looked at again when it comes first *)
  let proposed = Array.make (Array.length t.flat) false in
  let propose f =
    let fresh = without t f in
    let add fresh = Heap.add heap { face = f; grows = growth t f fresh; change = t.changes.(f); fresh } in
    proposed.(f) <- Option.is_some fresh;
    Option.iter add fresh
  in
  let rec go count =
    if count <= most then Ok (there ())
    else
      match Heap.take heap with
      | None -> Error count
      | Some c when is_there c.face && Int.equal c.change t.changes.(c.face) ->
        let list = drop t c.face c.fresh in
        List.iter (fun g -> t.changes.(g) <- t.changes.(g) + 1) list;
        List.iter (fun g -> if not proposed.(g) then propose g) list;
        go (count - 1)
      | Some c ->
        if is_there c.face then propose c.face;
        go count
  in
  let first = there () in
  if List.compare_length_with first most > 0 then List.iter propose first;
  go (List.length first)
