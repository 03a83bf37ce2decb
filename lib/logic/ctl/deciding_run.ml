open Scc_exact

let never _ = false
let always _ = true
let stuck = Run.Follow { edge = never; flow = never }

let run start (found : Run.finish Run.found) : Run.t =
  { start; steps = found.steps; last = found.last; finish = found.result }

let lost () = Scc_base.Bug.fail __POS__ "what was decided has no run that shows it"

(* What happens first in the flow of a place. *)
let first_of ~f ~g (place : Run.place) =
  let p = place.position in
  if Positions.is_inside p then Flow.from ~f ~g p.offset else Flow.entering ~f ~g

let first ~f ~g (place : Run.place) =
  let s = place.position.node in
  first_of ~f:(Positions.along f s) ~g:(Positions.along g s) place

(* Since when f fails in the flow of a place. *)
let failure ~f (place : Run.place) =
  match first_of ~f:(Positions.along f place.position.node) ~g:(Pieces.constant false) place with
  | Lost m -> Some m
  | Reached _ | Passes -> None

let same (a : Timeline.moment option) (b : Timeline.moment option) =
  match (a, b) with
  | Some a, Some b -> Timeline.compare_moment a b = 0
  | None, None -> true
  | Some _, None | None, Some _ -> false

(* Which ways keep to the times: from a node those that take what is left to it exactly, from inside a flow
   those to the best target. *)
type tight = {
  edge : int -> int -> bool;
  flow : Positions.position -> int -> bool;
  own : Positions.position -> Timeline.moment -> bool;  (** g in the flow itself *)
}

let tight graph ~best times =
  let after d t = Option.map (Bounded.shift d) (times t) in
  let flow (p : Positions.position) t =
    match Timed_graph.flow graph p.node with
    | Lasts (d, targets) ->
      if Positions.is_inside p then same (times t) (best times targets)
      else same (after d t) (times p.node)
    | No_flow | Forever -> false
  in
  {
    edge = (fun s t -> same (times t) (times s));
    flow;
    own = (fun p m -> Positions.is_inside p || same (Some m) (times p.node));
  }

let anything = { edge = (fun _ -> always); flow = (fun _ -> always); own = (fun _ -> always) }

let the_until (u : Eval.until) quantifier high =
  Timed_formula.Until (quantifier, { low = Rat.zero; high }, u.left, u.right)

(** {2 Some run} *)

let some_from_start e (u : Eval.until) high start =
  let graph = Eval.graph e in
  let f = (Eval.value e u.left).lower and g = (Eval.value e u.right).lower in
  let keep =
    match high with
    | None -> anything
    | Some bound ->
      let times = Bounded.least (Eval.index e) ~generous:false ~bound ~f ~g in
      tight graph ~best:Bounded.earliest times
  in
  let judge (place : Run.place) =
    let p = place.position in
    let s = p.node in
    let inside = Positions.is_inside p in
    let limit = match high with None -> None | Some _ -> Some place.left in
    if (not inside) && Positions.at g s then Run.Found Run.At_state
    else if not (graph.known s && (inside || Positions.at f s)) then stuck
    else
      let edge = keep.edge s in
      match (graph.flow s, first ~f ~g place) with
      | No_flow, _ -> Follow { edge; flow = never }
      | _, Reached m when keep.own p m -> Found (Run.during graph ~f ~g ?limit s m)
      | _, Passes -> Follow { edge; flow = keep.flow p }
      | _, (Reached _ | Lost _) -> Follow { edge; flow = never }
  in
  match Run.search graph ?bound:high start judge with
  | Ok found -> run start found
  | Error _ -> lost ()

(* The parts of an operator from [a, b] on: what is left of b, and the solution. *)
let interval e (u : Eval.until) ~generous side =
  let high = Option.map (fun h -> Rat.sub h u.bound.low) u.bound.high in
  let phi = side (Eval.value e (the_until u u.quantifier high)) in
  let f = side (Eval.value e u.left) in
  let quantifier : Interval.quantifier =
    match u.quantifier with
    | Exists -> Some_run
    | All -> Every_run
    | Chance _ -> Scc_base.Bug.fail __POS__ "no one run decides a probability"
  in
  let x = Interval.solve (Eval.index e) quantifier ~generous ~from:u.bound.low ~f ~phi in
  (high, f, phi, x)

(* Whether the instant [left] of a place lies inside its flow, or after the flow, of the given time. *)
type reach = Within | After of Rat.t | Nowhere

let reach graph (place : Run.place) =
  match Timed_graph.flow graph place.position.node with
  | No_flow -> Nowhere
  | Forever -> Within
  | Lasts (d, _) -> if Algebraic.compare_rat place.left d < 0 then Within else After d

let is_now (place : Run.place) =
  (not (Positions.is_inside place.position)) && Algebraic.compare_rat place.left Rat.zero = 0

let instant (place : Run.place) : Run.finish =
  During { moment = { offset = place.left; attained = true }; sample = place.left }

let later d (place : Run.place) = Algebraic.add_rat (Rat.neg d) place.left

let then_ follow (first : Run.t) =
  match Run.goal first with
  | Some goal -> Run.append first (follow goal)
  | None -> Scc_base.Bug.fail __POS__ "a run without end goes on"

