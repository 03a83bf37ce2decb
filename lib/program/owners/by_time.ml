open Scc_exact
open Scc_ctl
open Scc_codec
open Progress
open Asked

type settings = {
  searches : bool;
  within : Rat.t option array;
  horizon : Rat.t option;
  most_states : int;
  most_rounds : int option;
}

type t = {
  part : Part.t;
  clock : Clock.t;
  mesh : Mesh.t;
  expansion : Expansion.t;
  settings : settings;
  show : Progress.t -> unit;
  settled : t -> bool;
  goals : goal array;
  days : Days.t;  (** states to be expanded *)
  mutable turns : int;  (** how many there have been, at all owners *)
  mutable left : int list;  (** states that cannot be expanded *)
  mutable cut : int list;  (** states of the last round that are not expanded any more *)
}

let make part clock mesh expansion (settings : settings) ~show ~settled =
  let goals = Array.map Asked.goal settings.within in
  {
    part; clock; mesh; expansion; settings; show; settled; goals;
    days = Days.make clock;
    turns = 0; left = []; cut = [];
  }

let me s = Mesh.number s.mesh
let turns s = s.turns
let arrival s id = Clock.time s.clock (Clock.arrival s.clock id)

(* Whether anything is asked of states that are reached at a time. *)
let asked s time = (not s.settings.searches) || Array.exists (asks time) s.goals

(* {1 Expanding} *)

type expanded = {
  order : int array;
  counts : int array;  (** of transitions, in this order *)
  mutable opened : int list;  (** the turns of states whose transitions were computed, the last first *)
  mutable ahead : (int * Round.event) list;  (** with goals *)
  faults : (string, int) Hashtbl.t;
  ends : (string, unit) Hashtbl.t;
}

(* So many states are expanded before others are listened to. *)
let few = 64

let note s x ~now id turn (note : Expansion.note) =
  let moment_of (m : Timeline.moment) = { m with offset = Algebraic.add_rat now m.offset } in
  let in_time goal = On_the_fly.is_in_time s.goals.(goal).within ~arrival:now in
  match note with
  | Fault text -> if not (Hashtbl.mem x.faults text) then Hashtbl.add x.faults text turn
  | End text -> Hashtbl.replace x.ends text ()
  | Ahead { goal; met; doubtful } ->
    (match met with
     | Some m when in_time goal m ->
       x.ahead <- (goal, { moment = moment_of m; turn; place = Touched.place_after; owner = me s; id }) :: x.ahead
     | Some _ | None -> ());
    (match doubtful with
     | Some m when in_time goal m -> s.goals.(goal).doubtful <- true
     | Some _ | None -> ())

let expand s now =
  let order = Days.take s.days now in
  Expansion.next_round s.expansion;
  let x =
    {
      order; counts = Array.make (Array.length order) 0; opened = []; ahead = [];
      faults = Hashtbl.create 4; ends = Hashtbl.create 4;
    }
  in
  let one k id =
    if k land (few - 1) = few - 1 then begin
      ignore (Expansion.flush_full s.expansion);
      Mesh.pump s.mesh 0.
    end;
    let turn = Clock.turn s.clock id and is_fault = ref false in
    let note n =
      (match n with Expansion.Fault _ -> is_fault := true | End _ | Ahead _ -> ());
      note s x ~now id turn n
    in
    x.counts.(k) <- Expansion.expand s.expansion id ~before:turn ~note;
    if !is_fault then s.left <- id :: s.left else x.opened <- turn :: x.opened
  in
  Array.iteri one order;
  ignore (Expansion.flush s.expansion);
  ignore (Mesh.gather s.mesh (fun _ -> ""));
  x

(* {1 What was found} *)

(* By goal, the states of this owner at whose arrival it is met. *)
let events s (all : Touched.t array) (hits : Part.hit list) =
  let by_id = Hashtbl.create 16 in
  if hits <> [] then Array.iter (fun (t : Touched.t) -> Hashtbl.replace by_id t.id t) all;
  let add events (h : Part.hit) =
    match Hashtbl.find_opt by_id h.id with
    | None -> events
    | Some (t : Touched.t) ->
      let goal = s.goals.(h.goal) in
      if not (counts goal t.time) then events
      else if h.sure then
        let moment = attained t.time in
        (h.goal, { Round.moment; turn = t.before; place = t.place; owner = me s; id = t.id }) :: events
      else begin
        goal.doubtful <- true;
        events
      end
  in
  List.fold_left add [] hits

let first_events s events ~upto =
  let met = Array.map (fun _ -> None) s.goals in
  let add (goal, (e : Round.event)) = if e.turn <= upto then met.(goal) <- Round.earlier met.(goal) (Some e) in
  List.iter add events;
  met

