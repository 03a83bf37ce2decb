open Scc_exact
open Scc_geometry
module Points = Hashtbl.Make (Vec)

let vertices n = Scc_base.Plural.count n "vertex" "vertices"
let faces n = Scc_base.Plural.count n "face" "faces"

(* {1 Grid} *)

let on_grid quantum (set : Polyhedron.ifs) =
  let round x = Rat.round_to x ~quantum in
  let snap (name, (v : Vec.t)) = (name, Vec.make (round v.x) (round v.y) (round v.z)) in
  let there = Array.map snap set.ifs_vertices in
  let far = ref 0 and farthest = ref Rat.zero and moved = ref 0 in
  Array.iteri
    (fun i (_, v) ->
       let d = Vec.norm2 (Vec.sub v (snd there.(i))) in
       if Rat.sign d > 0 then incr moved;
       if Rat.compare d !farthest > 0 then (
         far := i;
         farthest := d))
    set.ifs_vertices;
  let told =
    if !moved = 0 then "on the grid: nothing moved"
    else
      Printf.sprintf "on the grid: %s moved, %s the farthest, by %s" (vertices !moved)
        (fst set.ifs_vertices.(!far))
        (Decimal.significant ~digits:3 (Rat.root !farthest))
  in
  ({ set with ifs_vertices = there }, told)

(* {1 Weld} *)

(* Without corners that are their successor, around the end too. *)
let distinct (corners : int array) =
  let n = Array.length corners in
  let keep i = corners.(i) <> corners.((i + 1) mod n) in
  Array.of_list (List.filter_map (fun i -> if keep i then Some corners.(i) else None) (List.init n Fun.id))

let reversed corners =
  let n = Array.length corners in
  Array.init n (fun i -> corners.(n - 1 - i))

(* If each face is there from both sides, only the first of both stays. *)
let single faces =
  let once = Twice.single faces in
  let seen = Hashtbl.create 64 in
  let key c = Twice.from_least c in
  List.iter (fun (_, c) -> Hashtbl.replace seen (key c) ()) once;
  let other c = key (reversed c) in
  if once = [] || List.exists (fun (_, c) -> not (Hashtbl.mem seen (other c))) once then once
  else begin
    Hashtbl.reset seen;
    let first (_, c) =
      let stays = not (Hashtbl.mem seen (other c)) in
      if stays then Hashtbl.add seen (key c) ();
      stays
    in
    List.filter first once
  end

let has_faces_twice (set : Polyhedron.ifs) =
  List.compare_length_with (single (Array.to_list set.ifs_faces)) (Array.length set.ifs_faces) < 0

