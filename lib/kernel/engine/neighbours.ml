open Scc_data
open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_broad_phase
open Scc_semantics

(* {1 Boxes} *)

let is_upright (p : Part.t) = Quaternion.is_identity p.placed.turned && not (Part.turns p)

(* A box about a place, with a margin. Sums of floats are rounded to the nearest, so that the next float is on the
   safe side. *)
let grown margin box =
  if Rat.sign margin = 0 then box
  else
    let by = Float_box.up margin in
    let low k = Next_float.pred (Float_box.low box k -. by) in
    let high k = Next_float.succ (Float_box.high box k +. by) in
    Float_box.make ~low:(Array.init 3 low) ~high:(Array.init 3 high)

(* A box about a place that goes in a straight line: of the part itself, or of the ball that it turns in. *)
let framed ~margin (p : Part.t) =
  if is_upright p then (grown margin p.placed.solid.box, p.placed.at)
  else
    let r = Rat.add margin (Part.reach p) in
    let corner = Vec.make r r r in
    (Float_box.of_corners (Vec.neg corner) corner, p.centre)

let box ~margin p =
  let shape, at = framed ~margin p in
  Float_box.at at shape

(* {1 A memory of boxes} *)

(* The box about a part that does not turn, where it was when it was last asked for. *)
type seen = { solid : Solid.t; at : Vec.t; margin : Rat.t; box : Float_box.t }

(* That about a part that has turned, which takes long to find. *)
type turned = { placed : Placed.t; centre : Vec.t; turns : bool; margin : Rat.t; box : Float_box.t }

(* By the places of parts in the arrays that are asked about: many are where they were, as walls are always, and
   all of them when nothing but velocities has changed. Of what has turned there are some of
   each part: where it is in a state, and in those that this leads to. *)
type memory = {
  mutable seen : seen option array;
  turned : (int * int, turned Last_few.t) Hashtbl.t;
  mutable boxes : Float_box.t array;  (** those of the last call of [within] *)
  mutable pairs : (int * int) list;  (** which of them meet *)
}

let is_of margin (p : Part.t) (t : turned) =
  t.placed == p.placed && t.centre == p.centre && t.turns = Part.turns p && Rat.equal t.margin margin

let most_turned = 4

let turned_of memory name =
  match Hashtbl.find_opt memory.turned name with
  | Some known -> known
  | None ->
    let known = Last_few.create ~most:most_turned in
    Hashtbl.add memory.turned name known;
    known

let recall_turned memory margin (p : Part.t) =
  let known = turned_of memory (Part.name p) in
  match Last_few.find known (is_of margin p) with
  | Some t -> t.box
  | None ->
    let box = box ~margin p in
    Last_few.keep known { placed = p.placed; centre = p.centre; turns = Part.turns p; margin; box };
    box

let recall memory margin i (p : Part.t) =
  if not (is_upright p) then recall_turned memory margin p
  else
    match memory.seen.(i) with
    | Some s when s.solid == p.placed.solid && Vec.equal s.at p.placed.at && Rat.equal s.margin margin -> s.box
    | Some _ | None ->
      let box = box ~margin p in
      memory.seen.(i) <- Some { solid = p.placed.solid; at = p.placed.at; margin; box };
      box

let boxes_of memory margin parts =
  let missing = Array.length parts - Array.length memory.seen in
  if missing > 0 then memory.seen <- Array.append memory.seen (Array.make missing None);
  Long_array.init (Array.length parts) (fun i -> recall memory margin i parts.(i))

(* {1 Pairs} *)

(* With few boxes every pair is looked at: to sort them would cost more than it saves. *)
let few = 12

let meeting boxes =
  let n = Array.length boxes in
  if n > few then Boxes.pairs boxes
  else
    let rec from i j found =
      if i < 0 then found
      else if j = i then from (i - 1) (n - 1) found
      else from i (j - 1) (if Float_box.meet boxes.(i) boxes.(j) then (i, j) :: found else found)
    in
    from (n - 2) (n - 1) []

let same_boxes a b = Array.length a = Array.length b && Array.for_all2 ( == ) a b
let of_two_processes (parts : Part.t array) (i, j) = parts.(i).process <> parts.(j).process

let of_processes (parts : Part.t array) pairs =
  List.filter (of_two_processes parts) pairs |> List.map (fun (i, j) -> (parts.(i), parts.(j)))

let within memory margin (parts : Part.t array) =
  let boxes = boxes_of memory margin parts in
  if not (same_boxes boxes memory.boxes) then begin
    memory.boxes <- boxes;
    memory.pairs <- meeting boxes
  end;
  of_processes parts memory.pairs

(* {1 Sweeps} *)

