open Scc_base
open Scc_exact
open Scc_semantics
open Scc_json
open Scc_runs
open Json_format

let label_text = Transition.label_to_string

let one_of choices =
  let chosen _ at s =
    match List.assoc_opt s choices with
    | Some x -> x
    | None -> Fault.invalid at "one of these is expected: %s" (String.concat ", " (List.map fst choices))
  in
  { (Read.map chosen Read.text) with schema = Constant (List.map (fun (word, _) -> `String word) choices) }

let place_members =
  all
    [
      field "path" Answers.path (fun (p : Network_at.place) -> Array.to_list p.path);
      field "time" Shared.rational (fun (p : Network_at.place) -> p.time);
    ]

let taken_members =
  all
    [
      field "choice" natural (fun (_, choice, _) -> choice);
      field "label" State_json.label_format (fun (m, _, (t : Transition.t)) -> (m, t.label));
      field "rules" Answers.rules (fun (_, _, (t : Transition.t)) -> t.rules);
    ]

(* {1 successors} *)

type states = Here | Every | Neither

let totals =
  fields
    [
      field "momentum" Shared.vector (fun (t : Scc_engine.Totals.t) -> t.momentum);
      field "angular" Shared.vector (fun (t : Scc_engine.Totals.t) -> t.angular);
      field "energy" Shared.rational (fun (t : Scc_engine.Totals.t) -> t.energy);
    ]
  |> Answers.named "totals"

let successors_format =
  let target ((m, _, (t : Transition.t)), states) = if states = Every then Some (m, t.target) else None in
  let rounded ((m, _, t), _) = Option.map Lazy.force (Scc_engine.Totals.added m t) in
  let transition =
    fields
      [
        within fst taken_members;
        State_json.tie_chance (fun ((_, _, (t : Transition.t)), _) -> (t.label, t.chance));
        maybe "rounded" totals rounded;
        maybe "state" State_json.state_format target;
      ]
  in
  let here (network, (place : Network_at.place), states, _) =
    if states = Neither then None else Some (Network_at.model network, place.state)
  in
  let transitions (network, _, states, next) =
    List.mapi (fun choice t -> ((Network_at.model network, choice, t), states)) next
  in
  let ending (network, (place : Network_at.place), _, next) =
    if next <> [] then None
    else if Network.quiescent (Network_at.semantics network) place.state then Some "quiescent"
    else Some "stuck"
  in
  fields
    [
      within (fun (_, place, _, _) -> place) place_members;
      field "state" (nullable State_json.state_format) here;
      field "transitions" (list transition) transitions;
      field "ending" (nullable (word Fun.id [ "quiescent"; "stuck" ])) ending;
    ]

let successors =
  let states = Read.member "states" (one_of [ ("here", Here); ("all", Every); ("none", Neither) ]) in
  let params = Read.[ needs Models.handle; may Models.along; may states; Method.limits ] in
  let work store p =
    let { Models.network; _ } = Models.model store p in
    let states = Option.value (Read.optional p states) ~default:Here in
    let place = Models.path p network in
    (network, place, states, Network_at.next network place)
  in
  Method.make "successors" params successors_format work

(* {1 step} *)

let shown s = if String.length s <= 200 then s else "a long label"

let index_of m next label =
  let rec from i = function
    | [] -> None
    | (t : Transition.t) :: rest ->
      if String.equal label (label_text m t.label) then Some i else from (i + 1) rest
  in
  from 0 next

let chosen m next (place : Network_at.place) at : Wire.t -> int = function
  | Text label -> (
      match index_of m next label with
      | Some i -> i
      | None ->
        let message = Printf.sprintf "`%s` is not possible here" (shown label) in
        Fault.refuse (Not_possible { at = Array.length place.path; possible = Network_at.labels m next; message }))
  | _ -> Fault.invalid at "an index or the text of a label is expected"

let step =
  let choice =
    Read.member "choice" (Read.value (Any_of [ Read.natural.schema; Read.text.schema ]))
  in
  let params = Read.[ needs Models.handle; may Models.along; needs choice; Method.limits ] in
  let result =
    fields
      [
        within fst taken_members; within snd place_members;
        field "state" State_json.state_format (fun ((m, _, _), (after : Network_at.place)) -> (m, after.state));
      ]
  in
  let work store p =
    let { Models.network; _ } = Models.model store p in
    let m = Network_at.model network and place = Models.path p network in
    let next = Network_at.next network place in
    let at = Read.place p choice in
    let choice =
      match Read.required p choice with
      | Number _ as v -> Read.natural.value p at v
      | v -> chosen m next place at v
    in
    let after = Network_at.follow network (Array.append place.path [| choice |]) in
    ((m, choice, List.nth next choice), after)
  in
  Method.make "step" params result work

(* {1 replay} *)

let choice =
  let index = Read.member "choice" Read.natural and label = Read.member "label" Read.text in
  let both = Read.fields Read.[ may index; may label ] in
  let some = ("minProperties", `Int 1) in
  let schema = Json_schema.Any_of [ Read.natural.schema; Read.text.schema; Also ([ some ], both.schema) ] in
  Read.reader schema (fun p at v : Schedule.choice ->
      match v with
      | Number _ -> { index = Some (Read.natural.value p at v); label = None; at = Span.none }
      | Text label -> { index = None; label = Some label; at = Span.none }
      | Object _ ->
        let p = both.value p at v in
        let index = Read.optional p index and label = Read.optional p label in
        if Option.is_none index && Option.is_none label then
          Fault.invalid at "`choice` or `label` is needed"
        else { index; label; at = Span.none }
      | Null | Bool _ | List _ -> Fault.invalid at "an index, a label or an object is expected")

let choices = Read.member "choices" (Read.short_list choice ~limit:"steps" (fun q -> q.steps))
let offset = Read.member "offset" Read.not_negative

let choose =
  Read.member "choose"
    (Models.word_or_seed "first" ~simple:Replay.First ~random:(fun seed -> Replay.Random seed))

let steps = Read.member "steps" Read.natural
let time = Read.member "time" Read.not_negative

let policy p : Replay.policy =
  let choices = Read.optional p choices in
  let offset = Read.optional p offset in
  match (choices, Read.optional p choose) with
  | Some choices, None ->
    Scheduled
      {
        model = None;
        check = None;
        digest = None;
        parameters = [];
        choices;
        offset;
        offset_at = Span.none;
      }
  | None, Some policy ->
    if Option.is_some offset then Fault.invalid (Member "offset") "it goes with `choices` only";
    policy
  | None, None -> Fault.invalid (Member "choices") "either `choices` or `choose` is needed"
  | Some _, Some _ -> Fault.invalid (Member "choose") "it does not go with `choices`"

let limits p (policy : Replay.policy) : Replay.limits =
  let most = (Read.quotas p).steps in
  let given = Read.optional p steps in
  Option.iter (fun n -> if n > most then Fault.refuse (Limit ("steps", most))) given;
  let time = Read.optional p time in
  let steps =
    match (given, policy) with
    | Some n, _ -> Some n
    | None, Scheduled _ -> None
    | None, (First | Random _) -> Some Replay.default_steps
  in
  { steps; time; instant = Replay.default_instant }

(* The lines so far, the last one first; choices, likewise; and how it ended. *)
type told = {
  mutable lines : string list;
  mutable bytes : int;
  mutable taken : int list;
  mutable finish : (int * Rat.t * Replay.ending) option;
}

let tell (q : Quotas.t) told json =
  let line = Json.line json in
  told.bytes <- told.bytes + String.length line + 1;
  if told.bytes > q.reply_bytes then Fault.refuse (Limit ("reply_bytes", q.reply_bytes));
  told.lines <- line :: told.lines

let on_event q m states told (event : Replay.event) =
  (match event with
   | Start _ | Instant _ -> ()
   | Step s -> told.taken <- s.index :: told.taken
   | End e -> told.finish <- Some (e.steps, e.time, e.ending));
  List.iter (tell q told) (Trace.event m states event)

let misfit network told message =
  let place = Network_at.follow network (Array.of_list (List.rev told.taken)) in
  let possible = Network_at.labels (Network_at.model network) (Network_at.next network place) in
  Fault.refuse (Not_possible { at = List.length told.taken; possible; message })

let end_members =
  all
    [
      field "steps" natural (fun (steps, _, _) -> steps);
      field "time" Shared.rational (fun (_, time, _) -> time);
      field "ending" (word Fun.id [ "open"; "quiescent"; "stuck"; "zeno" ]) (fun (_, _, e) -> Trace.ending e);
    ]

let replay =
  let states = Read.member "states" (one_of [ ("all", Trace.All); ("ends", Trace.Ends) ]) in
  let params =
    Read.
      [
        needs Models.handle; may choices; may offset; may choose; may steps; may time; may states; Method.limits;
      ]
  in
  (* The lines are texts already. *)
  let result =
    fields [ field "lines" (list ~least:1 (document ~file:"trace" Trace.format)) (fun _ -> []); end_members ]
  in
  let work store p =
    Read.only p params;
    let { Models.network; model = l } = Models.model store p in
    let policy = policy p in
    let limits = limits p policy and q = Read.quotas p in
    let states = Option.value (Read.optional p states) ~default:Trace.All in
    let told = { lines = []; bytes = 0; taken = []; finish = None } in
    tell q told (Trace.header l.origin);
    let interrupted () = false in
    match Replay.run l.semantics l.declared policy limits ~interrupted (on_event q l.model states told) with
    | Error (Refused d) -> misfit network told d.message
    | Error (Fault f) ->
      let diagnostics = Fault.diagnostics ~source:(fun _ -> None) [ Transition.diagnostic l.model f.fault ] in
      Fault.refuse (No_transitions { at = List.length told.taken; diagnostics })
    | Error (Interrupted _) -> Bug.fail __POS__ "nobody interrupts"
    | Ok _ -> (
        match told.finish with
        | None -> Bug.fail __POS__ "a run without its end"
        | Some finish ->
          let value (name, json) = (name, Reply.Value json) in
          let lines = ("lines", Reply.Printed (List.rev told.lines)) in
          Reply.Fields (lines :: List.map value (written_members end_members finish)))
  in
  { Method.name = "replay"; params; result = schema result; work }