(* States that are entered now have later turns than all before. *)
let next_day s all =
  let known = Days.first s.days ~none:s.turns in
  let add best (t : Touched.t) =
    if Part.is_too_long s.part t.id then best
    else
      match best with
      | Some (time, _) when Rat.compare time t.time <= 0 -> best
      | Some _ | None -> Some (t.time, s.turns)
  in
  Array.fold_left add known all

let round_of s (p : Progress.t) x all events ~upto : Round.t =
  let count f = Array.fold_left (fun n (t : Touched.t) -> if f t then n + 1 else n) 0 all in
  let is_unknown text = not (List.mem text p.faults) in
  {
    found = count Touched.is_new;
    ranked = Array.length all;
    transitions = Array.fold_left ( + ) 0 x.counts;
    too_long = count (fun t -> Touched.is_new t && Part.is_too_long s.part t.id);
    opened = List.fold_left (fun _ turn -> if turn <= upto then Some turn else None) None x.opened;
    met = first_events s events ~upto;
    next = next_day s all;
    faults = Hashtbl.fold (fun text turn all -> if is_unknown text then (text, turn) :: all else all) x.faults [];
    ends = Hashtbl.fold (fun text () all -> if List.mem text p.ends then all else text :: all) x.ends [];
  }

let read s source =
  let round = Round.read source in
  if Array.length round.met <> Array.length s.goals then raise (Packed.Malformed "it has other goals");
  round

let agree s ~low keys mine =
  let key k =
    let before, place = keys.(k) in
    (before - low, place)
  in
  let length = Array.length keys and width = Int.max 1 (s.turns - low) in
  let told, ranks = Ranking.agree s.mesh ~width ~length ~keys:key ~mine ~put:Round.put ~read:(read s) in
  (Round.merge told, ranks)

(* {1 Where it ends} *)

(* The last turn that may be expanded where states are bounded: the one after it finds too many. *)
let last_turn s ~low mine all ~room =
  let firsts = List.filter_map (fun (t : Touched.t) -> t.first) (Array.to_list all) in
  let keys = Array.of_list (List.map (fun (f : Clock.first) -> (f.before, f.choice)) firsts) in
  Array.sort compare keys;
  let _, ranks = agree s ~low keys mine in
  let next = ref 0 in
  Array.iteri (fun k rank -> if rank = room then next := fst keys.(k) + 1) ranks;
  match Mesh.sums s.mesh [ !next ] with [ next ] -> next - 2 | _ -> max_int

(* Exact numbers of transitions and of new states up to a turn; states that are not expanded are left. *)
let up_to s x all last =
  let transitions = ref 0 in
  let count k id =
    if Clock.turn s.clock id <= last then transitions := !transitions + x.counts.(k) else s.cut <- id :: s.cut
  in
  Array.iteri count x.order;
  let is_before n (t : Touched.t) =
    match t.first with Some f when f.before <= last -> n + 1 | Some _ | None -> n
  in
  match Mesh.sums s.mesh [ !transitions; Array.fold_left is_before 0 all ] with
  | [ transitions; found ] -> (transitions, found)
  | _ -> (0, 0)

let decide s now round =
  let last = Asked.decide s.goals now round in
  Array.iteri (fun k g -> if g.decided then Part.found s.part k) s.goals;
  last

(* {1 Rounds} *)

let enter_days s all ranks =
  let put k (t : Touched.t) =
    Clock.set_turn s.clock t.id (s.turns + ranks.(k));
    if Part.is_too_long s.part t.id then begin
      if Touched.is_new t then s.left <- t.id :: s.left
    end
    else Days.put s.days t.time t.id
  in
  Array.iteri put all

let next s (p : Progress.t) ~now ~low =
  let x = expand s now in
  let all = Touched.all s.part s.clock in
  let events = x.ahead @ events s all (Part.hits s.part) in
  let keys = Array.map (fun (t : Touched.t) -> (t.before, t.place)) all in
  let r, ranks = agree s ~low keys (round_of s p x all events ~upto:max_int) in
  let room = s.settings.most_states - p.states in
  let r, bound =
    if r.found <= room then (r, None)
    else
      let bound = last_turn s ~low (round_of s p x all events ~upto:max_int) all ~room in
      let bounded, _ = agree s ~low [||] (round_of s p x all events ~upto:bound) in
      ({ r with met = bounded.met; opened = bounded.opened }, Some bound)
  in
  let decided = decide s now r in
  let last =
    match (decided, bound) with
    | Some last, _ when not (asked s now) -> Some last
    | _, bound -> bound
  in
  let transitions, found =
    match last with Some last -> up_to s x all last | None -> (r.transitions, r.found)
  in
  enter_days s all ranks;
  s.turns <- s.turns + r.ranked;
  let within (text, turn) =
    match last with Some last when turn > last -> None | Some _ | None -> Some text
  in
  let p =
    {
      p with
      level = p.level + 1;
      width = r.ranked;
      states = p.states + found;
      transitions = p.transitions + transitions;
      stop = (if last = None then None else if asked s now then Some States else Some Early);
      faults = add p.faults (List.filter_map within r.faults);
      ends = add p.ends r.ends;
      too_long = p.too_long + r.too_long;
    }
  in
  s.show p;
  (p, r.next)

