open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs

type way = { since : Rat.t; process : State.process option }

type t = {
  model : Model.t;
  initial : State.t;
  ways : way list array;  (** by leaf, the newest first *)
  mutable labels : (Rat.t * Transition.label) list;  (** the newest first *)
  mutable now : Rat.t;
  mutable sorted : way array array option;  (** once the run is over *)
}

let enter t (p : State.process) =
  Array.iter
    (fun (l : State.leaf) -> t.ways.(l.leaf) <- { since = t.now; process = Some p } :: t.ways.(l.leaf))
    p.leaves

(* Who has gone leaves its leaves; those that are not absorbed come again. *)
let leave t first =
  match t.ways.(first) with
  | { process = Some p; _ } :: _ ->
    Array.iter
      (fun (l : State.leaf) -> t.ways.(l.leaf) <- { since = t.now; process = None } :: t.ways.(l.leaf))
      p.leaves
  | { process = None; _ } :: _ | [] -> ()

let start semantics (initial : State.t) =
  let model = Semantics.model semantics in
  let ways = Array.map (fun _ -> []) model.leaves in
  let t = { model; initial; ways; labels = []; now = Rat.zero; sorted = None } in
  Array.iter (enter t) initial.processes;
  t

let step t : Replay.event -> unit = function
  | Start _ | End _ -> ()
  | Instant { offset; _ } -> t.now <- Rat.add t.now offset
  | Step { taken; changes; _ } -> (
      t.labels <- (t.now, taken.label) :: t.labels;
      t.now <- Rat.add t.now (Transition.duration_of taken.label);
      match changes () with
      | None -> Bug.fail __POS__ "a run that does not tell who has changed"
      | Some { gone; come } ->
        List.iter (leave t) gone;
        List.iter (enter t) come)

let model t = t.model
let initial t = t.initial
let labels t = List.rev t.labels
let duration t = t.now
let of_leaf t leaf = List.rev t.ways.(leaf)

let sorted t =
  match t.sorted with
  | Some s -> s
  | None ->
    let s = Array.map (fun ways -> Array.of_list (List.rev ways)) t.ways in
    t.sorted <- Some s;
    s

(* The last way that has begun. *)
let present ways time =
  let rec search low high =
    if high - low = 1 then low
    else
      let middle = (low + high) / 2 in
      if Rat.compare ways.(middle).since time <= 0 then search middle high else search low middle
  in
  if Array.length ways = 0 then None
  else
    let w = ways.(search 0 (Array.length ways)) in
    Option.map (fun p -> (w.since, p)) w.process

let at t time =
  let process leaf ways =
    match present ways time with
    | Some (since, (p : State.process)) when p.leaves.(0).leaf = leaf ->
      let d = Rat.sub time since in
      Some (if Rat.sign d = 0 then p else Turn.pass t.model d p)
    | Some _ | None -> None
  in
  let processes = List.filter_map Fun.id (Array.to_list (Array.mapi process (sorted t))) in
  State.make ~processes ~step:None ~time:None
