open Scc_exact
open Scc_semantics
open Scc_motion
open Scc_loading
open Scc_json
open Scc_runs

type run = States of Course.t | Changes of Ways.t
type t = { title : string; origin : Origin.t; run : run }
type file = string * ((string -> unit) -> unit)

let model f =
  match f.run with States c -> Semantics.model (Course.semantics c) | Changes w -> Ways.model w

let initial f = match f.run with States c -> Course.initial c | Changes w -> Ways.initial w
let duration f = match f.run with States c -> Course.duration c | Changes w -> Ways.duration w
let at f time = match f.run with States c -> Course.at c time | Changes w -> Ways.at w time

let tracks f = match f.run with States c -> Track.of_course c | Changes w -> Track.of_ways w

(* Of all transitions, each with the time before it. *)
let labels f =
  match f.run with
  | Changes w -> Ways.labels w
  | States c -> List.map (fun (l : Course.leg) -> (l.start, l.label)) (Array.to_list (Course.legs c))

let events f =
  let is_event (_, label) = not (Transition.is_time label) in
  List.filter is_event (labels f)

let most_instants = 1_000_000
let too_many f ~every = Rat.compare (Rat.div (duration f) every) (Rat.of_int most_instants) > 0

let instants f ~every =
  let over = duration f in
  let inner =
    match every with
    | None -> List.map fst (labels f)
    | Some step ->
      let rec back k list = if k <= 0 then list else back (k - 1) (Rat.mul step (Rat.of_int k) :: list) in
      back (Z.to_int (Rat.floor (Rat.div over step))) []
  in
  let add times t = match times with last :: _ when Rat.equal last t -> times | _ -> t :: times in
  List.rev (add (List.fold_left add [ Rat.zero ] inner) over)

let about f =
  [
    ("model", Json.option Json.text f.origin.name);
    ("digest", `String f.origin.digest);
    ("parameters", Origin_json.parameters f.origin);
  ]
