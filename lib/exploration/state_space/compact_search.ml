open Scc_ctl
open Scc_exact
open Scc_graph_search
open Scc_semantics

type met = { choices : int list; during : (Timeline.moment * Algebraic.t) option }

type answer = Met of met | Unmet of string option

type result = {
  answers : answer list;
  states : int;
  transitions : int;
  depth : int;
  arrival : Rat.t;
  left : Transition.fault Explore.reason list;
  omission : float;
  bytes : int;
}

(* A goal, and the state and moment at which it was met. *)
type monitor = {
  goal : On_the_fly.predicate;
  mutable place : (int * (Timeline.moment * Algebraic.t) option) option;
  mutable undefined : string option;
}

let is_true = function Truth.True -> true | False | Undecided _ -> false

let doubt m = function
  | Truth.Undecided why -> m.undefined <- Some why
  | True | False -> ()

let found m i tuple =
  if Option.is_none m.place then begin
    let truth = m.goal.at tuple in
    doubt m truth;
    if is_true truth then m.place <- Some (i, None)
  end

let extent context ~rests tuple (steps : Lts.step list) =
  let timed (s : Lts.step) = Rat.sign (Network_lts.duration context s.label) > 0 in
  match List.find_opt timed steps with
  | Some s -> Some (Timeline.Lasts (Network_lts.duration context s.label))
  | None when steps = [] && rests tuple -> Some Timeline.Forever
  | None -> None

let opened context ~rests m i tuple steps =
  match (m.place, m.goal.along, extent context ~rests tuple steps) with
  | None, Some along, Some extent ->
    let timeline = along tuple extent in
    let meet moment = m.place <- Some (i, Some (moment, Timeline.sample timeline moment)) in
    let unsure = function Truth.Undecided _ -> true | True | False -> false in
    let doubtful moment = doubt m (Timeline.at timeline (Timeline.sample timeline moment)) in
    Option.iter doubtful (Timeline.first_after_start unsure timeline);
    Option.iter meet (Timeline.first_after_start is_true timeline)
  | _ -> ()

let search ?expanding limits around context ~capacity ~rests goals =
  let monitors = List.map (fun goal -> { goal; place = None; undefined = None }) goals in
  let visitor =
    {
      State_fingerprints.found = (fun i tuple -> List.iter (fun m -> found m i tuple) monitors);
      opened = (fun i tuple steps -> List.iter (fun m -> opened context ~rests m i tuple steps) monitors);
      enough =
        (fun () -> goals <> [] && List.for_all (fun m -> Option.is_some m.place) monitors);
    }
  in
  let family = Network_exchange.family context in
  let r = State_fingerprints.run ?expanding visitor ~capacity ~family limits around context in
  let answer m =
    match m.place with
    | Some (i, during) -> Met { choices = r.path i; during }
    | None -> Unmet m.undefined
  in
  {
    answers = List.map answer monitors;
    states = r.size;
    transitions = r.transitions;
    depth = r.depth;
    arrival = r.arrival;
    left = r.left;
    omission = r.omission;
    bytes = r.bytes;
  }
