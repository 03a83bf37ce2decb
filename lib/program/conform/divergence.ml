open Scc_exact
open Scc_semantics

type kind =
  | Wrong_time
  | Wrong_features
  | Wrong_channel
  | Wrong_kind
  | Wrong_partner
  | Wrong_order
  | Missing_event
  | Extra_event
  | Wrong_position
  | Wrong_velocity
  | Wrong_spin
  | Wrong_orientation
  | Wrong_bonds
  | Wrong_behaviour
  | Wrong_clock
  | Wrong_presence
  | Wrong_step
  | Wrong_ending
  | Time_back

let names =
  [
    (Wrong_time, "wrong-time"); (Wrong_features, "wrong-features"); (Wrong_channel, "wrong-channel");
    (Wrong_kind, "wrong-kind"); (Wrong_partner, "wrong-partner"); (Wrong_order, "wrong-order");
    (Missing_event, "missing-event"); (Extra_event, "extra-event"); (Wrong_position, "wrong-position");
    (Wrong_velocity, "wrong-velocity"); (Wrong_spin, "wrong-spin"); (Wrong_orientation, "wrong-orientation");
    (Wrong_bonds, "wrong-bonds"); (Wrong_behaviour, "wrong-behaviour"); (Wrong_clock, "wrong-clock");
    (Wrong_presence, "wrong-presence");
    (Wrong_step, "wrong-step"); (Wrong_ending, "wrong-ending"); (Time_back, "time-back");
  ]

let all = List.map fst names
let kind_name kind = snd (List.find (fun (k, _) -> k = kind) names)

type allowed = { label : Transition.label; rules : Rule.t list; time : Rat.t }

type t = {
  kind : kind;
  item : Recorded.item;
  rules : string list;
  why : string;
  closest : allowed option;
  off : Rat.t option;
  differences : Against.difference list;
  allowed : allowed list;
  after : allowed option;
}

let most_allowed = 12

let allowed_of (o : Prospect.t) = { label = o.taken.label; rules = o.taken.rules; time = o.time }

(* {1 Rules} *)

let rigid against = Option.is_some (Against.model against).rigid

let when_rules against : Transition.label -> string list = function
  | Time _ -> [ "Time" ]
  | Weak_split _ -> [ "WeakSplit"; "I-9" ]
  | Lot _ -> [ "Lot" ]
  | Strong_split _ -> [ "StrongSplit"; "TimeBehaviour" ]
  | Draw _ -> [ "Draw"; "Steer" ]
  | Close _ -> [ "Close"; "TimeBehaviour" ]
  | Bind _ | Bounce _ | Absorb _ -> if rigid against then [ "Cast"; "Collision" ] else [ "Ftoc"; "Collision" ]

let urgency : Transition.label -> string list * string = function
  | Strong_split _ -> ([ "StrongSplit"; "Time" ], "a strong split that is enabled is urgent")
  | Close _ -> ([ "Close"; "Time" ], "a bond that two leaves of one process can make is urgent")
  | Draw _ -> ([ "Draw"; "Time" ], "no time passes while a velocity has to be drawn")
  | Lot _ -> ([ "Lot"; "Time" ], "no time passes while lots have to be drawn")
  | Bind _ | Bounce _ | Absorb _ -> ([ "Collision"; "Time" ], "no time passes while bodies collide")
  | Weak_split _ | Time _ -> ([ "Time" ], "time cannot pass")

let kind_rules : Recorded.kind -> string list = function
  | Bind -> [ "Bind"; "Collision" ]
  | Close -> [ "Close"; "I-37" ]
  | Bounce -> [ "Bounce"; "Collision" ]
  | Absorb -> [ "Absorb"; "Collision" ]
  | Weak -> [ "WeakSplit"; "I-9" ]
  | Strong -> [ "StrongSplit" ]
  | Draw -> [ "Draw" ]

(* {1 Events that do not fit} *)

let text against (o : Prospect.t) = Transition.label_to_string (Against.model against) o.taken.label

type found = { kind : kind; rules : string list; why : string; closest : Prospect.t option }

let distance (item : Recorded.item) (o : Prospect.t) = Rat.abs (Rat.sub o.time item.time)