(* {1 The end} *)

(* States that could be expanded, and are not. *)
let waiting s each =
  List.iter each s.cut;
  Days.iter s.days each

let finish s (p : Progress.t) : Progress.t =
  let goals = Array.length s.goals in
  let is_open = Array.make goals false and left = ref 0 in
  let look id = Array.iteri (fun k g -> if counts g (arrival s id) then is_open.(k) <- true) s.goals in
  List.iter look s.left;
  waiting s (fun id ->
      incr left;
      look id);
  let flags array = List.map Bool.to_int (Array.to_list array) in
  let sums = Mesh.sums s.mesh (!left :: (flags is_open @ flags (Array.map (fun g -> g.doubtful) s.goals))) in
  let flag n = match List.nth_opt sums n with Some n -> n > 0 | None -> false in
  let place (e : Round.event) = { level = 0; owner = e.owner; id = e.id } in
  let is_undecided k = Option.is_none s.goals.(k).met in
  let stop =
    match p.stop with
    | Some (States | Levels) as stop -> stop
    | Some (Early | Late) | None ->
      if not (flag 0) then None
      else if p.stop = Some Early || (s.settings.searches && Array.for_all (fun g -> g.decided) s.goals) then
        Some Early
      else Some Late
  in
  {
    p with
    stop;
    met = Array.map (fun g -> Option.map place g.met) s.goals;
    doubts = Array.init goals (fun k -> is_undecided k && flag (1 + goals + k));
    open_ = Some (Array.init goals (fun k -> is_undecided k && flag (1 + k)));
  }

let graph s : Cycles.graph =
  let rest = lazy (
    let ids = Hashtbl.create 64 in
    let add id = Hashtbl.replace ids id () in
    List.iter add s.left;
    waiting s add;
    ids)
  in
  {
    number = Clock.turn s.clock;
    find = Clock.find s.clock;
    level = (fun _ -> 0);
    is_expanded = (fun id -> not (Hashtbl.mem (Lazy.force rest) id));
  }

let too_late s time =
  match s.settings.horizon with Some bound -> Rat.compare time bound > 0 | None -> false

(* Goals that are met may be met earlier, until they are decided. *)
let is_settled s before p =
  let met g = if g.decided then Option.map (fun _ -> { level = 0; owner = 0; id = 0 }) g.met else None in
  (not s.settings.searches)
  && Progress.is_time_to_look ~before { p with met = Array.map met s.goals }
  && s.settled s

let rec rounds s (p : Progress.t) ~last ~at_once next_day =
  match next_day with
  | _ when p.stop <> None -> p
  | None -> p
  | Some (now, _) when too_late s now || not (asked s now) -> p
  | Some (now, low) ->
    let at_once = if Option.equal Rat.equal last (Some now) then at_once + 1 else 0 in
    if match s.settings.most_rounds with Some most -> at_once > most | None -> false then
      { p with stop = Some Levels }
    else
      let before = p in
      let p, next_day = next s p ~now ~low in
      let p = if is_settled s before p then { p with stop = Some Early } else p in
      rounds s p ~last:(Some now) ~at_once next_day

let run s ~home =
  let filter = Part.filter s.part in
  let initial = Scc_successors.Filter.initial filter in
  if home = me s then begin
    Part.enter_initial s.part ~home;
    ignore (Part.hits s.part)
  end;
  Clock.close s.clock;
  let here : Round.event = { moment = attained Rat.zero; turn = 0; place = 0; owner = home; id = 0 } in
  let look k (g : goal) =
    match initial.goals.(k) with
    | True when counts g Rat.zero -> g.met <- Some here
    | Undecided _ when counts g Rat.zero -> g.doubtful <- true
    | True | Undecided _ | False -> ()
  in
  Array.iteri look s.goals;
  s.turns <- 1;
  if home = me s then
    if initial.too_long then s.left <- [ 0 ]
    else Days.put s.days Rat.zero 0;
  let p : Progress.t =
    {
      level = 0; depth = 0; width = 1; states = 1; transitions = 0;
      met = Array.map (fun _ -> None) s.goals;
      doubts = Array.map (fun _ -> false) s.goals;
      open_ = None; stop = None; faults = []; ends = [];
      too_long = Bool.to_int initial.too_long;
      too_deep = 0;
    }
  in
  let next_day = if initial.too_long then None else Some (Rat.zero, 0) in
  finish s (rounds s p ~last:None ~at_once:0 next_day)
