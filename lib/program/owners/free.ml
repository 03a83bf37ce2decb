open Scc_codec
open Progress

type t = {
  part : Part.t;
  mesh : Mesh.t;
  expansion : Expansion.t;
  searches : bool;
  quota : int;  (** states of this owner *)
  show : Progress.t -> unit;
  termination : Termination.t;
  met : int option array;  (** by goal: a state of this owner that meets it *)
  doubts : bool array;
  met_by : bool array;  (** by goal, at the first owner: some owner meets it *)
  faults : (string, unit) Hashtbl.t;
  ends : (string, unit) Hashtbl.t;
  others : (int * int) array;  (** at the first owner: states and transitions of each *)
  mutable transitions : int;
  mutable next : int;  (** the state that is expanded next *)
  mutable stop : stop option option;  (** once it is over: why *)
  mutable told_at : float;
}

let make part mesh expansion ~searches ~most_states ~show =
  let goals = Array.length (Scc_successors.Filter.predicates (Part.filter part)) and count = Mesh.count mesh in
  {
    part; mesh; expansion; searches; show;
    quota = Int.max 1 (most_states / count);
    termination = Termination.make ~first:(Mesh.number mesh = 0);
    met = Array.make goals None;
    doubts = Array.make goals false;
    met_by = Array.make goals false;
    faults = Hashtbl.create 4; ends = Hashtbl.create 4;
    others = Array.make count (0, 0);
    transitions = 0; next = 0; stop = None; told_at = 0.;
  }

let is_expanded s id = id < s.next && not (Part.is_too_long s.part id)
let token = 'K'
let goal_met = 'M'
let how_far = 'S'
let over = 'Z'
let is_first s = Mesh.number s.mesh = 0

let written numbers =
  let b = Buffer.create 16 in
  List.iter (Packed.put_nat b) numbers;
  Buffer.contents b

(* {1 The end} *)

let reasons = [| None; Some Early; Some States |]

let end_all s reason =
  if s.stop = None then begin
    s.stop <- Some reasons.(reason);
    List.iter (fun peer -> Mesh.post s.mesh peer over (written [ reason ])) (Mesh.others s.mesh)
  end

(* The first owner knows when all is decided. *)
let note_met s goal =
  s.met_by.(goal) <- true;
  if s.searches && Array.for_all Fun.id s.met_by then end_all s 1

let meet s goal id =
  if Option.is_none s.met.(goal) then begin
    s.met.(goal) <- Some id;
    Part.found s.part goal;
    if is_first s then note_met s goal else Mesh.post s.mesh 0 goal_met (written [ goal ])
  end

let look_at_hits s =
  let each (h : Part.hit) = if h.sure then meet s h.goal h.id else s.doubts.(h.goal) <- true in
  List.iter each (Part.hits s.part)

(* {1 Messages} *)

let signed n = if n >= 0 then 2 * n else (-2 * n) - 1
let unsigned n = if n land 1 = 0 then n / 2 else -((n + 1) / 2)
let next_owner s = (Mesh.number s.mesh + 1) mod Mesh.count s.mesh

let hear_states s = Termination.received s.termination

let heard s peer kind text =
  let source = Packed.source text in
  let goals = Array.length s.met in
  match kind with
  | 'K' ->
    let sum = unsigned (Packed.nat source) in
    let colour : Termination.colour = if Packed.nat source = 0 then White else Black in
    Termination.arrived s.termination { sum; colour };
    true
  | 'M' ->
    note_met s (Packed.below goals ~what:"the goal" source);
    true
  | 'S' ->
    let states = Packed.nat source in
    s.others.(peer) <- (states, Packed.nat source);
    true
  | 'Z' ->
    if s.stop = None then s.stop <- Some reasons.(Packed.below 3 ~what:"the reason" source);
    true
  | _ -> false

let pass s (t : Termination.token) =
  Mesh.post s.mesh (next_owner s) token (written [ signed t.sum; (match t.colour with White -> 0 | Black -> 1) ])

(* {1 The work} *)

let so_far s ~states ~transitions : Progress.t =
  {
    level = 0; depth = 0; width = 0; states; transitions;
    met = Array.map (fun _ -> None) s.met;
    doubts = s.doubts;
    open_ = None; stop = None; faults = []; ends = []; too_long = 0; too_deep = 0;
  }

