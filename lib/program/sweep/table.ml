open Scc_exact
open Scc_elaborate
open Scc_loading
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

type t = {
  name : string option;
  digest : string;
  grid : Grid.t;
  bounds : (string * string) list;
  checks : string list;
  decimals : int option;
  diffuses : bool;
}

let origin (o : Origin.t) = (o.name, o.digest)

(* {1 CSV} *)

let csv_line fields =
  let b = Buffer.create 128 in
  Scc_export.Table.line (Buffer.add_string b) fields;
  Buffer.contents b

let sides = [ "least"; "greatest" ]

let number_columns t =
  let rounded way =
    Option.fold ~none:"" ~some:(fun k -> Printf.sprintf " (rounded %s to %d decimals)" way k) t.decimals
  in
  List.concat_map (fun side -> [ side ^ " from" ^ rounded "down"; side ^ " to" ^ rounded "up" ]) sides

let csv_header t =
  csv_line
    (("point" :: List.map (fun (a : Grid.axis) -> a.name) t.grid)
     @ (if t.diffuses then [ "kick" ] else [])
     @ [ "check"; "verdict" ] @ number_columns t @ [ "why" ])

let number_fields t (c : Outcome.check) =
  let text exactly rounded = function
    | None -> ""
    | Some x -> ( match t.decimals with None -> exactly x | Some places -> rounded ~places x)
  in
  let field side =
    match List.find_opt (fun (n : Outcome.number) -> String.equal n.over side) c.numbers with
    | None -> [ ""; "" ]
    | Some { infinite = true; _ } -> [ "infinite"; "infinite" ]
    | Some n ->
      [ text Rat.to_string Decimal.rounded_down n.low; text Rat.to_string Decimal.rounded_up n.high ]
  in
  List.concat_map field sides

let csv t k outcome =
  let start = string_of_int k :: List.map (fun (_, r) -> Rat.to_string r) (Grid.point t.grid k) in
  let start = start @ if t.diffuses then [ Lattices.kicks (Outcome.lattices outcome) ] else [] in
  match (outcome : Outcome.t) with
  | Refused { code; message } ->
    let nothing = List.map (fun _ -> "") (number_columns t) in
    csv_line (start @ [ ""; "invalid" ] @ nothing @ [ Printf.sprintf "%s: %s" code message ])
  | Checked { checks; _ } ->
    let line (c : Outcome.check) =
      csv_line (start @ [ c.name; c.verdict ] @ number_fields t c @ [ String.concat "; " c.reasons ])
    in
    String.concat "" (List.map line checks)

(* {1 JSON} *)

let header_format =
  let axis =
    fields
      [
        field "name" text (fun (a : Grid.axis) -> a.name);
        field "values" (array ~least:1 Shared.rational) (fun (a : Grid.axis) -> a.values);
      ]
  in
  fields
    (Shared.head "scc-sweep" 1
     @ [
       Shared.semantics ();
       field "model" (nullable text) (fun t -> t.name);
       field "digest" Shared.digest (fun t -> t.digest);
       field "bounds" (entries text) (fun t -> t.bounds) ~about:"The bounds that were given, by their options.";
       maybe "checks" (list ~least:1 text)
         (fun t -> match t.checks with [] -> None | _ :: _ -> Some t.checks)
         ~about:"The names of the checks that were chosen; without it, all.";
       field "grid" (list ~least:1 axis) (fun t -> t.grid)
         ~about:"The points are all combinations, numbered from 0; the last parameter goes fastest.";
     ])

let check =
  let end_ of_number =
    let infinite (n : Outcome.number) = if n.infinite then Some () else None in
    let finite (n : Outcome.number) = if n.infinite then None else Some (of_number n) in
    union [ case (constant (`String "infinite")) infinite Fun.id; case (nullable Shared.rational) finite ignore ]
    |> named ~file:"sweep" "end"
  in
  let number =
    fields
      [
        field "over" (word Fun.id sides) (fun (n : Outcome.number) -> n.over);
        field "low" (end_ (fun n -> n.low)) Fun.id;
        field "high" (end_ (fun n -> n.high)) Fun.id;
      ]
  in
  fields
    [
      field "name" text (fun (c : Outcome.check) -> c.name);
      field "verdict" Check_json.kind_format (fun (c : Outcome.check) -> c.verdict);
      field "values" (list number) (fun (c : Outcome.check) -> c.numbers)
        ~about:"Of a check that asks for a number: where it is, over all schedulers.";
      field "reasons" Shared.texts (fun (c : Outcome.check) -> c.reasons)
        ~about:"Why it is not known, or no better; bounds up to which it holds.";
    ]

let lattice =
  let lattice f (l : Lattices.t) = f l.lattice in
  fields
    [
      field "bodies" (list ~least:1 text) (fun (l : Lattices.t) -> l.bodies)
        ~about:"Names of bodies; a family once, by its name.";
      field "kick" Shared.rational (lattice (fun l -> l.kick));
      field "chosen" bool (lattice (fun l -> l.chosen))
        ~about:"The model does not give the kick: it is the least power of two that is long enough.";
      maybe "spin" Shared.rational (lattice (fun l -> l.spin))
        ~about:"The spin of a kick of the orientation, of laws that say `turning`.";
    ]

let point_format =
  let refusal = fields [ field "code" Shared.code fst; field "message" text snd ] in
  let refused : Outcome.t -> _ = function Refused { code; message } -> Some (code, message) | Checked _ -> None in
  let lattices o = match Outcome.lattices o with [] -> None | _ :: _ as lattices -> Some lattices in
  fields
    [
      field "point" natural (fun (_, k, _) -> k);
      field "parameters" Origin_json.parameters_format (fun (t, k, _) -> Grid.point t.grid k);
      field "refused" (nullable refusal) (fun (_, _, o) -> refused o)
        ~about:"Why the model is invalid there; then there are no checks.";
      maybe "lattices" (list ~least:1 lattice) (fun (_, _, o) -> lattices o)
        ~about:"Of the bodies that diffuse: the lengths of their kicks.";
      field "checks" (list check) (fun (_, _, o) -> Outcome.checks o);
    ]

let format =
  union [ case header_format Either.find_left ignore; case point_format Either.find_right ignore ]

let line x = Json.line (write format x) ^ "\n"
let json_header t = line (Left t)
let json t k outcome = line (Right (t, k, outcome))
