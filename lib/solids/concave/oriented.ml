open Scc_base
open Scc_exact
open Scc_geometry
open Scc_mesh

type t = { set : Polyhedron.ifs; turned : int list; hollows : int list }

let place (set : Polyhedron.ifs) v = snd set.ifs_vertices.(v)

let reversed corners =
  let n = Array.length corners in
  Array.init n (fun i -> corners.(n - 1 - i))

(* {1 Pieces} *)

(* All look outward, whatever they were. *)
type piece = { first : int; faces : int list; inward : bool; volume : Rat.t; low : Vec.t; high : Vec.t }

let piece (set : Polyhedron.ifs) faces =
  let own = Array.of_list (List.map (fun f -> set.ifs_faces.(f)) faces) in
  let volume = Drawn.volume { set with ifs_faces = own } in
  let each f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let start = place set (snd own.(0)).(0) in
  let over f =
    let widen m v = each f m (place set v) in
    Array.fold_left (fun m (_, c) -> Array.fold_left widen m c) start own
  in
  let inward = Rat.sign volume < 0 in
  { first = List.hd faces; faces; inward; volume = Rat.abs volume; low = over Rat.min; high = over Rat.max }

let all_axes test (a : Vec.t) (b : Vec.t) = test a.x b.x && test a.y b.y && test a.z b.z
let at_most a b = Rat.compare a b <= 0
let less a b = Rat.compare a b < 0
let boxed p q = less p.volume q.volume && all_axes at_most q.low p.low && all_axes at_most p.high q.high
let strictly_boxed p q = all_axes less q.low p.low && all_axes less p.high q.high
let boxes_overlap p q = all_axes less p.low q.high && all_axes less q.low p.high

(* {1 What is within what} *)

(* The distinct counts of the pieces, over all places. *)
let places pieces (set : Polyhedron.ifs) =
  let of_piece k p =
    let face f = match set.ifs_faces.(f) with name, c -> (name, if p.inward then reversed c else c) in
    let own = { set with ifs_faces = Array.of_list (List.map face p.faces) } in
    let own = match Bent.triangulated own with Some (own, _) -> own | None -> own in
    List.map (fun face -> (k, face)) (Array.to_list own.ifs_faces)
  in
  let faces = List.concat (List.mapi of_piece (Array.to_list pieces)) in
  let*? sheets = United.sheets { set with ifs_faces = Array.of_list (List.map snd faces) } in
  let of_face = Array.of_list (List.map fst faces) in
  let of_sheet = Array.map (fun (s : Sheets.t) -> of_face.(s.face)) sheets in
  let space = Surrounded.make ~tick:ignore sheets and found = Hashtbl.create 64 in
  let look k polygon =
    match Surrounded.sides space k polygon with
    | None -> ()
    | Some { behind; front } ->
      let enter count = Hashtbl.replace found (Surrounded.of_pieces of_sheet count) () in
      enter behind;
      enter front
  in
  let of_sheet k (s : Sheets.t) =
    let met = Surrounded.met space k in
    if met.touched then
      Array.iter (fun (p : Sheets.piece) -> if p.leaf then look k p.polygon) (Sheets.pieces ~tick:ignore s met)
    else if Surrounded.patch space k = k then look k s.corners
  in
  Array.iteri of_sheet sheets;
  Some (Hashtbl.fold (fun count () all -> count :: all) found [])

let has count k = List.exists (fun (l, n) -> Int.equal l k && n > 0) count

(* True for hollows. *)
let hollows (set : Polyhedron.ifs) pieces =
  let n = Array.length pieces in
  let others k = List.filter (fun l -> l <> k) (List.init n Fun.id) in
  let asked k p =
    List.exists (fun l -> boxed p pieces.(l) || (p.inward && boxes_overlap p pieces.(l))) (others k)
  in
  if not (List.exists (fun k -> asked k pieces.(k)) (List.init n Fun.id)) then Array.make n false
  else
    match places pieces set with
    | None ->
      let hollow k p = p.inward && List.exists (fun l -> strictly_boxed p pieces.(l)) (others k) in
      Array.mapi hollow pieces
    | Some places ->
      let own = Array.make n [] in
      List.iter (fun count -> List.iter (fun (k, m) -> if m > 0 then own.(k) <- count :: own.(k)) count) places;
      let within k l = boxed pieces.(k) pieces.(l) && List.for_all (fun count -> has count l) own.(k) in
      let depth = Array.init n (fun k -> List.length (List.filter (within k) (others k))) in
      let same k l =
        Rat.equal pieces.(k).volume pieces.(l).volume && List.for_all (fun count -> has count l) own.(k)
      in
      let crossing k =
        depth.(k) = 0 && pieces.(k).inward && not (List.exists (same k) (others k))
      in
      let solid = Array.init n (fun k -> depth.(k) land 1 = 0 && not (crossing k)) in
      let decide k =
        let covered count = List.exists (fun (l, m) -> l <> k && m > 0 && solid.(l)) count in
        if crossing k && not (List.for_all covered own.(k)) then solid.(k) <- true
      in
      let greater k l =
        match Rat.compare pieces.(l).volume pieces.(k).volume with 0 -> Int.compare k l | order -> order
      in
      List.iter decide (List.sort greater (List.init n Fun.id));
      Array.map not solid

(* {1 All} *)

let max_pieces = 1000

let make (set : Polyhedron.ifs) =
  let* found = Mend.consistent set in
  if List.compare_length_with found.closed max_pieces > 0 then
    Error (Printf.sprintf "it falls apart into more than %d pieces" max_pieces)
  else begin
    let turned = found.turned in
    let over turned f (name, c) = (name, if turned.(f) then reversed c else c) in
    let agreeing = { set with ifs_faces = Array.mapi (over turned) set.ifs_faces } in
    let solid p = Rat.sign p.volume <> 0 in
    let pieces = Array.of_list (List.filter solid (List.map (piece agreeing) found.closed)) in
    let hollow = hollows agreeing pieces in
    let turn k p =
      if not (Bool.equal hollow.(k) p.inward) then List.iter (fun f -> turned.(f) <- not turned.(f)) p.faces
    in
    Array.iteri turn pieces;
    let firsts = List.mapi (fun k p -> if hollow.(k) then Some p.first else None) (Array.to_list pieces) in
    Ok
      {
        set = { set with ifs_faces = Array.mapi (over turned) set.ifs_faces };
        turned = List.filter (fun f -> turned.(f)) (List.init (Array.length turned) Fun.id);
        hollows = List.filter_map Fun.id firsts;
      }
  end

let pieces set =
  match Mend.consistent set with
  | Error _ -> 0
  | Ok found -> if Mend.all_closed found then List.length found.closed else 0

let max_named = 6

let named (set : Polyhedron.ifs) list =
  let first = List.filteri (fun i _ -> i < max_named) list in
  String.concat ", " (List.map (fun f -> fst set.ifs_faces.(f)) first)
  ^ if List.compare_length_with list max_named > 0 then ", …" else ""

let told t =
  let over =
    match t.turned with
    | [] -> "no face had to be turned over"
    | list ->
      Printf.sprintf "%s turned over: %s" (Plural.count (List.length list) "face" "faces") (named t.set list)
  in
  match t.hollows with
  | [] -> over
  | list -> Printf.sprintf "%s; within other pieces, and so hollows: the pieces of %s" over (named t.set list)
