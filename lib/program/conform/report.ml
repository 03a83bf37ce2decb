open Scc_exact
open Scc_semantics
open Scc_json
open Scc_runs

type t = {
  file : string;
  loaded : Scc_loading.Loaded.t;
  trace : Recorded.t;
  tolerance : Rat.t;
  answer : Verdict.answer;
}

let source_line (i : Recorded.item) = Printf.sprintf "line %d, time %s" i.line (Number.short i.time)

let reason m : Trace_search.reason -> string = function
  | Too_many_states -> "more states than the limit would have to be looked at (--states)"
  | Interrupted -> "it was interrupted"
  | Fault fault -> (Transition.diagnostic m fault).message

(* {1 For people} *)

let plural n one many = if n = 1 then "1 " ^ one else Printf.sprintf "%d %s" n many

let happened (i : Recorded.item) =
  match i.what with
  | Event e -> Recorded.event_text e
  | State ([], None) | Watched -> "nothing more up to this time"
  | State _ -> "a state"
  | Quiescent -> "nothing will ever happen again"
  | Stuck -> "nothing can happen, not even the passing of time"

let allowed_text t (a : Divergence.allowed) =
  Printf.sprintf "%s at time %s   {%s}"
    (Transition.label_to_string t.loaded.model a.label)
    (Number.short a.time)
    (String.concat ", " (List.map Rule.id a.rules))

let most_shown = 6

let some_of lines =
  let n = List.length lines in
  if n <= most_shown then lines
  else
    List.filteri (fun i _ -> i < most_shown) lines
    @ [ Printf.sprintf "… %s" (plural (n - most_shown) "more" "more") ]

let difference_text (d : Against.difference) =
  let number text = match Rat.of_literal text with Ok q -> Number.short q | Error _ -> text in
  let shown text = if Option.is_some d.off then number text else text in
  Printf.sprintf "%s%s: %s in the trace, %s expected"
    (if d.body = "" then "" else d.body ^ ": ")
    d.quantity (shown d.told) (shown d.held)

let divergence_text t (d : Divergence.t) =
  let section title = function
    | [] -> []
    | lines -> ("  " ^ title) :: List.map (fun l -> "    " ^ l) (some_of lines)
  in
  [
    Printf.sprintf "%s: diverges at %s: %s" t.trace.name (source_line d.item) (Divergence.kind_name d.kind);
    "  the trace: " ^ happened d.item;
    "  " ^ d.why;
    "  rules: " ^ String.concat ", " d.rules;
  ]
  @ section "what differs:" (List.map difference_text d.differences)
  @ section "allowed there:" (List.map (allowed_text t) d.allowed)
  @ (match d.after with Some a -> [ "  after: " ^ allowed_text t a ] | None -> [])

let text t =
  let lines =
    match t.answer with
    | Conforms { choices; ended; deviation; widest } ->
      let met = plural (Recorded.events t.trace) "event" "events" in
      let off =
        if Rat.sign t.tolerance = 0 then []
        else
          [
            Printf.sprintf "  off by at most %s in time, %s in position, %s in velocity (tolerance %s)"
              (Number.short deviation.time) (Number.short deviation.position)
              (Number.short deviation.velocity) (Number.short t.tolerance);
          ]
      in
      [
        Printf.sprintf "%s: conforms: %s, a run of %s up to time %s" t.trace.name met
          (plural (List.length choices) "transition" "transitions")
          (Number.short ended);
      ]
      @ off
      @ if widest > 1 then [ Printf.sprintf "  it could be in %d states at once" widest ] else []
    | Diverges d -> divergence_text t d
    | Undecided { reason = why; items } ->
      [
        Printf.sprintf "%s: undecided after %d of %s: %s" t.trace.name items
          (plural (Array.length t.trace.items) "item" "items")
          (reason t.loaded.model why);
      ]
  in
  String.concat "" (List.map (fun l -> Scc_base.Visible.line l ^ "\n") lines)

