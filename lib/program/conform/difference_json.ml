open Scc_exact
open Scc_json
open Scc_runs
open Json_format

let item =
  fields
    [
      field "line" Shared.from_one (fun (i : Recorded.item) -> i.line);
      field "time" Report_json.about (fun (i : Recorded.item) -> i.time);
      field "event" (nullable Report_json.event) Report_json.event_of;
    ]
  |> nullable |> named ~file:"diff" "item"

(* The same members for all kinds; what does not apply is null. *)
type parts = {
  kind : string;
  count : int option;
  items : Recorded.item option * Recorded.item option;
  body : string option;
  quantity : string option;
  values : (string * string) option;
  off : Rat.t option;
}

let kinds = [ "header"; "event"; "time"; "choice"; "rules"; "more"; "state"; "ending" ]

let parts (d : Difference.t) =
  let none =
    { kind = ""; count = None; items = (None, None); body = None; quantity = None; values = None; off = None }
  in
  match d with
  | Header { what; first; second } ->
    { none with kind = "header"; quantity = Some what; values = Some (first, second) }
  | Event { number; first; second; what } -> (
      let event = { none with kind = "event"; count = Some number; items = (Some first, Some second) } in
      match what with
      | Label -> event
      | Time off ->
        let values = Some (Json.fraction first.time, Json.fraction second.time) in
        { event with kind = "time"; values; off = Some off }
      | Choice (m, n) -> { event with kind = "choice"; values = Some (string_of_int m, string_of_int n) }
      | Rules (r, s) ->
        { event with kind = "rules"; values = Some (Difference_report.set r, Difference_report.set s) })
  | More { side; number; item } ->
    let items = match side with First -> (Some item, None) | Second -> (None, Some item) in
    { none with kind = "more"; count = Some number; items }
  | State { first; second; events; body; quantity; told; off } ->
    {
      kind = "state"; count = Some events; items = (Some first, Some second); body = Some body;
      quantity = Some quantity; values = Some told; off;
    }
  | Ending { first; second; quantity; told; off } ->
    let items = (Some first, Some second) in
    { none with kind = "ending"; items; quantity = Some quantity; values = Some told; off }

let difference =
  let told p = match p.values with None -> [ None; None ] | Some (one, two) -> [ Some one; Some two ] in
  fields
    [
      field "kind" (word Fun.id kinds) (fun p -> p.kind)
        ~about:
          "Of the header; which event, its time, its choice, its rules; an event that only one has; a state; \
           how they end.";
      field "event" (nullable (integer ())) (fun p -> p.count)
        ~about:"The number of the event, from 1; for a state, that of the event before it, or 0.";
      field "first" item (fun p -> fst p.items);
      field "second" item (fun p -> snd p.items);
      field "body" (nullable text) (fun p -> p.body);
      field "quantity" (nullable text) (fun p -> p.quantity)
        ~about:
          "Of a body (time: when it is told of; name: another body is told of), of the header, or of the end \
           (time, claim).";
      field "told" (list ~least:2 ~most:2 (nullable text)) told ~about:"What the first and the second say.";
      field "off" (nullable Report_json.about) (fun p -> p.off) ~about:"The second less the first, of numbers.";
    ]

let side =
  fields
    (Report_json.trace_fields
     @ [
       field "digest" (nullable text) (fun (t : Recorded.t) -> Option.map fst t.digest);
       field "events" natural Recorded.events;
     ])
  |> named ~file:"diff" "side"

type t = {
  first : Recorded.t;
  second : Recorded.t;
  tolerance : Rat.t;
  exit : int;
  found : Difference.t option;
}

let format =
  let verdict t = if Option.is_none t.found then "same" else "different" in
  fields
    (Shared.head "scc-diff" 1
     @ [
       field "verdict" (word Fun.id [ "same"; "different" ]) verdict;
       field "exit" Shared.exit (fun t -> t.exit);
       field "tolerance" Report_json.about (fun t -> t.tolerance);
       field "first" side (fun t -> t.first);
       field "second" side (fun t -> t.second);
       field "difference" (nullable difference) (fun t -> Option.map parts t.found)
         ~about:"The first one; null when there is none.";
       field "diagnostics" Diag_json.formats (fun _ -> ((fun _ -> None), []));
     ])

let json first second ~tolerance ~exit found = write format { first; second; tolerance; exit; found }
