open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_broad_phase
open Scc_calculus
open Scc_semantics

type flight = {
  first : int;
  mutable velocity : Vec.t;
  parts : int array;
  mutable sweep : int;
  mutable rounds : int;
}

type watch = { contact : Rat.t -> flight -> flight -> unit; sweep_end : Rat.t -> flight -> unit }
type work = { sweeps : int; neighbours : int; casts : int }

(* By the number of the part: those of the first leaf come first. *)
type t = {
  semantics : Semantics.t;
  first_part : int array;  (** by leaf *)
  solid : Solid.t array;
  line : Vec.t array;  (** of the reference point *)
  boxes : Moving_boxes.t;
  owner : flight array;
  tree : Box_tree.t;
  mutable turns : Rat.t;  (** when velocities change next, as far as it has been asked for *)
  mutable near : float;  (** about the same *)
  mutable ends : (int * Rat.t) list;  (** just after that, by grain: the ends of sweeps *)
  mutable sweeps : int;
  mutable neighbours : int;
  mutable casts : int;
}

let nobody = { first = -1; velocity = Vec.zero; parts = [||]; sweep = -1; rounds = 0 }

let create semantics =
  let m = Semantics.model semantics in
  let counts = Array.map (fun (l : Model.leaf) -> Array.length l.parts) m.leaves in
  let total = ref 0 in
  let first_part =
    Array.map
      (fun n ->
         let first = !total in
         total := first + n;
         first)
      counts
  in
  let solids (l : Model.leaf) = Array.map (fun (part : Model.part) -> part.solid) l.parts in
  let solid = Array.concat (List.map solids (Array.to_list m.leaves)) in
  {
    semantics;
    first_part;
    solid;
    line = Array.make !total Vec.zero;
    boxes = Moving_boxes.create !total;
    owner = Array.make !total nobody;
    tree = Box_tree.create ();
    turns = Rat.zero;
    near = 0.;
    ends = [];
    sweeps = 0;
    neighbours = 0;
    casts = 0;
  }

let work (t : t) : work = { sweeps = t.sweeps; neighbours = t.neighbours; casts = t.casts }

(* {1 How far to sweep} *)

(* The first sweep of a process takes it about twice its own size along: the longer a sweep, the less often it is
   renewed, and the more neighbours it has. Slowly, further ones go farther, up to one without end: so that what
   never meets anything again is at rest after some sweeps. Any times would be right; these are multiples of
   powers of two, that is short numbers. *)

let rounds_to_double = 4
let most_rounds = 40
let grains = 6
let fraction = -3
let clamp exponent = Int.max (-1000) (Int.min 1000 exponent)

(* The time in which a process moves by about a quarter of its size, at first: this power of two. *)
let grain t f =
  let size = Array.fold_left (fun s i -> Float.max s (Float_box.extent t.solid.(i).box)) 0. f.parts in
  let speed q = Float.abs (Rat.to_float q) in
  let v = f.velocity in
  let fastest = Float.max (speed v.x) (Float.max (speed v.y) (speed v.z)) in
  let _, exponent = Float.frexp (size /. fastest) in
  clamp exponent - 2 + (f.rounds / rounds_to_double)

(* A multiple of the grain that is later than a time, by so many grains at most. *)
let after grain time grains =
  let grain = Rat.power_of_two grain in
  let ends = Z.add (Rat.floor (Rat.div time grain)) (Z.of_int grains) in
  Rat.mul (Rat.make ends Z.one) grain

(* The velocity is likely to change at the time [turns]. The sweep ends a little later, and so is not renewed at
   that time. *)
let note_turns t time =
  if t.turns != time then begin
    t.turns <- time;
    t.near <- Rat.to_float time;
    t.ends <- []
  end

let after_turns t time grain =
  match List.assoc_opt grain t.ends with
  | Some ends -> ends
  | None ->
    let ends = after (grain + fraction) time 1 in
    t.ends <- (grain, ends) :: t.ends;
    ends

let end_of_sweep t ~now ~from ~turns f =
  if Vec.is_zero f.velocity || f.rounds > most_rounds then None
  else
    let grain = grain t f in
    Option.iter (note_turns t) turns;
    let far = from +. Float.ldexp (float_of_int grains) grain in
    match turns with
    | Some time when t.near < far -> Some (after_turns t time grain)
    | Some _ | None -> Some (after grain now grains)

(* {1 Collisions to come} *)

