open Scc_exact
open Scc_semantics

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
  | Stopped Memory -> "the limit of memory was met"
  | Stopped (Interrupted | Seconds) -> "it was interrupted"
  | Fault fault -> (Transition.diagnostic m fault).message

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
    @ [ Printf.sprintf "… %s" (Scc_base.Plural.count (n - most_shown) "more" "more") ]

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
      let met = Scc_base.Plural.count (Recorded.events t.trace) "event" "events" in
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
          (Scc_base.Plural.count (List.length choices) "transition" "transitions")
          (Number.short ended);
      ]
      @ off
      @ if widest > 1 then [ Printf.sprintf "  it could be in %d states at once" widest ] else []
    | Diverges d -> divergence_text t d
    | Undecided { reason = why; items } ->
      [
        Printf.sprintf "%s: undecided after %d of %s: %s" t.trace.name items
          (Scc_base.Plural.count (Array.length t.trace.items) "item" "items")
          (reason t.loaded.model why);
      ]
  in
  String.concat "" (List.map (fun l -> Scc_base.Visible.line l ^ "\n") lines)