let tell s =
  let now = Unix.gettimeofday () in
  if now -. s.told_at > 0.3 then begin
    s.told_at <- now;
    if is_first s then begin
      s.others.(0) <- (Part.size s.part, s.transitions);
      let states, transitions = Array.fold_left (fun (a, b) (c, d) -> (a + c, b + d)) (0, 0) s.others in
      s.show (so_far s ~states ~transitions)
    end
    else Mesh.post s.mesh 0 how_far (written [ Part.size s.part; s.transitions ])
  end

let note s id (note : Expansion.note) =
  match note with
  | Fault text -> Hashtbl.replace s.faults text ()
  | End text -> Hashtbl.replace s.ends text ()
  | Ahead { goal; met; _ } -> if Option.is_some met then meet s goal id else s.doubts.(goal) <- true

let few = 64

let expand_some s =
  let stop = Int.min (Part.size s.part) (s.next + few) in
  while s.next < stop do
    let id = s.next in
    s.next <- id + 1;
    if not (Part.is_too_long s.part id) then
      s.transitions <- s.transitions + Expansion.expand s.expansion id ~before:id ~note:(note s id)
  done;
  Termination.sent s.termination (Expansion.flush_full s.expansion);
  look_at_hits s

let rec work s =
  if s.stop = None then begin
    tell s;
    if Part.size s.part > s.quota then end_all s 2
    else if s.next < Part.size s.part then begin
      expand_some s;
      Mesh.pump s.mesh 0.
    end
    else rest s;
    look_at_hits s;
    work s
  end

and rest s =
  Termination.sent s.termination (Expansion.flush s.expansion);
  (* While it was sent, others may have sent something. *)
  if s.next < Part.size s.part then ()
  else if Mesh.count s.mesh = 1 then end_all s 0
  else begin
    (match Termination.idle s.termination with
     | Wait -> ()
     | Pass t -> pass s t
     | Over -> end_all s 0);
    if s.stop = None then Mesh.pump s.mesh 0.3
  end

(* {1 What was found} *)

let summary s =
  let b = Buffer.create 64 in
  let too_long = ref 0 in
  for id = 0 to Part.size s.part - 1 do if Part.is_too_long s.part id then incr too_long done;
  List.iter (Packed.put_nat b) [ Part.size s.part; s.transitions; !too_long ];
  Array.iter (put_option b Packed.put_nat) s.met;
  Array.iter (put_bool b) s.doubts;
  put_texts b (Hashtbl.fold (fun text () all -> text :: all) s.faults []);
  put_texts b (Hashtbl.fold (fun text () all -> text :: all) s.ends []);
  Buffer.contents b

let add s owner (p : Progress.t) text =
  let source = Packed.source text in
  let states = p.states + Packed.nat source in
  let transitions = p.transitions + Packed.nat source in
  let too_long = p.too_long + Packed.nat source in
  let place known =
    let id = read_option source Packed.nat in
    match known with Some _ -> known | None -> Option.map (fun id -> { level = 0; owner; id }) id
  in
  let met = Array.map place p.met in
  let doubts = Array.map (fun known -> read_bool source || known) p.doubts in
  let faults = Progress.add p.faults (Packed.list source Packed.text) in
  let ends = Progress.add p.ends (Packed.list source Packed.text) in
  { p with states; transitions; too_long; met; doubts; faults; ends; stop = Option.join s.stop }

let result s =
  let mine = summary s in
  let texts = Mesh.gather s.mesh (fun _ -> mine) in
  let start = { (so_far s ~states:0 ~transitions:0) with doubts = Array.map (fun _ -> false) s.doubts } in
  let each (owner, p) text =
    match add s owner p text with
    | p -> (owner + 1, p)
    | exception (Packed.Malformed what | Invalid_argument what) -> Failure.refused "owner %d: %s" (owner + 1) what
  in
  snd (Array.fold_left each (0, start) texts)

let run s ~home =
  if home = Mesh.number s.mesh then Part.enter_initial s.part ~home;
  Part.keep_first s.part;
  if s.searches && Array.length s.met = 0 then s.stop <- Some (Some Early);
  look_at_hits s;
  work s;
  result s
