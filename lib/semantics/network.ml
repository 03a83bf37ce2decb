open Scc_calculus

let ( let* ) = Result.bind

(* Replaces the processes at some indices by others. *)
let replace (s : State.t) indices processes ~step =
  let kept =
    List.filteri (fun i _ -> not (List.mem i indices)) (Array.to_list s.processes)
  in
  State.make ~processes:(processes @ kept) ~step ~time:s.time

(* What collides in the rigid calculus begins new turns for all (rule Turn). *)
let at_contact (m : Model.t) (s : State.t) =
  let turning (p : State.process) = Scc_exact.Rat.sign p.since > 0 in
  let stale () = Turn.is_free m || Array.exists turning s.processes in
  match m.rigid with
  | Some _ when stale () && Encounter.colliding m s <> [] -> Steer.renewed m s
  | Some _ | None -> s

let finish m label rules target =
  let* settled = Steer.settle m (at_contact m target) in
  let target = match m.Model.rigid with None -> settled.state | Some _ -> Turn.shortened settled.state in
  Ok { Transition.label; rules = rules @ settled.rules; target; rounded = settled.rounded }

(* A collision ends the movement step, unless this instant has been steered already. *)
let after_collision (step : State.step option) =
  let next : State.phase -> State.phase = function
    | Moving | Due -> Due
    | Steered -> Steered
  in
  Option.map (fun (s : State.step) -> { s with phase = next s.phase }) step

let splits m (s : State.t) outcomes_of =
  Array.to_list s.processes
  |> List.mapi (fun i p ->
      List.map
        (fun (o : Split.outcome) -> finish m o.label o.rules (replace s [ i ] o.pieces ~step:s.step))
        (outcomes_of m p))
  |> List.concat

(* Two processes that collide, with what may come of it. *)
type meeting = {
  first : int;
  second : int;
  outcomes : unit -> (Collision.outcome list, Transition.fault) result;
}

let meetings (m : Model.t) s =
  match m.rigid with
  | None ->
    List.filter Collision.colliding (Collision.contacts m s)
    |> List.map (fun (c : Collision.contact) ->
        { first = c.first; second = c.second; outcomes = (fun () -> Ok (Collision.resolve m s c)) })
  | Some _ ->
    List.map
      (fun (e : Encounter.t) ->
         { first = e.first; second = e.second; outcomes = (fun () -> Encounter.outcomes m s e) })
      (Encounter.colliding m s)

let resolved m (s : State.t) meetings =
  List.concat_map
    (fun c ->
       match c.outcomes () with
       | Error fault -> [ Error fault ]
       | Ok outcomes ->
         List.map
           (fun (o : Collision.outcome) ->
              let step = after_collision s.step in
              finish m o.label o.rules (replace s [ c.first; c.second ] o.results ~step))
           outcomes)
    meetings

let time_rules (m : Model.t) =
  match m.rigid with
  | None -> [ Rule.Time; Time_behaviour ]
  | Some _ -> [ Rule.Time; Time_behaviour; Turn ]

let time m s =
  match Time.delay m s with
  | None -> []
  | Some d -> [ finish m (Transition.Time d) (time_rules m) (Time.pass m d s) ]

let distinct transitions =
  let same (a : Transition.t) (b : Transition.t) =
    Transition.equal_label a.label b.label && State.equal a.target b.target
  in
  List.fold_left
    (fun kept t -> if List.exists (same t) kept then kept else t :: kept)
    [] transitions
  |> List.rev

let rec all_ok acc = function
  | [] -> Ok (List.rev acc)
  | Ok t :: rest -> all_ok (t :: acc) rest
  | Error e :: _ -> Error e

let all transitions = Result.map distinct (all_ok [] transitions)
let strong m s = all (splits m s Split.strong)
let weak m s = all (splits m s Split.weak)
let collisions m s = all (resolved m s (meetings m s))
let colliding m s = List.map (fun c -> (c.first, c.second)) (meetings m s)

let successors m s =
  let strong = splits m s Split.strong in
  let weak = splits m s Split.weak in
  let contacts = meetings m s in
  let time = if strong = [] && contacts = [] then time m s else [] in
  all (strong @ weak @ resolved m s contacts @ time)

let quiescent m s =
  Array.for_all (fun p -> Split.strong m p = [] && Option.is_none p.State.clock) s.State.processes
  && colliding m s = []
  && Option.is_none (Time.delay m s)

let initial (m : Model.t) (declared : State.t) =
  let step =
    if m.steered then Some { State.remaining = m.timestep; length = m.timestep; phase = State.Due } else None
  in
  let time = if m.keeps_time then Some Scc_exact.Rat.zero else None in
  let start p =
    let p = Process.restart_clock m p in
    match m.rigid with None -> p | Some _ -> Turn.start m p
  in
  let processes = List.map start (Array.to_list declared.processes) in
  let* settled = Steer.settle m (State.make ~processes ~step ~time) in
  Ok settled.state

let follow m s choices =
  let rec go s place acc = function
    | [] -> Ok (List.rev acc)
    | choice :: rest -> (
        match successors m s with
        | Error fault -> Error (place, Some fault)
        | Ok list -> (
            match if choice < 0 then None else List.nth_opt list choice with
            | None -> Error (place, None)
            | Some t -> go t.Transition.target (place + 1) (t :: acc) rest))
  in
  go s 0 [] choices
