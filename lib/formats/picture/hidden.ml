open Scc_exact

type t = {
  view : View.t;
  glass : int -> bool;
  boxes : Cells.box array;
  cells : Cells.t;
  nearest : float array;  (** no point of the face is nearer *)
  farthest : float array;
  number : (int * int, int) Hashtbl.t;  (** of a face, by body and face *)
  seen : Convex.t list option array;  (** of faces that have been asked for *)
}

let view t = t.view

let depths (f : View.face) =
  let depth (p : Ivec.t) =
    let x = Rat.near_float (Rat.make (Ivec.dot f.depth p) (Z.mul f.scale p.z)) in
    (Cells.below x, Cells.above x)
  in
  let all = Array.map depth f.polygon in
  ( Array.fold_left (fun m (_, high) -> Float.max m high) neg_infinity all,
    Array.fold_left (fun m (low, _) -> Float.min m low) infinity all )

let make ?(glass = fun _ -> false) (view : View.t) =
  let boxes = Array.map (fun (f : View.face) -> Cells.around f.polygon) view.faces in
  let range = Array.map depths view.faces in
  let number = Hashtbl.create 64 in
  Array.iteri (fun i (f : View.face) -> Hashtbl.replace number (f.body, f.face) i) view.faces;
  {
    view;
    glass;
    boxes;
    cells = Cells.make boxes;
    nearest = Array.map fst range;
    farthest = Array.map snd range;
    number;
    seen = Array.make (Array.length view.faces) None;
  }

let none = function [] -> true | _ :: _ -> false
let is_glass t body = t.glass body
let of_glass t j = t.glass t.view.faces.(j).body

(* Whether face [j] may hide something of face [i]: glass hides only glass. *)
let may_hide t i j = j <> i && t.nearest.(j) >= t.farthest.(i) && (of_glass t i || not (of_glass t j))

(* {1 Faces} *)

(* A piece of a face, with its box. *)
type piece = { polygon : Convex.t; box : Cells.box }

let piece polygon = { polygon; box = Cells.around polygon }

(* What is left of a piece of face [i] where face [j] is not in front of it. In the part that both cover, the
   sign of [line] tells who is in front. *)
let less ~line ~first (g : View.face) box p =
  if not (Cells.meet box p.box) then [ p ]
  else
    match Convex.split p.polygon g.sides with
    | None -> [ p ]
    | Some (both, others) -> (
        let without more = List.map piece (more @ others) in
        if Ivec.is_zero line then if first then without [] else [ p ]
        else
          match Convex.cut both line with
          | None, _ -> [ p ]
          | Some _, None -> without []
          | Some _, Some behind -> without [ behind ])

(* The faces that may be in front of face [i], those first that are likely to hide much. *)
let candidates t i =
  let found = List.filter (may_hide t i) (Cells.near t.cells t.boxes.(i)) in
  let order a b =
    Float.compare t.nearest.(b) t.nearest.(a) <?> fun () -> Int.compare a b
  in
  List.sort order found

let find_pieces t i =
  let f = t.view.faces.(i) in
  let rec from pieces = function
    | [] -> pieces
    | _ when none pieces -> []
    | j :: others ->
      let g = t.view.faces.(j) in
      let line = View.nearer g f in
      from (List.concat_map (less ~line ~first:(j < i) g t.boxes.(j)) pieces) others
  in
  List.map (fun p -> p.polygon) (from [ piece f.polygon ] (candidates t i))

let pieces t i =
  match t.seen.(i) with
  | Some pieces -> pieces
  | None ->
    let pieces = find_pieces t i in
    t.seen.(i) <- Some pieces;
    pieces

let hiders t i =
  let whole = piece t.view.faces.(i).polygon in
  let hides j =
    let g = t.view.faces.(j) in
    match less ~line:(View.nearer g t.view.faces.(i)) ~first:(j < i) g t.boxes.(j) whole with
    | [ rest ] -> rest != whole
    | _ -> true
  in
  List.filter hides (candidates t i)

let all_pieces t = Array.init (Array.length t.view.faces) (pieces t)

(* {1 Edges} *)

(* A part of an edge, as a range of the numbers from 0, at its first end, to 1. *)
type range = Rat.t * Rat.t

let value line (p : Ivec.t) = Rat.make (Ivec.dot line p) p.z

(* Where a linear function that has these values at both ends is positive. *)
let above a b (low, high) : range option =
  match (Rat.sign a, Rat.sign b) with
  | sa, sb when sa <= 0 && sb <= 0 -> None
  | sa, sb when sa >= 0 && sb >= 0 -> Some (low, high)
  | sa, _ ->
    let zero = Rat.div a (Rat.sub a b) in
    let low, high = if sa > 0 then (low, Rat.min high zero) else (Rat.max low zero, high) in
    if Rat.compare low high < 0 then Some (low, high) else None

