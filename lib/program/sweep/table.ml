open Scc_exact
open Scc_loading
open Scc_json

type t = { name : string option; digest : string; grid : Grid.t; bounds : (string * string) list }

let origin (o : Origin.t) = (o.name, o.digest)

(* {1 CSV} *)

let csv_line fields =
  let b = Buffer.create 128 in
  Scc_export.Table.line (Buffer.add_string b) fields;
  Buffer.contents b

let sides = [ "least"; "greatest" ]
let number_columns = List.concat_map (fun side -> [ side ^ " from"; side ^ " to" ]) sides

let csv_header t =
  csv_line
    (("point" :: List.map (fun (a : Grid.axis) -> a.name) t.grid)
     @ [ "check"; "verdict" ] @ number_columns @ [ "why" ])

let number_fields (c : Outcome.check) =
  let field side =
    match List.find_opt (fun (n : Outcome.number) -> String.equal n.over side) c.numbers with
    | None -> [ ""; "" ]
    | Some { infinite = true; _ } -> [ "infinite"; "infinite" ]
    | Some n ->
      let text = Option.fold ~none:"" ~some:Rat.to_string in
      [ text n.low; text n.high ]
  in
  List.concat_map field sides

let csv t k outcome =
  let start = string_of_int k :: List.map (fun (_, r) -> Rat.to_string r) (Grid.point t.grid k) in
  match (outcome : Outcome.t) with
  | Refused { code; message } ->
    let nothing = List.map (fun _ -> "") number_columns in
    csv_line (start @ [ ""; "invalid" ] @ nothing @ [ Printf.sprintf "%s: %s" code message ])
  | Checked checks ->
    let line (c : Outcome.check) =
      csv_line (start @ [ c.name; c.verdict ] @ number_fields c @ [ String.concat "; " c.reasons ])
    in
    String.concat "" (List.map line checks)

(* {1 JSON} *)

let line members = Json.line (`Assoc members) ^ "\n"

let json_header t =
  let axis (a : Grid.axis) : Json.t =
    `Assoc
      [ ("name", Json.text a.name); ("values", `List (Array.to_list (Array.map Json.rat a.values))) ]
  in
  line
    [
      ("format", `String "scc-sweep");
      ("version", `Int 1);
      ("semantics", `String Scc_calculus.Parameters.version);
      ("model", Json.option Json.text t.name);
      ("digest", `String t.digest);
      ("bounds", `Assoc (List.map (fun (name, value) -> (name, `String value)) t.bounds));
      ("grid", `List (List.map axis t.grid));
    ]

let number (n : Outcome.number) : Json.t =
  let end_ r : Json.t = if n.infinite then `String "infinite" else Json.option Json.rat r in
  `Assoc [ ("over", `String n.over); ("low", end_ n.low); ("high", end_ n.high) ]

let check (c : Outcome.check) : Json.t =
  `Assoc
    [
      ("name", `String c.name);
      ("verdict", `String c.verdict);
      ("values", `List (List.map number c.numbers));
      ("reasons", `List (List.map Json.text c.reasons));
    ]

let json t k outcome =
  let refused, checks =
    match (outcome : Outcome.t) with
    | Refused { code; message } ->
      (`Assoc [ ("code", `String code); ("message", Json.text message) ], [])
    | Checked checks -> (`Null, List.map check checks)
  in
  line
    [
      ("point", `Int k);
      ("parameters", `Assoc (List.map (fun (name, r) -> (name, Json.rat r)) (Grid.point t.grid k)));
      ("refused", refused);
      ("checks", `List checks);
    ]
