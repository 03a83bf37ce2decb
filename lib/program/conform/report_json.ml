open Scc_semantics
open Scc_json
open Scc_runs
open Json_format

let in_conform name t = named ~file:"conform" name t

(* Decimals are texts, too: a reader that wants floats makes its own. *)
let about =
  fields [ field "exact" Shared.rational Fun.id; field "about" some_text Number.decimal ]
  |> Json_format.about "A number, and nearly the same as a decimal for people."
  |> in_conform "number"

let event =
  let kinds : Recorded.kind list = [ Bind; Close; Bounce; Absorb; Weak; Strong; Draw ] in
  fields
    [
      field "kind" (word Recorded.kind_name kinds) (fun (e : Recorded.event) -> e.kind);
      field "channels" Shared.texts (fun (e : Recorded.event) -> e.channels);
      field "bodies" Shared.texts (fun (e : Recorded.event) -> e.bodies);
      field "features" Shared.texts (fun (e : Recorded.event) -> e.features);
    ]
  |> Json_format.about "An event as the trace tells it; empty arrays were not told."
  |> in_conform "event"

let event_of (i : Recorded.item) =
  match i.what with Event e -> Some e | State _ | Watched | Quiescent | Stuck -> None

let item =
  let what (i : Recorded.item) =
    match i.what with
    | Event _ -> "event"
    | State _ -> "state"
    | Watched -> "end"
    | Quiescent -> "quiescent"
    | Stuck -> "stuck"
  in
  fields
    [
      field "line" Shared.from_one (fun (i : Recorded.item) -> i.line);
      field "time" about (fun (i : Recorded.item) -> i.time);
      field "what" (word Fun.id [ "event"; "state"; "end"; "quiescent"; "stuck" ]) what;
      field "event" (nullable event) event_of;
    ]

let allowed =
  fields
    [
      field "label" State_json.label_format (fun (m, (a : Divergence.allowed)) -> (m, a.label));
      field "rules" (list ~least:1 text) (fun (_, (a : Divergence.allowed)) -> List.map Rule.id a.rules);
      field "time" about (fun (_, (a : Divergence.allowed)) -> a.time);
    ]
  |> Json_format.about "A transition of the model, and the time after it."
  |> in_conform "allowed"

let difference =
  fields
    [
      field "body" (nullable text) (fun (d : Against.difference) -> if d.body = "" then None else Some d.body);
      field "quantity" some_text (fun (d : Against.difference) -> d.quantity);
      field "told" text (fun (d : Against.difference) -> d.told);
      field "expected" text (fun (d : Against.difference) -> d.held);
      field "off" (nullable about) (fun (d : Against.difference) -> d.off)
        ~about:"Told less expected, of numbers.";
    ]

let divergence =
  let part f (_, (d : Divergence.t)) = f d in
  let one f (m, d) = Option.map (fun a -> (m, a)) (f d) in
  let many (m, (d : Divergence.t)) = List.map (fun a -> (m, a)) d.allowed in
  fields
    [
      field "kind" (word Divergence.kind_name Divergence.all) (part (fun d -> d.kind));
      field "at" item (part (fun d -> d.item)) ~about:"Where in the trace.";
      field "rules" (list ~least:1 some_text) (part (fun d -> d.rules))
        ~about:"Entries of the rule book that are not kept, the most telling one first.";
      field "why" some_text (part (fun d -> d.why));
      field "closest" (nullable allowed) (one (fun (d : Divergence.t) -> d.closest))
        ~about:"The allowed event that is most like it.";
      field "off" (nullable about) (part (fun d -> d.off))
        ~about:"The time in the trace less that of the closest.";
      field "differences" (list difference) (part (fun d -> d.differences))
        ~about:"Of a state, from the run that differs in the fewest things.";
      field "allowed" (list allowed) many
        ~about:"Events that were allowed there or next, in order of time; some of them when they are many.";
      field "after" (nullable allowed) (one (fun (d : Divergence.t) -> d.after))
        ~about:"The latest transition before it; null at the start.";
    ]
  |> in_conform "divergence"

let run =
  let deviation =
    fields
      [
        field "time" about (fun (d : Against.deviation) -> d.time);
        field "position" about (fun (d : Against.deviation) -> d.position);
        field "velocity" about (fun (d : Against.deviation) -> d.velocity);
      ]
  in
  fields
    [
      field "transitions" natural (fun (choices, _, _, _) -> List.length choices);
      field "time" about (fun (_, ended, _, _) -> ended) ~about:"Of its last transition.";
      field "states" Shared.from_one (fun (_, _, widest, _) -> widest)
        ~about:"How many states of the model the trace could be in at once, at most.";
      field "deviation" deviation (fun (_, _, _, off) -> off) ~about:"By how much the trace is off at most.";
    ]

let model =
  let origin (t : Report.t) = t.loaded.origin in
  fields
    [
      field "file" text (fun (t : Report.t) -> t.file);
      field "name" (nullable text) (fun t -> (origin t).name);
      within origin Origin_json.identity;
    ]

let trace_fields =
  [
    field "file" text (fun (t : Recorded.t) -> t.name);
    field "format" (word Fun.id [ "jsonl"; "csv" ]) (fun (t : Recorded.t) -> t.format);
  ]

let trace =
  let items (t : Recorded.t) = Array.length t.items in
  fields
    (trace_fields
     @ [
       field "events" natural Recorded.events; field "items" natural items ~about:"Events, states and claims.";
     ])

let verdict = function
  | Verdict.Conforms _ -> "conforms"
  | Diverges _ -> "diverges"
  | Undecided _ -> "undecided"

let format =
  let of_run (t : Report.t) =
    match t.answer with
    | Conforms { choices; ended; deviation; widest } -> Some (choices, ended, widest, deviation)
    | Diverges _ | Undecided _ -> None
  in
  let of_divergence (t : Report.t) = match t.answer with Diverges d -> Some (t.loaded.model, d) | _ -> None in
  let why (t : Report.t) =
    match t.answer with
    | Undecided { reason = r; _ } -> Some (Report.reason t.loaded.model r)
    | Conforms _ | Diverges _ -> None
  in
  let verdicts = word Fun.id [ "conforms"; "diverges"; "undecided" ] in
  let of_report part = within (fun (t, _, _) -> t) part in
  fields
    (Shared.head "scc-conform" 1
     @ [
       Shared.semantics ();
       of_report (field "verdict" verdicts (fun (t : Report.t) -> verdict t.answer));
       field "exit" Shared.exit (fun (_, exit, _) -> exit);
       of_report (field "model" model Fun.id);
       of_report (field "trace" trace (fun (t : Report.t) -> t.trace));
       of_report (field "tolerance" about (fun (t : Report.t) -> t.tolerance));
       of_report (field "run" (nullable run) of_run ~about:"A run that the trace is of, when it conforms.");
       of_report
         (field "divergence" (nullable divergence) of_divergence
            ~about:"The first thing in the trace that no run does.");
       of_report (field "reason" (nullable text) why ~about:"Why it is undecided.");
       field "diagnostics" Diag_json.formats (fun (_, _, diagnostics) -> diagnostics);
     ])

let json t ~exit ~source ~diagnostics = write format (t, exit, (source, diagnostics))
