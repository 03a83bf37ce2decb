open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_explain
open Scc_json
open Scc_reports

type about = { formula : string; verdict : string; text : string }

type step = { choice : int option; label : Transition.label; rules : Rule.t list; after : State.t }

let about a =
  `Assoc
    [ ("formula", Json.text a.formula); ("verdict", `String a.verdict); ("text", Json.text a.text) ]

let named name = ("name", Json.text name)
let none ~name a = `Assoc [ named name; ("check", about a); ("start", `Null) ]

(* {1 Steps} *)

let step_json ~tail (s : step) ~label ~target =
  `Assoc
    ([
      ("choice", Json.option (fun k -> `Int k) s.choice);
      ("label", `Int label);
      ("to", `Int target);
      ("rules", States.rules s.rules);
    ]
      @ if tail then [ ("tail", `Bool true) ] else [])

(* The states of a run, each with what was possible there. *)
let follow states world ~most ~tail (n, state) steps =
  let one (n, state, told) (s : step) =
    ignore (Graph.expand states world ~most (n, state));
    let d = Transition.duration_of s.label in
    let target = States.after world (n, state) d s.after in
    let label = States.label world s.label in
    (target, s.after, step_json ~tail s ~label ~target :: told)
  in
  let n, state, told = List.fold_left one (n, state, []) steps in
  (n, state, List.rev told)

(* {1 After the last step} *)

(* In a network that rests, what spins goes from turn to turn: they are told one by one, and no more than this. *)
let most_turns = 32

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

let finished states world ~most (n, state) ~rests ~over offset =
  let semantics = States.semantics world in
  if rests && Network.quiescent semantics state then begin
    ignore (Graph.expand states world ~most (n, state));
    let wanted = Rat.max offset (a_while semantics ~over state) in
    let steps, left = turns semantics state wanted most_turns in
    let _, _, told = follow states world ~most ~tail:true (n, state) steps in
    (told, left)
  end
  else begin
    ignore (Graph.expand states world ~most (n, state));
    ([], offset)
  end

(* {1 Runs} *)

let duration steps =
  List.fold_left (fun d s -> Rat.add d (Transition.duration_of s.label)) Rat.zero steps

let run states world ~most ~name check ~initial steps ~offset ~rests ~finish more =
  let start = States.start world initial in
  let n, state, told = follow states world ~most ~tail:false (start, initial) steps in
  let tail, rest = finished states world ~most (n, state) ~rests ~over:(duration steps) offset in
  `Assoc
    ([
      named name;
      ("check", Json.option about check);
      ("start", `Int start);
      ("steps", `List (told @ tail));
      ("rest", Json.rat rest);
      ("finish", `String finish);
    ]
      @ more)

let lines list = `List (List.map Json.text list)

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
    | Repeats { cycle; _ } | Goes_on { cycle } -> `Int cycle
    | At_state | During _ | Rests _ | Stops | Passes _ -> `Null
  in
  let rests = match w.finish with Rests _ -> true | _ -> false in
  let offset = Option.value (Witness.offset w) ~default:Rat.zero in
  let values =
    match w.fixed with
    | None | Some { values = []; _ } -> []
    | Some f -> [ ("values", `Assoc (List.map (fun (name, v) -> (name, Json.rat v)) f.values)) ]
  in
  run states world ~most ~name check ~initial:w.initial (List.map step w.steps) ~offset ~rests
    ~finish:(Witness_json.finish w)
    ([
      ("cycle", cycle);
      ("facts", lines w.facts);
      ("argument", Json.option (Json_format.write Witness_json.argument_format) w.argument);
      ("ending", lines (Witness.ending model w));
    ]
      @ values)

let of_steps states world ~most ~name check ~initial steps ~offset ~finish ~ending =
  run states world ~most ~name check ~initial steps ~offset ~rests:(String.equal finish "quiescent") ~finish
    [ ("cycle", `Null); ("facts", lines []); ("argument", `Null); ("ending", lines ending) ]
