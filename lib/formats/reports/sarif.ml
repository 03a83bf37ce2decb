open Scc_base
open Scc_explain
open Scc_verify
open Scc_property
open Scc_json

let violated = "violated"
let undecided = "undecided"

let rules =
  Array.of_list
    (List.map (fun ((code : Code.t), what) -> ((code :> string), what)) Code.all
     @ [
       (violated, "a property of the model that does not hold");
       (undecided, "a property of the model that could be neither proved nor refuted");
     ])

let message text = `Assoc [ ("text", Json.text text) ]

let rule (id, what) =
  `Assoc [ ("id", `String id); ("shortDescription", message (String.capitalize_ascii what)) ]

let index_of id =
  let rec go i =
    if i = Array.length rules then Bug.fail __POS__ "a finding of no rule"
    else if String.equal (fst rules.(i)) id then i
    else go (i + 1)
  in
  go 0

(* A path as a relative reference or a file URI: what is not unreserved is escaped, and so is a colon, which would
   make a scheme of what stands before it. *)
let uri path =
  let b = Buffer.create (String.length path) in
  if String.length path > 0 && path.[0] = '/' then Buffer.add_string b "file://";
  String.iter
    (function
      | ('A' .. 'Z' | 'a' .. 'z' | '0' .. '9' | '-' | '.' | '_' | '~' | '/') as c -> Buffer.add_char b c
      | c -> Buffer.add_string b (Printf.sprintf "%%%02X" (Char.code c)))
    path;
  Buffer.contents b

let region s (span : Span.t) =
  let line, column = Source.position s span.start and end_line, end_column = Source.position s span.stop in
  `Assoc
    [
      ("startLine", `Int line);
      ("startColumn", `Int column);
      ("endLine", `Int end_line);
      ("endColumn", `Int end_column);
    ]

let place ~source (span : Span.t) =
  let file = ("artifactLocation", `Assoc [ ("uri", `String (uri span.file)) ]) in
  match source span.file with
  | Some s -> ("physicalLocation", `Assoc [ file; ("region", region s span) ])
  | None -> ("physicalLocation", `Assoc [ file ])

let locations ~source span =
  if Span.is_none span then [] else [ ("locations", `List [ `Assoc [ place ~source span ] ]) ]

let result ~source ~id ~level ~text ?(kind = "fail") ?(more = []) span =
  `Assoc
    ([
      ("ruleId", `String id);
      ("ruleIndex", `Int (index_of id));
      ("kind", `String kind);
      ("level", `String level);
      ("message", message text);
    ]
      @ locations ~source span @ more)

let diagnostic ~source (d : Diag.t) =
  let note i (span, text) =
    let where = if Span.is_none span then [] else [ place ~source span ] in
    `Assoc (("id", `Int (i + 1)) :: ("message", message text) :: where)
  in
  let related =
    match d.notes with [] -> [] | notes -> [ ("relatedLocations", `List (List.mapi note notes)) ]
  in
  let text = match d.hint with Some hint -> d.message ^ " (" ^ hint ^ ")" | None -> d.message in
  let level = if Diag.is_error d then "error" else "warning" in
  result ~source ~id:d.code ~level ~text ~more:related d.span

let flow ~source m (check : Property.check) (w : Witness.t) =
  let step i text =
    let location = `Assoc [ place ~source check.span; ("message", message text) ] in
    `Assoc [ ("location", location); ("executionOrder", `Int (i + 1)) ]
  in
  let steps = List.mapi step (Witness.lines m w) in
  match steps with
  | [] -> []
  | _ :: _ ->
    [ ("codeFlows", `List [ `Assoc [ ("threadFlows", `List [ `Assoc [ ("locations", `List steps) ] ]) ] ]) ]

let witness_of_reason : Verdict.reason -> Witness.t option = function
  | Truncated _ | Unevaluated _ | Unexplored _ | Undefined _ | Fault _ -> None

let property ~source m ({ check; verdict = v; scale; _ } as o : Verdict.outcome) =
  (* The resolution is the model's own, and the same for all of them. *)
  let meant = Verdict.scale_to_string { scale with resolution = None } in
  let unshown = Verdict.unshown o in
  let said what = Printf.sprintf "`%s` is %s%s: %s%s" check.name what meant check.text unshown in
  let run w = Option.fold ~none:[] ~some:(flow ~source m check) w in
  match v with
  | Holds _ -> None
  | Violated { witness } ->
    Some (result ~source ~id:violated ~level:"error" ~text:(said violated) ~more:(run witness) check.span)
  | Depends _ | Measured { reasons = []; _ } -> None
  | Measured { reasons; _ } | Undecided reasons ->
    let text = said undecided ^ " (" ^ String.concat "; " (List.map Verdict.reason_to_string reasons) ^ ")" in
    let more = run (List.find_map witness_of_reason reasons) in
    Some (result ~source ~id:undecided ~kind:"open" ~level:"none" ~text ~more check.span)

let document ~source ~version ~exit ~ok ~faults ~diagnostics ~properties =
  let of_properties =
    match properties with
    | None -> []
    | Some (m, verdicts) -> List.filter_map (property ~source m) verdicts
  in
  let notifications =
    match List.map (fun text -> `Assoc [ ("level", `String "error"); ("message", message text) ]) faults with
    | [] -> []
    | notes -> [ ("toolExecutionNotifications", `List notes) ]
  in
  let driver =
    `Assoc
      [
        ("name", `String "scc");
        ("version", `String version);
        ("rules", `List (Array.to_list (Array.map rule rules)));
      ]
  in
  let run =
    `Assoc
      [
        ("tool", `Assoc [ ("driver", driver) ]);
        ( "invocations",
          `List [ `Assoc ([ ("executionSuccessful", `Bool ok); ("exitCode", `Int exit) ] @ notifications) ] );
        ("columnKind", `String "unicodeCodePoints");
        ("results", `List (List.map (diagnostic ~source) diagnostics @ of_properties));
      ]
  in
  `Assoc
    [
      ("$schema", `String "https://docs.oasis-open.org/sarif/sarif/v2.1.0/os/schemas/sarif-schema-2.1.0.json");
      ("version", `String "2.1.0");
      ("runs", `List [ run ]);
    ]
