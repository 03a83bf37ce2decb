open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

type about = { formula : string; verdict : string; text : string }

type taken = { choice : int option; label : int; target : int; rules : Rule.t list; tail : bool }
type step = { choice : int option; label : Transition.label; rules : Rule.t list; after : State.t }

type course = {
  start : int;
  steps : taken list;
  rest : Rat.t;
  finish : string;
  cycle : int option;
  facts : string list;
  argument : Witness.argument option;
  ending : string list;
}

type t = {
  name : string;
  check : about option;
  course : course option;
  values : (string * Rat.t) list;
  leaves : Bodies.t list option;
  sample : bool;
  contrast : int option;
}

(* {1 JSON} *)

let about_members =
  all
    [
      field "formula" some_text (fun a -> a.formula);
      field "verdict" Check_json.kind_format (fun a -> a.verdict);
      field "text" some_text (fun (a : about) -> a.text);
    ]

let about_format = Rows.named "check" (obj about_members)

let taken =
  fields
    [
      field "choice" (nullable natural) (fun (s : taken) -> s.choice)
        ~about:"Which it was of what was possible; null: a passing of time in part.";
      field "label" Rows.number (fun (s : taken) -> s.label);
      field "to" Rows.number (fun s -> s.target);
      field "rules" States.rules (fun (s : taken) -> s.rules);
      maybe "tail" (constant (`Bool true)) (fun s -> if s.tail then Some () else None)
        ~about:"No transition: time passes on where nothing happens any more, from turn to turn.";
    ]
  |> Rows.named "step"

let lines = list some_text

let course =
  let part f (_, c) = f c in
  all
    [
      field "name" some_text (fun (r, _) -> r.name);
      field "check" (nullable about_format) (fun (r, _) -> r.check);
      field "start" Rows.number (part (fun c -> c.start));
      field "steps" (list taken) (part (fun c -> c.steps));
      field "rest" Shared.rational (part (fun c -> c.rest)) ~about:"Time that passes after the last step.";
      field "finish" some_text (part (fun c -> c.finish))
        ~about:"Where the run is taken to: as in a witness of scc check, or as a trace ends.";
      field "cycle" (nullable natural) (part (fun c -> c.cycle))
        ~about:"From which step on it goes on again and again.";
      field "facts" lines (part (fun c -> c.facts));
      field "argument" (nullable Witness_json.argument_format) (part (fun c -> c.argument));
      field "ending" lines (part (fun c -> c.ending));
    ]

let format =
  let about = "Of the parameters that have ranges." in
  let values ~sample (r, _) = if Bool.equal r.sample sample && r.values <> [] then Some r.values else None in
  let values ~sample = maybe "values" Origin_json.parameters_format (values ~sample) ~about in
  let unshown r = match (r.course, r.check) with None, Some check -> Some (r.name, check) | _ -> None in
  union
    [
      case
        (fields [ field "name" some_text fst; field "check" about_format snd; fixed "start" `Null ]
         |> Json_format.about "A check of which no single run shows the verdict.")
        unshown ignore;
      case
        (fields
           [
             course; values ~sample:false;
             maybe "leaves" (list Bodies.format) (fun (r, _) -> r.leaves)
               ~about:
                 "Where they are put together in another way than those of the document, as that depends on \
                  parameters.";
             maybe "sample" (constant (`Bool true)) (fun (r, _) -> if r.sample then Some () else None)
               ~about:"A run from a start in the drawing of regions.";
             values ~sample:true;
             maybe "contrast" natural (fun (r, _) -> r.contrast)
               ~about:
                 "A run that does otherwise than the one before it in the list, which a check has: so many steps \
                  at their beginning are the same.";
           ])
        (fun r -> Option.map (fun c -> (r, c)) r.course)
        ignore;
    ]
  |> Rows.named "run"

let run name check course = { name; check; course; values = []; leaves = None; sample = false; contrast = None }
let none ~name about = run name (Some about) None

let with_leaves (tables : Tables.t) ~of_document own (run : t) =
  let own, all =
    let leaves = Bodies.leaves ~solids:tables.solids in
    (leaves own, leaves of_document)
  in
  let line leaves = Json.line Json_format.(write (list Bodies.format) leaves) in
  if String.equal (line own) (line all) then run else { run with leaves = Some own }

let about run check ~ending =
  { run with check = Some check; course = Option.map (fun c -> { c with ending }) run.course }

(* {1 Steps} *)

(* The states of a run, each with what was possible there. *)
let follow states world ~most ~tail (n, state) steps =
  let one (n, state, told) (s : step) =
    ignore (Graph.expand states world ~most (n, state));
    let d = Transition.duration_of s.label in
    let target = States.after world (n, state) d s.after in
    let label = States.label world s.label in
    (target, s.after, { choice = s.choice; label; target; rules = s.rules; tail } :: told)
  in
  let n, state, told = List.fold_left one (n, state, []) steps in
  (n, state, List.rev told)

(* {1 After the last step} *)

(* In a network that rests, what spins goes from turn to turn: they are told one by one, and no more than this. *)
let most_turns = 32
let most_turns_until = 1000

let rec turns semantics state left count =
  let turn = Array.to_list state.State.processes |> List.filter_map Turn.left in
  match turn with
  | d :: more when count > 0 && Rat.sign left > 0 ->
    let d = Rat.min left (List.fold_left Rat.min d more) in
    (* The next turns begin. *)
    (match Steer.settle semantics (Time.pass semantics d state) with
     | Error _ -> ([], Rat.zero)
     | Ok { state = after; rules; _ } ->
       let steps, left = turns semantics after (Rat.sub left d) (count - 1) in
       ({ choice = None; label = Time d; rules = Rule.Time :: rules; after } :: steps, left))
  | _ :: _ -> ([], Rat.zero)
  | [] -> ([], left)

let moves (s : State.t) =
  Array.exists
    (fun (p : State.process) -> (not (Vec.is_zero p.velocity)) || not (Vec.is_zero p.spin))
    s.processes


(* How long what moves takes to go about as far as leaves are from each other. *)
let across (s : State.t) =
  let places = List.map (fun (l : State.leaf) -> l.position) (State.leaves s) in
  let along axis =
    let all = List.map (Vec.component axis) places in
    let least, greatest = Rat.span (List.hd all) all in
    Rat.sub greatest least
  in
  let fastest axis =
    Array.fold_left
      (fun v (p : State.process) -> Rat.max v (Rat.abs (Vec.component axis p.velocity)))
      Rat.zero s.processes
  in
  let greatest f = Rat.max (f Vec.X) (Rat.max (f Vec.Y) (f Vec.Z)) in
  let v = greatest fastest in
  if Rat.sign v = 0 then Rat.zero else Rat.div (greatest along) v

(* How long to look on where nothing happens any more, in whole movement steps. *)
let a_while semantics ~over state =
  if not (moves state) then Rat.zero
  else
    let step = (Semantics.model semantics).timestep in
    let most = Rat.mul (Rat.of_int 100) (Rat.add step over) in
    let long = Rat.max (Rat.mul Rat.half over) (Rat.min (across state) most) in
    Rat.mul step (Rat.make (Z.add Z.one (Rat.floor (Rat.div long step))) Z.one)

let finished ?until states world ~most (n, state) ~rests ~over offset =
  let semantics = States.semantics world in
  if rests && (not (States.too_long world state)) && Network.quiescent semantics state then begin
    let wanted, most_turns =
      match until with
      | Some time -> (Rat.max offset (Rat.sub time over), most_turns_until)
      | None -> (Rat.max offset (a_while semantics ~over state), most_turns)
    in
    let steps, left = turns semantics state wanted most_turns in
    let n, state, told = follow states world ~most ~tail:true (n, state) steps in
    ignore (Graph.expand states world ~most (n, state));
    (told, left)
  end
  else begin
    ignore (Graph.expand states world ~most (n, state));
    ([], offset)
  end

(* {1 Runs} *)

let duration steps =
  List.fold_left (fun d s -> Rat.add d (Transition.duration_of s.label)) Rat.zero steps

let follow_to ?until states world ~most ~initial steps ~offset ~rests ~finish =
  let start = States.start world initial in
  let n, state, told = follow states world ~most ~tail:false (start, initial) steps in
  let tail, rest = finished ?until states world ~most (n, state) ~rests ~over:(duration steps) offset in
  { start; steps = told @ tail; rest; finish; cycle = None; facts = []; argument = None; ending = [] }

let of_witness states world ~most ~name check (w : Witness.t) =
  let model = Semantics.model (States.semantics world) in
  let step (s : Witness.step) =
    {
      choice = Some s.choice;
      label = s.transition.label;
      rules = s.transition.rules;
      after = s.transition.target;
    }
  in
  let cycle =
    match w.finish with
    | Repeats { cycle; _ } | Goes_on { cycle } -> Some cycle
    | At_state | During _ | Rests _ | Stops | Passes _ -> None
  in
  let rests = match w.finish with Rests _ -> true | _ -> false in
  let offset = Option.value (Witness.offset w) ~default:Rat.zero in
  let values = Option.fold ~none:[] ~some:(fun (f : Witness.fixed) -> f.values) w.fixed in
  let course =
    follow_to states world ~most ~initial:w.initial (List.map step w.steps) ~offset ~rests
      ~finish:(Witness_json.finish w)
  in
  (* The reasons are a member of their own. *)
  let ending = Witness.ending model { w with argument = None } in
  { (run name check (Some { course with cycle; facts = w.facts; argument = w.argument; ending })) with values }

let of_steps ?until states world ~most ~name ~initial steps ~offset ~finish ~ending =
  let rests = String.equal finish "quiescent" in
  let course = follow_to ?until states world ~most ~initial steps ~offset ~rests ~finish in
  run name None (Some { course with ending })
