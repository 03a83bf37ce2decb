open Scc_exact
open Scc_semantics
open Scc_motion
open Scc_session
open Scc_exchange

type t = { title : string; origin : Origin.t; course : Course.t }
type file = string * ((string -> unit) -> unit)

let model f = Semantics.model (Course.semantics f.course)

let events f =
  let event (l : Course.leg) =
    match l.label with
    | Time _ -> None
    | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ -> Some (l.start, l.label)
  in
  List.filter_map event (Array.to_list (Course.legs f.course))

let most_instants = 1_000_000
let too_many f ~every = Rat.compare (Rat.div (Course.duration f.course) every) (Rat.of_int most_instants) > 0

let instants f ~every =
  let over = Course.duration f.course in
  let inner =
    match every with
    | None -> List.map (fun (l : Course.leg) -> l.start) (Array.to_list (Course.legs f.course))
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
