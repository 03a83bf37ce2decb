(* Probabilities and means that the time cuts short at any point: what is told is what would be told with more time, or says
   that the time was over. The clock counts how often it is asked whether to stop. *)

open Scc_exact
open Scc_graph_search
open Scc_semantics
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

let report places total =
  let e = Load.exactly (Load.text (walker places)) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let surroundings, asked = surroundings total in
  let bounds = { Bounds.default with seconds = Given 9. } in
  match Network.initial semantics e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let report = Check.run { Setup.default with bounds; surroundings } semantics ~initial e.checks in
    (List.map (fun (o : Verdict.outcome) -> o.verdict) report.outcomes, !asked)

let says_so = function
  | Verdict.Truncated _ | Unevaluated _ -> true
  | Unexplored _ | Undefined _ | Fault _ -> false

let is_exact (_, m) = Scc_explain.Likelihoods.is_exact m

(* As narrow as is asked for where there is no exact value. *)
let is_narrow (_, (m : Scc_ctl.Eval.measured)) =
  match (m.least, m.most) with
  | Within (low, _), Within (_, high) -> Rat.compare (Rat.sub high low) Scc_chance.Effort.default.width <= 0
  | _ -> false

(* Whether a verdict is the one of enough time, in what it claims. *)
let settled (full : Verdict.t) (found : Verdict.t) =
  match (full, found) with
  | Holds _, Holds { bounds = []; _ } | Violated _, Violated _ -> true
  | Measured a, Measured b -> List.for_all is_exact b.values && a.values = b.values
  | _ -> false

let kinds = Hashtbl.create 4

let fits what full (found : Verdict.t) =
  let kind, right =
    match found with
    | Undecided reasons ->
      let exact = function
        | Verdict.Undefined text -> Str.string_match (Str.regexp "the probability is [0-9]") text 0
        | _ -> false
      in
      ("undecided", List.exists says_so reasons && not (List.exists exact reasons))
    | Measured { values; reasons; _ } when not (List.for_all is_exact values) ->
      ("measured", List.exists says_so reasons || List.for_all is_narrow values)
    | _ -> ("settled", settled full found)
  in
  Hashtbl.replace kinds kind ();
  if not right then Alcotest.failf "%s: %s, with more time %s" what (Verdict.to_string found) (Verdict.to_string full)

(* Some parts of chains of more than a thousand states are worked on in turns. *)
let sweep places points () =
  let full, asked = report places infinity in
  for k = 1 to points do
    let total = Float.floor (asked *. float_of_int k /. float_of_int points) in
    let found, _ = report places total in
    List.iter2 (fits (Printf.sprintf "%d places, stop at %g of %g" places total asked)) full found
  done

let all_kinds () =
  List.iter
    (fun kind -> Alcotest.(check bool) (kind ^ " came up") true (Hashtbl.mem kinds kind))
    [ "undecided"; "measured"; "settled" ]

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ( "cut short",
    [
      ( "cut short",
        [
          quick "a short chain" (sweep 20 60);
          quick "a long chain" (sweep 300 8);
          quick "each kind" all_kinds;
        ] );
    ] )
