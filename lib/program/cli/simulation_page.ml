open Scc_property
open Scc_runs
open Scc_simulate
open Scc_view

type t = {
  plan : Simulation.plan;
  mutable runs : Simulation.run list;  (** the first ones, the last of them first *)
  mutable made : int;
  over : int array;  (** how many runs were over before a time, and not before an earlier one *)
  cut : int array;
}

let create (plan : Simulation.plan) =
  let none () = Array.make (Array.length plan.times) 0 in
  { plan; runs = []; made = 0; over = none (); cut = none () }

let add t (r : Simulation.run) =
  if t.made < Viewed.most_runs then t.runs <- r :: t.runs;
  t.made <- t.made + 1;
  if r.reached < Array.length t.plan.times then begin
    let counts = if r.interrupted then t.cut else t.over in
    counts.(r.reached) <- counts.(r.reached) + 1
  end

(* {1 Writing} *)

let from_first counts =
  let sum = ref 0 in
  Array.map (fun n -> sum := !sum + n; !sum) counts

let cell values =
  let mean = if Statistics.count values = 0 then None else Some (Statistics.mean values) in
  { Spread.sorted = Statistics.sorted values; mean }

let spread t (report : Report.t) ~asked ~first ~summary =
  let shown (r : Simulation.run) = { Spread.number = r.number; values = r.values; ended = r.ended } in
  {
    Spread.seed = report.seed;
    first;
    asked;
    made = t.made;
    observables = report.observables;
    times = report.times;
    over = from_first t.over;
    cut = from_first t.cut;
    cells = Array.map (Array.map cell) (Report.cells summary);
    shown = List.rev_map shown t.runs;
    hurried = false;
  }

(* The numbers among the observables, each once. What has no value as a curve is left to the table. *)
let most_plots = 8

let numbers (plan : Simulation.plan) =
  let add found (o : Scc_export.Table.observable) =
    match o.what with
    | Number n when not (List.exists (Formula.equal_num n) found) -> n :: found
    | Number _ | Truth _ -> found
  in
  List.filteri (fun i _ -> i < most_plots) (List.rev (List.fold_left add [] plan.observables))

(* After an interruption the runs of the page have so many seconds. *)
let patience = 5.

let write t console model ~path ~name ~report ~asked ~first ~summary ~interrupted =
  let times = report.Report.times in
  let limits =
    { Replay.steps = t.plan.steps; time = Some times.(Array.length times - 1); instant = Replay.default_instant }
  in
  let spread = spread t report ~asked ~first ~summary in
  (* What an interruption has ended is made again to where it was last observed. *)
  let cut (shown : Spread.shown) =
    match List.find_opt (fun (r : Simulation.run) -> r.number = shown.number) t.runs with
    | Some r when r.interrupted -> Some times.(Int.max 0 (r.reached - 1))
    | Some _ | None -> None
  in
  let hurry = ref None in
  let late () =
    interrupted ()
    &&
    match !hurry with
    | None -> hurry := Some (Unix.gettimeofday () +. patience); false
    | Some deadline -> Unix.gettimeofday () > deadline
  in
  let simulation = { Viewed.spread; limits; numbers = numbers t.plan } in
  let* document = Viewed.simulated model ~name simulation ~cut ~interrupted:late in
  let page = Page.write ~title:(name ^ " – scc") (Document.write document) in
  match Console.with_output console ~path:(Some path) page with
  | Error d -> Error [ d ]
  | Ok () ->
    let hurried = Option.fold ~none:false ~some:(fun (s : Spread.t) -> s.hurried) document.spread in
    let shown = Scc_base.Plural.count (List.length document.runs) "run" "runs" in
    if hurried then
      Console.note console
        (Printf.sprintf "scc: interrupted: the page shows %s, as many as there was time for" shown);
    Ok (not hurried)

let too_large ~times ~observables =
  if times * observables <= Spread.most_cells then None
  else
    Some
      (Printf.sprintf
         "a page of --view has room for %d values of a run, and these are %d (%s at %d times): take a greater \
          --every, or fewer observables"
         Spread.most_cells (times * observables)
         (Scc_base.Plural.count observables "observable" "observables")
         times)
