open Scc_exact
open Scc_loading
open Scc_json
open Scc_runs

type form = Csv | Jsonl
type digits = Exactly | Rounded of int

type t = {
  form : form;
  digits : digits;
  origin : Origin.t;
  seed : int64;
  observables : string list;
  times : Rat.t array;
}

(* {1 Numbers} *)

let rounded k = Decimal.padded ~places:k
let number t r = match t.digits with Exactly -> Rat.to_string r | Rounded k -> rounded k r
let json_number t r : Json.t = match t.digits with Exactly -> Json.rat r | Rounded k -> `String (rounded k r)

(* {1 Each run} *)

let csv fields =
  let b = Buffer.create 256 in
  Scc_export.Table.line (Buffer.add_string b) fields;
  Buffer.contents b

let json members = Json.line (`Assoc members) ^ "\n"
let texts list = `List (List.map Json.text list)

(* What is asked for, which tells one simulation from another one. *)
let asked t more =
  let digits = match t.digits with Exactly -> `Null | Rounded k -> `Int k in
  json
    ([
      ("format", `String "scc-simulation");
      ("version", `Int 1);
      ("semantics", `String Scc_calculus.Parameters.version);
    ]
      @ Origin_json.members t.origin
      @ [
        ("seed", `String (Int64.to_string t.seed));
        ("observables", texts t.observables);
        ("decimals", digits);
        ("times", `List (Array.to_list (Array.map Json.rat t.times)));
        ("summary", more);
      ])

let header t =
  match t.form with
  | Csv -> csv ([ "run"; "time" ] @ t.observables @ [ "ended" ])
  | Jsonl -> asked t `Null

let run t (r : Simulation.run) =
  match t.form with
  | Csv ->
    let ended = Option.value r.ended ~default:"" in
    let field = Option.fold ~none:"" ~some:(number t) in
    let line i row =
      csv
        ([ string_of_int r.number; number t t.times.(i) ] @ List.map field (Array.to_list row) @ [ ended ])
    in
    String.concat "" (Array.to_list (Array.mapi line r.values))
  | Jsonl ->
    let value = Json.option (json_number t) in
    let row values = `List (List.map value (Array.to_list values)) in
    json
      [
        ("run", `Int r.number);
        ("seed", `String (Int64.to_string (Simulation.seed_of t.seed r.number)));
        ("values", `List (List.map row (Array.to_list r.values)));
        ("ended", Json.option Json.text r.ended);
      ]

let read line : Simulation.run option =
  let ( let* ) = Option.bind in
  (* The element of a list, of which each has to be as it should. *)
  let all of_one json =
    let* items = Json.list json in
    let found = List.filter_map of_one items in
    if List.compare_lengths found items = 0 then Some (Array.of_list found) else None
  in
  let value : Json.t -> Rat.t option option = function
    | `Null -> Some None
    | json -> Option.map Option.some (Json.rational json)
  in
  let* json = Result.to_option (Json.parse (Scc_base.Source.make ~name:"line" line)) in
  let* number = Option.bind (Json.member "run" json) Json.int in
  let* values = Option.bind (Json.member "values" json) (all (all value)) in
  Some { Simulation.number; values; ended = Option.bind (Json.member "ended" json) Json.string }

(* {1 All together} *)

type summary = { cells : Statistics.t array array; runs : int; early : int }

let nobody t =
  {
    cells = Array.map (fun _ -> Array.make (List.length t.observables) Statistics.empty) t.times;
    runs = 0;
    early = 0;
  }

let add s (r : Simulation.run) =
  let one cell = Option.fold ~none:cell ~some:(Statistics.add cell) in
  {
    cells = Array.map2 (Array.map2 one) s.cells r.values;
    runs = s.runs + 1;
    early = (s.early + match r.ended with None -> 0 | Some _ -> 1);
  }

let runs s = s.runs
let cells s = s.cells
let early s = s.early

let csv_summary t ~quantiles ~decimals s put =
  let quantile_name q = "quantile " ^ Rat.to_string q in
  let names = [ "count"; "mean"; "variance"; "deviation"; "least" ] @ List.map quantile_name quantiles @ [
      "greatest" ] in
  let optional = Option.fold ~none:"" in
  let fields cell =
    if Statistics.count cell = 0 then "0" :: List.map (fun _ -> "") (List.tl names)
    else
      let variance = Statistics.variance cell in
      [
        string_of_int (Statistics.count cell); number t (Statistics.mean cell);
        optional ~some:(number t) variance;
        optional ~some:(Statistics.root ~decimals) variance;
        number t (Statistics.least cell);
      ]
      @ List.map (fun q -> number t (Statistics.quantile cell q)) quantiles
      @ [ number t (Statistics.greatest cell) ]
  in
  put (csv ([ "time"; "observable" ] @ names));
  Array.iteri
    (fun i row ->
       List.iteri (fun k text -> put (csv (number t t.times.(i) :: text :: fields row.(k)))) t.observables)
    s.cells

let json_summary t ~quantiles ~decimals s put =
  let value = json_number t in
  let members cell =
    let of_all f = if Statistics.count cell = 0 then `Null else value (f cell) in
    let variance = Statistics.variance cell in
    let quantile q = `Assoc [ ("of", Json.rat q); ("value", of_all (fun c -> Statistics.quantile c q)) ] in
    [
      ("count", `Int (Statistics.count cell));
      ("mean", of_all Statistics.mean);
      ("variance", Json.option value variance);
      ("deviation", Json.option (fun v -> `String (Statistics.root ~decimals v)) variance);
      ("least", of_all Statistics.least);
      ("quantiles", `List (List.map quantile quantiles));
      ("greatest", of_all Statistics.greatest);
    ]
  in
  put (asked t (`Assoc [ ("runs", `Int s.runs); ("ended_early", `Int s.early) ]));
  Array.iteri
    (fun i row ->
       let line k text = put (json (("time", value t.times.(i)) :: ("observable", Json.text text) :: members
                                      row.(k))) in List.iteri line t.observables)
    s.cells

let summary t = match t.form with Csv -> csv_summary t | Jsonl -> json_summary t