(* Where a line is positive along an edge, beside it: on its left if [left]. *)
let positive ~along ~left line (p, q) range : range option =
  let a = value line p and b = value line q in
  if Rat.sign a = 0 && Rat.sign b = 0 then
    (* One line is the other one, times a number. *)
    let same = Z.sign (Ivec.dot (Ivec.make line.Ivec.x line.y Z.zero) along) > 0 in
    if Bool.equal same left then Some range else None
  else above a b range

let hidden_by t ~along ~left ends i j : range option =
  let f = t.view.faces.(i) and g = t.view.faces.(j) in
  let inside range line = Option.bind range (positive ~along ~left line ends) in
  match Array.fold_left inside (Some (Rat.zero, Rat.one)) g.sides with
  | None -> None
  | Some _ as range ->
    let line = View.nearer g f in
    if Ivec.is_zero line then if j < i then range else None else inside range line

(* What is left of ranges in order. *)
let without ranges (low, high) =
  let rest (a, b) =
    let keep a b = if Rat.compare a b < 0 then [ (a, b) ] else [] in
    keep a (Rat.min b low) @ keep (Rat.max a high) b
  in
  List.concat_map rest ranges

let beside t (e : View.edge) ~left (f : View.face) : range list =
  let p, q = e.ends in
  let along = Convex.through p q in
  let i = Hashtbl.find t.number (f.body, f.face) in
  let rec from ranges = function
    | [] -> ranges
    | _ when none ranges -> []
    | j :: others ->
      let hidden = if may_hide t i j then hidden_by t ~along ~left e.ends i j else None in
      from (match hidden with None -> ranges | Some r -> without ranges r) others
  in
  from [ (Rat.zero, Rat.one) ] (Cells.near t.cells (Cells.around [| p; q |]))

(* What is in one of two lists of ranges. *)
let join some others =
  let rec merge found = function
    | (a, b) :: (c, d) :: rest when Rat.compare c b <= 0 -> merge found ((a, Rat.max b d) :: rest)
    | range :: rest -> merge (range :: found) rest
    | [] -> List.rev found
  in
  merge [] (List.merge (fun (a, _) (b, _) -> Rat.compare a b) some others)

let along ((p : Ivec.t), (q : Ivec.t)) at =
  (* Of p/w and q/w' the point that is [at] from the first to the second. *)
  let u = Rat.sub Rat.one at in
  let mean a b = Rat.add (Rat.mul u (Rat.make a p.z)) (Rat.mul at (Rat.make b q.z)) in
  let v, w = Ivec.of_vec (Vec.make (mean p.x q.x) (mean p.y q.y) Rat.zero) in
  Convex.point v.x v.y w

let segments t (e : View.edge) =
  let side ~left = function None -> [] | Some f -> beside t e ~left f in
  let ranges = join (side ~left:true e.left) (side ~left:false e.right) in
  List.map (fun (a, b) -> (along e.ends a, along e.ends b)) ranges

let opaque_near t box = List.filter (fun j -> not (of_glass t j)) (Cells.near t.cells box)

let uncovered t (p, near) (q, near') =
  let hides ranges j =
    let g = t.view.faces.(j) in
    let inside range line = Option.bind range (above (value line p) (value line q)) in
    let in_front p depth = Rat.sub (View.depth_at g p) depth in
    let covered = Array.fold_left inside (Some (Rat.zero, Rat.one)) g.sides in
    match Option.bind covered (above (in_front p near) (in_front q near')) with
    | None -> ranges
    | Some r -> without ranges r
  in
  let ranges = List.fold_left hides [ (Rat.zero, Rat.one) ] (opaque_near t (Cells.around [| p; q |])) in
  List.map (fun (a, b) -> (along (p, q) a, along (p, q) b)) ranges

(* {1 Points} *)

let over t p =
  let covers j = Convex.inside t.view.faces.(j).polygon p in
  List.filter covers (opaque_near t (Cells.around [| p |]))

let shows t p ~depth = List.for_all (fun j -> View.before t.view.faces.(j) p depth <= 0) (over t p)

let front t p =
  let nearer i j = Z.sign (Ivec.dot (View.nearer t.view.faces.(j) t.view.faces.(i)) p) > 0 in
  let better best j = match best with Some i when not (nearer i j) -> best | _ -> Some j in
  List.fold_left better None (over t p)