let some e (u : Eval.until) start =
  if Rat.sign u.bound.low <= 0 then some_from_start e u u.bound.high start
  else
    let graph = Eval.graph e in
    let high, f, phi, x = interval e u ~generous:false (fun v -> v.lower) in
    let judge (place : Run.place) =
      let s = place.position.node in
      let inside = Positions.is_inside place.position in
      if is_now place then Run.Found Run.At_state
      else if not (graph.known s && (inside || Positions.at f s)) then stuck
      else
        let edge t = Interval.at x t place.left in
        match (reach graph place, failure ~f place) with
        | Within, lost ->
          let holds = match lost with None -> true | Some m -> Algebraic.compare place.left m.offset <= 0 in
          if holds && Pieces.at (Positions.along phi s) place.left then Found (instant place)
          else Follow { edge; flow = never }
        | After d, None -> Follow { edge; flow = (fun t -> Interval.at x t (later d place)) }
        | After _, Some _ | Nowhere, _ -> Follow { edge; flow = never }
    in
    match Run.search graph ~by_time:true ~bound:u.bound.low start judge with
    | Ok found -> then_ (some_from_start e u high) (run start found)
    | Error _ -> lost ()

(** {2 Not every run} *)

(* Whether a moment of a flow comes only after the bound, for which [left] is there. *)
let comes_late high (place : Run.place) (m : Timeline.moment) =
  match high with
  | None -> false
  | Some _ ->
    let c = Algebraic.compare m.offset place.left in
    if m.attained then c > 0 else c >= 0

(* A run on which time goes on shows more than one that goes round within one instant. *)
let going_round region =
  let takes_time (move : Timed_graph.move) = match move with Edge _ -> false | Flow _ -> true in
  match Run.lasso region ~prefer:takes_time with
  | Some run -> run
  | None -> lost ()

let every_from_start e (u : Eval.until) high start =
  let graph = Eval.graph e in
  let f = (Eval.value e u.left).upper and g = (Eval.value e u.right).upper in
  let x = (Eval.value e (the_until u All None)).upper in
  let avoids t = not (Positions.at x t) in
  let endless = not (Positions.mem x start) in
  let keep =
    if endless then { anything with edge = (fun _ -> avoids); flow = (fun _ -> avoids) }
    else
      let times = Bounded.greatest (Eval.index e) ~generous:true ~f ~g in
      tight graph ~best:Bounded.latest times
  in
  let judge (place : Run.place) =
    let p = place.position in
    let s = p.node in
    let inside = Positions.is_inside p in
    let limit = match high with None -> None | Some _ -> Some place.left in
    if (not inside) && Positions.at g s then stuck
    else if (not inside) && not (Positions.at f s) then Run.Found Run.At_state
    else if not (graph.known s) then stuck
    else if Timed_graph.is_dead_end graph s then Found Stops
    else
      let edge = keep.edge s in
      let flow = graph.flow s in
      match (flow, first ~f ~g place) with
      | No_flow, _ -> Follow { edge; flow = never }
      | _, (Reached m | Lost m) when comes_late high place m -> Found (Passes place.left)
      | _, Lost m -> Found (Run.during graph ~f ~g ?limit s m)
      | _, Reached _ -> Follow { edge; flow = never }
      | Forever, Passes -> Found (match high with None -> Rests | Some _ -> Passes place.left)
      | Lasts (d, _), Passes ->
        let over = Option.is_some high && Algebraic.compare_rat place.left d < 0 in
        if over then Found (Passes place.left) else Follow { edge; flow = keep.flow p }
  in
  match Run.search graph ?bound:high start judge with
  | Ok found -> run start found
  | Error region -> going_round region

(* What a run leads to before the low end of the interval, or there. *)
type leads = Ends of Run.finish | Goes_on of Run.finish

let every e (u : Eval.until) start =
  if Rat.sign u.bound.low <= 0 then every_from_start e u u.bound.high start
  else
    let graph = Eval.graph e in
    let high, f, phi, x = interval e u ~generous:true (fun v -> v.upper) in
    let judge (place : Run.place) =
      let s = place.position.node in
      let inside = Positions.is_inside place.position in
      if is_now place then Run.Found (Goes_on At_state)
      else if (not inside) && not (Positions.at f s) then Found (Ends At_state)
      else if not (graph.known s) then stuck
      else if Timed_graph.is_dead_end graph s then Found (Ends Stops)
      else
        let edge t = not (Interval.at x t place.left) in
        let fails m = Run.Found (Ends (Run.during graph ~f ~g:f ~limit:place.left s m)) in
        match (reach graph place, failure ~f place) with
        | Nowhere, _ -> Follow { edge; flow = never }
        | Within, Some m when Algebraic.compare m.offset place.left < 0 -> fails m
        | Within, _ ->
          if Pieces.at (Positions.along phi s) place.left then Follow { edge; flow = never }
          else Found (Goes_on (instant place))
        | After _, Some m -> fails m
        | After d, None -> Follow { edge; flow = (fun t -> not (Interval.at x t (later d place))) }
    in
    match Run.search graph ~by_time:true ~bound:u.bound.low start judge with
    | Ok { steps; last; result = Ends finish } -> { start; steps; last; finish }
    | Ok { steps; last; result = Goes_on finish } ->
      then_ (every_from_start e u high) { start; steps; last; finish }
    | Error region -> going_round region

(** {2 The next edge} *)

let next e ~holds ~leads start =
  let graph = Eval.graph e in
  let judge (place : Run.place) =
    let s = place.position.node in
    let by_edge =
      if Positions.is_inside place.position then None
      else
        let rec go k targets =
          if k = Array.length targets then None else if holds targets.(k) then Some k else go (k + 1) targets
        in
        go 0 (Timed_graph.edges graph s)
    in
    match by_edge with
    | Some k -> Run.Found k
    | None -> Follow { edge = never; flow = leads }
  in
  match Run.search graph start judge with
  | Error _ -> lost ()
  | Ok { steps; last; result = k } ->
    let step = { Run.source = last; move = Edge k } in
    let steps = List.rev (step :: List.rev steps) in
    { Run.start; steps; last = Timed_graph.target graph last step.move; finish = At_state }