let nearest item options =
  List.fold_left
    (fun best o ->
       match best with
       | Some b when Rat.compare (distance item b) (distance item o) <= 0 -> best
       | _ -> Some o)
    None options

(* In order of time. *)
let nearest_few item options =
  List.stable_sort (fun a b -> Rat.compare (distance item a) (distance item b)) options
  |> List.filteri (fun i _ -> i < most_allowed)
  |> List.stable_sort (fun (a : Prospect.t) (b : Prospect.t) -> Rat.compare a.time b.time)

let near against item o = Rat.compare (distance item o) (Against.tolerance against) <= 0
let too_early against (item : Recorded.item) (o : Prospect.t) =
  Rat.compare (Rat.add o.time (Against.tolerance against)) item.time <= 0
  && not (near against item o && Rat.sign (Against.tolerance against) > 0)

let nearness against e (o : Prospect.t) = Against.nearness against o.at e o.taken.label
let fits against e o = nearness against e o = Against.Same

(* The events that are possible next when an option has been taken. *)
let following against ~observed (o : Prospect.t) =
  Prospect.at_first_instant against ~observed { o.from with state = o.taken.target; time = o.time }

(* The event that the trace has after an item. *)
let next_event (trace : Recorded.t) index =
  let rec from i =
    if i >= Array.length trace.items then None
    else match trace.items.(i).what with Event e -> Some (trace.items.(i), e) | _ -> from (i + 1)
  in
  from (index + 1)

let first_some attempts = List.find_map (fun attempt -> attempt ()) attempts

let wrong_order against trace ~observed index item e options =
  match next_event trace index with
  | None -> None
  | Some (_, later) ->
    let first o =
      fits against later o
      && (near against item o || Prospect.is_urgent o)
      && List.exists (fun o -> fits against e o) (following against ~observed o)
    in
    List.find_opt first options
    |> Option.map (fun o ->
        {
          kind = Wrong_order; rules = [ "Successors"; "Time" ]; closest = Some o;
          why = Printf.sprintf "%s has to come before it, and the trace has it later" (text against o);
        })