(* All pairs, but for those whose boxes do not meet before the time that is known by then. *)
let fold_pairs earlier boxes (parts : Part.t array) =
  let n = Array.length parts in
  let lines = Moving_boxes.create n in
  Array.iteri (fun i box -> Moving_boxes.set lines i box ~at:Vec.zero ~velocity:(Part.velocity parts.(i))) boxes;
  let may_be_earlier best i j =
    let bound = Moving_boxes.not_before lines i lines j in
    bound < infinity && match best with None -> true | Some t -> bound <= Float_box.up t
  in
  let rec from i j acc =
    if i >= n - 1 then acc
    else if j = n then from (i + 1) (i + 2) acc
    else from i (j + 1) (if may_be_earlier acc i j then earlier acc (i, j) else acc)
  in
  from 0 1 None

(* The pairs whose boxes, swept over [0, span] for a span > 0, meet. *)
let meeting_within boxes (parts : Part.t array) span =
  let until = Next_float.succ (Float_box.up span) in
  let sweep i = Float_box.swept (Part.velocity parts.(i)) ~until boxes.(i) in
  meeting (Long_array.init (Array.length parts) sweep)

let along memory span parts = of_processes parts (meeting_within (boxes_of memory Rat.zero parts) parts span)

(* Sizes and speeds only say how far to look, which floats are good enough for. *)

let greatest_speed (parts : Part.t array) =
  let component best v = Float.max best (Float.abs (Rat.to_float v)) in
  let of_part best (p : Part.t) =
    let v = Part.velocity p in
    component (component (component best v.x) v.y) v.z
  in
  Array.fold_left of_part 0. parts

let least_size (parts : Part.t array) =
  let size (p : Part.t) =
    let box = p.placed.solid.box in
    let along axis = Float_box.high box axis -. Float_box.low box axis in
    Float.min (along 0) (Float.min (along 1) (along 2))
  in
  Array.fold_left (fun best p -> Float.min best (size p)) infinity parts

let cut limit span = match limit with None -> span | Some l -> Rat.min l span

(* A power of two about as great as a float: a short number, which keeps the ends of the sweeps short. Of a float
   that is zero or infinite, any will do. *)
let power_of_two x =
  let _, exponent = Float.frexp x in
  Rat.power_of_two (Int.max (-1000) (Int.min 1000 exponent))

(* How far ahead to look first: so far that the fastest part sweeps about the least size of a part, or to the limit
   if that is sooner; [None]: at everything. Exact answers about what has turned cost so much that boxes always
   pay, and so they do where few are looked at for a short time. *)
let first_window (parts : Part.t array) ~limit =
  if not (Array.for_all is_upright parts) then limit
  else if Array.length parts <= few then limit
  else if Array.for_all (fun (p : Part.t) -> Vec.is_zero (Part.velocity p)) parts then None
  else Some (cut limit (power_of_two (least_size parts /. greatest_speed parts)))

(* Sweeps of bodies that fly apart never meet, however wide the window: without a limit the rounds must end. *)
let most_rounds = 10

(* The next window after one in which nothing was found: four times as long; [None] when the sweeps of the last one
   met so often that boxes no longer help, or after many rounds without a limit, as perhaps nothing ever meets. *)
let wider parts ~limit ~met ~round span =
  let n = Array.length parts in
  if met > n * n / 8 || (Option.is_none limit && round >= most_rounds) then None
  else Some (cut limit (Rat.mul (Rat.of_int 4) span))

let earliest memory ~margin ~limit time (parts : Part.t array) =
  let boxes = lazy (boxes_of memory margin parts) in
  let earlier best (i, j) =
    if not (Part.in_relative_motion parts.(i) parts.(j)) then best
    else
      Option.merge Rat.min best (time ~before:best parts.(i) parts.(j))
  in
  let within_limit t = match limit with None -> true | Some l -> Rat.compare t l <= 0 in
  (* Pairs whose swept boxes do not meet within the window have no time in it: what is found in the window is the
     least of all. *)
  let rec look round window =
    match window with
    | None -> fold_pairs earlier (Lazy.force boxes) parts
    | Some span -> (
        let near = meeting_within (Lazy.force boxes) parts span in
        match List.fold_left earlier None near with
        | Some t when Rat.compare t span <= 0 -> Some t
        | Some _ | None when Option.equal Rat.equal limit window -> None
        | Some _ | None -> look (round + 1) (wider parts ~limit ~met:(List.length near) ~round span))
  in
  let found =
    if Part.move_alike parts then None
    (* To look at boxes first takes as long as to cast one that does not turn. *)
    else if Array.length parts = 2 && Array.for_all is_upright parts then earlier None (0, 1)
    else look 1 (first_window parts ~limit)
  in
  match found with Some t when within_limit t -> Some t | Some _ | None -> None

let boxes () =
  let memory = { seen = [||]; turned = Hashtbl.create 16; boxes = [||]; pairs = [] } in
  { Kinematics.within = within memory; along = along memory; earliest = earliest memory }
