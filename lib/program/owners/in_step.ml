open Scc_codec
open Progress

type settings = {
  searches : bool;  (** all that is asked are searches: it ends once every goal is met *)
  most_states : int;
  most_at_once : int option;
  every : float option;  (** so many seconds between two levels that are kept *)
}

type calls = {
  keep : Progress.t -> unit;
  may_keep : unit -> bool;
  show : Progress.t -> unit;
  settled : Cycles.graph -> bool;
}

type t = {
  part : Part.t;
  mesh : Mesh.t;
  expansion : Expansion.t;
  levels : Levels.t;
  settings : settings;
  calls : calls;
  mutable kept_at : float;
  mutable expanded : int;  (** the number of the last state that is expanded *)
}

let make part mesh expansion levels settings calls =
  { part; mesh; expansion; levels; settings; calls; kept_at = Unix.gettimeofday (); expanded = -1 }

let me s = Mesh.number s.mesh

(* Numbers of states in the order in which they are found: ranks are below 2^30. *)
let shift = 31
let number ~level rank = (level lsl shift) lor rank

(* {1 Expanding a level} *)

type expanded = {
  order : int array;
  counts : int array;  (** of transitions, in this order *)
  ahead : event option array;
  doubtful : event option array;
  faults : (string, int) Hashtbl.t;
  ends : (string, unit) Hashtbl.t;
}

(* So many states are expanded before others are listened to. *)
let few = 64

let note x owner id rank (note : Expansion.note) =
  let at events goal =
    events.(goal) <- earlier events.(goal) (Some { rank; ahead = true; choice = 0; owner; id })
  in
  match note with
  | Fault text -> if not (Hashtbl.mem x.faults text) then Hashtbl.add x.faults text rank
  | End text -> Hashtbl.replace x.ends text ()
  | Ahead { goal; met; _ } -> at (if Option.is_some met then x.ahead else x.doubtful) goal

let is_too_deep s id =
  match s.settings.most_at_once with Some most -> Part.instant s.part id > most | None -> false

let expand s (p : Progress.t) =
  let order = Levels.by_rank s.levels p.level in
  Expansion.next_round s.expansion;
  let nothing () = Array.map (fun _ -> None) p.met in
  let x =
    {
      order; counts = Array.make (Array.length order) 0; ahead = nothing (); doubtful = nothing ();
      faults = Hashtbl.create 4; ends = Hashtbl.create 4;
    }
  in
  let one k id =
    if k land (few - 1) = few - 1 then begin
      ignore (Expansion.flush_full s.expansion);
      Mesh.pump s.mesh 0.
    end;
    if not (Part.is_too_long s.part id || is_too_deep s id) then begin
      let rank = Levels.rank s.levels id in
      x.counts.(k) <- Expansion.expand s.expansion id ~before:rank ~note:(note x (me s) id rank)
    end
  in
  Array.iteri one order;
  ignore (Expansion.flush s.expansion);
  ignore (Mesh.gather s.mesh (fun _ -> ""));
  Part.close s.part;
  x

(* {1 What was found} *)

(* The new states in the order of their keys. *)
let in_order s ~from =
  let size = Part.size s.part - from in
  let key id =
    let way = Part.way s.part id in
    (way.before lsl 31) lor way.choice
  in
  let keys = Array.init size (fun k -> key (from + k)) in
  let rec is_sorted k = k >= size || (keys.(k - 1) < keys.(k) && is_sorted (k + 1)) in
  let places = Array.init size Fun.id in
  if not (is_sorted 1) then Array.stable_sort (fun a b -> Int.compare keys.(a) keys.(b)) places;
  Array.map (fun k -> from + k) places

let events s hits goals =
  let met = Array.make goals None and doubts = Array.make goals None in
  let add (h : Part.hit) =
    let way = Part.way s.part h.id in
    let event = Some { rank = way.before; ahead = false; choice = way.choice; owner = me s; id = h.id } in
    let into = if h.sure then met else doubts in
    into.(h.goal) <- earlier into.(h.goal) event
  in
  List.iter add hits;
  (met, doubts)