(* {1 JSON} *)

let texts l = `List (List.map Json.text l)

(* Decimals are texts, too: a reader that wants floats makes its own. *)
let about q = `Assoc [ ("exact", Json.rat q); ("about", `String (Number.decimal q)) ]

let event_json (e : Recorded.event) =
  `Assoc
    [
      ("kind", `String (Recorded.kind_name e.kind));
      ("channels", texts e.channels);
      ("bodies", texts e.bodies);
      ("features", texts e.features);
    ]

let item_json (i : Recorded.item) =
  let what, event =
    match i.what with
    | Event e -> ("event", event_json e)
    | State _ -> ("state", `Null)
    | Watched -> ("end", `Null)
    | Quiescent -> ("quiescent", `Null)
    | Stuck -> ("stuck", `Null)
  in
  `Assoc
    [ ("line", `Int i.line); ("time", about i.time); ("what", `String what); ("event", event) ]

let allowed_json t (a : Divergence.allowed) =
  `Assoc
    [
      ("label", State_json.label t.loaded.model a.label);
      ("rules", `List (List.map (fun r -> `String (Rule.id r)) a.rules));
      ("time", about a.time);
    ]

let difference_json (d : Against.difference) =
  `Assoc
    [
      ("body", Json.option Json.text (if d.body = "" then None else Some d.body));
      ("quantity", `String d.quantity);
      ("told", Json.text d.told);
      ("expected", Json.text d.held);
      ("off", Json.option about d.off);
    ]

let divergence_json t (d : Divergence.t) =
  let option = Json.option (allowed_json t) in
  `Assoc
    [
      ("kind", `String (Divergence.kind_name d.kind));
      ("at", item_json d.item);
      ("rules", texts d.rules);
      ("why", Json.text d.why);
      ("closest", option d.closest);
      ("off", Json.option about d.off);
      ("differences", `List (List.map difference_json d.differences));
      ("allowed", `List (List.map (allowed_json t) d.allowed));
      ("after", option d.after);
    ]

let verdict = function
  | Verdict.Conforms _ -> "conforms"
  | Diverges _ -> "diverges"
  | Undecided _ -> "undecided"

let run_json = function
  | Verdict.Conforms { choices; ended; deviation; widest } ->
    `Assoc
      [
        ("transitions", `Int (List.length choices));
        ("time", about ended);
        ("states", `Int widest);
        ( "deviation",
          `Assoc
            [
              ("time", about deviation.time);
              ("position", about deviation.position);
              ("velocity", about deviation.velocity);
            ] );
      ]
  | Diverges _ | Undecided _ -> `Null

let json t ~exit ~diagnostics =
  let divergence = match t.answer with Diverges d -> divergence_json t d | _ -> `Null in
  let why =
    match t.answer with
    | Undecided { reason = r; _ } -> Json.text (reason t.loaded.model r)
    | Conforms _ | Diverges _ -> `Null
  in
  `Assoc
    [
      ("format", `String "scc-conform");
      ("version", `Int 1);
      ("semantics", `String Scc_calculus.Parameters.version);
      ("verdict", `String (verdict t.answer));
      ("exit", `Int exit);
      ( "model",
        `Assoc
          [
            ("file", Json.text t.file);
            ("name", Json.option Json.text t.loaded.origin.name);
            ("digest", `String t.loaded.origin.digest);
            ("parameters", Origin_json.parameters t.loaded.origin);
            ("settings", Origin_json.settings t.loaded.origin);
          ] );
      ( "trace",
        `Assoc
          [
            ("file", Json.text t.trace.name);
            ("format", `String t.trace.format);
            ("events", `Int (Recorded.events t.trace));
            ("items", `Int (Array.length t.trace.items));
          ] );
      ("tolerance", about t.tolerance);
      ("run", run_json t.answer);
      ("divergence", divergence);
      ("reason", why);
      ("diagnostics", `List diagnostics);
    ]
