open Scc_exact
open Scc_loading
open Scc_json
open Scc_runs
open Json_format

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

(* {1 Each run} *)

let csv fields =
  let b = Buffer.create 256 in
  Scc_export.Table.line (Buffer.add_string b) fields;
  Buffer.contents b

let line format x = Json.line (write format x) ^ "\n"
let in_simulation name t = named ~file:"simulation" name t

let number_format =
  from (fun (t, q) -> match t.digits with Exactly -> Json.fraction q | Rounded k -> rounded k q) Json_format.number
  |> about "Exact as p/q, or rounded." |> in_simulation "number"

let maybe_number =
  from (fun (t, q) -> Option.map (fun q -> (t, q)) q) (nullable number_format) |> in_simulation "maybe"

(* How many runs there are, and how many ended early. *)
let all_together =
  fields
    [
      field "runs" natural fst;
      field "ended_early" natural snd ~about:"How many of them did not come to the last time.";
    ]

let header_format =
  let part f (t, _) = f t in
  let decimals t = match t.digits with Exactly -> None | Rounded k -> Some k in
  fields
    (Shared.head "scc-simulation" 1
     @ [
       Shared.semantics ();
       within (part (fun t -> t.origin)) Origin_json.fields;
       field "seed" Shared.seed (part (fun t -> t.seed)) ~about:"Of all runs together; each has its own.";
       field "observables" (list ~least:1 text) (part (fun t -> t.observables));
       field "decimals" (nullable natural) (part decimals)
         ~about:"To so many decimals all numbers are rounded; null: they are exact.";
       field "times" (array ~least:1 Shared.rational) (part (fun t -> t.times));
       field "summary" (nullable all_together) snd
         ~about:
           "null: lines of runs follow, as many as there are. Otherwise a line for each time and observable.";
     ])

(* The line of a run that ended early does not say how far it came: at least to its last value. *)
let reached ~ended values =
  let rec last n = if n > 0 && Array.for_all Option.is_none values.(n - 1) then last (n - 1) else n in
  if Option.is_none ended then Array.length values else last (Array.length values)

let run_format =
  let rows (t, (r : Simulation.run)) =
    List.map (fun row -> List.map (fun q -> (t, q)) (Array.to_list row)) (Array.to_list r.values)
  in
  obj
    (let+ number = required "run" natural (fun (_, (r : Simulation.run)) -> r.number) ~about:"From 0."
     and+ () =
       field "seed" Shared.seed (fun (t, (r : Simulation.run)) -> Simulation.seed_of t.seed r.number)
         ~about:"scc trace --choose random:SEED makes the same run."
     and+ values =
       required "values" (list (list maybe_number)) rows
         ~about:"By time, and then by observable; of a truth 1 or 0; null where there is none."
     and+ ended =
       required "ended" (nullable text) (fun (_, (r : Simulation.run)) -> r.ended)
         ~about:"Why it did not come to the last time, in words."
     and+ interrupted =
       optional "interrupted" bool
         (fun (_, (r : Simulation.run)) -> if r.interrupted then Some true else None)
         ~about:"true: an interruption ended it, and it would have gone on. --resume makes it anew."
     in
     let interrupted = Option.value interrupted ~default:false in
     let values = Array.of_list (List.map Array.of_list values) in
     { Simulation.number; values; reached = reached ~ended values; ended; interrupted })

(* No two columns have one name: a model may have parameters of these names, and every model has a time. *)
let columns t =
  let own = [ "run"; "time"; "ended" ] in
  let column name = if List.mem name own then Printf.sprintf "(%s)" name else name in
  [ "run"; "time" ] @ List.map column t.observables @ [ "ended" ]

let header t =
  match t.form with
  | Csv -> csv (columns t)
  | Jsonl -> line header_format (t, None)

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
  | Jsonl -> line run_format (t, r)

let read line =
  match Json.parse (Scc_base.Source.make ~name:"line" line) with
  | Ok json -> Result.to_option (Json_format.read run_format json)
  | Error _ -> None

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

(* What is known at a time of an observable. *)
type moment = {
  table : t;
  quantiles : Rat.t list;
  decimals : int;
  time : Rat.t;
  observable : string;
  cell : Statistics.t;
}

let moment_format =
  let of_all f m = (m.table, if Statistics.count m.cell = 0 then None else Some (f m.cell)) in
  let variance m = Statistics.variance m.cell in
  let root m = Option.map (Statistics.root ~decimals:m.decimals) (variance m) in
  let quantile =
    fields
      [
        field "of" Shared.rational snd;
        field "value" maybe_number (fun (m, q) -> of_all (fun c -> Statistics.quantile c q) m);
      ]
  in
  fields
    [
      field "time" number_format (fun m -> (m.table, m.time));
      field "observable" text (fun m -> m.observable);
      field "count" natural (fun m -> Statistics.count m.cell)
        ~about:"How many runs have a value then; all that follows is of these.";
      field "mean" maybe_number (of_all Statistics.mean);
      field "variance" maybe_number (fun m -> (m.table, variance m))
        ~about:"Of the sample; null with less than two.";
      field "deviation" (nullable Json_format.number) root ~about:"Its root, rounded.";
      field "least" maybe_number (of_all Statistics.least);
      field "quantiles" (list quantile) (fun m -> List.map (fun q -> (m, q)) m.quantiles);
      field "greatest" maybe_number (of_all Statistics.greatest);
    ]

type line = Header of (t * (int * int) option) | Moment of moment

let format =
  union
    [
      case header_format (function Header h -> Some h | Moment _ -> None) ignore;
      case run_format (fun _ -> None) ignore;
      case moment_format (function Moment m -> Some m | Header _ -> None) ignore;
    ]

let json_summary table ~quantiles ~decimals s put =
  put (line format (Header (table, Some (s.runs, s.early))));
  let cell time observable cell =
    put (line format (Moment { table; quantiles; decimals; time; observable; cell }))
  in
  Array.iteri (fun i row -> List.iteri (fun k text -> cell table.times.(i) text row.(k)) table.observables) s.cells

let summary t = match t.form with Csv -> csv_summary t | Jsonl -> json_summary t