let weld (set : Polyhedron.ifs) =
  let n = Array.length set.ifs_vertices in
  let first = Points.create n in
  let find i (_, v) =
    match Points.find_opt first v with
    | Some j -> j
    | None ->
      Points.add first v i;
      i
  in
  let into = Array.mapi find set.ifs_vertices in
  let face (name, corners) = (name, distinct (Array.map (fun v -> into.(v)) corners)) in
  let mapped = Array.to_list (Array.map face set.ifs_faces) in
  let proper = List.filter (fun (_, c) -> Array.length c >= 3) mapped in
  let proper = Array.to_list (Slivers.dissolved { set with ifs_faces = Array.of_list proper }).ifs_faces in
  let kept = Array.of_list (single proper) in
  let cloud = Array.length set.ifs_faces = 0 in
  let used = Array.init n (fun i -> cloud && into.(i) = i) in
  Array.iter (fun (_, c) -> Array.iter (fun v -> used.(v) <- true) c) kept;
  let number = Array.make n 0 and next = ref 0 in
  Array.iteri
    (fun i u ->
       if u then (
         number.(i) <- !next;
         incr next))
    used;
  let left = List.filter (fun i -> used.(i)) (List.init n Fun.id) in
  let set' =
    {
      Polyhedron.ifs_vertices = Array.map (fun i -> set.ifs_vertices.(i)) (Array.of_list left);
      ifs_faces = Array.map (fun (name, c) -> (name, Array.map (fun v -> number.(v)) c)) kept;
    }
  in
  let gone = Array.length set.ifs_faces - List.length proper in
  let doubled = List.length proper - Array.length kept in
  let went n what = if n = 0 then "" else Printf.sprintf "; %s %s went" (faces n) what in
  let told =
    Printf.sprintf "welded: %s became %d%s%s" (vertices n) !next (went gone "without an area")
      (went doubled "that were there twice")
  in
  (set', told)

(* {1 Orient} *)

(* The faces at each edge, with whether they run along it from the lesser vertex to the greater. *)
let edges_of (set : Polyhedron.ifs) =
  let edges = Hashtbl.create 1024 in
  let put f corners =
    let n = Array.length corners in
    Array.iteri
      (fun i a ->
         let b = corners.((i + 1) mod n) in
         let edge = (min a b, max a b) in
         Hashtbl.replace edges edge ((f, a < b) :: Option.value ~default:[] (Hashtbl.find_opt edges edge)))
      corners
  in
  Array.iteri (fun f (_, c) -> put f c) set.ifs_faces;
  edges

let is_open set = Hashtbl.fold (fun _ at found -> found || List.compare_length_with at 1 = 0) (edges_of set) false

let closing_grid (set : Polyhedron.ifs) =
  let welded set = fst (weld set) in
  let larger m (_, (v : Vec.t)) = List.fold_left (fun m q -> Rat.max m (Rat.abs q)) m [ v.x; v.y; v.z ] in
  let greatest = Array.fold_left larger Rat.zero set.ifs_vertices in
  let ten = Rat.of_int 10 in
  let rec from quantum tries =
    if tries = 0 then None
    else
      let there = welded (fst (on_grid quantum set)) in
      if Array.length there.ifs_faces > 0 && not (is_open there) then Some quantum
      else from (Rat.mul quantum ten) (tries - 1)
  in
  if Array.length set.ifs_faces = 0 || Rat.sign greatest = 0 || not (is_open (welded set)) then None
  else
    let rec power q = if Rat.compare q greatest > 0 then Rat.div q ten else power (Rat.mul q ten) in
    let rec below q = if Rat.compare q greatest <= 0 then q else below (Rat.div q ten) in
    let billionth = Rat.make Z.one (Z.of_int 1_000_000_000) in
    from (Rat.mul billionth (power (below Rat.one))) 6

type consistent = { turned : bool array; closed : int list list }

(* All faces at an edge, of which any two neighbours agree. *)
let is_closed edges turned =
  let open_ = Hashtbl.create 16 in
  let look piece _ at =
    let way sum (f, along) = if Bool.equal along turned.(f) then sum - 1 else sum + 1 in
    let own = List.sort_uniq Int.compare (List.map (fun (f, _) -> piece.(f)) at) in
    let balanced p = List.fold_left way 0 (List.filter (fun (f, _) -> piece.(f) = p) at) = 0 in
    List.iter (fun p -> if not (balanced p) then Hashtbl.replace open_ p ()) own
  in
  fun piece ->
    Hashtbl.iter (look piece) edges;
    fun p -> not (Hashtbl.mem open_ p)

(* Two faces with the same corners, which solids share, or a solid and its hollow: the second one with the first.
*)
let shared_faces (set : Polyhedron.ifs) =
  let known = Hashtbl.create 64 in
  let enter f (_, c) =
    let key = List.sort Int.compare (Array.to_list c) in
    Hashtbl.replace known key (f :: Option.value ~default:[] (Hashtbl.find_opt known key))
  in
  Array.iteri enter set.ifs_faces;
  let pair f g =
    let key k = Twice.from_least (snd set.ifs_faces.(k)) in
    let turned = Twice.from_least (reversed (snd set.ifs_faces.(g))) in
    if key f = turned then Some (f, g, false) else if key f = key g then Some (f, g, true) else None
  in
  let look _ faces all = match faces with [ g; f ] -> Option.to_list (pair f g) @ all | _ -> all in
  List.sort compare (Hashtbl.fold look known [])

(* The faces at each edge, without some faces. *)
let edges_without shared (set : Polyhedron.ifs) =
  let edges = edges_of set and apart = Array.map (fun _ -> false) set.ifs_faces in
  let leave (f, g, _) =
    apart.(f) <- true;
    apart.(g) <- true
  in
  List.iter leave shared;
  if shared <> [] then
    Hashtbl.filter_map_inplace (fun _ at -> Some (List.filter (fun (f, _) -> not apart.(f)) at)) edges;
  edges

let neighbours_agree (set : Polyhedron.ifs) shared =
  let n = Array.length set.ifs_faces in
  let beside = Array.make n [] and edges = edges_without shared set in
  let join _ = function
    | [ (f, along); (g, along') ] when f <> g ->
      let differ = Bool.equal along along' in
      beside.(f) <- (g, differ) :: beside.(f);
      beside.(g) <- (f, differ) :: beside.(g)
    | _ -> ()
  in
  Hashtbl.iter join edges;
  let turned = Array.make n false and piece = Array.make n (-1) in
  let wrong = ref max_int in
  let follow first =
    let queue = Queue.create () in
    piece.(first) <- first;
    Queue.add first queue;
    while not (Queue.is_empty queue) do
      let f = Queue.pop queue in
      let visit (g, differ) =
        let wanted = not (Bool.equal turned.(f) differ) in
        if piece.(g) >= 0 then (if not (Bool.equal turned.(g) wanted) then wrong := min !wrong (max f g))
        else begin
          piece.(g) <- first;
          turned.(g) <- wanted;
          Queue.add g queue
        end
      in
      List.iter visit beside.(f)
    done
  in
  let share (f, g, over) =
    piece.(f) <- f;
    piece.(g) <- f;
    turned.(g) <- over
  in
  List.iter share shared;
  for f = 0 to n - 1 do
    if piece.(f) < 0 then follow f
  done;
  if !wrong < max_int then
    Error
      (Printf.sprintf "the surface has only one side: going around it, face %s comes out turned over"
         (fst set.ifs_faces.(!wrong)))
  else begin
    let members = Array.make n [] in
    for f = n - 1 downto 0 do
      members.(piece.(f)) <- f :: members.(piece.(f))
    done;
    let closed = is_closed edges turned piece in
    let firsts = List.filter (fun f -> piece.(f) = f && closed f) (List.init n Fun.id) in
    Ok { turned; closed = List.map (fun f -> members.(f)) firsts }
  end

let all_closed found = List.fold_left (fun n p -> n + List.length p) 0 found.closed = Array.length found.turned

(* Without the faces that they share, solids are closed together. *)
let consistent set =
  match shared_faces set with
  | [] -> neighbours_agree set []
  | shared -> (
      match neighbours_agree set shared with
      | Ok found when all_closed found -> Ok found
      | Ok _ | Error _ -> neighbours_agree set [])

(* {1 Merge} *)

let merge (set : Polyhedron.ifs) =
  (* A cloud of points keeps them: there is no face that could use them. *)
  let merged = if Array.length set.ifs_faces = 0 then set else Merge_coplanar.merge set in
  let told =
    Printf.sprintf "merged: %s became %d" (faces (Array.length set.ifs_faces)) (Array.length merged.ifs_faces)
  in
  (merged, told)
