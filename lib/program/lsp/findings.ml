open Scc_base
open Scc_syntax
open Scc_assist
open Scc_json

(* {1 Diagnostics} *)

let about_code code =
  List.find_map (fun ((c : Code.t), what) -> if String.equal (c :> string) code then Some what else None) Code.all

let severity : Diag.severity -> int = function Error -> 1 | Warning -> 2

let related (s : Session.t) ~base (d : Diag.t) : (string * Json.t) list =
  let note ((at : Span.t), message) : Json.t option =
    if Span.is_none at then None
    else
      Workspace.target s.workspace ~base ~file:at.file
      |> Option.map (fun (uri, places) : Json.t ->
          let location : Json.t = `Assoc [ ("uri", Json.text uri); ("range", Workspace.place places at) ] in
          `Assoc [ ("location", location); ("message", Json.text message) ])
  in
  match List.filter_map note d.notes with
  | [] -> []
  | _ when not s.client.related -> []
  | notes -> [ ("relatedInformation", `List notes) ]

let diagnostic s ~base places (d : Diag.t) : Json.t =
  let message = match d.hint with None -> d.message | Some hint -> Printf.sprintf "%s\nhint: %s" d.message hint in
  let about = match about_code d.code with None -> [] | Some what -> [ ("about", Json.text what) ] in
  let tags = if String.equal d.code (Code.unused :> string) then [ ("tags", `List [ `Int 1 ]) ] else [] in
  `Assoc
    ([
      ("range", Workspace.place places d.span);
      ("severity", `Int (severity d.severity));
      ("code", `String d.code);
      ("source", `String "scc");
      ("message", Json.text message);
    ]
      @ tags @ related s ~base d
      @ [ ("data", `Assoc about) ])

(* {1 Checks} *)

(* The checks of a text with the places of their names, those in loops as well. *)
let checks (d : Workspace.document) =
  let rec of_items (items : Ast.model) =
    List.concat_map
      (fun (i : Ast.item) ->
         match i.it with Check (n, _) -> [ n ] | For (_, inner) -> of_items inner | _ -> [])
      items
  in
  of_items (Lazy.force d.reading.model)

(* The verdict of `safe[2]` belongs to the check `safe`. *)
let bare name = match String.index_opt name '[' with Some i -> String.sub name 0 i | None -> name

let of_verdict d (v : Session.verdict) : Json.t option =
  let severity = match v.kind with "violated" -> Some 1 | "undecided" -> Some 2 | _ -> None in
  let name = List.find_opt (fun (n : Ast.name) -> String.equal n.it (bare v.name)) (checks d) in
  match (severity, name) with
  | Some severity, Some n ->
    Some
      (`Assoc
         [
           ("range", Session.range d n.at.start n.at.stop);
           ("severity", `Int severity);
           ("code", Json.text v.kind);
           ("source", `String "scc check");
           ("message", Json.text (Printf.sprintf "%s: %s" v.name v.text));
         ])
  | _, _ -> None

let command title name arguments : Json.t =
  `Assoc [ ("title", Json.text title); ("command", `String name); ("arguments", `List arguments) ]

let lenses s params : Json.t =
  match Session.plain_document s params with
  | None -> `Null
  | Some d ->
    let all = checks d and verdicts = Session.verdicts s d in
    let uri = Json.text d.uri in
    let lens (n : Ast.name) command : Json.t =
      `Assoc [ ("range", Session.range d n.at.start n.at.stop); ("command", command) ]
    in
    let of_check (n : Ast.name) =
      let name = Json.text n.it in
      let own = List.filter (fun (v : Session.verdict) -> String.equal (bare v.name) n.it) verdicts in
      let decided (v : Session.verdict) =
        let title = if String.equal v.name n.it then v.text else Printf.sprintf "%s: %s" v.name v.text in
        lens n (command title "scc.check" [ uri; Json.text v.name ])
        :: (if v.shown then [ lens n (command "show the run" "scc.showRun" [ uri; Json.text v.name ]) ] else [])
      in
      match own with
      | [] -> [ lens n (command "check" "scc.check" [ uri; name ]) ]
      | _ :: _ -> List.concat_map decided own
    in
    let whole =
      match all with
      | first :: _ :: _ ->
        let title = Printf.sprintf "check all %d" (List.length all) in
        [ lens first (command title "scc.check" [ uri ]) ]
      | _ -> []
    in
    `List (whole @ List.concat_map of_check all)

(* {1 Fixes} *)

let actions s params : Json.t =
  let d = Session.document s params in
  let range = Rpc.member "range" params in
  let side name = Positions.offset (Lazy.force d.positions) (Rpc.position (Rpc.member name range)) in
  let from = side "start" and upto = side "end" in
  let near (x : Diag.t) =
    String.equal x.span.file (Source.name d.reading.source) && x.span.start <= upto && from <= x.span.stop
  in
  let fix all ((x : Diag.t), (f : Fixes.t)) : Json.t =
    `Assoc
      [
        ("title", Json.text f.title);
        ("kind", `String "quickfix");
        ("diagnostics", `List [ diagnostic s ~base:d.path (Lazy.force d.positions) x ]);
        ("isPreferred", `Bool (List.length (List.filter (fun (y, _) -> y == x) all) = 1));
        ("edit", Navigate.edit s [ (d.uri, Lazy.force d.positions, f.edits) ]);
      ]
  in
  match Session.analysis s d with
  | None -> `List []
  | Some found -> 
    let all = Fixes.of_diagnostics d.reading (List.filter near found.diagnostics) in
    `List (List.map (fix all) all)

(* {1 Values} *)

(* What is written after the name, to the end of the declaration. *)
let written (d : Workspace.document) =
  let table = Hashtbl.create 64 in
  let note (n : Ast.name) (e : Ast.expr) = Hashtbl.replace table n.at.start (Printer.expr e) in
  let rec each (items : Ast.model) =
    List.iter
      (fun (i : Ast.item) ->
         match i.it with
         | Param (n, e) | Let (n, e) -> note n e
         | For (_, inner) -> each inner
         | _ -> ())
      items
  in
  each (Lazy.force d.reading.model);
  table

let longest = 40

let values s params : Json.t =
  match Session.plain_document s params with
  | None -> `Null
  | Some d -> (
      match Session.analysis s d with
      | None -> `List []
      | Some found ->
        let range = Rpc.member "range" params in
        let side name = Positions.offset (Lazy.force d.positions) (Rpc.position (Rpc.member name range)) in
        let from = side "start" and upto = side "end" and written = written d in
        let count = Hashtbl.create 16 in
        List.iter (fun ((at : Span.t), _) -> Hashtbl.add count at.start ()) found.values;
        let hint ((at : Span.t), value) : Json.t option =
          let is_own = String.equal at.file (Source.name d.reading.source) in
          let once = List.length (Hashtbl.find_all count at.start) = 1 in
          let says = Hashtbl.find_opt written at.start in
          let within = from <= at.start && at.stop <= upto in
          let is_news = match says with Some text -> not (String.equal text value) | None -> false in
          if is_own && once && within && is_news && String.length value <= longest then
            let line, character = Positions.of_offset (Lazy.force d.positions) at.stop in
            Some
              (`Assoc
                 [
                   ("position", `Assoc [ ("line", `Int line); ("character", `Int character) ]);
                   ("label", Json.text ("= " ^ value));
                   ("paddingLeft", `Bool true);
                 ])
          else None
        in
        `List (List.filter_map hint found.values))