let is_due s =
  match s.settings.every with
  | Some every -> me s = 0 && s.calls.may_keep () && Unix.gettimeofday () -. s.kept_at >= every
  | None -> false

let summary s (p : Progress.t) x fresh : Summary.t =
  let met, doubts = events s (Part.hits s.part) (Array.length p.met) in
  let is_new text = not (List.mem text p.faults) in
  let count test = Array.fold_left (fun n id -> if test id then n + 1 else n) 0 fresh in
  {
    fresh = Array.length fresh;
    transitions = Array.fold_left ( + ) 0 x.counts;
    too_long = count (Part.is_too_long s.part);
    too_deep = count (is_too_deep s);
    keep = is_due s;
    met = Array.map2 earlier met x.ahead;
    doubts = Array.map2 earlier doubts x.doubtful;
    faults = Hashtbl.fold (fun text rank all -> if is_new text then (text, rank) :: all else all) x.faults [];
    ends = Hashtbl.fold (fun text () all -> if List.mem text p.ends then all else text :: all) x.ends [];
  }

(* The summaries of all, and the ranks of the new states of this one, in order. *)
let agree s (p : Progress.t) summary fresh =
  let keys k =
    let way = Part.way s.part fresh.(k) in
    (way.before, way.choice)
  in
  let read source =
    let summary = Summary.read source in
    if Array.length summary.met <> Array.length p.met then raise (Packed.Malformed "it has other goals");
    summary
  in
  let told, ranks =
    Ranking.agree s.mesh ~width:p.width ~length:(Array.length fresh) ~keys ~mine:summary ~put:Summary.put ~read
  in
  (Summary.merge told, ranks)

(* {1 Where it ends} *)

(* The last rank that may be expanded where states are bounded: the one after it has too many that are new. *)
let last_rank s (p : Progress.t) (all : Summary.t) fresh ranks =
  let room = s.settings.most_states - p.states in
  if all.fresh <= room then None
  else
    let mine = ref 0 in
    Array.iteri (fun k rank -> if rank = room then mine := (Part.way s.part fresh.(k)).before + 1) ranks;
    match Mesh.sums s.mesh [ !mine ] with
    | [ next ] -> Some (next - 2)
    | _ -> None

(* Exact numbers of transitions and of new states up to a rank. *)
let up_to s x fresh last =
  let transitions = ref 0 in
  let count k id = if Levels.rank s.levels id <= last then transitions := !transitions + x.counts.(k) in
  Array.iteri count x.order;
  let is_before n id = if (Part.way s.part id).before <= last then n + 1 else n in
  match Mesh.sums s.mesh [ !transitions; Array.fold_left is_before 0 fresh ] with
  | [ transitions; fresh ] -> (transitions, fresh)
  | _ -> (0, 0)

let decided s met = s.settings.searches && Array.for_all Option.is_some met

(* The events by which goals are met now. *)
let firsts (p : Progress.t) (all : Summary.t) counts =
  let first goal event =
    match (p.met.(goal), (event : event option)) with
    | None, Some e when counts e.rank -> Some e
    | _ -> None
  in
  Array.mapi first all.met

let place (p : Progress.t) goal (e : event option) =
  match e with
  | Some e -> Some { level = (p.level + if e.ahead then 0 else 1); owner = e.owner; id = e.id }
  | None -> p.met.(goal)

let doubts (p : Progress.t) (all : Summary.t) counts =
  let is_doubtful goal (e : event option) =
    let now = match e with Some e -> counts e.rank | None -> false in
    p.doubts.(goal) || (now && Option.is_none p.met.(goal))
  in
  Array.mapi is_doubtful all.doubts

