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

type piece = { members : int list; closed : bool }

(* Which faces are to be turned, and the pieces; [Error f]: no choice fits at f. *)
let pieces (set : Polyhedron.ifs) =
  let n = Array.length set.ifs_faces in
  let beside = Array.make n [] and shut = Array.make n true in
  let open_edge l = List.iter (fun (f, _) -> shut.(f) <- false) l in
  Hashtbl.iter
    (fun _ at ->
       match at with
       | [ (f, along); (g, along') ] when f <> g ->
         let differ = Bool.equal along along' in
         beside.(f) <- (g, differ) :: beside.(f);
         beside.(g) <- (f, differ) :: beside.(g)
       | other -> open_edge other)
    (edges_of set);
  let turned = Array.make n None in
  let wrong = ref max_int in
  let piece f =
    let queue = Queue.create () in
    turned.(f) <- Some false;
    Queue.add f queue;
    let members = ref [] and closed = ref true in
    while not (Queue.is_empty queue) do
      let f = Queue.pop queue in
      members := f :: !members;
      closed := !closed && shut.(f);
      let own = Option.equal Bool.equal turned.(f) (Some true) in
      let visit (g, differ) =
        let wanted = not (Bool.equal own differ) in
        match turned.(g) with
        | Some t -> if not (Bool.equal t wanted) then wrong := min !wrong (max f g)
        | None ->
          turned.(g) <- Some wanted;
          Queue.add g queue
      in
      List.iter visit beside.(f)
    done;
    { members = !members; closed = !closed }
  in
  let found = List.filter_map (fun f -> if Option.is_none turned.(f) then Some (piece f) else None) in
  let found = found (List.init n Fun.id) in
  if !wrong < max_int then Error !wrong
  else Ok (Array.map (Option.equal Bool.equal (Some true)) turned, found)

let volume (set : Polyhedron.ifs) turned members =
  let p i = snd set.ifs_vertices.(i) in
  let face sum f =
    let c = snd set.ifs_faces.(f) in
    let part = ref Rat.zero in
    for k = 1 to Array.length c - 2 do
      part := Rat.add !part (Vec.dot (p c.(0)) (Vec.cross (p c.(k)) (p c.(k + 1))))
    done;
    if turned.(f) then Rat.sub sum !part else Rat.add sum !part
  in
  List.fold_left face Rat.zero members

(* The least and greatest coordinates. *)
let box (set : Polyhedron.ifs) members =
  let lift f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let widen acc i =
    let v = snd set.ifs_vertices.(i) in
    match acc with
    | None -> Some (v, v)
    | Some (low, high) -> Some (lift Rat.min low v, lift Rat.max high v)
  in
  List.fold_left (fun acc f -> Array.fold_left widen acc (snd set.ifs_faces.(f))) None members

let strictly_inside inner outer =
  match (inner, outer) with
  | Some ((a : Vec.t), (b : Vec.t)), Some ((c : Vec.t), (d : Vec.t)) ->
    let less x y = Rat.compare x y < 0 in
    less c.x a.x && less c.y a.y && less c.z a.z && less b.x d.x && less b.y d.y && less b.z d.z
  | _ -> false

let max_named = 6

let named (set : Polyhedron.ifs) list =
  let first = List.filteri (fun i _ -> i < max_named) list in
  String.concat ", " (List.map (fun f -> fst set.ifs_faces.(f)) first)
  ^ if List.compare_length_with list max_named > 0 then ", …" else ""

(* Their boxes are compared each with all others. *)
let max_pieces = 1000

let orient (set : Polyhedron.ifs) =
  match pieces set with
  | Ok (_, found) when List.compare_length_with found max_pieces > 0 ->
    Error (Printf.sprintf "it falls apart into more than %d pieces" max_pieces)
  | Error f ->
    Error
      (Printf.sprintf "the surface has only one side: going around it, face %s comes out turned over"
         (fst set.ifs_faces.(f)))
  | Ok (turned, found) ->
    let boxes = lazy (List.map (fun p -> box set p.members) found) in
    let cavities = ref [] in
    let outward p =
      if p.closed && Rat.sign (volume set turned p.members) < 0 then
        let inner =
          match found with
          | [ _ ] -> false
          | _ ->
            let own = box set p.members in
            List.exists (strictly_inside own) (Lazy.force boxes)
        in
        if inner then cavities := List.fold_left min max_int p.members :: !cavities
        else List.iter (fun f -> turned.(f) <- not turned.(f)) p.members
    in
    List.iter outward found;
    let over = List.filter (fun f -> turned.(f)) (List.init (Array.length turned) Fun.id) in
    let turn f (name, c) = (name, if turned.(f) then reversed c else c) in
    let told =
      match over with
      | [] -> "oriented: no face had to be turned over"
      | _ -> Printf.sprintf "oriented: %s turned over: %s" (faces (List.length over)) (named set over)
    in
    let told =
      match List.rev !cavities with
      | [] -> told
      | l -> Printf.sprintf "%s; what may be cavities stays inside out: the pieces of %s" told (named set l)
    in
    Ok ({ set with ifs_faces = Array.mapi turn set.ifs_faces }, told)

(* {1 Merge} *)

let merge (set : Polyhedron.ifs) =
  (* A cloud of points keeps them: there is no face that could use them. *)
  let merged = if Array.length set.ifs_faces = 0 then set else Merge_coplanar.merge set in
  let told =
    Printf.sprintf "merged: %s became %d" (faces (Array.length set.ifs_faces)) (Array.length merged.ifs_faces)
  in
  (merged, told)

let closing_merge set =
  let closed (set : Polyhedron.ifs) = Array.length set.ifs_faces > 0 && not (is_open set) in
  let merged set = fst (merge set) in
  if not (is_open set) then None
  else if closed (merged set) then Some `Alone
  else
    let welded = fst (weld set) in
    if is_open welded && closed (merged welded) then Some `Welded else None