let substitute against item e options =
  let here = List.filter (near against item) options in
  let of_kind nearness' kind rules why () =
    List.find_opt (fun o -> nearness against e o = nearness') here
    |> Option.map (fun o -> { kind; rules; why = text against o ^ " is allowed there" ^ why o; closest = Some o })
  in
  let own = kind_rules e.kind in
  first_some
    [
      of_kind Against.Other_motion Wrong_velocity own (fun _ -> ", of another velocity");
      of_kind Against.Other_features Wrong_features own
        (fun _ -> ", by other features");
      of_kind Against.Other_channel Wrong_channel own (fun _ -> ", by another channel");
      of_kind Against.Other_kind Wrong_kind
        (match e.Recorded.kind with
         | Bind | Bounce -> [ "Bind"; "Bounce" ]
         | Absorb -> [ "Absorb"; "Bind"; "Bounce" ]
         | Close | Weak | Strong | Draw -> own)
        (fun o ->
           match (e.kind, o.Prospect.taken.label) with
           | Bounce, Absorb _ -> ": what hits a body that absorbs never bounces"
           | Bounce, _ -> ": a collision with a candidate never bounces"
           | Bind, Close _ -> ": the two are of one process already"
           | Bind, _ -> ": the collision has no such candidate"
           | (Absorb | Close | Weak | Strong | Draw), _ -> "");
      of_kind Against.Other_partner Wrong_partner own
        (fun _ -> ", of other bodies");
    ]

let missing against ~observed item e options =
  let leads o =
    Prospect.is_urgent o && too_early against item o
    && List.exists
      (fun next -> fits against e next && near against item next)
      (following against ~observed o)
  in
  List.find_opt leads options
  |> Option.map (fun o ->
      let rules, reason = urgency o.Prospect.taken.label in
      {
        kind = Missing_event; rules; closest = Some o;
        why = Printf.sprintf "%s has to happen before, and was not recorded: %s" (text against o) reason;
      })

let other_time against trace index (item : Recorded.item) e options =
  match nearest item (List.filter (fits against e) options) with
  | None -> None
  | Some o -> (
      let met_later =
        match next_event trace index with
        | Some (next, later) -> fits against later o && near against next o
        | None -> false
      in
      if met_later then None
      else
        let off = Number.short (distance item o) in
        let early = Rat.compare item.time o.time < 0 in
        Some
          {
            kind = Wrong_time; rules = when_rules against o.Prospect.taken.label; closest = Some o;
            why =
              Printf.sprintf "%s is allowed at time %s: the trace is %s too %s" (text against o)
                (Number.short o.time) off
                (if early then "early" else "late");
          })

let left_out against item options =
  List.find_opt (fun o -> Prospect.is_urgent o && too_early against item o) options
  |> Option.map (fun o ->
      let rules, reason = urgency o.Prospect.taken.label in
      {
        kind = Missing_event; rules; closest = Some o;
        why =
          Printf.sprintf "%s has to happen at time %s, and was not recorded: %s" (text against o)
            (Number.short o.time) reason;
      })

let extra item (e : Recorded.event) options =
  match nearest item options with
  | None ->
    {
      kind = Extra_event; rules = "Quiescent" :: kind_rules e.kind; closest = None;
      why = "nothing can happen any more";
    }
  | Some o ->
    {
      kind = Extra_event; rules = kind_rules e.kind; closest = Some o;
      why = "nothing of the kind is allowed there";
    }

let event against trace ~observed index item e options =
  let found =
    first_some
      [
        (fun () -> wrong_order against trace ~observed index item e options);
        (fun () -> substitute against item e options);
        (fun () -> missing against ~observed item e options);
        (fun () -> other_time against trace index item e options);
        (fun () -> left_out against item options);
      ]
  in
  match found with Some f -> f | None -> extra item e options

(* {1 States that do not fit} *)

let kind_of_quantity = function
  | "x" | "y" | "z" -> Wrong_position
  | "vx" | "vy" | "vz" -> Wrong_velocity
  | "wx" | "wy" | "wz" -> Wrong_spin
  | "turned" -> Wrong_orientation
  | "process" | "bonds" -> Wrong_bonds
  | "behaviour" | "origin" -> Wrong_behaviour
  | "clock" -> Wrong_clock
  | "presence" -> Wrong_presence
  | _ -> Wrong_step

(* What gives a body the velocity that it has: the latest transition, if it is of this instant. *)
let rules_of_state against (h : Trace_search.hypothesis) (item : Recorded.item) kind =
  let recent =
    match h.last with
    | Some (label, rules, time)
      when Rat.compare (Rat.abs (Rat.sub time item.time)) (Against.tolerance against) <= 0 -> Some (label, rules)
    | _ -> None
  in
  let motion = if rigid against then [ "Turn"; "Time" ] else [ "Time" ] in
  let law = if (Against.model against).steered then [ "Steer" ] else [] in
  let split = if rigid against then [ "Impact"; "I-11" ] else [ "I-11" ] in
  match (kind, recent) with
  | (Wrong_velocity | Wrong_spin), Some ((Bounce _), _) ->
    "Bounce" :: (if rigid against then [ "Impact" ] else [ "Response" ])
  | (Wrong_velocity | Wrong_spin), Some (Bind _, _) -> "Bind" :: (if rigid against then [ "Impact" ] else [])
  | (Wrong_velocity | Wrong_spin), Some ((Weak_split _ | Strong_split _), _) -> split
  | (Wrong_velocity | Wrong_spin), _ -> law @ motion
  | (Wrong_position | Wrong_orientation), _ -> motion
  | Wrong_presence, _ -> [ "Absorb" ]
  | Wrong_clock, _ -> [ "I-9" ]
  | Wrong_step, _ -> [ "Steer" ]
  | Wrong_behaviour, Some (label, rules) when not (Transition.is_time label) -> List.map Rule.id rules
  | Wrong_behaviour, _ -> [ "TimeBehaviour" ]
  | _, Some (_, rules) -> List.map Rule.id rules
  | _, None -> [ "Def-5.2" ]

let difference_text (d : Against.difference) =
  let number text = match Rat.of_literal text with Ok q -> Number.short q | Error _ -> text in
  let told = if d.off = None then d.told else number d.told in
  let held = if d.off = None then d.held else number d.held in
  let off =
    match d.off with Some q -> Printf.sprintf ", off by %s" (Number.short q) | None -> ""
  in
  Printf.sprintf "%s%s is %s in the trace, and %s%s"
    (if d.body = "" then "" else "of " ^ d.body ^ ", ")
    d.quantity told held off

let fewest (misfits : Trace_search.misfit list) =
  List.fold_left
    (fun best (m : Trace_search.misfit) ->
       match best with
       | Some (b : Trace_search.misfit) when List.length b.differences <= List.length m.differences -> best
       | _ -> Some m)
    None misfits

let state against item (misfits : Trace_search.misfit list) options =
  match fewest misfits with
  | Some ({ differences = d :: _; _ } as m) ->
    let kind = kind_of_quantity d.quantity in
    let rules = rules_of_state against m.of_ item kind in
    ({ kind; rules; why = difference_text d; closest = None }, m.differences)
  | Some { differences = []; _ } | None -> (
      match left_out against item options with
      | Some f -> (f, [])
      | None ->
        let why = "time does not come to this instant" in
        ({ kind = Wrong_time; rules = [ "Time" ]; why; closest = None }, []))

let ending item options ~quiescent =
  let closest = nearest item options in
  {
    kind = Wrong_ending; closest;
    rules = (if quiescent then [ "Quiescent" ] else [ "Time"; "Successors" ]);
    why =
      (match closest with
       | Some _ -> "the trace claims that nothing can happen any more, and something can"
       | None when quiescent -> "the trace claims that nothing will ever happen, and time is stuck"
       | None -> "the trace claims that time is stuck, and it can pass");
  }

(* {1 The first divergence} *)

(* Of the hypotheses that met as many items as possible, the one that waits for the latest. *)
let furthest (dead : Trace_search.dead_end) =
  List.fold_left
    (fun best (h : Trace_search.hypothesis) ->
       match best with
       | Some (b : Trace_search.hypothesis) when b.next > h.next -> best
       | _ -> Some h)
    None dead.reached

let goes_back against (trace : Recorded.t) index =
  let time = Rat.add trace.items.(index).time (Against.tolerance against) in
  let rec before i = i >= 0 && (Rat.compare time trace.items.(i).time < 0 || before (i - 1)) in
  Rat.sign time < 0 || before (index - 1)

let find against (trace : Recorded.t) ~observed (dead : Trace_search.dead_end) =
  let h =
    match furthest dead with
    | Some h -> h
    | None -> Scc_base.Bug.fail __POS__ "a dead end without a way to it"
  in
  let index = h.next in
  let item = trace.items.(index) in
  let waits (g : Trace_search.hypothesis) = g.next = index in
  let dead =
    {
      Trace_search.reached = List.filter waits dead.reached;
      possible = List.filter (fun (p : Trace_search.possible) -> waits p.from) dead.possible;
      misfits = List.filter (fun (m : Trace_search.misfit) -> waits m.of_) dead.misfits;
    }
  in
  let options = Prospect.find against ~observed ~past:item.time dead in
  let found, differences =
    if goes_back against trace index then
      ( { kind = Time_back; rules = [ "Time" ]; why = "the times of the trace decrease"; closest = None }, [] )
    else
      match item.what with
      | Event e -> (event against trace ~observed index item e options, [])
      | State _ -> state against item dead.misfits options
      | Watched -> state against item [] options
      | Quiescent -> (ending item options ~quiescent:true, [])
      | Stuck -> (ending item options ~quiescent:false, [])
  in
  {
    kind = found.kind; item; rules = found.rules; why = found.why;
    closest = Option.map allowed_of found.closest;
    off = Option.map (fun (o : Prospect.t) -> Rat.sub item.time o.time) found.closest;
    differences;
    allowed = List.map allowed_of (nearest_few item options);
    after =
      Option.map
        (fun (label, rules, time) -> { label; rules; time })
        (match List.rev dead.reached with h :: _ -> h.last | [] -> h.last);
  }
