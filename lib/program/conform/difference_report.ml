open Scc_exact
open Scc_json

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
    Printf.sprintf "the traces are the same: %s\n" (if n = 1 then "1 event" else Printf.sprintf "%d events" n)
  | Some d -> String.concat "" (List.map (fun l -> Scc_base.Visible.line l ^ "\n") (lines a b d))

let item_json (i : Recorded.item) =
  `Assoc
    [
      ("line", `Int i.line);
      ("time", Report.about i.time);
      ("event", match i.what with Event e -> Report.event_json e | _ -> `Null);
    ]

(* The same members for all kinds; what does not apply is null. *)
let difference_json (d : Difference.t) =
  let texts l = `String (set l) in
  let kind, count, items, body, quantity, values, off =
    match d with
    | Header { what; first; second } ->
      ("header", None, (None, None), None, Some what, Some (Json.text first, Json.text second), None)
    | Event { number; first; second; what } ->
      let at = (Some first, Some second) in
      (match what with
       | Label -> ("event", Some number, at, None, None, None, None)
       | Time off ->
         ("time", Some number, at, None, None, Some (Json.rat first.time, Json.rat second.time), Some off)
       | Choice (m, n) ->
         let text n = `String (string_of_int n) in
         ("choice", Some number, at, None, None, Some (text m, text n), None)
       | Rules (r, s) -> ("rules", Some number, at, None, None, Some (texts r, texts s), None))
    | More { side = First; number; item } -> ("more", Some number, (Some item, None), None, None, None, None)
    | More { side = Second; number; item } -> ("more", Some number, (None, Some item), None, None, None, None)
    | State { first; second; events; body; quantity; told = one, two; off } ->
      ( "state", Some events, (Some first, Some second), Some body, Some quantity,
        Some (Json.text one, Json.text two), off )
    | Ending { first; second; quantity; told = one, two; off } ->
      ("ending", None, (Some first, Some second), None, Some quantity, Some (Json.text one, Json.text two), off)
  in
  let value side = match values with Some v -> side v | None -> `Null in
  `Assoc
    [
      ("kind", `String kind);
      ("event", Json.option (fun n -> `Int n) count);
      ("first", Json.option item_json (fst items));
      ("second", Json.option item_json (snd items));
      ("body", Json.option Json.text body);
      ("quantity", Json.option Json.text quantity);
      ("told", `List [ value fst; value snd ]);
      ("off", Json.option Report.about off);
    ]

let side (t : Recorded.t) =
  `Assoc
    [
      ("file", Json.text t.name);
      ("format", `String t.format);
      ("digest", Json.option (fun (d, _) -> Json.text d) t.digest);
      ("events", `Int (Recorded.events t));
    ]

let json a b ~tolerance ~exit found =
  `Assoc
    [
      ("format", `String "scc-diff");
      ("version", `Int 1);
      ("verdict", `String (if Option.is_none found then "same" else "different"));
      ("exit", `Int exit);
      ("tolerance", Report.about tolerance);
      ("first", side a);
      ("second", side b);
      ("difference", Json.option difference_json found);
      ("diagnostics", `List []);
    ]
