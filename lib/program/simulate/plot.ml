open Scc_exact
open Scc_loading
open Scc_svg

let band quantiles cell =
  match quantiles with
  | [] | [ _ ] -> None
  | q :: rest ->
    let low, high = Rat.span q rest in
    Some (Statistics.quantile cell low, Statistics.quantile cell high)

(* In pieces, where at some times no run has a value. *)
let pieces quantiles times cells =
  let point i cell : Chart.point = { x = times.(i); y = Statistics.mean cell; band = band quantiles cell } in
  let add i cell pieces =
    match (Statistics.count cell, pieces) with
    | 0, _ -> [] :: pieces
    | _, piece :: rest -> (point i cell :: piece) :: rest
    | _, [] -> [ [ point i cell ] ]
  in
  let rec from i pieces = if i < 0 then pieces else from (i - 1) (add i cells.(i) pieces) in
  List.filter (fun piece -> piece <> []) (from (Array.length cells - 1) [])

let caption (t : Report.t) quantiles summary =
  let runs = Report.runs summary in
  let between =
    match List.sort Rat.compare quantiles with
    | [] | [ _ ] -> ""
    | q :: rest ->
      let last = List.nth rest (List.length rest - 1) in
      Printf.sprintf ", and the range from the quantile %s to %s" (Rat.to_string q) (Rat.to_string last)
  in
  Printf.sprintf "mean of %d %s%s; seed %Ld" runs (if runs = 1 then "run" else "runs") between t.seed

let chart (t : Report.t) ~quantiles summary =
  let panel k text : Chart.panel =
    let cells = Array.map (fun row -> row.(k)) (Report.cells summary) in
    { title = text; curves = [ { name = ""; pieces = pieces quantiles t.times cells } ] }
  in
  let title = Option.value t.origin.Origin.name ~default:"a model" in
  let panels = List.mapi panel t.observables in
  Chart.sheet ~title ~caption:(caption t quantiles summary) ~x:"time" ~named:[] panels []
