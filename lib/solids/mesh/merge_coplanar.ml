open Scc_data
open Scc_exact
open Scc_geometry

let next corners i = if i + 1 = Array.length corners then corners.(0) else corners.(i + 1)

(* The face along each directed edge; None when several run along it. *)
let directed faces =
  let table = Int_pairs.create (4 * Array.length faces) in
  let add f corners =
    Array.iteri
      (fun i v ->
         let e = (v, next corners i) in
         Int_pairs.replace table e (if Int_pairs.mem table e then None else Some f))
      corners
  in
  Array.iteri add faces;
  table

let across table v w = Option.join (Int_pairs.find_opt table (w, v))

(* {1 Groups of coplanar neighbours} *)

let same_plane points normals faces f g =
  let n = normals.(f) in
  Z.sign (Ivec.dot n normals.(g)) > 0
  && Ivec.is_zero (Ivec.cross n normals.(g))
  &&
  let base = points.(faces.(f).(0)) in
  Array.for_all (fun v -> Z.sign (Ivec.dot n (Ivec.sub points.(v) base)) = 0) faces.(g)

let groups points faces table =
  let normals =
    Array.map
      (fun c -> if Array.length c < 3 then Ivec.zero else Face_check.normal points c)
      faces
  in
  let joined = Union_find.create (Array.length faces) in
  let join f corners =
    Array.iteri
      (fun i v ->
         match across table v (next corners i) with
         | Some g when g > f && same_plane points normals faces f g ->
           ignore (Union_find.union joined f g)
         | Some _ | None -> ())
      corners
  in
  Array.iteri join faces;
  Array.init (Array.length faces) (Union_find.find joined)

(* {1 Outlines} *)

(* The one simple closed line that bounds the faces of a group, if that is what bounds them. *)
let outline faces table group members =
  let r = List.hd members in
  let after = Hashtbl.create 16 in
  let inner v w =
    match across table v w with
    | Some g -> group.(g) = r
    | None -> false
  in
  let simple = ref true in
  let side v w =
    if not (inner v w) then
      if Hashtbl.mem after v then simple := false else Hashtbl.add after v w
  in
  List.iter (fun f -> Array.iteri (fun i v -> side v (next faces.(f) i)) faces.(f)) members;
  let total = Hashtbl.length after in
  let start =
    List.find_map (fun f -> List.find_opt (Hashtbl.mem after) (Array.to_list faces.(f))) members
  in
  match start with
  | Some start when !simple ->
    let rec follow line k v =
      if k > total then None
      else
        match Hashtbl.find_opt after v with
        | None -> None
        | Some w when w = start -> if k = total then Some (Array.of_list (List.rev (v :: line))) else None
        | Some w -> follow (v :: line) (k + 1) w
    in
    follow [] 1 start
  | Some _ | None -> None

(* Groups in the order of their first faces: (first face, corners). *)
let outlines faces table group =
  let members = Array.make (Array.length faces) [] in
  for f = Array.length faces - 1 downto 0 do
    members.(group.(f)) <- f :: members.(group.(f))
  done;
  let one acc = function
    | [] -> acc
    | [ f ] -> (f, faces.(f)) :: acc
    | f :: _ as several -> (
        match outline faces table group several with
        | Some corners -> (f, corners) :: acc
        | None -> List.fold_left (fun acc f -> (f, faces.(f)) :: acc) acc several)
  in
  List.rev (Array.fold_left one [] members)

(* {1 Straight corners} *)

let goes_straight points corners i =
  let n = Array.length corners in
  let before = points.(corners.((i + n - 1) mod n)) and here = points.(corners.(i)) in
  let one = Ivec.sub here before and two = Ivec.sub points.(next corners i) here in
  Ivec.is_zero (Ivec.cross one two) && Z.sign (Ivec.dot one two) > 0

let without_straight_corners points lines =
  let keep = Array.make (Array.length points) false in
  let note (_, corners) =
    Array.iteri (fun i v -> if not (goes_straight points corners i) then keep.(v) <- true) corners
  in
  List.iter note lines;
  List.rev_map
    (fun (f, corners) -> (f, Array.of_list (List.filter (fun v -> keep.(v)) (Array.to_list corners))))
    (List.rev lines)

(* {1 All together} *)

let compact (ifs : Polyhedron.ifs) lines =
  let number = Array.make (Array.length ifs.ifs_vertices) (-1) in
  List.iter (fun (_, corners) -> Array.iter (fun v -> number.(v) <- 0) corners) lines;
  let count = ref 0 in
  Array.iteri
    (fun v used ->
       if used = 0 then begin
         number.(v) <- !count;
         incr count
       end)
    number;
  let kept = List.filter (fun v -> number.(v) >= 0) (List.init (Array.length number) Fun.id) in
  {
    Polyhedron.ifs_vertices = Array.map (fun v -> ifs.ifs_vertices.(v)) (Array.of_list kept);
    ifs_faces =
      Array.map
        (fun (f, corners) -> (fst ifs.ifs_faces.(f), Array.map (fun v -> number.(v)) corners))
        (Array.of_list lines);
  }

(* A corner of a convex solid is on three faces or more. *)
let real_corners lines vertices =
  let degree = Array.make vertices 0 in
  List.iter (fun (_, corners) -> Array.iter (fun v -> degree.(v) <- degree.(v) + 1) corners) lines;
  let keep v = degree.(v) >= 3 in
  List.map (fun (f, corners) -> (f, Array.of_list (List.filter keep (Array.to_list corners)))) lines

let unite (ifs : Polyhedron.ifs) group =
  let faces = Array.map snd ifs.ifs_faces in
  let lines = outlines faces (directed faces) group in
  compact ifs (real_corners lines (Array.length ifs.ifs_vertices))

let merge (ifs : Polyhedron.ifs) =
  let points, _ = Ivec.of_vecs (Array.map snd ifs.ifs_vertices) in
  let faces = Array.map snd ifs.ifs_faces in
  let table = directed faces in
  let group = groups points faces table in
  (* What was on a line has two corners left, and so each of its neighbours has the edge between them. *)
  let proper (_, corners) = Array.length corners >= 3 in
  compact ifs (List.filter proper (without_straight_corners points (outlines faces table group)))