(* The cast goes along the whole lines, from time 0. As two bodies never interpenetrate, the one time at which the
   lines enter the obstacle, if there is one, is in the past when the bodies have met and parted already (or
   would have, had they moved as now before). *)
let cast t ~now f i g j watch =
  let w = Vec.sub g.velocity f.velocity in
  if not (Vec.is_zero w) then begin
    t.casts <- t.casts + 1;
    let placed i = { Placed.solid = t.solid.(i); turned = Quaternion.identity; at = t.line.(i) } in
    match t.semantics.setting.geometry.first_time_of_contact (placed i) (placed j) w with
    | Never | Inside -> ()
    | At time ->
      let until = Float.min (Moving_boxes.until t.boxes i) (Moving_boxes.until t.boxes j) in
      if Rat.compare time now >= 0 && Rat.to_float time <= until then watch.contact time f g
  end

(* Two parts whose swept boxes meet. *)
let consider t ~now ~from i f j g watch =
  t.neighbours <- t.neighbours + 1;
  if Moving_boxes.may_meet t.boxes i j ~from then
    if f.first < g.first then cast t ~now f i g j watch else if g.first < f.first then cast t ~now g j f i watch

(* If two processes collide at a time during the present sweeps of both, then at that time both are inside of what
   they sweep, and touch: whoever was swept last has found the other in the tree. The result has the box that each
   part sweeps. *)
let begin_sweep t ~now ~turns f watch =
  t.sweeps <- t.sweeps + 1;
  f.sweep <- t.sweeps;
  let from = Float_box.down now in
  let until = end_of_sweep t ~now ~from ~turns f in
  let bound = match until with None -> infinity | Some time -> Float_box.up time in
  Option.iter (fun time -> watch.sweep_end time f) until;
  fun i ->
    Moving_boxes.set_until t.boxes i bound;
    Moving_boxes.swept t.boxes i ~from

(* Those that are in the tree already, each as {!begin_sweep} has it. *)
let sweep_again t ~now ~turns flights watch =
  let from = Float_box.down now in
  let begin_again moves f =
    let swept = begin_sweep t ~now ~turns:(turns f) f watch in
    Array.fold_left (fun moves i -> (i, swept i) :: moves) moves f.parts
  in
  Box_tree.move t.tree (List.fold_left begin_again [] flights);
  Box_tree.iter_moved_pairs t.tree (fun i j -> consider t ~now ~from i t.owner.(i) j t.owner.(j) watch)

let parts_of t (p : State.process) =
  let of_leaf (l : State.leaf) =
    let parts = (Semantics.model t.semantics).leaves.(l.leaf).parts in
    Array.init (Array.length parts) (fun k -> t.first_part.(l.leaf) + k)
  in
  Array.concat (List.map of_leaf (Array.to_list p.leaves))

let place_parts t f (p : State.process) =
  let place_leaf (l : State.leaf) =
    Array.iteri
      (fun k (part : Model.part) ->
         let i = t.first_part.(l.leaf) + k in
         let at = if Vec.is_zero part.offset then l.position else Vec.add l.position part.offset in
         t.line.(i) <- at;
         Moving_boxes.set t.boxes i t.solid.(i).box ~at ~velocity:f.velocity;
         t.owner.(i) <- f)
      (Semantics.model t.semantics).leaves.(l.leaf).parts
  in
  Array.iter place_leaf p.leaves

let launch t ~now ~turns (line : State.process) watch =
  let f =
    {
      nobody with
      first = line.leaves.(0).leaf;
      velocity = line.velocity;
      parts = parts_of t line;
    }
  in
  place_parts t f line;
  let swept = begin_sweep t ~now ~turns f watch in
  let boxes = Array.map (fun i -> (i, swept i)) f.parts and from = Float_box.down now in
  Array.iter (fun (i, box) -> Box_tree.insert t.tree i box) boxes;
  let look (i, box) =
    Box_tree.iter_meeting t.tree box (fun j -> consider t ~now ~from i f j t.owner.(j) watch)
  in
  Array.iter look boxes;
  f

let renew t ~now ~turns flights watch =
  List.iter (fun f -> f.rounds <- f.rounds + 1) flights;
  sweep_again t ~now ~turns flights watch

let turn t ~now ~turns flights watch =
  let place_again (f, (line : State.process)) =
    f.velocity <- line.velocity;
    f.rounds <- 0;
    place_parts t f line
  in
  List.iter place_again flights;
  sweep_again t ~now ~turns (List.rev_map fst flights) watch

let drop t f =
  Array.iter (Box_tree.remove t.tree) f.parts;
  f.sweep <- -1
