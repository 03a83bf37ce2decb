(* Probabilities and means that the time cuts short at any point: what is told is what would be told with more
   time, or says that the time was over. The clock counts how often it is asked whether to stop. With
   [SCC_TIMES=n] it stops at n times as many points. *)

open Scc_exact
open Scc_graph_search
open Scc_semantics
open Scc_explain
open Scc_verify
open Scc_test_models

let surroundings total =
  let now = ref 0. in
  let rec until last : Limits.surroundings =
    let stop () : Limits.stop option =
      now := !now +. 1.;
      if !now > last then Some Seconds else None
    in
    let part p = until (!now +. (p *. (last -. !now))) in
    { Limits.quiet with stop; half = (fun () -> part 0.5);
                        share = (fun ~mine ~all -> part (float_of_int mine /. float_of_int all)) }
  in
  (until total, now)

let walker places =
  Printf.sprintf
    {|
shape C = box(1,1,1)
process w = C mass 1 at translate (3,0,0) [nil]
fixed l = C absorb at translate (-1,0,0)
fixed r = C absorb at translate (%d,0,0)
motion w = choose { (1,0,0), (-1,0,0) }
check mean  : E = ? [ time U gone(w) ]
check least : P <= 1/3 [ eventually event absorb(w, r) ]
check most  : P > 1/2 [ eventually event absorb(w, l) ]
check share : P = ? [ eventually event absorb(w, r) ]
check soon  : P = ? [ eventually event absorb(w, l) within 40 ]
check never : P >= 2/3 [ eventually event absorb(w, r) within 40 ]
|}
    (places + 1)

let report (e : Scc_elaborate.Elaborate.t) total =
  let semantics = Scc_engine.Standard.of_model e.model in
  let surroundings, asked = surroundings total in
  let bounds = { Bounds.default with seconds = Given 9. } in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let report = Check.run { Setup.default with bounds; surroundings } semantics ~initial e.checks in
    (report, !asked)

let says_so = function
  | Verdict.Truncated _ | Unevaluated _ -> true
  | Unexplored _ | Undefined _ | Fault _ -> false

let is_exact (_, m) = Likelihoods.is_exact m

(* As narrow as is asked for where there is no exact value. *)
let is_narrow (_, (m : Scc_ctl.Eval.measured)) =
  match (Scc_chance.Answer.lower m.least, Scc_chance.Answer.upper m.most) with
  | Some low, Some high -> Rat.compare (Rat.sub high low) Scc_chance.Effort.default.width <= 0
  | _ -> false

(* Whether a verdict is the one of enough time, in what it claims. *)
let settled (full : Verdict.t) (found : Verdict.t) =
  match (full, found) with
  | Holds a, Holds { bounds = []; _ } -> a.bounds = []
  | Violated _, Violated _ -> true
  | Measured a, Measured b ->
    List.for_all is_exact b.values && List.for_all2 (fun (_, x) (_, y) -> Likelihoods.equal x y) a.values b.values
  | Undecided _, Undecided _ -> true
  | _ -> false

let kinds = Hashtbl.create 4

let fits what ~complete (full : Verdict.outcome) (outcome : Verdict.outcome) =
  let found = outcome.verdict in
  let has_run (o : Verdict.outcome) = Option.is_some (Verdict.shown o.verdict) in
  let kind, right =
    match (full.verdict, found) with
    | Holds { bounds = _ :: _; _ }, Holds { bounds = _ :: _; _ } -> ("bounded", true)
    | _, Holds { bounds = (_ :: _) as bounds; _ } ->
      let of_time (t : Verdict.truncation) = match t.limit with Seconds _ -> true | _ -> false in
      ("bounded", List.exists of_time bounds)
    | _, Undecided reasons ->
      let exact = function
        | Verdict.Undefined text -> Str.string_match (Str.regexp "the probability is [0-9]") text 0
        | _ -> false
      in
      ("undecided", List.exists says_so reasons && not (List.exists exact reasons))
    | Measured of_enough, Measured { values; reasons; inexact; _ } when not (List.for_all is_exact values) ->
      (* A narrow interval says why it is no fraction, unless it was none with all time. *)
      let told = Option.is_some inexact || not (List.for_all is_exact of_enough.values) in
      if Option.is_some inexact then Hashtbl.replace kinds "no fraction" ();
      ("measured", List.exists says_so reasons || (List.for_all is_narrow values && told))
    | _ -> ("settled", 
            settled full.verdict found
            && (has_run outcome || (not (has_run full)) || Option.is_some outcome.left_out || not complete))
  in
  Hashtbl.replace kinds kind ();
  if not right then
    Alcotest.failf "%s, %s: %s, with more time %s" what full.check.name (Verdict.to_string found)
      (Verdict.to_string full.verdict)

(* Some parts of chains of more than a thousand states are worked on in turns. *)
let times = Option.value (Option.bind (Sys.getenv_opt "SCC_TIMES") int_of_string_opt) ~default:1

let sweep e points () =
  let points = points * times in
  let full, asked = report e infinity in
  for k = 1 to points do
    let total = Float.floor (asked *. float_of_int k /. float_of_int points) in
    let found, _ = report e total in
    let what = Printf.sprintf "stop at %g of %g" total asked in
    List.iter2 (fits what ~complete:found.stats.complete) full.outcomes found.outcomes
  done

let walker places points () = sweep (Load.exactly (Load.text (walker places))) points ()
let model name points () = sweep (Load.exactly (Load.file ("../../../specs/models/" ^ name ^ ".sc"))) points ()
let models = [ "crosslink"; "dissociation"; "crowded"; "association"; "ruin"; "brownian" ]

let all_kinds () =
  List.iter
    (fun kind -> Alcotest.(check bool) (kind ^ " came up") true (Hashtbl.mem kinds kind))
    [ "undecided"; "measured"; "settled"; "no fraction" ]

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ( "cut short",
    [
      ( "cut short",
        [
          quick "a short chain" (walker 20 60);
          quick "a long chain" (walker 300 8);
        ] );
      ("models", List.map (fun name -> quick name (model name 20)) models);
      ("all", [ quick "each kind" all_kinds ]);
    ] )