let after s (p : Progress.t) x (all : Summary.t) fresh ranks =
  let bound = last_rank s p all fresh ranks in
  let within last (rank : int) = match last with Some last -> rank <= last | None -> true in
  let firsts = firsts p all (within bound) in
  let met = Array.mapi (place p) firsts in
  let ends_here = decided s met in
  let latest n (e : event option) = match e with Some e -> Int.max n e.rank | None -> n in
  let last = if ends_here then Some (Array.fold_left latest 0 firsts) else bound in
  let transitions, new_states =
    match last with Some last -> up_to s x fresh last | None -> (all.transitions, all.fresh)
  in
  s.expanded <- number ~level:p.level (match last with Some last -> Int.max 0 last | None -> (1 lsl shift) - 1);
  let goes_on = new_states > 0 || Option.fold ~none:false ~some:(fun last -> last < p.width - 1) last in
  let stop =
    if ends_here then if goes_on then Some Early else None
    else if Option.is_some bound then Some States
    else None
  in
  let faults = List.filter (fun (_, rank) -> within last rank) all.faults in
  ( {
    level = p.level + 1;
    depth = (if new_states > 0 then p.level + 1 else p.depth);
    width = all.fresh;
    states = p.states + new_states;
    transitions = p.transitions + transitions;
    met; stop; open_ = None;
    doubts = doubts p all (within bound);
    faults = add p.faults (List.map fst faults);
    ends = add p.ends all.ends;
    too_long = p.too_long + all.too_long;
    too_deep = p.too_deep + all.too_deep;
  },
    new_states )

(* {1 Levels} *)

let commit s fresh ranks =
  let from = Levels.start s.levels (Levels.count s.levels) in
  let by_number = Array.make (Array.length fresh) 0 in
  Array.iteri (fun k id -> by_number.(id - from) <- ranks.(k)) fresh;
  Levels.add s.levels by_number

let next s p =
  (* Others may have begun with the level already, and sent what they found. *)
  let from = Levels.start s.levels (Levels.count s.levels) in
  let x = expand s p in
  let fresh = in_order s ~from in
  let all, ranks = agree s p (summary s p x fresh) fresh in
  let after, new_states = after s p x all fresh ranks in
  Array.iteri (fun goal place -> if Option.is_some place then Part.found s.part goal) after.met;
  commit s fresh ranks;
  if all.keep && after.stop = None && new_states > 0 then begin
    s.kept_at <- Unix.gettimeofday ();
    s.calls.keep after
  end;
  s.calls.show after;
  (after, new_states > 0)

let graph s : Cycles.graph =
  let number id = number ~level:(Levels.level s.levels id) (Levels.rank s.levels id) in
  {
    number;
    find = (fun n -> Levels.find s.levels (n lsr shift) (n land ((1 lsl shift) - 1)));
    level = (fun n -> n lsr shift);
    is_expanded =
      (fun id -> number id <= s.expanded && not (Part.is_too_long s.part id || is_too_deep s id));
  }

let is_settled s before p =
  (not s.settings.searches) && Progress.is_time_to_look ~before p && s.calls.settled (graph s)

let rec run s (p : Progress.t) =
  if p.stop <> None then p
  else
    let before = p in
    let p, goes_on = next s p in
    if goes_on then run s (if is_settled s before p then { p with stop = Some Early } else p)
    else if p.too_deep > 0 && p.stop = None then { p with stop = Some Levels }
    else p

(* {1 The beginning} *)

let begin_ s ~home =
  let filter = Part.filter s.part in
  let initial = Scc_successors.Filter.initial filter in
  if home = me s then begin
    Part.enter_initial s.part ~home;
    ignore (Part.hits s.part)
  end;
  Part.close s.part;
  Levels.add s.levels (Array.make (Part.size s.part) 0);
  let is_true (t : Scc_ctl.Truth.t) = match t with True -> true | Undecided _ | False -> false in
  let is_open (t : Scc_ctl.Truth.t) = match t with Undecided _ -> true | True | False -> false in
  let here = { level = 0; owner = home; id = 0 } in
  let met = Array.map (fun g -> if is_true g then Some here else None) initial.goals in
  let p =
    {
      level = 0; depth = 0; width = 1; states = 1; transitions = 0; met;
      doubts = Array.map is_open initial.goals;
      open_ = None; stop = None; faults = []; ends = []; too_long = Bool.to_int initial.too_long; too_deep = 0;
    }
  in
  { p with stop = (if decided s met then Some Early else None) }
