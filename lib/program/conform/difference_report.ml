open Scc_exact

let line = Report.source_line

let event (i : Recorded.item) =
  match i.what with Event e -> Recorded.event_text e | _ -> Scc_base.Bug.fail __POS__ "no event"

let number told off =
  match (off, Rat.of_literal told) with
  | Some _, Ok q -> Number.short q
  | _ -> told

let set l = "{" ^ String.concat ", " l ^ "}"

let lines (a : Recorded.t) (b : Recorded.t) : Difference.t -> string list = function
  | Header { what; first; second } ->
    [
      Printf.sprintf "the traces differ in the %s: they are not of one model" what;
      Printf.sprintf "  %s: %s" a.name first;
      Printf.sprintf "  %s: %s" b.name second;
    ]
  | Event { number; first; second; what } ->
    let title =
      match what with
      | Label -> "is another"
      | Time off ->
        Printf.sprintf "is %s %s in the second" (Number.short (Rat.abs off))
          (if Rat.sign off > 0 then "later" else "earlier")
      | Choice (m, n) -> Printf.sprintf "is another choice: %d, and %d in the second" m n
      | Rules (r, s) -> Printf.sprintf "is by other rules: %s, and %s in the second" (set r) (set s)
    in
    [
      Printf.sprintf "the traces differ: event %d %s" number title;
      Printf.sprintf "  %s, %s: %s" a.name (line first) (event first);
      Printf.sprintf "  %s, %s: %s" b.name (line second) (event second);
    ]
  | More { side; number; item } ->
    let who, other = match side with First -> (a.name, b.name) | Second -> (b.name, a.name) in
    [
      Printf.sprintf "the traces differ: only one has an event %d" number;
      Printf.sprintf "  %s, %s: %s" who (line item) (event item);
      Printf.sprintf "  %s: nothing more" other;
    ]
  | State { first; second; events; body; quantity; told = one, two; off } ->
    [
      Printf.sprintf "the traces differ: %s, %s of %s%s"
        (match events with
         | 0 -> "before any event"
         | 1 -> "after 1 event"
         | n -> Printf.sprintf "after %d events" n)
        quantity body
        (match off with Some q -> Printf.sprintf ", by %s" (Number.short (Rat.abs q)) | None -> "");
      Printf.sprintf "  %s, %s: %s" a.name (line first) (number one off);
      Printf.sprintf "  %s, %s: %s" b.name (line second) (number two off);
    ]
  | Ending { first; second; quantity; told = one, two; off } ->
    [
      (match off with
       | Some q ->
         Printf.sprintf "the traces differ in the %s at which they end, by %s" quantity (Number.short (Rat.abs q))
       | None -> "the traces differ in how they say that they end");
      Printf.sprintf "  %s, line %d: %s" a.name first.line (number one off);
      Printf.sprintf "  %s, line %d: %s" b.name second.line (number two off);
    ]

let text (a : Recorded.t) (b : Recorded.t) = function
  | None ->
    let n = Recorded.events a in
    Printf.sprintf "the traces are the same: %s\n" (Scc_base.Plural.count n "event" "events")
  | Some d -> String.concat "" (List.map (fun l -> Scc_base.Visible.line l ^ "\n") (lines a b d))
