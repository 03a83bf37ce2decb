open Scc_base
open Scc_data
open Scc_exact
open Scc_ctl
open Scc_semantics
open Scc_graph_search
open Scc_state_space

type label = Transition.label * Rat.t option

module Labels = Scc_data.Numbering.Make (struct
    type t = label

    let equal (a, p) (b, q) = Transition.equal_label a b && Option.equal Rat.equal p q
    let hash (l, chance) = Catalogue.hash_label l + Option.fold ~none:0 ~some:Rat.hash chance
  end)

type reached = { tuple : int array; fingerprint : Keys.fingerprint; goals : Truth.t array; too_long : bool }
type met = { choice : int option; moment : Timeline.moment; sample : Algebraic.t }
type ahead = { met : met option; doubt : string option; doubtful : Timeline.moment option }

type t = {
  question : Question.t;
  context : Network_lts.context;
  keys : Keys.t;
  predicates : On_the_fly.predicate array;
  limits : Limits.t;
  labels : Labels.t;
  numbers : int Growable.t;  (** of the labels of the context *)
  looks_ahead : bool;  (** some goal may change while time passes *)
  nothing_ahead : ahead option array;
}

type 'moves following =
  | Moves of 'moves list
  | Rests
  | Ends of Diag.t
  | Stops
  | Fault of Diag.t

type bare = Lts.step following
type follows = (int * reached) following

type expanded = { state : reached; follows : follows; ahead : ahead option array }

let build question labels =
  let context = Question.context question in
  let predicates = Question.predicates question context in
  let changes (p : On_the_fly.predicate) = Option.is_some p.along in
  {
    question; context; labels; predicates;
    keys = Keys.make context question.Question.initial;
    looks_ahead = Array.exists changes predicates;
    nothing_ahead = Array.map (fun _ -> None) predicates;
    limits = { Limits.unlimited with bits = Some question.bits };
    numbers = Growable.create ();
  }

let make question = build question (Labels.create ())
let question f = f.question
let keys f = f.keys
let context f = f.context
let predicates f = f.predicates
let events f = Network_lts.events f.context
let labels f = Labels.size f.labels
let label f = Labels.get f.labels
let catalogue f = Network_lts.catalogue f.context

(* Processes of the network, each with its bytes, some hundred bytes in all. *)
let most_bodies = 4_000_000

let renew ?(most = most_bodies) f =
  if Catalogue.bodies (catalogue f) > most then build f.question f.labels else f

let label_number f number =
  for i = Growable.length f.numbers to number do
    let label = (Catalogue.label_of (catalogue f) i, Catalogue.chance (catalogue f) i) in
    Growable.push f.numbers (Labels.number f.labels label)
  done;
  Growable.get f.numbers number

(* What is read has the form of a state, and is one if it can be reached. What cannot may break what the rules rest
   on, anywhere in them: then there is no answer, and no harm is done, as nothing is kept of it. *)
let guarded work =
  match work () with
  | result -> Ok result
  | exception (Bug.Bug _ | Invalid_argument _ | Not_found | Division_by_zero) ->
    Error "this is no state that the model can reach: the rules do not apply to it"

let truth tuple (p : On_the_fly.predicate) =
  match guarded (fun () -> p.at tuple) with Ok t -> t | Error what -> Truth.Undecided what

let reach f tuple fingerprint =
  let bits () = Network_lts.bits f.context tuple in
  {
    tuple; fingerprint;
    goals = Array.map (truth tuple) f.predicates;
    too_long = Limits.too_long f.limits ~longest:(Network_lts.longest f.context) ~bits;
  }

let reached f tuple = reach f tuple (Keys.fingerprint f.keys tuple)
let initial f = reached f (Network_lts.initial f.context)

let no_state what = Diag.error Code.no_state Span.none "%s" what
let guarded work = Result.map_error no_state (guarded work)

let read f text ~from ~stop =
  match Keys.read f.keys text ~from ~stop with
  | Ok tuple -> Ok tuple
  | Error what -> Error (no_state ("this is no state of the model: " ^ what))

(* {1 What follows} *)

let decode f tuple = Catalogue.decode (catalogue f) tuple

(* A state without transitions. *)
let silent f tuple : bare =
  let semantics = Question.semantics f.question in
  let state = decode f tuple in
  if Network.quiescent semantics state then Rests
  else
    match Network.successors semantics state with
    | Ok _ -> Stops
    | Error fault -> Ends (Transition.diagnostic (Network_lts.model f.context) fault)

(* With nothing worked out of where they lead. *)
let bare f tuple : bare =
  match Network_lts.successors f.context tuple with
  | Error fault -> Fault (Transition.diagnostic (Network_lts.model f.context) fault)
  | Ok [] -> silent f tuple
  | Ok steps -> Moves steps

let follows f (state : reached) bare : follows =
  let move (s : Lts.step) =
    let target = Tuples.apply s.changes state.tuple in
    (label_number f s.label, reach f target (Keys.after f.keys state.fingerprint state.tuple s.changes target))
  in
  match bare with
  | Moves steps -> Moves (List.map move steps)
  | (Rests | Ends _ | Stops | Fault _) as other -> other

(* Time passes in one way only from a state, whatever transitions it ends in. *)
let extent f (follows : bare) =
  let timed k (s : Lts.step) =
    let d = Network_lts.duration f.context s.label in
    if Rat.sign d > 0 then Some (Some k, Timeline.Lasts d) else None
  in
  match follows with
  | Moves moves -> List.find_map Fun.id (List.mapi timed moves)
  | Rests -> Some (None, Timeline.Forever)
  | Ends _ | Stops | Fault _ -> None

let ahead f tuple follows =
  let of_goal extent (p : On_the_fly.predicate) =
    match (p.along, extent) with
    | None, _ -> None
    | Some _, None -> Some { met = None; doubt = None; doubtful = None }
    | Some along, Some (choice, extent) ->
      let timeline = along tuple extent in
      let phases = On_the_fly.phases timeline in
      let met moment = { choice; moment; sample = Timeline.sample timeline moment } in
      let doubtful = if Option.is_some phases.why then phases.perhaps else None in
      Some { met = Option.map met phases.surely; doubt = phases.why; doubtful }
  in
  if not f.looks_ahead then f.nothing_ahead else Array.map (of_goal (extent f follows)) f.predicates

let expand f tuple =
  guarded (fun () ->
      let state = reached f tuple in
      let bare = bare f tuple in
      { state; follows = follows f state bare; ahead = ahead f tuple bare })

let look f tuple =
  guarded (fun () ->
      let bare = bare f tuple in
      (bare, ahead f tuple bare))
